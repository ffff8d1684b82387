// What every use of the HDF5 library needs: identifiers that are closed, failures that
// are exceptions, property lists and types as this project wants them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <hdf5.h>

namespace colloid {

/// Throws std::runtime_error with the library's reason if `status` is that of a failure.
/// No user can cause one: files are written in memory, and checked before they are read.
void check_hdf5(bool ok);

template <class Status>
Status checked(Status status) {
  check_hdf5(status >= 0);
  return status;
}

/// Owns an identifier of the library.
class H5Handle {
 public:
  using Close = herr_t (*)(hid_t);
  /// Throws if `id` is that of a failure.
  H5Handle(hid_t id, Close close);
  ~H5Handle();
  H5Handle(H5Handle&& other) noexcept
      : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  H5Handle& operator=(H5Handle&&) = delete;
  H5Handle(const H5Handle&) = delete;
  H5Handle& operator=(const H5Handle&) = delete;

  hid_t id() const { return id_; }

 private:
  hid_t id_;
  Close close_;
};

using Shape = std::vector<hsize_t>;

/// A new property list of `kind`, such as H5P_FILE_ACCESS.
H5Handle properties(hid_t kind);
/// The same, to create objects without a time of day: the same content, the same bytes.
H5Handle timeless(hid_t kind);

/// Strings of `size` bytes, UTF-8, padded with zeros.
H5Handle text_type(std::size_t size);

H5Handle scalar_space();
H5Handle array_space(const Shape& shape);

/// The length of the longest of `texts`, at least 1.
std::size_t longest(const std::vector<std::string>& texts);
/// `texts` one after the other, each padded with zeros to `size`.
std::string padded(const std::vector<std::string>& texts, std::size_t size);

}  // namespace colloid
