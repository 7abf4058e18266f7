# SPDX-License-Identifier: GPL-3.0-or-later
# What all targets of this tree share and those that link the library do not get: warnings, the root of the tree as an
# include path, and results that do not depend on how the compiler contracts multiply-adds.
add_library(bspline_curve_build_options INTERFACE)
target_include_directories(bspline_curve_build_options INTERFACE ${PROJECT_SOURCE_DIR})
if(MSVC)  # untested
  target_compile_options(bspline_curve_build_options INTERFACE
    /fp:precise /utf-8 /bigobj /W3 $<$<BOOL:${BSPLINE_CURVE_WERROR}>:/WX>)
else()
  target_compile_options(bspline_curve_build_options INTERFACE
    -ffp-contract=off
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Wcast-align -Woverloaded-virtual
    -Wconversion -Wdouble-promotion -Wformat=2
    $<$<CXX_COMPILER_ID:Clang,AppleClang>:-Wno-sign-conversion>  # g++ has it apart from -Wconversion
    $<$<BOOL:${BSPLINE_CURVE_WEB}>:-Wno-shorten-64-to-32>  # sizes have 32 bits there alone
    $<$<BOOL:${BSPLINE_CURVE_WERROR}>:-Werror>)
endif()
