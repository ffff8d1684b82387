// Runs the real poreclog-solve as a user does.  Include once per test program, which
// defines PORECLOG_SOLVE as the program's path.
#pragma once

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace colloid {

struct Outcome {
  int exit_code;  ///< 124: out of time, -1 or above 128: killed
  std::string out;
  std::string err;
};

/// A file of this process alone.
inline std::string temporary(const std::string& name) {
  return testing::TempDir() + "poreclog_" + std::to_string(getpid()) + "_" + name;
}

inline std::string content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// Writes a temporary file; returns its path.
inline std::string write_temporary(const std::string& name, const std::string& text) {
  const std::string path = temporary(name);
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

/// `arguments` as a shell splits them; ended after `seconds`.
inline Outcome run_program(const std::string& arguments, int seconds = 60) {
  const std::string out = temporary("out");
  const std::string err = temporary("err");
  const std::string command = "timeout " + std::to_string(seconds) +
                              " " PORECLOG_SOLVE " " + arguments + " >" + out + " 2>" +
                              err;
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(out), content(err)};
}

}  // namespace colloid
