# Man pages partwise-TOOL.1, made at installation from what the tools say with --help.
find_program(HELP2MAN_PROGRAM help2man)

function(partwise_install_man_pages)
  if(NOT HELP2MAN_PROGRAM)
    message(STATUS "No help2man: man pages are left out")
    return()
  endif()
  set(pages)
  foreach(tool IN LISTS ARGN)
    set(page ${PROJECT_BINARY_DIR}/man/partwise-${tool}.1)
    add_custom_command(OUTPUT ${page}
      COMMAND ${PROJECT_SOURCE_DIR}/cmake/write-man-page ${HELP2MAN_PROGRAM} $<TARGET_FILE:${tool}> ${page}
      DEPENDS ${tool} ${PROJECT_SOURCE_DIR}/cmake/write-man-page
      VERBATIM)
    list(APPEND pages ${page})
  endforeach()
  add_custom_target(man_pages DEPENDS ${pages})
  install(CODE "execute_process(COMMAND \"${CMAKE_COMMAND}\" --build \"${PROJECT_BINARY_DIR}\" --target man_pages
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)")
  install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
endfunction()
