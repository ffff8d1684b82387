// A file without a name, for a program that wants to read one.
#pragma once

#include <string>

namespace colloid {

/// Lives in memory and goes with its last reader, however we end: nothing is left behind
/// in a folder for temporary files (memfd_create(2)).
class MemoryFile {
 public:
  /// StorageError if it cannot be made.
  explicit MemoryFile(const std::string& text);
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile();

  /// The name under which this process and its children can open it.
  std::string path() const;

 private:
  int descriptor_;
};

}  // namespace colloid
