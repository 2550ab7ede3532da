# How every target of the project is compiled.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  # What it must know of precompiled headers: https://ccache.dev/manual/4.7.html#_precompiled_headers
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE_PROGRAM})
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
endif()

add_library(partwise_compilation INTERFACE)
target_compile_options(partwise_compilation INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
  $<$<BOOL:${PARTWISE_WARNINGS_AS_ERRORS}>:-Werror>
  # GCC 12 takes "text" + std::string for a copy that overlaps, has no end, or leaves its array (its bug 105651).
  "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict;-Wno-stringop-overflow;-Wno-array-bounds>"
  # The same bytes on every machine: no fused multiply-add the source does not ask for.
  -ffp-contract=off)

set(PARTWISE_SANITIZE "" CACHE STRING "Sanitizers to build with, such as address,undefined or thread")
if(PARTWISE_SANITIZE)
  target_compile_options(partwise_compilation INTERFACE
    -fsanitize=${PARTWISE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
    # A third of the time to compile, for what the address sanitizer and this processor tell or forgive.
    -fno-sanitize=null,alignment,vptr
    # GCC sees values through the sanitizers' code that it takes for uninitialized, in the standard library, too.
    -Wno-maybe-uninitialized)
  target_link_options(partwise_compilation INTERFACE -fsanitize=${PARTWISE_SANITIZE})
endif()
