// HDF5 files put together and taken apart in memory: the C library behind values and
// exceptions.
//
// In memory, because the library defers writes: on a full disk it fails late, without a
// reason, in a close that leaves it unable to close at all.  So the library makes the
// bytes, and AtomicFile writes them.  A result takes a few megabytes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/hdf5_handle.h"
#include "io/realisation.h"

namespace colloid {

/// Version of the HDF5 library in use, "1.10.8".
std::string hdf5_version();

/// A new file in memory, and its bytes.
H5Handle create_image();
std::string image_bytes(const H5Handle& file);
/// The file whose bytes these are, for reading.
H5Handle open_image(std::string_view bytes);

/// A group at a path below `parent`; groups on the way are made.  Remembers the order in
/// which its attributes are written.
H5Handle create_group(const H5Handle& parent, const char* path);
H5Handle open_group(const H5Handle& parent, const char* path);

void put_attribute(const H5Handle& object, const std::string& name, double value);
void put_attribute(const H5Handle& object, const std::string& name, std::int64_t value);
void put_attribute(const H5Handle& object, const std::string& name, std::uint64_t value);
void put_attribute(const H5Handle& object, const std::string& name,
                   const std::string& value);
void put_attribute(const H5Handle& object, const std::string& name,
                   const std::vector<std::int64_t>& values);
void put_attribute(const H5Handle& object, const std::string& name,
                   const std::vector<std::string>& values);

void get_attribute(const H5Handle& object, const std::string& name, double& value);
void get_attribute(const H5Handle& object, const std::string& name, std::int64_t& value);
void get_attribute(const H5Handle& object, const std::string& name, std::uint64_t& value);
void get_attribute(const H5Handle& object, const std::string& name, std::string& value);

/// All attributes of a group as numbers, in the order they were written.
NamedNumbers get_numbers(const H5Handle& group);

/// Of the members of a group, sorted.
std::vector<std::string> member_names(const H5Handle& group);

}  // namespace colloid
