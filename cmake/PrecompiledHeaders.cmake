# Headers that most files parse, compiled once for the library, once for the tools and once for the tests: a cold build
# takes half the time. CMAKE_DISABLE_PRECOMPILE_HEADERS=ON builds without them and so finds missing includes.
set(PARTWISE_COMMON_HEADERS
  <algorithm> <array> <cmath> <filesystem> <functional> <limits> <map> <memory> <numeric> <optional> <set> <sstream>
  <string> <utility> <vector>
  <Eigen/Dense> <OpenMesh/Core/Mesh/TriConnectivity.hh> <nlohmann/json.hpp>)

# partwise_precompiled_headers(name HEADERS ... LIBRARIES ...) makes a target that others REUSE_FROM when they link
# partwise::common and, perhaps, LIBRARIES; HEADERS come on top of those the library has.
function(partwise_precompiled_headers name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "HEADERS;LIBRARIES")
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/${name}.cpp CONTENT "")
  add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/${name}.cpp)
  target_link_libraries(${name} PRIVATE partwise::common partwise_compilation ${ARG_LIBRARIES})
  target_precompile_headers(${name} PRIVATE ${PARTWISE_COMMON_HEADERS} ${ARG_HEADERS})
endfunction()
