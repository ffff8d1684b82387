// What libOpenFOAM finds in the environment.  It asks before main(), for its
// etc/controlDict, and ends the program without it; setenv() comes too late.  It asks
// through the dynamic linker, so this definition in the program stands in for its own
// (ELF interposition).  The object must be linked as such: from an archive it would never
// be taken.
//
// Called before the static objects of this program exist: it must use none.
#include <cstdlib>

#include <OSspecific.H>

Foam::string Foam::getEnv(const std::string& name) {
  if (name == "WM_PROJECT_DIR") {
    return {PORECLOG_OPENFOAM_FOLDER};
  }
  if (name == "FOAM_SIGFPE") {
    return {"false"};  // no traps: whoever solves looks for NaN
  }
  if (name.compare(0, 5, "FOAM_") == 0 || name.compare(0, 3, "WM_") == 0) {
    return {};  // what another OpenFOAM on this machine may have set
  }
  const char* value = std::getenv(name.c_str());
  return value == nullptr ? Foam::string() : Foam::string(value);
}
