# poreclog_dem: the discrete elements of the transient tier, if LIGGGHTS and MPI are
# found.  LIGGGHTS ships neither a .pc file nor a CMake configuration.
find_package(MPI COMPONENTS CXX)
find_path(LIGGGHTS_INCLUDE_DIR library_cfd_coupling.h PATH_SUFFIXES liggghts)
find_library(LIGGGHTS_LIBRARY NAMES liggghts)

if(MPI_CXX_FOUND AND LIGGGHTS_INCLUDE_DIR AND LIGGGHTS_LIBRARY)
  set(dem_folder ${PROJECT_SOURCE_DIR}/solver/src/tiers/transient)
  add_library(poreclog_dem STATIC
    ${dem_folder}/dem.cpp
    ${dem_folder}/dem_bonds.cpp
    ${dem_folder}/dem_engine.cpp
    ${dem_folder}/dem_errors.cpp
    ${dem_folder}/dem_forces.cpp
    ${dem_folder}/dem_limits.cpp
    ${dem_folder}/dem_lubrication.cpp
    ${dem_folder}/dem_surface_force.cpp)
  target_include_directories(poreclog_dem PUBLIC ${PROJECT_SOURCE_DIR}/solver/src)
  target_link_libraries(poreclog_dem PUBLIC poreclog_tiers
                        PRIVATE MPI::MPI_CXX ${LIGGGHTS_LIBRARY})
  poreclog_warnings(poreclog_dem)
  # Their headers have names like error.h: only the files that wrap them see the folder.
  set_source_files_properties(${dem_folder}/dem_engine.cpp ${dem_folder}/dem_errors.cpp
    PROPERTIES COMPILE_OPTIONS
    "-isystem;${LIGGGHTS_INCLUDE_DIR};-DOMPI_SKIP_MPICXX;-fvisibility=default")
endif()
