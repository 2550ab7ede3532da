# The tool measure: its documents, its tables, its messages.

setup() {
  cd "$BATS_TEST_TMPDIR"
  PATH=$PARTWISE_BIN:$PATH
  mkdir a b
  sample_compatible a/compatible.ply
  sample_compatible b/compatible.ply 0.3
}

@test "figures go to standard output or a file" {
  measure a/compatible.ply >a/stdout.json
  measure a/compatible.ply -o a/measure.json
  cmp a/stdout.json a/measure.json
  jq -e '.schema == "partwise/measure-1" and .source_faces == 800 and .target_faces == 800 and .markers == 1' a/measure.json
  jq -e '.rms_distance < 1e-12 and .max_distance < 1e-12 and .on_surface_max < 1e-12 and .flipped_faces == 0' a/measure.json
  jq -e '.history[-1].tool == "measure" and .one_to_one == false' a/measure.json
}

@test "folds and gaps come from the stages' metrics" {
  measure a/compatible.ply -o a/measure.json
  jq -e '.hull_folds == {"total": 3, "parts": {"whole": 3}, "certified": false} and .boundary_gap_max == 0' a/measure.json
}

@test "a mesh off its target is found out" {
  measure b/compatible.ply -o b/measure.json
  jq -e '.map_gap_max > 0.05 and .on_surface_max > 0.01 and .max_distance > 0.05 and .marker_error_max > 0.05' b/measure.json
  jq -e '.marker_worst == "pole"' b/measure.json
}

@test "the same bytes on every run" {
  measure a/compatible.ply -o first.json
  measure a/compatible.ply -o second.json
  cmp first.json second.json
}

@test "a table is text; with -o the document is written too" {
  run measure a/compatible.ply --table -o a/measure.json
  [ "$status" -eq 0 ]
  [[ $output == *"facets of the source"*800* ]]
  jq -e .rms_distance a/measure.json
  measure a/compatible.ply -o plain.json
  cmp plain.json a/measure.json
}

@test "several inputs make a table with a line each" {
  run measure a/compatible.ply b/compatible.ply --table
  [ "$status" -eq 0 ]
  [ "${#lines[@]}" -eq 3 ]
  [[ ${lines[1]} == a\ * && ${lines[2]} == b\ * ]]
}

@test "a summary has a line per measure document, named by its folder" {
  measure a/compatible.ply -o a/measure.json
  measure b/compatible.ply -o b/measure.json
  run measure --summary a/measure.json b/measure.json
  [ "$status" -eq 0 ]
  [ "${#lines[@]}" -eq 3 ]
  [[ ${lines[1]} == a\ *800* && ${lines[2]} == b\ *800* ]]
}

@test "a summary shows what there is and fails for what is missing" {
  measure a/compatible.ply -o a/measure.json
  run measure --summary a/measure.json c/measure.json
  [ "$status" -eq 4 ]
  [[ $output == *"a "*800* ]]
  [[ $output == *"c/measure.json: cannot be opened"* ]]
}

@test "a summary refuses other files" {
  echo '{"schema": "partwise/measure-1"}' >a/measure.json
  run measure --summary a/measure.json
  [ "$status" -eq 3 ]
  [[ $output == *"a/measure.json"* ]]
  run measure --summary a/compatible.ply
  [ "$status" -eq 3 ]
  [[ $output == *"no JSON"* ]]
}

@test "the true map has no error" {
  measure a/compatible.ply --truth identity -o a/measure.json
  jq -e '.truth.vertices == 402 and .truth.max == 0 and .truth.share_below_05 == 1' a/measure.json
  jq -e '.history[-1].arguments == {"truth": "identity"}' a/measure.json
}

@test "a file of ground truth is read, faults name its line" {
  { echo 1; seq 1 401; } >truth.txt
  measure a/compatible.ply --truth truth.txt -o a/measure.json
  jq -e '.truth.vertices == 402 and .truth.max > 0 and .truth.median == 0' a/measure.json
  { echo x; seq 1 401; } >truth.txt
  run measure a/compatible.ply --truth truth.txt
  [ "$status" -eq 3 ]
  [[ $output == *"truth.txt: line 1"* ]]
  seq 1 10 >truth.txt
  run measure a/compatible.ply --truth truth.txt
  [ "$status" -eq 3 ]
  [[ $output == *"10 lines"*402* ]]
}

@test "the source's connectivity can be checked" {
  measure a/compatible.ply --source b/compatible.ply -o a/measure.json
  jq -e '.connectivity_kept' a/measure.json
}

@test "existing output is kept without --force" {
  echo mine >a/measure.json
  run measure a/compatible.ply -o a/measure.json
  [ "$status" -eq 4 ]
  [ "$(cat a/measure.json)" = mine ]
  measure a/compatible.ply --force -o a/measure.json
  jq -e .schema a/measure.json
}

@test "wrong usage ends with 2" {
  run measure a/compatible.ply b/compatible.ply
  [ "$status" -eq 2 ]
  run measure a/compatible.ply --samples 0
  [ "$status" -eq 2 ]
  run measure a/compatible.ply --no-such-option
  [ "$status" -eq 2 ]
}

@test "inputs that are no compatible mesh end with 3, missing ones with 4" {
  printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >mesh.ply
  run measure mesh.ply
  [ "$status" -eq 3 ]
  [[ $output == *"mesh.ply"*"kind mesh"* ]]
  run measure missing.ply
  [ "$status" -eq 4 ]
  [[ $output == *"missing.ply"* ]]
}

@test "coloured meshes say what their colours mean, and are written for one input" {
  measure b/compatible.ply --distance-colors d.ply --distortion-colors s.ply --fold-colors f.ply -o m.json
  head -c 600 d.ply | grep -a "comment colours: viridis, dark violet at 0 and below, yellow at 0.01 and above, linear"
  head -c 600 s.ply | grep -a "comment quality: symmetric Dirichlet energy"
  convert-mesh f.ply -o f.off
  jq -e '.history[-1].arguments == {}' m.json
  run measure a/compatible.ply b/compatible.ply --table --fold-colors g.ply
  [ "$status" -eq 2 ]
  run measure a/compatible.ply --fold-colors f.ply -o n.json
  [ "$status" -eq 4 ]
}
