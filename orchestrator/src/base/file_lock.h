// A lock that the system takes back when its holder dies, however it dies.
//
// A lock of the open file description (fcntl(2), F_OFD_SETLK) on a file that stays.  It
// can be asked after without being taken, so that asking never gets in a holder's way.
// What is in the file (who, where, since when) is for people and may be stale; whether
// the lock is held never is.
#pragma once

#include <optional>
#include <string>

namespace colloid {

class FileLock {
 public:
  /// Takes the lock of the file `path`, which is made if need be, and writes `holder`
  /// into it; none if another process holds it.  Children do not inherit it.
  static std::optional<FileLock> take(const std::string& path, const std::string& holder);

  /// Is the lock held by anyone?  False if there is no such file.
  static bool is_held(const std::string& path);

  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&&) = delete;
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;
  ~FileLock();

  /// What the file said before, if its holder did not let go of the lock in order.
  const std::string& left_behind() const { return left_behind_; }

 private:
  FileLock(int descriptor, std::string left_behind)
      : descriptor_(descriptor), left_behind_(std::move(left_behind)) {}

  int descriptor_;
  std::string left_behind_;
};

}  // namespace colloid
