# The tool critical-points: on the target of a compatible mesh, and on a mesh alone.

setup() {
  cd "$BATS_TEST_TMPDIR"
  PATH=$PARTWISE_BIN:$PATH
  sample_crossmap cross.ply
  reconstruct cross.ply -o compatible.ply
}

@test "a compatible mesh gets its target's critical points and keeps all else" {
  critical-points compatible.ply -o critical.ply
  jq -e '.schema == "partwise/compatible-1" and (.history | length) == 2' critical.json
  jq -e '.metrics["critical-points"].critical_points | . > 6 and . <= 38' critical.json
  jq -e '.metrics.reconstruct.vertices == 386 and (.markers | length) == 8' critical.json
}

@test "their number can be bounded" {
  critical-points compatible.ply --count 6 -o six.ply
  jq -e '.metrics["critical-points"] | .critical_points == 6 and .radius_scale > 1' six.json
  grep -a -q "element critical_point 6" six.ply
}

@test "a mesh alone gets a table of its own" {
  {
    printf 'ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n'
    printf 'element face 4\nproperty list uchar int vertex_indices\nend_header\n'
    printf '1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n'
  } >solid.ply
  critical-points solid.ply --fraction 1 -o critical.ply
  jq -e '.schema == "partwise/mesh-1" and .metrics["critical-points"].critical_points >= 1' critical.json
  grep -a -q "element critical_point" critical.ply
  grep -a -q "property list int int region" critical.ply
}

@test "wrong usage ends with 2, the wrong document with 3" {
  run critical-points compatible.ply --fraction 2
  [ "$status" -eq 2 ]
  run critical-points compatible.ply --fraction 0
  [ "$status" -ne 0 ]
  run critical-points cross.ply
  [ "$status" -eq 3 ]
  [[ $output == *"cross.ply"* ]]
}
