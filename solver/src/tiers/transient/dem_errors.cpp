// LIGGGHTS ends the process on an error.  These definitions of its Error members take the
// place of the library's, as the program's symbols come first, and throw instead.  They
// must stay visible to the library: compile without -fvisibility=hidden.
#include "tiers/transient/dem_engine.h"

// Of LIGGGHTS.
#include "error.h"
#include "fix.h"

namespace colloid {

namespace {

[[noreturn]] void raise(const std::string& message) {
  throw EngineError(message);
}

std::string named(const LAMMPS_NS::Fix* fix, const char* message) {
  return std::string(fix->style) + ": " + message;
}

}  // namespace

bool error_hook_is_linked() {
  return true;
}

}  // namespace colloid

#pragma GCC visibility push(default)
namespace LAMMPS_NS {

void Error::all(const char* /*file*/, int /*line*/, const char* message) {
  colloid::raise(message);
}
void Error::one(const char* /*file*/, int /*line*/, const char* message) {
  colloid::raise(message);  // safe: the only rank
}
void Error::universe_all(const char* /*file*/, int /*line*/, const char* message) {
  colloid::raise(message);
}
void Error::universe_one(const char* /*file*/, int /*line*/, const char* message) {
  colloid::raise(message);
}
void Error::done() {
  colloid::raise("it was told to quit");
}
void Error::fix_error(const char* /*file*/, int /*line*/, Fix* fix, const char* message) {
  colloid::raise(colloid::named(fix, message));
}
void Error::fix_error(const char* /*file*/, int /*line*/, Fix* /*fix*/, const char* style,
                      const char* message) {
  colloid::raise(std::string(style) + ": " + message);
}
void Error::compute_error(const char* /*file*/, int /*line*/, Compute* /*compute*/,
                          const char* message) {
  colloid::raise(message);
}
void Error::warning(const char* /*file*/, int /*line*/, const char* /*message*/,
                    int /*log*/) {}

}  // namespace LAMMPS_NS
#pragma GCC visibility pop
