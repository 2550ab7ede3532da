# The tool hull: its document, its messages.
load meshes.bash

setup() {
  cd "$BATS_TEST_TMPDIR"
  PATH=$PARTWISE_BIN:$PATH
  octahedron >octahedron.ply
  segment octahedron.ply -o octahedron.segment.ply
}

@test "every part has its hull" {
  hull octahedron.segment.ply -o hull.ply
  jq -e '.schema == "partwise/hull-1" and .history[-1].tool == "hull"' hull.json
  jq -e '.metrics.hull.parts == {"whole": {"hull_vertices": 6, "hull_facets": 8, "openings": 0}}' hull.json
}

@test "pipe and file give the same content, each run the same bytes" {
  hull octahedron.segment.ply -o first.ply
  hull octahedron.segment.ply -o second.ply
  cmp first.ply second.ply
  cmp first.json second.json
  segment -q octahedron.ply | hull | map-to-hull -o piped.ply
  map-to-hull first.ply -o filed.ply
  cmp piped.json filed.json
}

@test "a flat part is named" {
  square >square.ply
  segment square.ply -o square.segment.ply
  run hull square.segment.ply -o hull.ply
  [ "$status" -eq 3 ]
  [[ $output == *square.segment.ply*'part "whole"'*"one plane"* ]]
  [ ! -e hull.ply ]
}

@test "a document of another stage is refused with the stage to use" {
  run hull octahedron.ply -o hull.ply
  [ "$status" -eq 3 ]
  [[ $output == *"octahedron.ply"*"mesh"*"segment"* ]]
  [ ! -e hull.ply ]
}

@test "usage" {
  hull --help | grep -q 'hull cat.segment.ply'
  run hull --no-such-option
  [ "$status" -eq 2 ]
}
