// poreclog-attempt FOLDER SECONDS SECONDS_TO_STOP --job JOB -- COMMAND...
// poreclog-attempt --serve
//
// Keeps attempts (attempt/keep.h): one, for a cluster's job, or one after another for an
// executor on this machine (attempt/protocol.h).  Without the C++ library's iostream and
// without libraries, because a cluster's job starts it once per attempt.
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include "attempt/keep.h"
#include "attempt/protocol.h"

namespace {

constexpr std::size_t kFolder = 0;
constexpr std::size_t kSeconds = 1;
constexpr std::size_t kSecondsToStop = 2;
constexpr std::size_t kLine = 3;
constexpr std::size_t kCommand = 4;

bool read_all(void* to, std::size_t size) {
  char* at = static_cast<char*>(to);
  while (size > 0) {
    const ssize_t count = ::read(colloid::kAttempts, at, size);
    if (count <= 0) {
      return false;
    }
    at += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

/// The words of `text`, and a null after the last.
std::vector<char*> words_of(std::vector<char>& text) {
  std::vector<char*> words;
  for (std::size_t at = 0; at < text.size(); at += std::strlen(&text[at]) + 1) {
    words.push_back(&text[at]);
  }
  words.push_back(nullptr);
  return words;
}

int serve() {
  // The solvers have no part in this; and whoever asked may be gone when one has ended.
  ::fcntl(colloid::kAttempts, F_SETFD, FD_CLOEXEC);
  ::fcntl(colloid::kEndings, F_SETFD, FD_CLOEXEC);
  ::signal(SIGPIPE, SIG_IGN);
  std::uint32_t size = 0;
  while (read_all(&size, sizeof size)) {
    std::vector<char> text(size);
    if (!read_all(text.data(), size) || size == 0 || text.back() != '\0') {
      return colloid::kNotKept;
    }
    const std::vector<char*> words = words_of(text);
    if (words.size() <= kCommand + 1) {
      return colloid::kNotKept;
    }
    colloid::Attempt attempt;
    attempt.folder = words[kFolder];
    attempt.seconds = std::strtod(words[kSeconds], nullptr);
    attempt.seconds_to_stop = std::strtod(words[kSecondsToStop], nullptr);
    attempt.line = words[kLine];
    attempt.command = words.data() + kCommand;
    const std::int32_t ending = colloid::keep(attempt);
    if (::write(colloid::kEndings, &ending, sizeof ending) !=
        static_cast<ssize_t>(sizeof ending)) {
      break;
    }
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  colloid::block_signals();
  if (argc == 2 && std::strcmp(argv[1], "--serve") == 0) {
    return serve();
  }
  if (argc < 8 || std::strcmp(argv[4], "--job") != 0 || std::strcmp(argv[6], "--") != 0) {
    std::fprintf(stderr,
                 "usage: poreclog-attempt FOLDER SECONDS SECONDS_TO_STOP --job JOB -- "
                 "COMMAND...\n       poreclog-attempt --serve\n");
    return colloid::kNotKept;
  }
  colloid::Attempt attempt;
  attempt.folder = argv[1];
  attempt.seconds = std::strtod(argv[2], nullptr);
  attempt.seconds_to_stop = std::strtod(argv[3], nullptr);
  attempt.job = argv[5];
  attempt.command = argv + 7;
  return colloid::keep(attempt);
}
