// Lets OpenFOAM start without environment variables.
//
// Its static initialisers look for etc/controlDict before main runs, by way of
// Foam::getEnv, which this definition in the executable replaces (ELF interposition).  No
// static objects here: they might not be there yet.
#include <cstdlib>

#include "OSspecific.H"

Foam::string Foam::getEnv(const std::string& name) {
  if (const char* value = ::getenv(name.c_str())) {
    return Foam::string(value);
  }
  if (name == "WM_PROJECT_DIR") {
    return Foam::string("/usr/share/openfoam");
  }
  if (name == "FOAM_SIGFPE") {
    return Foam::string("false");
  }
  return Foam::string();
}
