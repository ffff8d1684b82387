# LIGGGHTS as Debian packages it (libliggghts-dev), which brings no CMake file of its own:
# LIGGGHTS_FOUND, the target LIGGGHTS::LIGGGHTS.  MPI must have been found.
include(FindPackageHandleStandardArgs)

find_path(LIGGGHTS_INCLUDE_DIR library_cfd_coupling.h PATH_SUFFIXES liggghts)
find_library(LIGGGHTS_LIBRARY liggghts)
mark_as_advanced(LIGGGHTS_INCLUDE_DIR LIGGGHTS_LIBRARY)
find_package_handle_standard_args(LIGGGHTS
  REQUIRED_VARS LIGGGHTS_LIBRARY LIGGGHTS_INCLUDE_DIR)

if(LIGGGHTS_FOUND AND NOT TARGET LIGGGHTS::LIGGGHTS)
  add_library(LIGGGHTS::LIGGGHTS UNKNOWN IMPORTED)
  # No definitions: those of LIGGGHTS change the layout of its classes.
  set_target_properties(LIGGGHTS::LIGGGHTS PROPERTIES
    IMPORTED_LOCATION "${LIGGGHTS_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${LIGGGHTS_INCLUDE_DIR}"
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${LIGGGHTS_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES MPI::MPI_CXX)
endif()
