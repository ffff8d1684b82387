#include "io/columns.h"

#include <cstring>

namespace colloid {

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    if (name.empty() || name.find(kListSeparator) != std::string::npos) {
      throw std::invalid_argument("not a name: \"" + name + "\"");
    }
    text += (text.empty() ? "" : kListSeparator) + name;
  }
  return text;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(kListSeparator, begin), text.size());
    names.push_back(text.substr(begin, end - begin));
    begin = end + std::strlen(kListSeparator);
  }
  return names;
}

void put_column(const H5Handle& group, const std::string& name, const Label& label,
                const std::vector<double>& values) {
  put_array(group, name, label, {values.size()}, values);
}

void put_column(const H5Handle& group, const std::string& name, const Label& label,
                const std::vector<std::int64_t>& values) {
  put_array(group, name, label, {values.size()}, values);
}

void put_column(const H5Handle& group, const std::string& name, const Label& label,
                const std::vector<Vec3>& values) {
  std::vector<double> numbers;
  numbers.reserve(3 * values.size());
  for (const Vec3& value : values) {
    numbers.insert(numbers.end(), {value.x, value.y, value.z});
  }
  put_array(group, name, label, {values.size(), 3}, numbers);
}

void put_column(const H5Handle& group, const std::string& name, const Label& label,
                const std::vector<bool>& values) {
  // The words by which h5py and PyTables know a truth value.
  put_words(group, name, label, {values.size()},
            std::vector<std::int8_t>(values.begin(), values.end()), {"FALSE", "TRUE"});
}

void put_column(const H5Handle& group, const std::string& name, const Label& label,
                const std::vector<std::vector<std::string>>& values) {
  std::vector<std::string> texts;
  texts.reserve(values.size());
  for (const std::vector<std::string>& names : values) {
    texts.push_back(joined(names));
  }
  put_texts(group, name, label, texts);
}

void get_column(const H5Handle& group, const std::string& name,
                std::vector<double>& values) {
  get_array(group, name, values);
}

void get_column(const H5Handle& group, const std::string& name,
                std::vector<std::int64_t>& values) {
  get_array(group, name, values);
}

void get_column(const H5Handle& group, const std::string& name,
                std::vector<Vec3>& values) {
  std::vector<double> numbers;
  get_array(group, name, numbers);
  values.resize(numbers.size() / 3);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
  }
}

void get_column(const H5Handle& group, const std::string& name,
                std::vector<bool>& values) {
  std::vector<std::int8_t> indices;
  get_array(group, name, indices);
  values.assign(indices.begin(), indices.end());
}

void get_column(const H5Handle& group, const std::string& name,
                std::vector<std::vector<std::string>>& values) {
  std::vector<std::string> texts;
  get_texts(group, name, texts);
  values.clear();
  values.reserve(texts.size());
  for (const std::string& text : texts) {
    values.push_back(split(text));
  }
}

}  // namespace colloid
