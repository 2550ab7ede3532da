# partwise_bundle_pages(bundles PACKAGES folder SCRIPTS script...)
#
# Bundles scripts of pages, each with what it imports from its own and the others' folders and from the npm packages of
# folder/package.json and package-lock.json, and sets `bundles` to the files made: one per script, of the same name.
# Without npm, or without its registry, they are empty, everything else is built all the same, and the build says so.
find_program(NPM_PROGRAM npm)

function(partwise_bundle_pages bundles)
  cmake_parse_arguments(PARSE_ARGV 1 pages "" "PACKAGES" "SCRIPTS")
  set(script ${PROJECT_SOURCE_DIR}/cmake/bundle-pages)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/pages)
  set(sources "")
  set(made "")
  foreach(entry IN LISTS pages_SCRIPTS)
    get_filename_component(name ${entry} NAME)
    list(APPEND made ${folder}/${name})
    get_filename_component(beside ${entry} DIRECTORY)
    file(GLOB imported CONFIGURE_DEPENDS ${beside}/*.js)
    list(APPEND sources ${imported})
  endforeach()
  list(REMOVE_DUPLICATES sources)
  add_custom_command(OUTPUT ${made}
    COMMAND ${script} "${NPM_PROGRAM}" ${pages_PACKAGES} ${folder} ${pages_SCRIPTS}
    DEPENDS ${sources} ${pages_PACKAGES}/package.json ${pages_PACKAGES}/package-lock.json ${script}
    COMMENT "Bundling the pages"
    VERBATIM)
  set(${bundles} ${made} PARENT_SCOPE)
endfunction()
