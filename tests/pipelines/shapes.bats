# Shapes whose result can be foretold: features that must arrive, open meshes, handles cut open.
load pipelines.bash

setup() {
  cd "$BATS_TEST_TMPDIR"
}

# shape NAME: a mesh of the test builders, as NAME.ply
shape() {
  "$PARTWISE_BIN/sample_mesh" "$1" "$1.ply"
}

# facets NAME
facets() {
  sed -n "s/^element face //p;/end_header/q" "$1.ply"
}

# Eight markers at the corners of a cube with sides of 2 * $1.
corner_markers() {
  jq -n --argjson a "$1" '{schema: "partwise/sketch-1", markers: [
    range(8) | {name: "corner \(.)", point: [(. % 2 * 2 - 1) * $a, ((./2 | floor) % 2 * 2 - 1) * $a, ((./4 | floor) * 2 - 1) * $a]}]}'
}

# Two parts, the halves with negative and with positive x, of a torus around the z axis.
halves() {
  jq -n --argjson r "$1" '{schema: "partwise/sketch-1", parts: [{name: "left", strokes: [{points: [[-3, 0, $r], [-2.2, 2.2, $r], [-2.2, -2.2, $r]]}]},
    {name: "right", strokes: [{points: [[3, 0, $r], [2.2, 2.2, $r], [2.2, -2.2, $r]]}]}],
    markers: [{name: "left outside", point: [(-3 - $r), 0, 0]}, {name: "right outside", point: [(3 + $r), 0, 0]}]}'
}

@test "cube -> bumpy sphere, one part and eight markers: the bumps arrive" {
  shape cube
  shape bumpy-sphere
  corner_markers 1 >cube.sketch.json
  corner_markers 0.577 >bumpy.sketch.json
  cross_parameterize cube.ply cube.sketch.json bumpy-sphere.ply bumpy.sketch.json out
  check_result out "$(facets cube)" "$(facets bumpy-sphere)"
  jq -e '.markers == 8 and .rms_distance < 0.005 and .max_distance < 0.03 and .hull_folds.total == 0' out/measure.json
}

@test "cube -> sphere with 60 bumps, eight markers: they arrive with critical points, and collapse without" {
  shape cube
  shape many-bumps
  corner_markers 1 >cube.sketch.json
  corner_markers 0.577 >bumps.sketch.json
  cross_parameterize cube.ply cube.sketch.json many-bumps.ply bumps.sketch.json out RELOCATE_FLAGS="--refine 0.005"
  jq -e '.max_distance < 0.006 and .one_to_one and .flipped_faces == 0 and .self_intersections.compatible == 0' \
    out/measure.json
  jq -e '.refined_vertices <= 200' out/compatible.json
  # The paper's Fig. 11c and d, by its own scheme.
  for without in "" "--critical-iterations 0"; do
    "$PARTWISE_BIN/relocate" out/critical.ply --method umbrella $without --force -o umbrella.ply
    "$PARTWISE_BIN/measure" umbrella.ply --force -o "figures${without:+-without}.json"
  done
  jq -e '.max_distance < 0.01' figures.json
  jq -e '.max_distance > 0.02' figures-without.json
}

@test "open meshes: boundary on boundary" {
  shape hemisphere
  shape fine-hemisphere
  cross_parameterize hemisphere.ply "" fine-hemisphere.ply "" out
  check_result out "$(facets hemisphere)" "$(facets fine-hemisphere)"
  jq -e '.rms_distance < 0.005 and .flipped_faces == 0 and .hull_folds.total == 0' out/measure.json
  # The rim stays at z = 0.
  "$PARTWISE_BIN/convert-mesh" hemisphere.ply -o before.off
  "$PARTWISE_BIN/convert-mesh" out/compatible.ply -o after.off
  paste -d' ' <(awk 'NF == 3' before.off) <(awk 'NF == 3' after.off) |
    awk 'NR > 1 && $3 == 0 { if ($6 > 1e-9 || $6 < -1e-9) exit 1; ++rim } END { exit rim != 64 }'
}

@test "a torus cut into two parts that meet twice" {
  shape torus
  shape fat-torus
  halves 1 >torus.sketch.json
  halves 1.4 >fat-torus.sketch.json
  cross_parameterize torus.ply torus.sketch.json fat-torus.ply fat-torus.sketch.json out
  check_result out "$(facets torus)" "$(facets fat-torus)"
  jq -e '.rms_distance < 0.01 and .flipped_faces == 0 and .hull_folds.total == 0 and .boundary_gap_max < 1e-9' out/measure.json
  # No sphere holds a torus: each half is certified, and their common boundary is one curve.
  jq -e '.certificate.pieces | length == 2' out/measure.json
  "$PARTWISE_BIN/measure" --certify --require-certificate out/compatible.ply out/crossmap.ply
}

@test "a torus in one part is mapped, but not certified" {
  shape torus
  shape fat-torus
  run cross_parameterize torus.ply "" fat-torus.ply "" out
  [ "$status" -eq 0 ]
  [[ $output == *"not certified one-to-one"*"handle"* ]]
  jq -e '.one_to_one == false and (.certificate.reason | length > 0)' out/measure.json
  run "$PARTWISE_BIN/measure" --certify --require-certificate out/compatible.ply
  [ "$status" -eq 1 ]
}
