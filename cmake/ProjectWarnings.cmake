# SPDX-License-Identifier: GPL-3.0-or-later
add_library(project_warnings INTERFACE)
target_compile_options(project_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Wcast-align -Woverloaded-virtual
  -Wconversion -Wdouble-promotion -Wformat=2
  $<$<BOOL:${BSPLINE_CURVE_WERROR}>:-Werror>)
