// How far a run is: a bar with the remaining time on a terminal, plain lines otherwise.
// On stderr, so that stdout holds the command's answer alone.
#pragma once

#include <cstdio>

namespace colloid {

class Progress {
 public:
  /// `total` realisations, of which `done` before this run.
  Progress(long total, long done);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows the present state, not more often than is useful.
  void show(long ingested, long failed, long active, bool at_once = false);

 private:
  long total_;
  long before_;
  double started_;
  double shown_ = -1e9;
  bool terminal_;
  bool bar_is_open_ = false;
};

}  // namespace colloid
