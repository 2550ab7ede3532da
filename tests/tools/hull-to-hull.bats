# The tool hull-to-hull: two hull maps in, one crossmap out; what does not fit together is named.

load setup

# A ball's hull maps from strokes on its two sides and a further line of the sketch:
# hull_map <name> <n> <part> <other part> [markers]
hull_map() {
  sphere "$2" "$1.off"
  cat > "$1.sketch.json" <<END
{"schema": "partwise/sketch-1",
 "parts": [{"name": "$3", "strokes": [{"points": [[1, 0, 0], [0.7, 0, 0.7], [0.7, 0.7, 0]]}]},
           {"name": "$4", "strokes": [{"points": [[-1, 0, 0], [-0.7, 0, 0.7], [-0.7, 0.7, 0]]}]}],
 "markers": [${5:-}]}
END
  convert-mesh "$1.off" | segment --sketch "$1.sketch.json" -q | hull -o "$1.hull.ply"
  map-to-hull -q "$1.hull.ply" -o "$1.ply"
}

@test "maps one model's parts onto the other's hulls" {
  hull_map source 6 front back
  hull_map target 8 front back
  run hull-to-hull -q source.ply target.ply -o crossmap.ply --require-certificate
  expect_code 0
  [ -z "$output" ]
  jq -e '.schema == "partwise/crossmap-1" and (.history | length > 1)' crossmap.json
  jq -e '.metrics["hull-to-hull"] | .one_to_one and .folds == 0 and (.parts | length == 2)' crossmap.json
  jq -e '.metrics["hull-to-hull"].parts | keys == ["back", "front"]' crossmap.json
}

@test "the same bytes on every run, by files and by pipes" {
  hull_map source 6 front back
  hull_map target 8 front back
  hull-to-hull -q source.ply target.ply -o first.ply
  hull-to-hull -q source.ply target.ply -o second.ply
  cmp first.ply second.ply
  cmp first.json second.json
  hull-to-hull -q source.ply target.ply > first.pipe
  hull-to-hull -q <(map-to-hull -q source.hull.ply) target.ply > second.pipe
  cmp first.pipe second.pipe
}

@test "the paper's energy is in the history" {
  hull_map source 6 front back
  hull_map target 8 front back
  hull-to-hull -q --method energy source.ply target.ply -o crossmap.ply
  jq -e '.history[-1].arguments.method == "energy"' crossmap.json
}

@test "different parts are refused by name" {
  hull_map source 6 front back
  hull_map target 6 front tail
  run hull-to-hull source.ply target.ply -o crossmap.ply
  expect_code 3
  expect_text "source.ply and target.ply"
  expect_text "'back'"
  expect_text "'tail'"
  expect_text "segment --check"
  [ ! -e crossmap.ply ]
}

@test "a marker on one side only is a warning" {
  hull_map source 6 front back '{"name": "tip", "point": [1, 0, 0]}, {"name": "lost", "point": [0.7, 0, 0.7]}'
  hull_map target 8 front back '{"name": "tip", "point": [1, 0, 0]}'
  run hull-to-hull source.ply target.ply -o crossmap.ply
  expect_code 0
  expect_text "marker 'lost' only on the source"
  jq -e '.markers | map(.name) == ["tip"]' crossmap.json
  jq -e '.metrics["hull-to-hull"].marker_distances.tip < 1e-9' crossmap.json
}

@test "a marker in different parts is a warning with their names" {
  hull_map source 6 front back '{"name": "tip", "point": [1, 0, 0]}'
  hull_map target 8 front back '{"name": "tip", "point": [-1, 0, 0]}'
  run hull-to-hull source.ply target.ply -o crossmap.ply
  expect_code 0
  expect_text "marker 'tip' lies in part 'front' of the source but in part 'back' of the target"
}

@test "a part without a certificate is named, and refused when one is required" {
  load meshes
  torus 24 12 > torus.ply
  segment -q torus.ply | hull -q | map-to-hull -q > ring.ply
  run hull-to-hull ring.ply ring.ply -o crossmap.ply
  expect_code 0
  expect_text 'not certified one-to-one: part "whole" has a handle: cut it into two parts'
  jq -e '.metrics["hull-to-hull"] | (.one_to_one | not) and .parts.whole.euler_characteristic == 0' crossmap.json
  run hull-to-hull ring.ply ring.ply -o none.ply --require-certificate
  expect_code 1
  expect_text 'part "whole"'
  [ ! -e none.ply ]
}

@test "documents of another kind are refused" {
  hull_map source 6 front back
  convert-mesh source.off -o mesh.ply
  run hull-to-hull source.ply mesh.ply -o crossmap.ply
  expect_code 3
  expect_text "mesh.ply"
  [ ! -e crossmap.ply ]
}
