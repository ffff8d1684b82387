// Where a result comes from: the program, the machine, the command, the moment.
#pragma once

#include <string>
#include <vector>

namespace colloid {

struct Provenance {
  std::string version;         ///< of the program
  std::string commit;          ///< it was built from
  std::string compiler;        ///< name and version
  std::string compiler_flags;  ///< of the build type
  std::string hdf5_version;    ///< of the library at run time
  std::string user;            ///< login name, or "unknown"
  std::string hostname;
  std::string cpu_model;
  int cores = 0;             ///< this process may use
  std::string command_line;  ///< quoted for a shell
  std::string start_time;    ///< ISO 8601, UTC
};

/// Of this process, now.  `arguments`: the program's argv.
Provenance collect_provenance(const std::vector<std::string>& arguments);

}  // namespace colloid
