# SPDX-License-Identifier: GPL-3.0-or-later
# Modules that MeshLab loads:
#   add_meshlab_plugin(<target> <interface> <sources>...)
# `interface`: of cmake/FindMeshLabSource.cmake, MeshLab::common…

# The host brings MeshLab's common library. To link without one, an empty library of the same name stands in for it;
# the plugin only records that it needs the name.
if(NOT TARGET meshlab_common_stub)
  set(stub_source ${CMAKE_BINARY_DIR}/stub/meshlab_common_stub.cpp)
  file(CONFIGURE OUTPUT ${stub_source} CONTENT "// Empty: only the name of this library is used.\n")
  add_library(meshlab_common_stub SHARED ${stub_source})
  set_target_properties(meshlab_common_stub PROPERTIES
    OUTPUT_NAME meshlab-common
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/stub)
endif()

function(add_meshlab_plugin target interface)
  add_library(${target} MODULE ${ARGN})
  set_target_properties(${target} PROPERTIES AUTOMOC ON SKIP_BUILD_RPATH ON)
  # AUTOMOC's headers are not ours.
  set_property(TARGET ${target} PROPERTY AUTOGEN_USE_SYSTEM_INCLUDE ON)
  target_link_libraries(${target} PRIVATE ${interface} bspline_curve_build_options)
  # Without --no-as-needed the linker drops the empty library, and the host finds undefined symbols.
  target_link_libraries(${target} PRIVATE -Wl,--no-as-needed meshlab_common_stub -Wl,--as-needed)
endfunction()
