#include "base/memory_file.h"

#include <cerrno>
#include <cstring>

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include "base/error.h"

namespace colloid {

MemoryFile::MemoryFile(const std::string& text)
    : descriptor_(::memfd_create("poreclog", 0)) {  // inherited on purpose
  bool written = descriptor_ >= 0;
  for (std::size_t at = 0; written && at < text.size();) {
    const ssize_t count = ::write(descriptor_, text.data() + at, text.size() - at);
    written = count > 0;
    at += written ? static_cast<std::size_t>(count) : 0;
  }
  if (!written) {
    const int error = errno;
    ::close(descriptor_);
    throw StorageError(fmt::format("no file in memory: {}", std::strerror(error)));
  }
}

MemoryFile::~MemoryFile() {
  ::close(descriptor_);
}

std::string MemoryFile::path() const {
  return fmt::format("/dev/fd/{}", descriptor_);
}

}  // namespace colloid
