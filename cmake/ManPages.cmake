# Man pages partwise-TOOL.1, made from what the tools say with --help.
# man_pages(TARGET...) adds their making to the build when help2man is there.
find_program(HELP2MAN_PROGRAM help2man)

function(man_pages)
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
  add_custom_target(man_pages ALL DEPENDS ${pages})
  install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
endfunction()
