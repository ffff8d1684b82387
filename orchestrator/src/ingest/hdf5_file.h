// What is needed of the HDF5 C library to read a result file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <hdf5.h>

namespace colloid {

/// A handle that is closed at the end of its scope.
class H5Handle {
 public:
  H5Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  H5Handle(H5Handle&& other) noexcept : id_(other.id_), close_(other.close_) {
    other.id_ = -1;
  }
  H5Handle& operator=(H5Handle&&) = delete;
  H5Handle(const H5Handle&) = delete;
  H5Handle& operator=(const H5Handle&) = delete;
  ~H5Handle() {
    if (id_ >= 0) {
      close_(id_);
    }
  }
  hid_t get() const { return id_; }
  explicit operator bool() const { return id_ >= 0; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// The file, or none if it is not a whole HDF5 file.
std::optional<H5Handle> open_hdf5(const std::string& path);

/// The group, or none.
std::optional<H5Handle> open_group(hid_t parent, const char* name);

// Attributes of a group; none if there is no such attribute, or it has another kind.
std::optional<double> number_attribute(hid_t object, const char* name);
std::optional<std::string> text_attribute(hid_t object, const char* name);

// Columns of a group; none if there is no such dataset, or it has another kind.
/// Row after row if there are several numbers in a row.
std::optional<std::vector<double>> numbers(hid_t group, const char* name);
/// Texts, or the names of an enumeration's values.
std::optional<std::vector<std::string>> words(hid_t group, const char* name);

}  // namespace colloid
