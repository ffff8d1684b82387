# The libraries of OpenFOAM v1912 as Debian builds them, and their headers, which Debian ships
# as source only: OpenFOAM_FOUND, the target OpenFOAM::OpenFOAM,
# and OpenFOAM_WHY_NOT, a reason if they are not found.
#   PORECLOG_OPENFOAM_HEADERS (cache or environment): a folder with headers, either as
#   scripts/openfoam_headers.sh makes it or the folder src of OpenFOAM v1912 after its build.
#   Not given: the script takes them from Debian's source package, once.
include(FindPackageHandleStandardArgs)

set(PORECLOG_OPENFOAM_HEADERS "" CACHE PATH "Headers of OpenFOAM; empty: fetched once")
set(openfoam_libraries finiteVolume meshTools surfMesh fileFormats OpenFOAM Pstream)

# All of them lie beside this one.
find_library(OpenFOAM_LIBRARY OpenFOAM)
# What its libraries read when they are loaded (Debian's package openfoam).
find_path(OpenFOAM_PROJECT_DIR etc/controlDict PATHS /usr/share/openfoam NO_DEFAULT_PATH)
mark_as_advanced(OpenFOAM_LIBRARY OpenFOAM_PROJECT_DIR)

set(headers "${PORECLOG_OPENFOAM_HEADERS}")
if(NOT headers)
  set(headers "$ENV{PORECLOG_OPENFOAM_HEADERS}")
endif()
set(OpenFOAM_WHY_NOT "")
if(OpenFOAM_LIBRARY AND NOT headers)
  execute_process(COMMAND bash "${PROJECT_SOURCE_DIR}/scripts/openfoam_headers.sh"
    OUTPUT_VARIABLE headers OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_VARIABLE OpenFOAM_WHY_NOT)
endif()

set(OpenFOAM_INCLUDE_DIRS "")
foreach(folder OpenFOAM OSspecific finiteVolume meshTools fileFormats surfMesh)
  foreach(place "${headers}/${folder}/lnInclude" "${headers}/${folder}/POSIX/lnInclude"
                "${headers}/${folder}")
    if(IS_DIRECTORY "${place}")
      list(APPEND OpenFOAM_INCLUDE_DIRS "${place}")
      break()
    endif()
  endforeach()
endforeach()
list(LENGTH OpenFOAM_INCLUDE_DIRS found_folders)
if(NOT found_folders EQUAL 6 OR NOT EXISTS "${headers}")
  set(OpenFOAM_INCLUDE_DIRS "")
  if(headers)
    set(OpenFOAM_WHY_NOT "${headers} has no headers of OpenFOAM")
  endif()
endif()

find_package_handle_standard_args(OpenFOAM
  REQUIRED_VARS OpenFOAM_LIBRARY OpenFOAM_PROJECT_DIR OpenFOAM_INCLUDE_DIRS REASON_FAILURE_MESSAGE "${OpenFOAM_WHY_NOT}")

if(OpenFOAM_FOUND AND NOT TARGET OpenFOAM::OpenFOAM)
  add_library(OpenFOAM::OpenFOAM INTERFACE IMPORTED)
  get_filename_component(openfoam_folder "${OpenFOAM_LIBRARY}" DIRECTORY)
  set_target_properties(OpenFOAM::OpenFOAM PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${OpenFOAM_INCLUDE_DIRS}"
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${OpenFOAM_INCLUDE_DIRS}"
    # How Debian built the libraries; NoRepository: template headers bring their definitions.
    INTERFACE_COMPILE_DEFINITIONS "OPENFOAM=1912;WM_DP;WM_LABEL_SIZE=32;NoRepository"
    INTERFACE_COMPILE_OPTIONS "-ftemplate-depth-100"
    # Libraries register what is chosen at run time when they are loaded, used or not.
    INTERFACE_LINK_OPTIONS "-Wl,--no-as-needed"
    INTERFACE_LINK_DIRECTORIES "${openfoam_folder}"
    # By name: they have no SONAME, a full path would be written into the program.  Not
    # libOSspecific.o: it is in libOpenFOAM already, and twice is a double free at exit.
    INTERFACE_LINK_LIBRARIES "${openfoam_libraries};dl;m")
endif()
