// Rows of a struct as columns of a group: the visitors that layout.h declares columns to,
// one to write and one to read, so that the two cannot disagree.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "core/vec3.h"
#include "io/hdf5.h"
#include "io/hdf5_dataset.h"
#include "scene/names.h"

namespace colloid {

/// Between names in a column of lists of names; no name contains it.
constexpr const char* kListSeparator = ", ";

std::string joined(const std::vector<std::string>& names);
std::vector<std::string> split(const std::string& text);

// One column, as its values: numbers, vectors [n][3], words, flags, lists of names.
void put_column(const H5Handle& group, const std::string& name, const Label& label,
                const std::vector<double>& values);
void put_column(const H5Handle& group, const std::string& name, const Label& label,
                const std::vector<std::int64_t>& values);
void put_column(const H5Handle& group, const std::string& name, const Label& label,
                const std::vector<Vec3>& values);
void put_column(const H5Handle& group, const std::string& name, const Label& label,
                const std::vector<bool>& values);
void put_column(const H5Handle& group, const std::string& name, const Label& label,
                const std::vector<std::vector<std::string>>& values);

void get_column(const H5Handle& group, const std::string& name,
                std::vector<double>& values);
void get_column(const H5Handle& group, const std::string& name,
                std::vector<std::int64_t>& values);
void get_column(const H5Handle& group, const std::string& name,
                std::vector<Vec3>& values);
void get_column(const H5Handle& group, const std::string& name,
                std::vector<bool>& values);
void get_column(const H5Handle& group, const std::string& name,
                std::vector<std::vector<std::string>>& values);

/// The enumerator whose word is `word`.
template <class E>
E from_word(const std::string& word) {
  const std::vector<std::string> words = words_of<E>();
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == word) {
      return static_cast<E>(i);
    }
  }
  throw std::runtime_error("unknown word in an HDF5 file: " + word);
}

template <class E, class = std::enable_if_t<std::is_enum_v<E>>>
void put_column(const H5Handle& group, const std::string& name, const Label& label,
                const std::vector<E>& values) {
  std::vector<std::vector<std::string>> words;
  words.reserve(values.size());
  for (const E value : values) {
    words.push_back({word_of(value)});
  }
  put_column(group, name, label, words);
}

template <class E, class = std::enable_if_t<std::is_enum_v<E>>>
void get_column(const H5Handle& group, const std::string& name, std::vector<E>& values) {
  std::vector<std::vector<std::string>> words;
  get_column(group, name, words);
  values.clear();
  values.reserve(words.size());
  for (const std::vector<std::string>& word : words) {
    values.push_back(from_word<E>(joined(word)));
  }
}

/// Writes the members of `rows` that it is shown.
template <class Row>
class ColumnWriter {
 public:
  ColumnWriter(const H5Handle& group, const std::vector<Row>& rows)
      : group_(group), rows_(rows) {}

  template <class T>
  void column(const char* name, const char* unit, const char* description,
              T Row::*member) {
    std::vector<T> values;
    values.reserve(rows_.size());
    for (const Row& row : rows_) {
      values.push_back(row.*member);
    }
    put_column(group_, name, {unit, description}, values);
  }

 private:
  const H5Handle& group_;
  const std::vector<Row>& rows_;
};

/// Fills the members of `rows` that it is shown; the first one sets their number.
template <class Row>
class ColumnReader {
 public:
  ColumnReader(const H5Handle& group, std::vector<Row>& rows)
      : group_(group), rows_(rows) {
    rows_.clear();
  }

  template <class T>
  void column(const char* name, const char*, const char*, T Row::*member) {
    std::vector<T> values;
    get_column(group_, name, values);
    if (rows_.empty()) {
      rows_.resize(values.size());
    }
    if (rows_.size() != values.size()) {
      throw std::runtime_error(std::string("columns of unequal length: ") + name);
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      rows_[i].*member = values[i];
    }
  }

 private:
  const H5Handle& group_;
  std::vector<Row>& rows_;
};

/// Writes the values it is shown as attributes; enums as words.
class AttributeWriter {
 public:
  explicit AttributeWriter(const H5Handle& object) : object_(object) {}

  template <class T>
  void value(const char* name, const T& value) {
    if constexpr (std::is_enum_v<T>) {
      put_attribute(object_, name, word_of(value));
    } else {
      put_attribute(object_, name, value);
    }
  }

 private:
  const H5Handle& object_;
};

/// Fills the values it is shown.
class AttributeReader {
 public:
  explicit AttributeReader(const H5Handle& object) : object_(object) {}

  template <class T>
  void value(const char* name, T& value) {
    if constexpr (std::is_enum_v<T>) {
      std::string word;
      get_attribute(object_, name, word);
      value = from_word<T>(word);
    } else {
      get_attribute(object_, name, value);
    }
  }

 private:
  const H5Handle& object_;
};

}  // namespace colloid
