# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the library for find_package(bspline_curve), target bspline_curve::bspline_curve, and for pkg-config.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/bspline_curve)
set(pkgconfig_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# In the order in which a linker needs them.
set(archives bspline_curve_sketch bspline_curve_workpiece bspline_curve_field bspline_curve_core)
set(required eigen3)
set(finds "")
if(TARGET bspline_curve_io)
  list(PREPEND archives bspline_curve_io)
  list(APPEND required tinyxml2)
  string(APPEND finds "find_dependency(tinyxml2)\n")
  get_target_property(io_links bspline_curve_io LINK_LIBRARIES)
  if("Freetype::Freetype" IN_LIST io_links)
    list(APPEND required freetype2)
    string(APPEND finds "find_dependency(Freetype)\n")
  endif()
else()
  set(without_files REGEX "/(atomic_file|files|whole_shell)\\.h$" EXCLUDE)
endif()
foreach(archive IN LISTS archives)
  string(REPLACE bspline_curve_ "" name ${archive})
  set_target_properties(${archive} PROPERTIES EXPORT_NAME ${name})
  string(APPEND link_flags " -l${archive}")
endforeach()
set_target_properties(bspline_curve_library PROPERTIES EXPORT_NAME bspline_curve)

install(TARGETS ${archives} bspline_curve_library EXPORT bspline_curve-targets ARCHIVE COMPONENT library)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ ${PROJECT_BINARY_DIR}/include/
  TYPE INCLUDE COMPONENT library FILES_MATCHING PATTERN *.h ${without_files})
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

# Places are said relative to that of the file, so that an installation may be moved.
cmake_path(RELATIVE_PATH CMAKE_INSTALL_FULL_LIBDIR BASE_DIRECTORY ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig
  OUTPUT_VARIABLE library_from_file)
cmake_path(RELATIVE_PATH CMAKE_INSTALL_FULL_INCLUDEDIR BASE_DIRECTORY ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig
  OUTPUT_VARIABLE headers_from_file)
list(JOIN required ", " required)
configure_file(${CMAKE_CURRENT_LIST_DIR}/bspline_curve.pc.in ${PROJECT_BINARY_DIR}/bspline_curve.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/bspline_curve.pc DESTINATION ${pkgconfig_folder} COMPONENT library)
