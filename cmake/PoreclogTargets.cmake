# How every library, program and test of the project is declared.

include(GoogleTest)

# Warnings are ours alone: PRIVATE, never handed to who links the target.
function(poreclog_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                         $<$<BOOL:${PORECLOG_WERROR}>:-Werror>)
endfunction()

# poreclog_module(NAME SOURCES a.cpp ... DEPENDS target ...): one folder of solver/src.
function(poreclog_module name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  add_library(poreclog_${name} STATIC ${ARG_SOURCES})
  target_include_directories(poreclog_${name} PUBLIC ${PROJECT_SOURCE_DIR}/solver/src)
  target_link_libraries(poreclog_${name} PUBLIC ${ARG_DEPENDS})
  poreclog_warnings(poreclog_${name})
endfunction()

# poreclog_orchestrator_module(NAME SOURCES a.cpp ... DEPENDS target ...): the folder NAME of
# orchestrator/src.
function(poreclog_orchestrator_module name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  list(TRANSFORM ARG_SOURCES PREPEND ${PROJECT_SOURCE_DIR}/orchestrator/src/${name}/)
  add_library(poreclog_${name} STATIC ${ARG_SOURCES})
  target_include_directories(poreclog_${name} PUBLIC ${PROJECT_SOURCE_DIR}/orchestrator/src)
  target_link_libraries(poreclog_${name} PUBLIC ${ARG_DEPENDS})
  poreclog_warnings(poreclog_${name})
endfunction()

# poreclog_test(NAME LABEL unit|verification|... [PREFIX text] SOURCES a.cpp ...
#               DEPENDS target ...); the prefix tells apart a source that two programs test.
function(poreclog_test name)
  cmake_parse_arguments(ARG "" "LABEL;PREFIX" "SOURCES;DEPENDS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_DEPENDS} GTest::gtest_main GTest::gmock)
  target_compile_definitions(${name} PRIVATE PORECLOG_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  poreclog_warnings(${name})
  gtest_discover_tests(${name} TEST_PREFIX "${ARG_PREFIX}"
                       PROPERTIES LABELS ${ARG_LABEL} TIMEOUT 600 DISCOVERY_TIMEOUT 60)
endfunction()
