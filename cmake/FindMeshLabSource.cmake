# SPDX-License-Identifier: GPL-3.0-or-later
# The headers of MeshLab and vcglib, from checkouts (MESHLAB_SOURCE_DIR, MESHLAB_2022_SOURCE_DIR,
# MESHLAB_2020_SOURCE_DIR) or, where these are empty, from the cache that scripts/fetch_meshlab fills. Defines
#   MeshLab::common       the plugin interface of MESHLAB_SOURCE_DIR (2025.07) with scalars of BSPLINE_CURVE_SCALAR, and
#                         the parts of Qt that its headers need; where the component `plugin` is asked for
#   MeshLab::common_2022  that of MeshLab 2022.02 with float; component `plugin_2022`
#   MeshLab::common_2020  that of MeshLab 2020.09 with float; component `plugin_2020`
#   MeshLabSource_VERSION, MeshLabSource_VCGLIB_DIR, MeshLabSource_COMMON_DIR  of MESHLAB_SOURCE_DIR
set(meshlab_source_cache "$ENV{XDG_CACHE_HOME}")
if(NOT meshlab_source_cache)
  set(meshlab_source_cache "$ENV{HOME}/.cache")
endif()

# Fills the cache with the sources of a version, or ends with what went wrong as a part of the one error.
function(fetch_meshlab_sources version variable)
  execute_process(
    COMMAND "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../scripts/fetch_meshlab" ${version}
    RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE said)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR
      "The headers of MeshLab ${version} and vcglib are not there, and could not be fetched:\n${said}\n"
      "With the network back run it again; else clone MeshLab with its submodules and set ${variable} to the checkout "
      "(pip: --config-settings cmake.define.${variable}=<the checkout>).")
  endif()
endfunction()

# Finds the sources of a version: sets <prefix>_VCGLIB_DIR, <prefix>_COMMON_DIR and <prefix>_VERSION. `variable`: names
# the checkout; `header`: of the plugin interface.
function(find_meshlab_sources prefix version variable header)
  # The place is that of scripts/fetch_meshlab.
  set(source "${meshlab_source_cache}/bspline_curve/meshlab-${version}")
  if(${variable})
    set(source "${${variable}}")
  elseif(NOT EXISTS "${source}/ML_VERSION")
    if(BSPLINE_CURVE_FETCH)
      fetch_meshlab_sources(${version} ${variable})
    else()
      message(FATAL_ERROR
        "The headers of MeshLab ${version} and vcglib are not there.\n"
        "Run scripts/fetch_meshlab ${version} (it downloads 5 to 12 MB from this machine's Debian mirror), or clone "
        "MeshLab with its submodules and configure with -D${variable}=<the checkout>.")
    endif()
  endif()
  # vcglib lies in src/ since MeshLab 2022, beside it before.
  find_path(vcglib vcg/complex/complex.h
    PATHS "${source}/src/vcglib" "${source}/vcglib" NO_DEFAULT_PATH NO_CACHE)
  find_path(common ${header} PATHS "${source}/src" NO_DEFAULT_PATH NO_CACHE)
  if(NOT vcglib)
    message(FATAL_ERROR
      "No vcglib in ${source}: ${variable} must be a checkout of MeshLab with its submodules (git clone --recursive).")
  endif()
  if(EXISTS "${source}/ML_VERSION")
    file(STRINGS "${source}/ML_VERSION" found LIMIT_COUNT 1)
  endif()
  set(${prefix}_VCGLIB_DIR "${vcglib}" PARENT_SCOPE)
  set(${prefix}_COMMON_DIR "${common}" PARENT_SCOPE)
  set(${prefix}_VERSION "${found}" PARENT_SCOPE)
endfunction()

# Defines a target for plugins of the sources that were found as <prefix>_…; a host loads a plugin only where both agree
# on the scalar and on the version, in which "d" marks double.
function(add_meshlab_interface target prefix scalar)
  if(NOT ${prefix}_COMMON_DIR)
    message(FATAL_ERROR "The sources of MeshLab beside ${${prefix}_VCGLIB_DIR} have another plugin interface than ${target}.")
  endif()
  set(version ${${prefix}_VERSION})
  if(scalar STREQUAL double)
    string(APPEND version d)
  endif()
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} SYSTEM INTERFACE "${${prefix}_COMMON_DIR}" "${${prefix}_VCGLIB_DIR}")
  target_compile_definitions(${target} INTERFACE MESHLAB_SCALAR=${scalar} MESHLAB_VERSION=${version})
  target_link_libraries(${target} INTERFACE
    Eigen3::Eigen Qt5::Core Qt5::Gui Qt5::Widgets Qt5::OpenGL Qt5::Xml)
endfunction()

set(modern_interface common/plugins/interfaces/filter_plugin.h)
find_meshlab_sources(MeshLabSource 2025.07 MESHLAB_SOURCE_DIR ${modern_interface})

if(MeshLabSource_FIND_COMPONENTS)
  find_package(Qt5 5.15 REQUIRED COMPONENTS Core Gui Widgets OpenGL Xml)
endif()
if(plugin IN_LIST MeshLabSource_FIND_COMPONENTS AND NOT TARGET MeshLab::common)
  add_meshlab_interface(MeshLab::common MeshLabSource ${BSPLINE_CURVE_SCALAR})
endif()
if(plugin_2022 IN_LIST MeshLabSource_FIND_COMPONENTS AND NOT TARGET MeshLab::common_2022)
  find_meshlab_sources(meshlab_2022 2022.02 MESHLAB_2022_SOURCE_DIR ${modern_interface})
  add_meshlab_interface(MeshLab::common_2022 meshlab_2022 float)
endif()
if(plugin_2020 IN_LIST MeshLabSource_FIND_COMPONENTS AND NOT TARGET MeshLab::common_2020)
  find_meshlab_sources(meshlab_2020 2020.09 MESHLAB_2020_SOURCE_DIR common/interfaces.h)
  add_meshlab_interface(MeshLab::common_2020 meshlab_2020 float)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MeshLabSource
  REQUIRED_VARS MeshLabSource_VCGLIB_DIR VERSION_VAR MeshLabSource_VERSION)
