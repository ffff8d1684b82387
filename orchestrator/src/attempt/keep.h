// Keeps one attempt: lies between the orchestrator (or a cluster's scheduler) and the
// solver, so that what must not die with the orchestrator does not: the time limit, the
// record of how the solver ended, and the sign that it still runs.
//   - It holds the lock of FOLDER/lock, and the solver inherits it: held means alive.
//   - The solver's output goes to FOLDER/stdout and FOLDER/stderr; FOLDER is the working
//     directory.
//   - After `seconds`, or on SIGTERM or SIGINT, the solver gets SIGTERM,
//     `seconds_to_stop` later SIGKILL; on SIGQUIT it gets SIGKILL at once.  Times are of
//     the monotonic clock.
//   - If this program is killed, the kernel kills the solver: nothing runs unwatched.
//   - FOLDER/ending.json says how it ended; it is whole or absent.
//   - An attempt begins once.  Without a cluster's job, FOLDER is made here (and the
//     realisation's, around it) and must not be there, and `line` goes to
//     FOLDER/command: here, because keepers do it beside each other and the orchestrator
//     would do it for one after another.  With a job, for which FOLDER is there, who
//     makes the file FOLDER/lock has the attempt, on whatever machine, also where a file
//     system has no locks.
#pragma once

namespace colloid {

struct Attempt {
  const char* folder = nullptr;
  double seconds = 0.0;
  double seconds_to_stop = 0.0;
  const char* job = nullptr;   ///< name of a cluster's job; null without one
  const char* line = nullptr;  ///< the command as a shell would take it; null with a job
  char* const* command = nullptr;  ///< ends with null
};

/// Blocks the signals that keep() waits for: call it before anything else.
void block_signals();

/// Runs the attempt to its end.  Returns an ending of attempt/protocol.h.
int keep(const Attempt& attempt);

}  // namespace colloid
