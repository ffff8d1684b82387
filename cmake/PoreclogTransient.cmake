# Whether the program of the tier transient is built: sets PORECLOG_BUILD_TRANSIENT.
set(PORECLOG_WITH_TRANSIENT AUTO CACHE STRING
  "Build poreclog-solve-transient: ON, OFF, or AUTO (where its libraries are installed)")
set_property(CACHE PORECLOG_WITH_TRANSIENT PROPERTY STRINGS AUTO ON OFF)

set(PORECLOG_BUILD_TRANSIENT OFF)
if(PORECLOG_WITH_TRANSIENT)
  set(needed QUIET)
  if(NOT PORECLOG_WITH_TRANSIENT STREQUAL AUTO)
    set(needed REQUIRED)
  endif()
  set(MPI_CXX_SKIP_MPICXX ON)  # its C++ bindings are gone from the standard, and warn
  find_package(MPI ${needed} COMPONENTS CXX)
  find_package(LIGGGHTS ${needed})
  find_package(OpenFOAM ${needed})
  if(MPI_CXX_FOUND AND LIGGGHTS_FOUND AND OpenFOAM_FOUND)
    set(PORECLOG_BUILD_TRANSIENT ON)
  else()
    message(STATUS "poreclog-solve-transient is not built: "
      "MPI ${MPI_CXX_FOUND}, LIGGGHTS ${LIGGGHTS_FOUND}, OpenFOAM ${OpenFOAM_FOUND}")
  endif()
endif()
