# The tool reconstruct: from a cross map to a compatible mesh.

setup() {
  cd "$BATS_TEST_TMPDIR"
  PATH=$PARTWISE_BIN:$PATH
  sample_crossmap cross.ply
}

@test "every vertex lies on the target, the connectivity is the source's" {
  reconstruct cross.ply -o compatible.ply
  measure compatible.ply -o measure.json
  jq -e '.on_surface_max < 1e-12 and .source_faces == 768 and .target_faces == 1568' measure.json
  jq -e '.flipped_faces == 0 and .connectivity_kept != false' measure.json
  jq -e '.schema == "partwise/compatible-1" and .history[-1].tool == "reconstruct"' compatible.json
  jq -e '.metrics.reconstruct | .vertices == 386 and .ambiguous == 0 and .boundary_gap_max == 0' compatible.json
}

@test "the map is certified one-to-one, and the document proves it" {
  reconstruct cross.ply --require-certificate -o compatible.ply
  jq -e '.metrics.reconstruct | .one_to_one and .charts[0].folds == 0' compatible.json
  jq -e '.charts | length == 1' compatible.json
  run measure --certify --require-certificate compatible.ply
  [ "$status" -eq 0 ]
  [[ $output == *"compatible.ply: certified one-to-one"*"source: 768 facets, 0 folded, Euler 2, degree 1"* ]]
}

@test "folds can be left, and then nothing is certified" {
  reconstruct cross.ply --leave-folds -o left.ply
  jq -e '.charts == []' left.json
  run measure --certify left.ply
  [ "$status" -eq 0 ]
  [[ $output == *"not certified"* ]]
  run measure --require-certificate left.ply --table
  [ "$status" -eq 1 ]
}

@test "a gap between two parts' maps is reported" {
  sample_crossmap halves.ply halves
  reconstruct halves.ply -o compatible.ply
  jq -e '.metrics.reconstruct.boundary_gap_max | . > 0 and . < 0.1' compatible.json
}

@test "pipe and files give the same bytes, every time" {
  reconstruct cross.ply -o first.ply
  reconstruct cross.ply -o second.ply
  cmp first.ply second.ply
  cmp first.json second.json
  reconstruct cross.ply >piped.ply
  measure piped.ply -o piped.json
  measure first.ply -o filed.json
  [ "$(jq .rms_distance piped.json)" = "$(jq .rms_distance filed.json)" ]
}

@test "the paper's coordinates are averages, projected to the target" {
  for mode in convex-hull mean-value; do
    reconstruct cross.ply --coordinates $mode -o $mode.ply
    jq -e '.metrics.reconstruct.largest_projection > 0' $mode.json
    jq -e ".history[-1].arguments == {\"coordinates\": \"$mode\"}" $mode.json
    measure $mode.ply --force -o measure.json
    jq -e '.on_surface_max < 1e-12 and .rms_distance < 0.02' measure.json
  done
}

@test "wrong usage ends with 2, the wrong document with 3 and a word about the stage" {
  run reconstruct cross.ply --coordinates nearest
  [ "$status" -eq 2 ]
  run reconstruct cross.ply --radius -1
  [ "$status" -eq 2 ]
  reconstruct cross.ply -o compatible.ply
  run reconstruct compatible.ply -o again.ply
  [ "$status" -eq 3 ]
  [[ $output == *"compatible.ply"*"hull-to-hull"* ]]
  [ ! -e again.ply ]
}
