// What this build is: for --version and the provenance of results.
#pragma once

#include <string>

namespace colloid {

/// "0.1.0"
std::string project_version();
/// The commit it was built from, with "-dirty" if there were changes; "unknown" without
/// git.
std::string git_commit();
/// "GNU 12.2.0"
std::string compiler();

/// The three on one line.
std::string version_text();

}  // namespace colloid
