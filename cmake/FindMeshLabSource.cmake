# SPDX-License-Identifier: GPL-3.0-or-later
# The headers of MeshLab and vcglib, from the checkout MESHLAB_SOURCE_DIR or, where that is empty, from the cache that
# scripts/fetch_meshlab fills. Defines
#   MeshLab::vcglib   vcglib, headers only
#   MeshLab::common   MeshLab's plugin interface with double scalars, and the parts of Qt that its headers need;
#                     only where the component `plugin` is asked for
#   MeshLabSource_VERSION
set(meshlab_source_cache "$ENV{XDG_CACHE_HOME}")
if(NOT meshlab_source_cache)
  set(meshlab_source_cache "$ENV{HOME}/.cache")
endif()
# The version and the place are those of scripts/fetch_meshlab.
set(meshlab_source "${meshlab_source_cache}/bspline_curve/meshlab-2025.07")
if(MESHLAB_SOURCE_DIR)
  set(meshlab_source "${MESHLAB_SOURCE_DIR}")
elseif(NOT EXISTS "${meshlab_source}/ML_VERSION")
  message(FATAL_ERROR
    "The headers of MeshLab and vcglib are not there.\n"
    "Run scripts/fetch_meshlab (it downloads 5 MB from this machine's Debian mirror), or clone MeshLab with its "
    "submodules and configure with -DMESHLAB_SOURCE_DIR=<the checkout>.")
endif()

# vcglib lies in src/ since MeshLab 2022, beside it before.
find_path(MeshLabSource_VCGLIB_DIR vcg/complex/complex.h
  PATHS "${meshlab_source}/src/vcglib" "${meshlab_source}/vcglib" NO_DEFAULT_PATH NO_CACHE)
find_path(MeshLabSource_COMMON_DIR common/plugins/interfaces/filter_plugin.h
  PATHS "${meshlab_source}/src" NO_DEFAULT_PATH NO_CACHE)
if(EXISTS "${meshlab_source}/ML_VERSION")
  file(STRINGS "${meshlab_source}/ML_VERSION" MeshLabSource_VERSION LIMIT_COUNT 1)
endif()
if(NOT MeshLabSource_VCGLIB_DIR)
  message(FATAL_ERROR
    "No vcglib in ${meshlab_source}: MESHLAB_SOURCE_DIR must be a checkout of MeshLab with its submodules "
    "(git clone --recursive).")
endif()

if(NOT TARGET MeshLab::vcglib)
  add_library(MeshLab::vcglib INTERFACE IMPORTED)
  target_include_directories(MeshLab::vcglib SYSTEM INTERFACE "${MeshLabSource_VCGLIB_DIR}")
  target_link_libraries(MeshLab::vcglib INTERFACE Eigen3::Eigen)
endif()

if(plugin IN_LIST MeshLabSource_FIND_COMPONENTS AND NOT TARGET MeshLab::common)
  if(NOT MeshLabSource_COMMON_DIR)
    message(FATAL_ERROR "${meshlab_source} has no plugin interface of MeshLab 2022.02 or later.")
  endif()
  find_package(Qt5 5.15 REQUIRED COMPONENTS Core Gui Widgets OpenGL Xml)
  add_library(MeshLab::common INTERFACE IMPORTED)
  target_include_directories(MeshLab::common SYSTEM INTERFACE "${MeshLabSource_COMMON_DIR}")
  # A host loads a plugin only where both agree on the scalar and on the version; "d" marks double.
  target_compile_definitions(MeshLab::common INTERFACE MESHLAB_SCALAR=double MESHLAB_VERSION=${MeshLabSource_VERSION}d)
  target_link_libraries(MeshLab::common INTERFACE
    MeshLab::vcglib Qt5::Core Qt5::Gui Qt5::Widgets Qt5::OpenGL Qt5::Xml)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MeshLabSource
  REQUIRED_VARS MeshLabSource_VCGLIB_DIR VERSION_VAR MeshLabSource_VERSION)
