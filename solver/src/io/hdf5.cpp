#include "io/hdf5.h"

#include <fmt/format.h>

namespace colloid {

namespace {

/// Files held in memory.  Their superblock stays the oldest: of the later ones
/// H5Fget_file_image (1.10) hands out copies with a wrong checksum.
H5Handle memory_access() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // failures become exceptions
  H5Handle access = properties(H5P_FILE_ACCESS);
  checked(H5Pset_fapl_core(access.id(), 1 << 20, false));
  return access;
}

void put_attribute(const H5Handle& object, const std::string& name, hid_t type,
                   const H5Handle& space, const void* value) {
  const H5Handle attribute(
      H5Acreate2(object.id(), name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  checked(H5Awrite(attribute.id(), type, value));
}

void get_attribute(const H5Handle& object, const std::string& name, hid_t type,
                   void* value) {
  const H5Handle attribute(H5Aopen(object.id(), name.c_str(), H5P_DEFAULT), H5Aclose);
  checked(H5Aread(attribute.id(), type, value));
}

}  // namespace

std::string hdf5_version() {
  unsigned major = 0;
  unsigned minor = 0;
  unsigned release = 0;
  checked(H5get_libversion(&major, &minor, &release));
  return fmt::format("{}.{}.{}", major, minor, release);
}

H5Handle create_image() {
  const H5Handle access = memory_access();
  const H5Handle creation = timeless(H5P_FILE_CREATE);
  return {H5Fcreate("image", H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose};
}

std::string image_bytes(const H5Handle& file) {
  checked(H5Fflush(file.id(), H5F_SCOPE_GLOBAL));
  const ssize_t size = checked(H5Fget_file_image(file.id(), nullptr, 0));
  std::string bytes(static_cast<std::size_t>(size), '\0');
  checked(H5Fget_file_image(file.id(), bytes.data(), bytes.size()));
  return bytes;
}

H5Handle open_image(std::string_view bytes) {
  const H5Handle access = memory_access();
  // The library copies the bytes and does not write to them.
  checked(H5Pset_file_image(access.id(), const_cast<char*>(bytes.data()), bytes.size()));
  return {H5Fopen("image", H5F_ACC_RDONLY, access.id()), H5Fclose};
}

H5Handle create_group(const H5Handle& parent, const char* path) {
  const H5Handle links = properties(H5P_LINK_CREATE);
  checked(H5Pset_create_intermediate_group(links.id(), 1));
  const H5Handle creation = timeless(H5P_GROUP_CREATE);
  checked(H5Pset_attr_creation_order(creation.id(),
                                     H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
  return {H5Gcreate2(parent.id(), path, links.id(), creation.id(), H5P_DEFAULT),
          H5Gclose};
}

H5Handle open_group(const H5Handle& parent, const char* path) {
  return {H5Gopen2(parent.id(), path, H5P_DEFAULT), H5Gclose};
}

void put_attribute(const H5Handle& object, const std::string& name, double value) {
  put_attribute(object, name, H5T_IEEE_F64LE, scalar_space(), &value);
}

void put_attribute(const H5Handle& object, const std::string& name, std::int64_t value) {
  put_attribute(object, name, H5T_STD_I64LE, scalar_space(), &value);
}

void put_attribute(const H5Handle& object, const std::string& name, std::uint64_t value) {
  put_attribute(object, name, H5T_STD_U64LE, scalar_space(), &value);
}

void put_attribute(const H5Handle& object, const std::string& name,
                   const std::string& value) {
  const H5Handle type = text_type(value.size());
  put_attribute(object, name, type.id(), scalar_space(), value.c_str());
}

void put_attribute(const H5Handle& object, const std::string& name,
                   const std::vector<std::int64_t>& values) {
  put_attribute(object, name, H5T_STD_I64LE, array_space({values.size()}), values.data());
}

void put_attribute(const H5Handle& object, const std::string& name,
                   const std::vector<std::string>& values) {
  const H5Handle type = text_type(longest(values));
  const std::string bytes = padded(values, longest(values));
  put_attribute(object, name, type.id(), array_space({values.size()}), bytes.data());
}

void get_attribute(const H5Handle& object, const std::string& name, double& value) {
  get_attribute(object, name, H5T_IEEE_F64LE, &value);
}

void get_attribute(const H5Handle& object, const std::string& name, std::int64_t& value) {
  get_attribute(object, name, H5T_STD_I64LE, &value);
}

void get_attribute(const H5Handle& object, const std::string& name,
                   std::uint64_t& value) {
  get_attribute(object, name, H5T_STD_U64LE, &value);
}

void get_attribute(const H5Handle& object, const std::string& name, std::string& value) {
  const H5Handle attribute(H5Aopen(object.id(), name.c_str(), H5P_DEFAULT), H5Aclose);
  const H5Handle type(H5Aget_type(attribute.id()), H5Tclose);
  value.assign(H5Tget_size(type.id()), '\0');
  checked(H5Aread(attribute.id(), type.id(), value.data()));
  value.resize(value.find_last_not_of('\0') + 1);
}

NamedNumbers get_numbers(const H5Handle& group) {
  std::vector<std::string> names;
  const auto collect = [](hid_t, const char* name, const H5A_info_t*,
                          void* out) -> herr_t {
    static_cast<std::vector<std::string>*>(out)->emplace_back(name);
    return 0;
  };
  checked(
      H5Aiterate2(group.id(), H5_INDEX_CRT_ORDER, H5_ITER_INC, nullptr, collect, &names));
  NamedNumbers numbers;
  numbers.reserve(names.size());
  for (const std::string& name : names) {
    get_attribute(group, name, numbers.emplace_back(name, 0.0).second);
  }
  return numbers;
}

std::vector<std::string> member_names(const H5Handle& group) {
  std::vector<std::string> names;
  const auto collect = [](hid_t, const char* name, const H5L_info_t*,
                          void* out) -> herr_t {
    static_cast<std::vector<std::string>*>(out)->emplace_back(name);
    return 0;
  };
  checked(H5Literate(group.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names));
  return names;
}

}  // namespace colloid
