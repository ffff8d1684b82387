#include "io/hdf5_handle.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace colloid {

namespace {

/// The library's innermost complaint.
std::string reason() {
  std::string text = "unknown error";
  H5Ewalk2(
      H5E_DEFAULT, H5E_WALK_UPWARD,
      [](unsigned depth, const H5E_error2_t* error, void* out) -> herr_t {
        if (depth == 0) {
          *static_cast<std::string*>(out) =
              fmt::format("{}: {}", error->func_name, error->desc);
        }
        return 0;
      },
      &text);
  return text;
}

}  // namespace

void check_hdf5(bool ok) {
  if (!ok) {
    throw std::runtime_error("HDF5: " + reason());
  }
}

H5Handle::H5Handle(hid_t id, Close close) : id_(checked(id)), close_(close) {}

H5Handle::~H5Handle() {
  if (id_ >= 0) {
    close_(id_);
  }
}

H5Handle properties(hid_t kind) {
  return {H5Pcreate(kind), H5Pclose};
}

H5Handle timeless(hid_t kind) {
  H5Handle creation = properties(kind);
  checked(H5Pset_obj_track_times(creation.id(), false));
  return creation;
}

H5Handle text_type(std::size_t size) {
  H5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  checked(H5Tset_size(type.id(), std::max<std::size_t>(size, 1)));
  checked(H5Tset_strpad(type.id(), H5T_STR_NULLPAD));
  checked(H5Tset_cset(type.id(), H5T_CSET_UTF8));
  return type;
}

H5Handle scalar_space() {
  return {H5Screate(H5S_SCALAR), H5Sclose};
}

H5Handle array_space(const Shape& shape) {
  return {H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
          H5Sclose};
}

std::string padded(const std::vector<std::string>& texts, std::size_t size) {
  std::string bytes;
  bytes.reserve(texts.size() * size);
  for (const std::string& text : texts) {
    if (text.find('\0') != std::string::npos) {
      throw std::invalid_argument("a text for an HDF5 file contains a zero byte");
    }
    bytes.append(text).append(size - text.size(), '\0');
  }
  return bytes;
}

std::size_t longest(const std::vector<std::string>& texts) {
  std::size_t size = 1;
  for (const std::string& text : texts) {
    size = std::max(size, text.size());
  }
  return size;
}

}  // namespace colloid
