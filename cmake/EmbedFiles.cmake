# partwise_embed(target HEADER header FUNCTION name FILES file...)
#
# Makes the text of files part of a target, so that a tool needs no files when it runs. `header` is C++ of ours, as the
# target's sources include it, such as io/embedded_schemas.h. It declares, in a namespace partwise::<the header's folder>,
#   const std::map<std::string, const char*>& name();
# and this defines it: from file names without their folders to texts. Files may be made by commands of the folder that
# calls; those that are empty then (scripts that could not be bundled) are left out.
function(partwise_embed target)
  cmake_parse_arguments(PARSE_ARGV 1 embed "" "HEADER;FUNCTION" "FILES")
  set(script ${PROJECT_SOURCE_DIR}/cmake/write-embedded-files.cmake)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${embed_FUNCTION}.cpp)
  add_custom_command(OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${source} -DHEADER=${embed_HEADER} -DFUNCTION=${embed_FUNCTION}
            "-DFILES=${embed_FILES}" -P ${script}
    DEPENDS ${embed_FILES} ${script}
    VERBATIM)
  # The target may be of another folder: it learns of the command through a target of this one.
  add_custom_target(partwise_${embed_FUNCTION} DEPENDS ${source})
  add_dependencies(${target} partwise_${embed_FUNCTION})
  target_sources(${target} PRIVATE ${source})
endfunction()
