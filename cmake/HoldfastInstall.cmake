# Installs the project, and makes the package that find_package(holdfast) then finds. Each layer is an export set, so
# that a consumer of the core never needs what the widgets need.

include(CMakePackageConfigHelpers)
set(holdfast_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/holdfast")

set(holdfast_layers core)
if(TARGET holdfast_widgets)
  list(APPEND holdfast_layers widgets)
endif()

foreach(layer IN LISTS holdfast_layers)
  set(further_headers FILE_SET core)
  if(layer STREQUAL core)
    set(further_headers FILE_SET generated)
  endif()
  install(TARGETS holdfast_${layer} EXPORT holdfast-${layer} ARCHIVE LIBRARY FILE_SET HEADERS ${further_headers})
  install(EXPORT holdfast-${layer} NAMESPACE holdfast:: DESTINATION "${holdfast_package_dir}")
endforeach()

foreach(program IN ITEMS holdfast-batch holdfast-batch-vtk holdfast)
  if(TARGET ${program})
    install(TARGETS ${program} RUNTIME)
  endif()
endforeach()

# Pages are installed with what they link to, in the folders of the project. The window shows the manual and the example data.
install(DIRECTORY "${PROJECT_SOURCE_DIR}/data" "${PROJECT_SOURCE_DIR}/docs" "${PROJECT_SOURCE_DIR}/examples"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/holdfast")
install(FILES README.md CHANGELOG.md CITATION.cff CONTRIBUTING.md LICENSE
  DESTINATION "${CMAKE_INSTALL_DATADIR}/holdfast")

configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/holdfast-config.cmake.in"
  "${PROJECT_BINARY_DIR}/holdfast-config.cmake" INSTALL_DESTINATION "${holdfast_package_dir}"
  NO_SET_AND_CHECK_MACRO)
# A minor version only adds (docs/library.md).
write_basic_package_version_file("${PROJECT_BINARY_DIR}/holdfast-config-version.cmake" COMPATIBILITY SameMajorVersion)
install(FILES "${PROJECT_BINARY_DIR}/holdfast-config.cmake" "${PROJECT_BINARY_DIR}/holdfast-config-version.cmake"
  DESTINATION "${holdfast_package_dir}")
install(FILES "${CMAKE_CURRENT_LIST_DIR}/FindLZ4.cmake" DESTINATION "${holdfast_package_dir}")
if(HOLDFAST_WITH_CHOLMOD)
  install(FILES "${CMAKE_CURRENT_LIST_DIR}/FindSuiteSparse.cmake" DESTINATION "${holdfast_package_dir}")
endif()
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
