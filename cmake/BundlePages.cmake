# partwise_bundle_pages(bundles SOURCES folder SCRIPTS script...)
#
# Bundles scripts of pages, each with what it imports from `folder` and from the npm packages of folder/package.json
# and package-lock.json, and sets `bundles` to the files made: one per script, of the same name. Without npm, or without
# its registry, they are empty, everything else is built all the same, and the build says so.
find_program(NPM_PROGRAM npm)

function(partwise_bundle_pages bundles)
  cmake_parse_arguments(PARSE_ARGV 1 pages "" "SOURCES" "SCRIPTS")
  set(script ${PROJECT_SOURCE_DIR}/cmake/bundle-pages)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/pages)
  file(GLOB sources CONFIGURE_DEPENDS ${pages_SOURCES}/*.js)
  set(made ${pages_SCRIPTS})
  list(TRANSFORM made PREPEND ${folder}/)
  add_custom_command(OUTPUT ${made}
    COMMAND ${script} "${NPM_PROGRAM}" ${pages_SOURCES} ${folder} ${pages_SCRIPTS}
    DEPENDS ${sources} ${pages_SOURCES}/package.json ${pages_SOURCES}/package-lock.json ${script}
    COMMENT "Bundling the pages of ${pages_SOURCES}"
    VERBATIM)
  set(${bundles} ${made} PARENT_SCOPE)
endfunction()
