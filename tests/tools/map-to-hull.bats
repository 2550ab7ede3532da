# The tool map-to-hull: its document, its options, its messages; a real mesh when there is one.
load meshes.bash

setup() {
  cd "$BATS_TEST_TMPDIR"
  PATH=$PARTWISE_BIN:$PATH
}

hulled() { # hulled MESH: MESH.hull.ply from MESH.ply, as one part
  segment -q "$1.ply" | hull -o "$1.hull.ply"
}

@test "the map is one-to-one and says how good it is" {
  octahedron >octahedron.ply
  hulled octahedron
  map-to-hull octahedron.hull.ply -o map.ply --require-certificate
  jq -e '.schema == "partwise/hullmap-1" and .history[-1].tool == "map-to-hull"' map.json
  jq -e '.metrics["map-to-hull"] | .one_to_one and .folds == 0' map.json
  jq -e '.metrics["map-to-hull"].parts.whole | .method == "progressive" and .facets == 8 and .distortion < 1.01' map.json
}

@test "the energy of the paper by option, with its weights in the history" {
  octahedron >octahedron.ply
  hulled octahedron
  map-to-hull octahedron.hull.ply -o map.ply --method energy --laplacian uniform --steps 4
  jq -e '.metrics["map-to-hull"].parts.whole | .method == "energy" and .folds == 0 and .folds_before_repair == 0' map.json
  jq -e '.history[-1].arguments | .method == "energy" and .laplacian == "uniform"' map.json
  map-to-hull octahedron.hull.ply -o closest.ply --method energy --fitting closest-point
  jq -e '.history[-1].arguments.fitting == "closest-point"' closest.json
  for wrong in "--method fast" "--fitting nearest" "--laplacian cotangent" "--steps -1" "--global-weight 0"; do
    run map-to-hull octahedron.hull.ply -o no.ply $wrong
    [ "$status" -eq 2 ]
  done
  [ ! -e no.ply ]
}

@test "a part with a handle runs, is warned of, and is not called one-to-one" {
  torus 24 12 >torus.ply
  hulled torus
  run map-to-hull torus.hull.ply -o map.ply
  [ "$status" -eq 0 ]
  [[ $output == *'warning: not certified one-to-one: part "whole" has 1 handle'*decompose* ]]
  jq -e '.metrics["map-to-hull"].parts.whole.euler_characteristic == 0' map.json
  run map-to-hull torus.hull.ply -o none.ply --require-certificate
  [ "$status" -eq 1 ]
  [[ $output == *'part "whole" has 1 handle'*decompose* ]]
  [ ! -e none.ply ]
  jq -e '.metrics["map-to-hull"] | (.one_to_one | not) and .parts.whole.method == "energy"' map.json
}

@test "a document of another stage is refused with the stage to use" {
  octahedron >octahedron.ply
  segment -q octahedron.ply -o octahedron.segment.ply
  run map-to-hull octahedron.segment.ply -o map.ply
  [ "$status" -eq 3 ]
  [[ $output == *octahedron.segment.ply*segment*hull* ]]
  [ ! -e map.ply ]
}

@test "the cat's parts map one-to-one, the same bytes on one thread and on all" {
  [ -n "${PARTWISE_REFERENCE_DATA:-}" ] || skip "PARTWISE_REFERENCE_DATA is not set"
  segment -q "$PARTWISE_REFERENCE_DATA/meshes/cat-reference.ply" \
    --sketch "$PARTWISE_REFERENCE_DATA/sketches/cat.sketch.json" | hull -o cat.hull.ply
  for method in progressive lifted energy; do
    map-to-hull -q cat.hull.ply --method $method -o all.$method.ply
    taskset -c 0 map-to-hull -q cat.hull.ply --method $method -o one.$method.ply
    cmp all.$method.ply one.$method.ply
    cmp all.$method.json one.$method.json
  done
  jq -e '.metrics["map-to-hull"] | .one_to_one and .folds == 0 and ([.parts[].distortion] | max < 2)' all.progressive.json
  jq -e '.metrics["map-to-hull"] | .one_to_one and ([.parts[].method] | unique == ["lifted"])' all.lifted.json
  jq -e '.metrics["map-to-hull"] | .folds < 150' all.energy.json
}
