// Runs a program to its end and keeps what it printed.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace colloid {

struct ProgramOutput {
  int exit_code = 0;  ///< 128 + n if signal n ended it
  std::string out;
  std::string err;
};

/// `words[0]` is the program, searched in PATH; no shell takes part.  InputError if it
/// cannot be started.
ProgramOutput run_program(const std::vector<std::string>& words);

/// A pipe whose ends are not inherited: {read, write}.  StorageError if there is none.
std::array<int, 2> make_pipe();

}  // namespace colloid
