# SPDX-License-Identifier: GPL-3.0-or-later
# The headers lie in the runtime's include/, which the toolchain searches. Debian's own package names /usr/include, where
# headers of this machine's C library would be found first.
if(NOT TARGET nlohmann_json::nlohmann_json)
  add_library(nlohmann_json::nlohmann_json INTERFACE IMPORTED)
endif()
