# SPDX-License-Identifier: GPL-3.0-or-later
# A text file as a C++ string, so that no file is looked for when a program runs:
#   embed_text(<target> <file> <namespace> <name>)
# adds a source to the target that defines `extern const std::string_view <namespace>::<name>`.
set(embed_text_script ${CMAKE_CURRENT_LIST_FILE})

function(embed_text target file namespace name)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  add_custom_command(
    OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -D FILE=${CMAKE_CURRENT_SOURCE_DIR}/${file} -D SOURCE=${source} -D NAMESPACE=${namespace}
            -D NAME=${name} -P ${embed_text_script}
    DEPENDS ${file} ${embed_text_script}
    VERBATIM)
  target_sources(${target} PRIVATE ${source})
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  file(READ ${FILE} text)
  file(WRITE ${SOURCE} "#include <string_view>\n\n// Texts may be long.\n#pragma GCC diagnostic ignored \"-Woverlength-strings\"\n\nnamespace ${NAMESPACE} {\n\nextern const std::string_view ${NAME};\n"
    "const std::string_view ${NAME} = R\"embedded(${text})embedded\";\n\n}  // namespace ${NAMESPACE}\n")
endif()
