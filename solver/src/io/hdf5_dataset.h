// Datasets of an HDF5 file: arrays of numbers, words and texts, each with its unit and
// its meaning.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/hdf5_handle.h"

namespace colloid {

/// What a dataset says of itself: attributes `unit` (as H5MD writes units: "m s-1",
/// "m+2", "1") and `description`.
struct Label {
  std::string unit;
  std::string description;
};

/// `values` in C order, product of `shape` of them.  Chunked and compressed (shuffle,
/// deflate) from 4 KiB on.
void put_array(const H5Handle& group, const std::string& name, const Label& label,
               const Shape& shape, const std::vector<double>& values);
void put_array(const H5Handle& group, const std::string& name, const Label& label,
               const Shape& shape, const std::vector<std::int64_t>& values);
/// Values that are the index of one of `words`.
void put_words(const H5Handle& group, const std::string& name, const Label& label,
               const Shape& shape, const std::vector<std::int8_t>& values,
               const std::vector<std::string>& words);
/// Texts without a zero byte, as strings of the length of the longest.
void put_texts(const H5Handle& group, const std::string& name, const Label& label,
               const std::vector<std::string>& values);
/// One text of any length.
void put_text(const H5Handle& group, const std::string& name, const Label& label,
              const std::string& value);

Shape shape_of(const H5Handle& group, const std::string& name);
void get_array(const H5Handle& group, const std::string& name,
               std::vector<double>& values);
void get_array(const H5Handle& group, const std::string& name,
               std::vector<std::int64_t>& values);
void get_array(const H5Handle& group, const std::string& name,
               std::vector<std::int8_t>& values);
void get_texts(const H5Handle& group, const std::string& name,
               std::vector<std::string>& values);

/// A second name, in `to`, for the dataset `name` of `from`.
void link_dataset(const H5Handle& from, const H5Handle& to, const std::string& name);

}  // namespace colloid
