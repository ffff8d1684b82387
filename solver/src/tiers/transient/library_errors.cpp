#include "tiers/transient/library_errors.h"

#include <sstream>
#include <stdexcept>
#include <string>

#include <error.H>

namespace colloid {

namespace {

/// Its lines, empty ones left out, as one.
std::string on_one_line(const std::string& text) {
  std::istringstream lines(text);
  std::string out;
  for (std::string word; lines >> word;) {
    out += (out.empty() ? "" : " ") + word;
  }
  return out;
}

}  // namespace

void with_our_errors(const std::function<void()>& work) {
  try {
    work();
  } catch (const Foam::error& error) {  // its what() says nothing
    throw std::runtime_error("OpenFOAM: " + on_one_line(error.message()));
  }
}

}  // namespace colloid
