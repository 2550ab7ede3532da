# What `cmake --install` brings: the tools into libexec/partwise, one command `partwise` onto the path.
set(tools_folder ${CMAKE_INSTALL_LIBEXECDIR}/partwise)
set(share_folder ${CMAKE_INSTALL_DATADIR}/partwise)

include(cmake/ManPages.cmake)

# Every executable that tools/ builds.
function(partwise_collect_executables folder result)
  get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  set(executables)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL "EXECUTABLE")
      list(APPEND executables ${target})
    endif()
  endforeach()
  foreach(subfolder IN LISTS folders)
    partwise_collect_executables(${subfolder} deeper)
    list(APPEND executables ${deeper})
  endforeach()
  set(${result} ${executables} PARENT_SCOPE)
endfunction()

partwise_collect_executables(${PROJECT_SOURCE_DIR}/tools tools)
if(tools)
  install(TARGETS ${tools} RUNTIME DESTINATION ${tools_folder})
  partwise_install_man_pages(${tools})
endif()

# The command finds the rest from where it lies itself, so an installation may be moved as a whole.
file(RELATIVE_PATH PARTWISE_TOOLS_FROM_BIN /prefix/${CMAKE_INSTALL_BINDIR} /prefix/${tools_folder})
file(RELATIVE_PATH PARTWISE_SHARE_FROM_BIN /prefix/${CMAKE_INSTALL_BINDIR} /prefix/${share_folder})
configure_file(${PROJECT_SOURCE_DIR}/tools/partwise.sh.in ${PROJECT_BINARY_DIR}/partwise @ONLY
  FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
install(PROGRAMS ${PROJECT_BINARY_DIR}/partwise DESTINATION ${CMAKE_INSTALL_BINDIR})

install(DIRECTORY pipelines DESTINATION ${share_folder} USE_SOURCE_PERMISSIONS)
install(DIRECTORY schemas DESTINATION ${share_folder} OPTIONAL)
install(FILES README.md LICENSE CHANGELOG.md CONTRIBUTING.md DESTINATION ${CMAKE_INSTALL_DOCDIR} OPTIONAL)
