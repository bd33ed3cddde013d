# Finds CHOLMOD, SPQR and UMFPACK of SuiteSparse, which ship no CMake package before version 7.
# Defines the target SuiteSparse::SuiteSparse.

find_path(SuiteSparse_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
set(_suitesparse_libraries)
foreach(component IN ITEMS spqr umfpack cholmod amd suitesparseconfig lapack blas)
  find_library(SuiteSparse_${component}_LIBRARY ${component})
  mark_as_advanced(SuiteSparse_${component}_LIBRARY)
  list(APPEND _suitesparse_libraries SuiteSparse_${component}_LIBRARY)
endforeach()
mark_as_advanced(SuiteSparse_INCLUDE_DIR)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SuiteSparse
  REQUIRED_VARS SuiteSparse_INCLUDE_DIR ${_suitesparse_libraries}
  REASON_FAILURE_MESSAGE "Install libsuitesparse-dev, or configure with -DHOLDFAST_WITH_CHOLMOD=OFF.")

if(SuiteSparse_FOUND AND NOT TARGET SuiteSparse::SuiteSparse)
  add_library(SuiteSparse::SuiteSparse INTERFACE IMPORTED)
  target_include_directories(SuiteSparse::SuiteSparse SYSTEM INTERFACE "${SuiteSparse_INCLUDE_DIR}")
  foreach(variable IN LISTS _suitesparse_libraries)
    target_link_libraries(SuiteSparse::SuiteSparse INTERFACE "${${variable}}")
  endforeach()
endif()
