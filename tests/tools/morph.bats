# The tool morph: blends of meshes with one connectivity.
load setup

# Two spheres of one connectivity, the second stretched, as PLY: shapes <n>
shapes() {
  sphere "$1" ball.off
  awk 'NF == 3 && FNR > 2 { print 2 * $1, $2, $3 + 1; next } { print }' ball.off >egg.off
  convert-mesh ball.off -o ball.ply
  convert-mesh egg.off -o egg.ply
}

# points_of FILE: a line per vertex
points_of() {
  convert-mesh "$1" -o points.off --force
  awk 'NF == 3 && FNR > 2' points.off
}

# Expects two files of three numbers a line to be equal but for rounding: expect_near A B
expect_near() {
  paste "$1" "$2" | awk '
    { for (i = 1; i <= 3; ++i) { d = $i - $(i + 3); if (d * d > most) most = d * d } }
    END { if (NR == 0 || most > 1e-24) { print "largest difference", sqrt(most); exit 1 } }'
}

@test "a folder of frames from the first model to the last" {
  shapes 4
  morph ball.ply egg.ply --frames 3 -o frames/
  expect_files frames 0000.json 0000.ply 0001.json 0001.ply 0002.json 0002.ply
  points_of ball.ply >a
  points_of frames/0000.ply >b
  expect_near a b
  points_of egg.ply >a
  points_of frames/0002.ply >b
  expect_near a b
  jq -e '.metrics.morph.weights == [0.5, 0.5] and .metrics.morph.inverted_faces == 0' frames/0001.json
  jq -e '.history | length == 3 and .[-1].tool == "morph" and .[-1].arguments.frames == 3' frames/0001.json
  document --check frames/0001.ply
}

@test "linear blends are sums of positions" {
  shapes 4
  morph ball.ply egg.ply --weights 0.25,0.75 --method linear -o blend.ply
  points_of blend.ply >a
  points_of ball.ply >ball
  points_of egg.ply >egg
  paste ball egg |
    awk '{ for (i = 1; i <= 3; ++i) printf "%.17g ", 0.25 * $i + 0.75 * $(i + 3); print "" }' >b
  expect_near a b
}

@test "one blend goes into a pipe, and is the frame of the same place" {
  shapes 4
  morph ball.ply egg.ply --at 0.5 | convert-mesh - --plain >a
  morph ball.ply egg.ply --frames 3 -o frames/
  convert-mesh frames/0001.ply --plain >b
  cmp a b
  morph ball.ply egg.ply -o mean.ply
  convert-mesh mean.ply --plain >c
  cmp a c
}

@test "an animation is one binary glTF file, the same on every run" {
  shapes 4
  morph ball.ply egg.ply --frames 5 --seconds 2 -o a.glb
  morph ball.ply egg.ply --frames 5 --seconds 2 -o b.glb
  cmp a.glb b.glb
  [ "$(head -c 4 a.glb)" = glTF ]
  length=$(od -An -tu4 -j12 -N4 a.glb | tr -d ' ')
  tail -c +21 a.glb | head -c "$length" >a.gltf.json
  jq -e '.meshes[0].primitives[0].targets | length == 4' a.gltf.json
  jq -e '.animations[0].channels[0].target.path == "weights" and .asset.version == "2.0"' a.gltf.json
  run morph ball.ply egg.ply -o a.glb
  expect_code 4
  expect_text "--force"
}

@test "a compatible mesh alone morphs from its source; source= names it among others" {
  sample_compatible compatible.ply
  morph compatible.ply --frames 2 -o pair/
  points_of pair/0001.ply >a
  points_of compatible.ply >b
  expect_near a b
  morph source=compatible.ply compatible.ply compatible.ply --weights 1,0,0 -o source.ply
  points_of pair/0000.ply >a
  points_of source.ply >b
  expect_near a b
  run morph source=pair/0000.ply compatible.ply -o x.ply
  expect_code 2
  expect_text "no compatible mesh"
}

@test "weights that do not add up to 1 are taken, with a word" {
  shapes 3
  run morph ball.ply egg.ply --weights 1,1 -o blend.ply
  expect_code 0
  expect_text "add up to 2"
  run morph ball.ply egg.ply --weights=-0.5,1.5 -o beyond.ply
  expect_code 0
  [ -z "$output" ]
}

@test "models of other sizes are told of, and aligned on request" {
  shapes 3
  awk 'NF == 3 && FNR > 2 { printf "%.17g %.17g %.17g\n", 10 * $2 + 4, -10 * $1, 10 * $3; next } { print }' ball.off >large.off
  run morph ball.ply large.off --at 1 -o large.ply
  expect_code 0
  expect_text "large.off is 10 times as large as ball.ply"
  run morph ball.ply large.off --at 1 --align -o same.ply
  expect_code 0
  [ -z "$output" ]
  points_of ball.ply >a
  points_of same.ply >b
  expect_near a b
}

@test "what does not fit is refused, and nothing is written" {
  shapes 3
  sphere 4 other.off
  convert-mesh other.off -o other.ply
  run morph ball.ply other.ply -o x.ply
  expect_code 3
  expect_text "other.ply: its connectivity is not that of ball.ply: it has 66 vertices instead of 38"
  sed 's/^3 \([0-9]*\) \([0-9]*\) \([0-9]*\)$/3 \2 \3 \1/' ball.off >turned.off
  run morph ball.ply turned.off -o x.ply
  expect_code 3
  expect_text "facet 0 is"
  run morph ball.ply egg.ply --weights 1,0,0 -o x.ply
  expect_code 2
  expect_text "one weight for each"
  run morph ball.ply egg.ply --weights 0.5,half -o x.ply
  expect_code 2
  expect_text "no list of numbers"
  run morph ball.ply egg.ply --frames 4 -o x.ply
  expect_code 2
  expect_text "FOLDER/"
  run morph ball.ply -o x.ply
  expect_code 2
  run morph ball.ply missing.ply -o x.ply
  expect_code 4
  [ ! -e x.ply ] && [ ! -e x.json ]
}
