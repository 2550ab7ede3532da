# The tool relocate: a cube on a bumpy sphere, 8 markers, as in the paper's Fig. 11.

setup() {
  cd "$BATS_TEST_TMPDIR"
  PATH=$PARTWISE_BIN:$PATH
  sample_crossmap cross.ply
  reconstruct cross.ply -o compatible.ply
  critical-points compatible.ply -o critical.ply
}

@test "it brings the mesh nearer to the target and leaves no vertex off it" {
  relocate critical.ply -o relocated.ply
  measure compatible.ply -o before.json
  measure relocated.ply -o after.json
  jq -e '.on_surface_max < 1e-12 and .flipped_faces == 0 and .marker_error_max < 1e-12' after.json
  jq -s -e '.[0].rms_distance > 2 * .[1].rms_distance' before.json after.json
  jq -e '.metrics.relocate | .critical_points_reached > 5 and .rounds >= 1 and .fit_moves > 0' relocated.json
}

@test "a map that is one-to-one stays so" {
  relocate critical.ply --require-certificate -o relocated.ply
  jq -e '.metrics.relocate | .one_to_one and .charts[0].folds == 0' relocated.json
  measure --certify --require-certificate relocated.ply
  measure relocated.ply -o before.json
  jq -e '.one_to_one' before.json
}

@test "without a certified start, relocate says so" {
  reconstruct cross.ply --leave-folds | critical-points -o left.ply
  run relocate left.ply -o relocated.ply
  [ "$status" -eq 0 ]
  [[ $output == *"not certified one-to-one"* ]]
  run relocate left.ply --require-certificate -o never.ply
  [ "$status" -eq 1 ]
  [ ! -e never.ply ]
}

@test "every step can be switched off" {
  relocate critical.ply --critical-iterations 0 --rounds 0 --relax-iterations 0 --registration-steps 0 --relax-sweeps 0 --gap-rounds 0 --fit-rounds 0 --fit-far-rounds 0 --unfold-sweeps 0 -o same.ply
  measure critical.ply -o before.json
  measure same.ply -o after.json
  [ "$(jq '[.rms_distance, .max_distance]' before.json)" = "$(jq '[.rms_distance, .max_distance]' after.json)" ]
}

@test "the three stages work in a pipe" {
  reconstruct cross.ply | critical-points | relocate -o piped.ply
  relocate critical.ply -o filed.ply
  cmp piped.ply filed.ply
}

@test "the same bytes on every run" {
  relocate critical.ply -o first.ply
  relocate critical.ply -o second.ply
  cmp first.ply second.ply
}

@test "wrong usage ends with 2, the wrong document with 3" {
  run relocate critical.ply --lambda 2
  [ "$status" -eq 2 ]
  run relocate critical.ply --rounds -1
  [ "$status" -eq 2 ]
  run relocate critical.ply --gap-threshold 0
  [ "$status" -eq 2 ]
  run relocate cross.ply
  [ "$status" -eq 3 ]
  [[ $output == *"cross.ply"* ]]
}

@test "--refine adds vertices until both surfaces are that near, and says how many" {
  relocate critical.ply --refine 0.004 --refine-limit 1 --require-certificate -o refined.ply
  measure refined.ply -o after.json
  jq -e '.max_distance < 0.0044 and .one_to_one and .on_surface_max < 1e-12' after.json
  [ "$(jq .metrics.relocate.refined_vertices refined.json)" -gt 0 ]
  [ "$(jq .metrics.relocate.refined_vertices refined.json)" = "$(jq .refined_vertices refined.json)" ]
  measure --certify --require-certificate refined.ply
  relocate critical.ply --refine 0.004 --refine-limit 1 -o again.ply
  cmp refined.ply again.ply
}

@test "--refine stops at its limit with a warning" {
  run relocate critical.ply --refine 0.0001 --refine-limit 0.05 -o refined.ply
  [ "$status" -eq 0 ]
  [[ $output == *"apart after adding 19 vertices"* ]]
}

@test "the paper's own scheme by option, certified only when it happens to be" {
  relocate critical.ply --method umbrella -o umbrella.ply
  measure umbrella.ply -o figures.json
  jq -e '.on_surface_max < 1e-12 and .marker_error_max < 1e-12' figures.json
  [ "$(jq .one_to_one figures.json)" = "$(jq .metrics.relocate.one_to_one umbrella.json)" ]
  jq -e '.history[-1].arguments.method == "umbrella"' umbrella.json
  run relocate critical.ply --method spring -o no.ply
  [ "$status" -eq 2 ]
}
