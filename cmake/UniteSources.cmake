# SPDX-License-Identifier: GPL-3.0-or-later
# The sources of one folder, compiled as one: headers are read and templates instantiated once, in about half of the
# time. Names in unnamed namespaces then have to differ within a folder. By folder, and not by count as CMake does it
# alone, so that a new file changes no other folder.
#   unite_sources_of_folders(<target> [HOT_LOOPS])  # call it after all sources were added
# HOT_LOOPS: g++ inlines less in large units, and hot loops would take up to a seventh more instructions; not here.
option(BSPLINE_CURVE_UNITE "Compile the sources of a folder as one" ON)

function(unite_sources_of_folders target)
  if(NOT BSPLINE_CURVE_UNITE)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  if("HOT_LOOPS" IN_LIST ARGN)
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:--param=large-unit-insns=1000000>)
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    cmake_path(ABSOLUTE_PATH source NORMALIZE)
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE folder)
    cmake_path(GET folder PARENT_PATH folder)
    string(MAKE_C_IDENTIFIER "${folder}" group)
    set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${group})
  endforeach()
endfunction()
