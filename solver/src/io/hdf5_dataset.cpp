#include "io/hdf5_dataset.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "io/hdf5.h"

namespace colloid {

namespace {

constexpr unsigned kDeflateLevel = 4;       // of 9; more gains a few per cent
constexpr hsize_t kPackedBytes = 4096;      // below, the index outweighs the gain
constexpr hsize_t kChunkBytes = 256 << 10;  // fits the library's cache of 1 MiB

H5Handle word_type(const std::vector<std::string>& words) {
  H5Handle type(H5Tenum_create(H5T_STD_I8LE), H5Tclose);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto value = static_cast<std::int8_t>(i);
    checked(H5Tenum_insert(type.id(), words[i].c_str(), &value));
  }
  return type;
}

/// Of the indices [begin, end) of an array of values of `value_size` bytes.
hsize_t byte_count(Shape::const_iterator begin, Shape::const_iterator end,
                   std::size_t value_size) {
  return std::accumulate(begin, end, hsize_t{value_size}, std::multiplies<>());
}

/// Whole rows (first index) of at most kChunkBytes, one row at least.
Shape chunk_of(const Shape& shape, std::size_t value_size) {
  Shape chunk = shape;
  const hsize_t row = byte_count(shape.begin() + 1, shape.end(), value_size);
  chunk[0] = std::clamp<hsize_t>(kChunkBytes / row, 1, shape[0]);
  return chunk;
}

void put_dataset(const H5Handle& group, const std::string& name, const Label& label,
                 hid_t type, const H5Handle& space, const H5Handle& creation,
                 const void* values) {
  const H5Handle dataset(H5Dcreate2(group.id(), name.c_str(), type, space.id(),
                                    H5P_DEFAULT, creation.id(), H5P_DEFAULT),
                         H5Dclose);
  checked(H5Dwrite(dataset.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
  put_attribute(dataset, "unit", label.unit);
  put_attribute(dataset, "description", label.description);
}

void put_array(const H5Handle& group, const std::string& name, const Label& label,
               hid_t type, const Shape& shape, const void* values) {
  const H5Handle creation = timeless(H5P_DATASET_CREATE);
  const std::size_t value_size = H5Tget_size(type);
  if (byte_count(shape.begin(), shape.end(), value_size) >= kPackedBytes) {
    const Shape chunk = chunk_of(shape, value_size);
    checked(H5Pset_chunk(creation.id(), static_cast<int>(chunk.size()), chunk.data()));
    checked(H5Pset_shuffle(creation.id()));
    checked(H5Pset_deflate(creation.id(), kDeflateLevel));
  }
  put_dataset(group, name, label, type, array_space(shape), creation, values);
}

H5Handle open_dataset(const H5Handle& group, const std::string& name) {
  return {H5Dopen2(group.id(), name.c_str(), H5P_DEFAULT), H5Dclose};
}

hsize_t value_count(const H5Handle& dataset) {
  const H5Handle space(H5Dget_space(dataset.id()), H5Sclose);
  return static_cast<hsize_t>(checked(H5Sget_simple_extent_npoints(space.id())));
}

template <class T>
void get_array(const H5Handle& group, const std::string& name, hid_t type,
               std::vector<T>& values) {
  const H5Handle dataset = open_dataset(group, name);
  values.resize(value_count(dataset));
  checked(H5Dread(dataset.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
}

}  // namespace

void put_array(const H5Handle& group, const std::string& name, const Label& label,
               const Shape& shape, const std::vector<double>& values) {
  put_array(group, name, label, H5T_IEEE_F64LE, shape, values.data());
}

void put_array(const H5Handle& group, const std::string& name, const Label& label,
               const Shape& shape, const std::vector<std::int64_t>& values) {
  put_array(group, name, label, H5T_STD_I64LE, shape, values.data());
}

void put_words(const H5Handle& group, const std::string& name, const Label& label,
               const Shape& shape, const std::vector<std::int8_t>& values,
               const std::vector<std::string>& words) {
  put_array(group, name, label, word_type(words).id(), shape, values.data());
}

void put_texts(const H5Handle& group, const std::string& name, const Label& label,
               const std::vector<std::string>& values) {
  const std::size_t size = longest(values);
  put_array(group, name, label, text_type(size).id(), {values.size()},
            padded(values, size).data());
}

void put_text(const H5Handle& group, const std::string& name, const Label& label,
              const std::string& value) {
  const H5Handle type = text_type(value.size());
  put_dataset(group, name, label, type.id(), scalar_space(), timeless(H5P_DATASET_CREATE),
              value.c_str());
}

Shape shape_of(const H5Handle& group, const std::string& name) {
  const H5Handle dataset = open_dataset(group, name);
  const H5Handle space(H5Dget_space(dataset.id()), H5Sclose);
  const int rank = checked(H5Sget_simple_extent_ndims(space.id()));
  Shape shape(static_cast<std::size_t>(rank));
  checked(H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr));
  return shape;
}

void get_array(const H5Handle& group, const std::string& name,
               std::vector<double>& values) {
  get_array(group, name, H5T_IEEE_F64LE, values);
}

void get_array(const H5Handle& group, const std::string& name,
               std::vector<std::int64_t>& values) {
  get_array(group, name, H5T_STD_I64LE, values);
}

void get_array(const H5Handle& group, const std::string& name,
               std::vector<std::int8_t>& values) {
  const H5Handle type(H5Dget_type(open_dataset(group, name).id()), H5Tclose);
  get_array(group, name, type.id(), values);
}

void get_texts(const H5Handle& group, const std::string& name,
               std::vector<std::string>& values) {
  const H5Handle dataset = open_dataset(group, name);
  const H5Handle type(H5Dget_type(dataset.id()), H5Tclose);
  const std::size_t size = H5Tget_size(type.id());
  values.assign(value_count(dataset), "");
  std::string bytes(values.size() * size, '\0');
  checked(H5Dread(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()));
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = bytes.substr(i * size, size);
    values[i].resize(values[i].find_last_not_of('\0') + 1);
  }
}

void link_dataset(const H5Handle& from, const H5Handle& to, const std::string& name) {
  checked(H5Lcreate_hard(from.id(), name.c_str(), to.id(), name.c_str(), H5P_DEFAULT,
                         H5P_DEFAULT));
}

}  // namespace colloid
