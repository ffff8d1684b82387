// One process of a program with MPI, OpenFOAM and LIGGGHTS: alone or one of several
// ranks.
#pragma once

#include <string>

namespace colloid {

/// At most one in a process, in its main().  From its beginning OpenFOAM prints nothing
/// and throws its errors (library_errors.h), and ranks other than 0 are silent.
class Runtime {
 public:
  Runtime(int& argc, char**& argv);
  Runtime(const Runtime&) = delete;
  Runtime& operator=(const Runtime&) = delete;
  ~Runtime();

  int rank() const { return rank_; }
  int ranks() const { return ranks_; }

  /// Whether it holds on every rank; all of them have to ask.
  bool on_all(bool holds) const;

  /// The end of this process, for main() to return: the exit code of the lowest rank that
  /// failed, on all ranks.  That rank prints its complaint.  A rank that fails while
  /// others go on, and wait for it for ever, ends them all.
  int end(int exit_code, const std::string& complaint);

 private:
  void complain(const std::string& complaint) const;

  int rank_ = 0;
  int ranks_ = 1;
  int error_output_ = 2;  ///< file descriptor of stderr as it was
};

}  // namespace colloid
