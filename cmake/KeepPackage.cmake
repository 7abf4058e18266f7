# SPDX-License-Identifier: GPL-3.0-or-later
# keep_package(<result> <folder> <version>): a copy of a package's folder in the build folder, made once for each version. pip
# builds in an environment of its own, which has another path each time; what is compiled from the copy stays as it is.
function(keep_package result folder version)
  cmake_path(GET folder FILENAME name)
  set(kept ${PROJECT_BINARY_DIR}/kept/${name}-${version})
  if(NOT EXISTS ${kept}/complete)
    file(REMOVE_RECURSE ${kept})
    file(COPY ${folder} DESTINATION ${kept} PATTERN __pycache__ EXCLUDE)
    file(TOUCH ${kept}/complete)
  endif()
  set(${result} ${kept}/${name} PARENT_SCOPE)
endfunction()
