#include "io/atomic_file.h"

#include <cassert>
#include <cerrno>
#include <filesystem>
#include <random>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "core/error.h"

namespace colloid {

namespace {

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

/// Makes the rename last through a power cut.  Failures are not reported: some file
/// systems cannot do this, and without it the file is still whole or absent.
void sync_folder(const std::string& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0) {
    ::fsync(descriptor);
    ::close(descriptor);
  }
}

}  // namespace

AtomicFile::AtomicFile(std::string path) : path_(std::move(path)) {
  require(!path_.empty(), "output file", "has an empty name");
  std::error_code ignored;
  require(!std::filesystem::is_directory(path_, ignored), path_,
          "is a folder, expected the name of a file to write");
  const std::string folder = folder_of(path_);
  require(std::filesystem::is_directory(folder, ignored), path_,
          fmt::format("cannot be written: there is no folder {}", folder));
  std::random_device random;
  do {
    part_path_ = fmt::format("{}.{:08x}.part", path_, random());
    descriptor_ =
        ::open(part_path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (descriptor_ < 0 && (errno == EEXIST || errno == EINTR));
  require(descriptor_ >= 0, path_, [&] {
    return fmt::format("cannot be written: the folder {} refuses new files: {}", folder,
                       std::generic_category().message(errno));
  });
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
    ::unlink(part_path_.c_str());
  }
}

void AtomicFile::write(std::string_view bytes) {
  assert(descriptor_ >= 0);
  if (::ftruncate(descriptor_, 0) != 0) {
    fail("cannot be truncated");
  }
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = ::pwrite(descriptor_, bytes.data() + done, bytes.size() - done,
                                   static_cast<off_t>(done));
    if (count < 0 && errno != EINTR) {
      fail("cannot be written");
    }
    done += count > 0 ? static_cast<std::size_t>(count) : 0;
  }
}

void AtomicFile::commit() {
  assert(descriptor_ >= 0);
  if (::fsync(descriptor_) != 0) {
    fail("cannot be brought to the disk");
  }
  // Some network file systems report a full disk or quota only here.
  if (::close(std::exchange(descriptor_, -1)) != 0) {
    fail("cannot be closed");
  }
  if (::rename(part_path_.c_str(), path_.c_str()) != 0) {
    fail("cannot be put in its place");
  }
  sync_folder(folder_of(path_));
}

void AtomicFile::fail(const char* what) {
  const int error_number = errno;
  if (descriptor_ >= 0) {
    ::close(std::exchange(descriptor_, -1));
  }
  ::unlink(part_path_.c_str());
  throw OutputError(path_, what, error_number);
}

}  // namespace colloid
