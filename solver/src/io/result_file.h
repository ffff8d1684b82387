// The result of one realisation, RESULT.h5.  Layout: schemas/result.md.
//
// Whole or absent: the content goes to a temporary file in the same folder, which takes
// the final name only when every byte is on the disk.
#pragma once

#include <string>

#include "io/atomic_file.h"
#include "io/provenance.h"
#include "io/realisation.h"
#include "scene/scene.h"

namespace colloid {

class ResultFile {
 public:
  /// Version of the layout; schemas/result.md says the same.
  static constexpr int kSchemaVersion = 1;

  /// Refuses a folder that is missing or cannot be written to, before hours are spent.
  /// Writes the provenance and the scene to the temporary file, so that what an
  /// interrupted run leaves behind says what it was.
  ResultFile(const std::string& path, Provenance provenance, Scene scene);

  /// Writes everything, `complete` = 1 last, and gives the file its name.  OutputError if
  /// the disk does not take it; nothing is left behind then.  Once at most.
  void finish(const Realisation& realisation);

  /// Of the temporary file.
  const std::string& part_path() const { return file_.part_path(); }

 private:
  std::string image(const Realisation* realisation) const;

  Provenance provenance_;
  Scene scene_;
  AtomicFile file_;
};

}  // namespace colloid
