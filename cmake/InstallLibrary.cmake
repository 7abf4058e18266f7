# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the library for find_package(bspline_curve): bspline_curve::bspline_curve, and bspline_curve::field where
# fields are built.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/bspline_curve)
set(targets bspline_curve_core)
set_target_properties(bspline_curve_core PROPERTIES EXPORT_NAME bspline_curve)
if(TARGET bspline_curve_field)
  list(APPEND targets bspline_curve_field)
  set_target_properties(bspline_curve_field PROPERTIES EXPORT_NAME field)
else()
  set(without_field PATTERN field.h EXCLUDE)
endif()

install(TARGETS ${targets} EXPORT bspline_curve-targets ARCHIVE COMPONENT library)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ ${PROJECT_BINARY_DIR}/include/
  TYPE INCLUDE COMPONENT library FILES_MATCHING PATTERN *.h ${without_field})
install(EXPORT bspline_curve-targets NAMESPACE bspline_curve:: DESTINATION ${package_folder} COMPONENT library)

configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/bspline_curve-config.cmake.in ${PROJECT_BINARY_DIR}/bspline_curve-config.cmake
  INSTALL_DESTINATION ${package_folder} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/bspline_curve-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/bspline_curve-config.cmake
  ${PROJECT_BINARY_DIR}/bspline_curve-config-version.cmake
  DESTINATION ${package_folder} COMPONENT library)
