# Whether the program of the tier transient is built: sets PORECLOG_BUILD_TRANSIENT; and how its
# tests are declared.
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
      "MPI ${MPI_CXX_FOUND}, LIGGGHTS ${LIGGGHTS_FOUND}, OpenFOAM ${OpenFOAM_FOUND} "
      "${OpenFOAM_WHY_NOT}")
  endif()
endif()

# The arguments of mpirun for tests, which may run as root, on fewer cores than ranks, and
# beside other programs: a rank that waits lets them have its core.
set(PORECLOG_MPIRUN mpirun -q --allow-run-as-root --oversubscribe --bind-to none
    --mca mpi_yield_when_idle 1)

# poreclog_transient_test(NAME LABEL label [RANKS n] SOURCES a.cpp ... [DEPENDS target ...]): as
# poreclog_test, of what lies in solver/src/tiers/transient.  Its sources may include headers of
# OpenFOAM and LIGGGHTS.  With RANKS the whole program is one test, run by so many ranks.
function(poreclog_transient_test name)
  cmake_parse_arguments(ARG "" "LABEL;RANKS" "SOURCES;DEPENDS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES} ${PROJECT_SOURCE_DIR}/tests/transient_main.cpp)
  target_link_libraries(${name} PRIVATE poreclog_transient ${ARG_DEPENDS} GTest::gtest
    GTest::gmock OpenFOAM::OpenFOAM LIGGGHTS::LIGGGHTS MPI::MPI_CXX)
  target_compile_definitions(${name} PRIVATE PORECLOG_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  poreclog_warnings(${name})
  if(ARG_RANKS)
    add_test(NAME ${name} COMMAND ${PORECLOG_MPIRUN} -n ${ARG_RANKS} $<TARGET_FILE:${name}>)
    set_tests_properties(${name} PROPERTIES LABELS ${ARG_LABEL} TIMEOUT 600
      PROCESSORS ${ARG_RANKS})
  else()
    gtest_discover_tests(${name} PROPERTIES LABELS ${ARG_LABEL} TIMEOUT 600
      DISCOVERY_TIMEOUT 60)
  endif()
endfunction()
