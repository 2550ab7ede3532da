# For the tests of whole jobs: real tools, real or generated meshes.

pipelines=$(cd "$BATS_TEST_DIRNAME/../../pipelines" && pwd)
sketches=$pipelines/sketches
unset MAKEFLAGS MAKELEVEL MFLAGS

# Meshes of Debian's package libcgal-demo, by name.
demo_mesh() {
  [ -n "${PARTWISE_DEMO_MESHES:-}" ] || skip "PARTWISE_DEMO_MESHES names no folder with the demo meshes"
  echo "$PARTWISE_DEMO_MESHES/$1.off"
}

reference_mesh() {
  [ -n "${PARTWISE_REFERENCE_DATA:-}" ] || skip "PARTWISE_REFERENCE_DATA names no folder with the reference meshes"
  echo "$PARTWISE_REFERENCE_DATA/meshes/$1.ply"
}

# cross_parameterize SOURCE SOURCE_SKETCH TARGET TARGET_SKETCH OUT [MAKE ARGUMENT...]
cross_parameterize() {
  make -f "$pipelines/cross-parameterize.mk" SOURCE="$1" SOURCE_SKETCH="$2" TARGET="$3" TARGET_SKETCH="$4" OUT="$5" \
    "${@:6}"
}

# piped SOURCE SOURCE_SKETCH TARGET TARGET_SKETCH OUT: the same job as one shell pipeline, as the README has it.
piped() {
  local bin=$PARTWISE_BIN
  "$bin/hull-to-hull" \
    <("$bin/convert-mesh" "$1" | "$bin/segment" --sketch "$2" | "$bin/hull" | "$bin/map-to-hull") \
    <("$bin/convert-mesh" "$3" | "$bin/segment" --sketch "$4" | "$bin/hull" | "$bin/map-to-hull") |
    "$bin/reconstruct" | "$bin/critical-points" | "$bin/relocate" -o "$5/compatible.ply"
  "$bin/measure" "$5/compatible.ply" -o "$5/measure.json"
}

# What every finished pair fulfils: check_result OUT SOURCE_FACETS TARGET_FACETS
check_result() {
  jq -e --argjson source "$2" --argjson target "$3" '
    .source_faces == $source and .target_faces == $target and .on_surface_max <= 1e-6 and .one_to_one and
    ([.rms_distance, .max_distance, .flipped_faces, .self_intersections, .hull_folds.total, .degenerate_faces,
      .l2_stretch_efficiency, .symmetric_dirichlet, .angle_error_deg, .boundary_gap_max]
     | all(. != null))' "$1/measure.json"
}

# A sphere of unit radius stretched by the given factors, as OFF: sphere RINGS SEGMENTS SX SY SZ
sphere() {
  awk -v rings="$1" -v segments="$2" -v sx="$3" -v sy="$4" -v sz="$5" 'BEGIN {
    pi = atan2(0, -1)
    print "OFF"
    print (rings - 1) * segments + 2, 2 * (rings - 1) * segments, 0
    for (i = 1; i < rings; ++i)
      for (j = 0; j < segments; ++j) {
        t = pi * i / rings
        p = 2 * pi * (j + i / 2) / segments
        printf "%.17g %.17g %.17g\n", sx * sin(t) * cos(p), sy * sin(t) * sin(p), sz * cos(t)
      }
    print 0, 0, sz
    print 0, 0, -sz
    north = (rings - 1) * segments
    for (j = 0; j < segments; ++j) {
      k = (j + 1) % segments
      print 3, north, j, k
      for (i = 0; i < rings - 2; ++i) {
        print 3, i * segments + j, (i + 1) * segments + j, (i + 1) * segments + k
        print 3, i * segments + j, (i + 1) * segments + k, i * segments + k
      }
      print 3, north + 1, (rings - 2) * segments + k, (rings - 2) * segments + j
    }
  }'
}
