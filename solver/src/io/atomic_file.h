// A file that appears under its name whole or not at all.
//
// The content grows under a name of its own, PATH.xxxxxxxx.part, and not simply
// PATH.part: a scheduler may start an attempt again while the first one still runs on
// another node, locks cannot be trusted on network file systems, and two writers of one
// file would spoil it.  So each has its own, and the last to finish gives the name.  What
// a killed run leaves behind ends in .part and may be deleted.
#pragma once

#include <string>
#include <string_view>

namespace colloid {

class AtomicFile {
 public:
  /// Creates the temporary file.  InputError if `path` is a folder, or if its own folder
  /// is missing or refuses new files.
  explicit AtomicFile(std::string path);

  /// Removes the temporary file unless it was committed.
  ~AtomicFile();

  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Replaces the content of the temporary file.  OutputError if the disk refuses.
  void write(std::string_view bytes);

  /// Forces the content to the disk and moves it to the final name, over what was there.
  /// OutputError if any of it fails; the temporary file is removed then.
  void commit();

  const std::string& part_path() const { return part_path_; }

 private:
  [[noreturn]] void fail(const char* what);

  std::string path_;
  std::string part_path_;
  int descriptor_ = -1;
};

}  // namespace colloid
