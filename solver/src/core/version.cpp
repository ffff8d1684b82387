#include "core/version.h"

#include <fmt/format.h>

#include "git_commit.h"  // written by cmake/GitCommit.cmake at every build

namespace colloid {

std::string project_version() {
  return PORECLOG_VERSION;
}

std::string git_commit() {
  return PORECLOG_GIT_COMMIT;
}

std::string compiler() {
  return PORECLOG_COMPILER;
}

std::string version_text() {
  return fmt::format("poreclog {} (commit {}, {})", project_version(), git_commit(),
                     compiler());
}

}  // namespace colloid
