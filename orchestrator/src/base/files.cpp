#include "base/files.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"

namespace colloid {

namespace {

constexpr std::size_t kLargestFile = std::size_t{256} << 20U;  // [byte]

/// A file descriptor that is closed at the end of its scope and not inherited.
class Descriptor {
 public:
  Descriptor(const std::string& path, int flags)
      : number_(::open(path.c_str(), flags | O_CLOEXEC, 0644)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) {
      ::close(number_);
    }
  }
  int number() const { return number_; }

 private:
  int number_;
};

[[noreturn]] void fail(const std::string& path, const char* what, int error) {
  throw StorageError(fmt::format("{}: {}: {}", path, what, std::strerror(error)));
}

/// The content, or none with errno set.
std::optional<std::string> content(const std::string& path) {
  const Descriptor file(path, O_RDONLY);
  if (file.number() < 0) {
    return std::nullopt;
  }
  std::string text;
  std::array<char, 65536> chunk;  // not set to zero: that would cost more than to read
  for (;;) {
    const ssize_t count = ::read(file.number(), chunk.data(), chunk.size());
    if (count == 0) {
      return text;
    }
    if (count < 0) {
      return std::nullopt;
    }
    text.append(chunk.data(), static_cast<std::size_t>(count));
    if (text.size() > kLargestFile) {
      errno = EFBIG;
      return std::nullopt;
    }
  }
}

/// errno, or 0.
int write_content(const std::string& path, const std::string& text, bool durable) {
  const Descriptor file(path, O_WRONLY | O_CREAT | O_TRUNC);
  if (file.number() < 0) {
    return errno;
  }
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t count = ::write(file.number(), text.data() + at, text.size() - at);
    if (count < 0) {
      return errno;
    }
    at += static_cast<std::size_t>(count);
  }
  return durable && ::fsync(file.number()) != 0 ? errno : 0;
}

}  // namespace

std::string read_text_file(const std::string& path) {
  auto text = content(path);
  require(text.has_value(), path,
          fmt::format("cannot be read: {}", std::strerror(errno)));
  require(text->find_first_not_of(" \t\r\n") != std::string::npos, path, "is empty");
  return *text;
}

std::optional<std::string> read_if_there(const std::string& path) {
  auto text = content(path);
  if (!text && errno != ENOENT && errno != ENOTDIR) {
    fail(path, "cannot be read", errno);
  }
  return text;
}

bool is_file(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

void write_whole(const std::string& path, const std::string& text, bool durable) {
  const std::string part = fmt::format("{}.{}.part", path, ::getpid());
  int error = write_content(part, text, durable);
  if (error == 0 && ::rename(part.c_str(), path.c_str()) != 0) {
    error = errno;
  }
  if (error != 0) {
    ::unlink(part.c_str());
    fail(path, "cannot be written", error);
  }
}

void write_new(const std::string& path, const std::string& text) {
  const int error = write_content(path, text, false);
  if (error != 0) {
    fail(path, "cannot be written", error);
  }
}

void make_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) {
    throw StorageError(
        fmt::format("{}: the folder cannot be made: {}", path, error.message()));
  }
}

bool claim_folder(const std::string& path) {
  if (::mkdir(path.c_str(), 0755) == 0) {
    return true;
  }
  if (errno != EEXIST) {
    fail(path, "the folder cannot be made", errno);
  }
  return false;
}

std::string absolute(const std::string& path) {
  std::string out = std::filesystem::absolute(path).lexically_normal().string();
  if (out.size() > 1 && out.back() == '/') {
    out.pop_back();
  }
  return out;
}

}  // namespace colloid
