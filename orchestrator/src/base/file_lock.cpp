#include "base/file_lock.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "base/error.h"

namespace colloid {

namespace {

struct flock whole_file() {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return lock;
}

}  // namespace

std::optional<FileLock> FileLock::take(const std::string& path,
                                       const std::string& holder) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (descriptor < 0) {
    throw StorageError(
        fmt::format("{}: cannot be written: {}", path, std::strerror(errno)));
  }
  struct flock lock_request = whole_file();
  if (::fcntl(descriptor, F_OFD_SETLK, &lock_request) != 0) {
    const int error = errno;
    ::close(descriptor);
    if (error == EAGAIN || error == EACCES) {
      return std::nullopt;
    }
    throw StorageError(
        fmt::format("{}: cannot be locked: {}", path, std::strerror(error)));
  }
  std::array<char, 512> old{};
  const ssize_t length = ::read(descriptor, old.data(), old.size());
  FileLock lock(
      descriptor,
      std::string(old.data(), static_cast<std::size_t>(std::max(length, ssize_t{0}))));
  if (::ftruncate(descriptor, 0) != 0 ||
      ::pwrite(descriptor, holder.data(), holder.size(), 0) < 0) {
    throw StorageError(
        fmt::format("{}: cannot be written: {}", path, std::strerror(errno)));
  }
  return lock;
}

bool FileLock::is_held(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) {
    return false;
  }
  struct flock lock = whole_file();
  const bool held =
      ::fcntl(descriptor, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
  ::close(descriptor);
  return held;
}

FileLock::FileLock(FileLock&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      left_behind_(std::move(other.left_behind_)) {}

FileLock::~FileLock() {
  if (descriptor_ >= 0) {
    // An empty file is a lock that was let go of in order.
    [[maybe_unused]] const int ignored = ::ftruncate(descriptor_, 0);
    ::close(descriptor_);
  }
}

}  // namespace colloid
