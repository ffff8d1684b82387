#include "ingest/hdf5_file.h"

#include <array>
#include <filesystem>
#include <map>

#include <malloc.h>

namespace colloid {

namespace {

constexpr std::uintmax_t kReadAtOnce = std::uintmax_t{256} << 10U;  // [byte]
constexpr int kKept = 8 << 20;                                      // [byte]

/// The library, as many small files want it; once.
///   - It prints every failed call.  Opening what may not exist is a question here (and
///     half as dear as asking first).
///   - It gives what a file needed (half a megabyte for its cache alone) back to the
///     system when the file is closed; the next file needs the same.
void prepare_library() {
  static const bool done = [] {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    H5set_free_list_limits(kKept, kKept, kKept, kKept, kKept, kKept);
    ::mallopt(M_MMAP_THRESHOLD, kKept);
    ::mallopt(M_TRIM_THRESHOLD, kKept);
    return true;
  }();
  static_cast<void>(done);
}

/// How to read the file: a small one whole (one read instead of one for each object).
/// Without locks: nobody writes to a result any more, and not every file system has them.
hid_t access_to(const std::string& path) {
  const auto unlocked = [](bool in_memory) {
    H5Handle list(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    if (in_memory) {
      H5Pset_fapl_core(list.get(), 1, false);
    }
    H5Pset_file_locking(list.get(), false, true);
    return list;
  };
  static const H5Handle whole = unlocked(true);
  static const H5Handle in_parts = unlocked(false);
  std::error_code none;
  return std::filesystem::file_size(path, none) <= kReadAtOnce ? whole.get()
                                                               : in_parts.get();
}

std::optional<H5Handle> attribute(hid_t object, const char* name) {
  H5Handle handle(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  return handle ? std::optional<H5Handle>(std::move(handle)) : std::nullopt;
}

/// A text of any length, written with a fixed or a variable one.  `read(type, buffer)`.
template <class Read>
std::optional<std::string> text_of(hid_t type, Read read) {
  if (H5Tget_class(type) != H5T_STRING) {
    return std::nullopt;
  }
  if (H5Tis_variable_str(type) > 0) {
    char* text = nullptr;
    if (read(type, &text) < 0 || text == nullptr) {
      return std::nullopt;
    }
    std::string out = text;
    H5free_memory(text);
    return out;
  }
  std::string out(H5Tget_size(type), '\0');
  if (read(type, out.data()) < 0) {
    return std::nullopt;
  }
  out.resize(out.find('\0') == std::string::npos ? out.size() : out.find('\0'));
  return out;
}

std::optional<std::size_t> elements(hid_t dataset) {
  const H5Handle space(H5Dget_space(dataset), H5Sclose);
  const hssize_t count = space ? H5Sget_simple_extent_npoints(space.get()) : -1;
  return count < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(count));
}

std::vector<std::string> fixed_texts(const std::string& bytes, std::size_t width) {
  std::vector<std::string> out;
  for (std::size_t at = 0; width > 0 && at < bytes.size(); at += width) {
    const std::string text = bytes.substr(at, width);
    out.push_back(text.substr(0, text.find('\0')));
  }
  return out;
}

std::optional<std::vector<std::string>> texts(hid_t dataset, hid_t type,
                                              std::size_t count) {
  if (H5Tis_variable_str(type) <= 0) {
    const std::size_t width = H5Tget_size(type);
    std::string bytes(count * width, '\0');
    return H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) < 0
               ? std::nullopt
               : std::optional(fixed_texts(bytes, width));
  }
  std::vector<char*> raw(count, nullptr);
  if (H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, raw.data()) < 0) {
    return std::nullopt;
  }
  std::vector<std::string> out;
  out.reserve(count);
  for (char* text : raw) {
    out.emplace_back(text == nullptr ? "" : text);
    H5free_memory(text);
  }
  return out;
}

std::optional<std::vector<std::string>> names_of_values(hid_t dataset, hid_t type,
                                                        std::size_t count) {
  const std::size_t width = H5Tget_size(type);
  std::vector<unsigned char> raw(count * width);
  if (H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, raw.data()) < 0) {
    return std::nullopt;
  }
  // The library sorts the enumeration at every question: one question per value.
  std::map<std::string, std::string> names;
  std::vector<std::string> out;
  out.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string value(reinterpret_cast<const char*>(raw.data()) + i * width, width);
    auto known = names.find(value);
    if (known == names.end()) {
      std::array<char, 64> name{};
      if (H5Tenum_nameof(type, value.data(), name.data(), name.size()) < 0) {
        return std::nullopt;
      }
      known = names.emplace(value, name.data()).first;
    }
    out.push_back(known->second);
  }
  return out;
}

}  // namespace

std::optional<H5Handle> open_hdf5(const std::string& path) {
  prepare_library();
  H5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access_to(path)), H5Fclose);
  return file ? std::optional<H5Handle>(std::move(file)) : std::nullopt;
}

std::optional<H5Handle> open_group(hid_t parent, const char* name) {
  H5Handle group(H5Gopen2(parent, name, H5P_DEFAULT), H5Gclose);
  return group ? std::optional<H5Handle>(std::move(group)) : std::nullopt;
}

std::optional<double> number_attribute(hid_t object, const char* name) {
  const auto handle = attribute(object, name);
  double value = 0.0;
  if (!handle || H5Aread(handle->get(), H5T_NATIVE_DOUBLE, &value) < 0) {
    return std::nullopt;
  }
  return value;
}

std::optional<std::string> text_attribute(hid_t object, const char* name) {
  const auto handle = attribute(object, name);
  if (!handle) {
    return std::nullopt;
  }
  const H5Handle type(H5Aget_type(handle->get()), H5Tclose);
  return text_of(type.get(), [&](hid_t t, void* buffer) {
    return H5Aread(handle->get(), t, buffer);
  });
}

std::optional<std::vector<double>> numbers(hid_t group, const char* name) {
  const H5Handle dataset(H5Dopen2(group, name, H5P_DEFAULT), H5Dclose);
  const auto count = dataset ? elements(dataset.get()) : std::nullopt;
  if (!count) {
    return std::nullopt;
  }
  std::vector<double> out(*count);
  if (H5Dread(dataset.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT,
              out.data()) < 0) {
    return std::nullopt;
  }
  return out;
}

std::optional<std::vector<std::string>> words(hid_t group, const char* name) {
  const H5Handle dataset(H5Dopen2(group, name, H5P_DEFAULT), H5Dclose);
  const auto count = dataset ? elements(dataset.get()) : std::nullopt;
  if (!count) {
    return std::nullopt;
  }
  const H5Handle type(H5Dget_type(dataset.get()), H5Tclose);
  switch (H5Tget_class(type.get())) {
    case H5T_STRING:
      return texts(dataset.get(), type.get(), *count);
    case H5T_ENUM:
      return names_of_values(dataset.get(), type.get(), *count);
    default:
      return std::nullopt;
  }
}

}  // namespace colloid
