# The tool transfer: poses and properties through a map, a cube on a bumpy sphere.
bats_require_minimum_version 1.5.0
load setup

setup_file() {
  PATH="$PARTWISE_BIN:$PATH"
  cd "$BATS_FILE_TMPDIR" || return 1
  sample_crossmap cross.ply
  reconstruct cross.ply -o map.ply
  morph source=map.ply map.ply --at 0 -o source.ply  # the source as it is
}

setup() {
  PATH="$PARTWISE_BIN:$PATH"
  cd "$BATS_TEST_TMPDIR" || return 1
  cp "$BATS_FILE_TMPDIR"/* .
  convert-mesh source.ply -o source.off
}

# A pose of a model: twice as large, and moved: posed <mesh.off> <pose.off>
posed() {
  awk 'NF == 3 && FNR > 2 { printf "%.17g %.17g %.17g\n", 2 * $1 + 1, 2 * $2, 2 * $3; next } { print }' "$1" >"$2"
}

# length_along_x FILE: extent of a mesh
length_along_x() {
  convert-mesh "$1" -o length.off --force
  awk 'NF == 3 && FNR > 2 { if (n++ == 0) a = b = $1; if ($1 < a) a = $1; if ($1 > b) b = $1 } END { print b - a }' length.off
}

@test "the target takes the poses of the source" {
  posed source.off large.off
  cp source.off rest.off
  transfer map.ply --poses large.off rest.off -o out/
  expect_files out large.json large.ply rest.json rest.ply
  rest=$(length_along_x out/rest.ply)
  large=$(length_along_x out/large.ply)
  awk -v a="$rest" -v b="$large" 'BEGIN { exit !(b > 1.999 * a && b < 2.001 * a) }'
  document --check out/large.ply
  jq -e '.metrics.transfer.inverted_faces == 0' out/large.json
  jq -e '.history[-1].tool == "transfer"' out/large.json
  grep -q 'element vertex 786' out/large.ply  # the target's own connectivity
}

@test "and the source those of the target, through the cross map as well" {
  transfer map.ply --poses source.off -o target.ply  # at rest
  convert-mesh target.ply -o target.off
  posed target.off large.off
  for map in map.ply cross.ply; do
    transfer "$map" --reverse --poses large.off -o back.ply --force
    length=$(length_along_x back.ply)
    awk -v b="$length" 'BEGIN { exit !(b > 3.999 && b < 4.001) }'
  done
}

# first_vertices_differ A B: by more than rounding
first_vertices_differ() {
  for file in "$1" "$2"; do
    convert-mesh "$file" -o first.off --force
    sed -n 3p first.off
  done | awk '{ for (i = 1; i <= 3; ++i) { d = $i - last[i]; sum += (NR == 2) * d * d; last[i] = $i } } END { exit !(sum > 1e-18) }'
}

@test "places that are held stand as they do on the giver" {
  # With the source itself as its pose nothing moves, so what is held is at rest.
  transfer map.ply --poses source.off -o rest.ply
  transfer map.ply --poses source.off --hold 0 --hold 100 -o still.ply
  run ! first_vertices_differ rest.ply still.ply
  posed source.off large.off
  transfer map.ply --poses large.off -o free.ply
  transfer map.ply --poses large.off --hold 0 --hold 100 -o held.ply
  first_vertices_differ free.ply held.ply
  run transfer map.ply --poses large.off --hold 0 --hold 0 -o x.ply
  expect_code 3
  expect_text "same place"
  run transfer map.ply --poses large.off --hold paw -o x.ply
  expect_code 3
  expect_text "there is no marker 'paw' to hold"
  run transfer map.ply --poses large.off --hold 9999 -o x.ply
  expect_code 3
  expect_text "the receiving model has 786"
  run transfer cross.ply --poses large.off --hold 0 -o x.ply
  expect_code 3
  expect_text "--hold needs a compatible mesh"
  [ ! -e x.ply ]
}

@test "several poses go into one animation" {
  posed source.off large.off
  transfer map.ply --poses source.off large.off -o poses.glb
  [ "$(head -c 4 poses.glb)" = glTF ]
  transfer map.ply --poses source.off large.off -o again.glb
  cmp poses.glb again.glb
}

@test "poses that are none of this model are refused" {
  sphere 4 other.off
  run transfer map.ply --poses other.off -o x.ply
  expect_code 3
  expect_text "other.off: its connectivity is not that of the source of map.ply: it has 66 vertices instead of 386"
  posed source.off large.off
  run transfer map.ply --reverse --poses large.off -o x.ply
  expect_code 3
  expect_text "the target of map.ply"
  run transfer source.ply --poses large.off -o x.ply
  expect_code 3
  expect_text "compatible (made by reconstruct) or crossmap"
  mkdir again && cp large.off again/
  run transfer map.ply --poses large.off again/large.off -o x/
  expect_code 2
  expect_text "two poses are called large"
  run transfer map.ply --poses source.off large.off -o x.ply
  expect_code 2
  [ ! -e x.ply ] && [ ! -e x ]
}

@test "a map that is not one-to-one serves, with a word" {
  reconstruct cross.ply --leave-folds -o left.ply
  run transfer left.ply --poses source.off -o out.ply
  expect_code 0
  expect_text "not certified one-to-one"
}

# A PLY of the source with a colour and a number per vertex and a label per facet: painted <file.ply>
painted() {
  awk '
    FNR == 2 {
      printf "ply\nformat ascii 1.0\ncomment TextureFile skin.png\nelement vertex %d\n", $1
      print "property double x\nproperty double y\nproperty double z"
      print "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float height"
      printf "element face %d\nproperty list uchar int vertex_indices\nproperty int side\nend_header\n", $2
    }
    FNR > 2 && NF == 3 { x[n++] = $1; print $0, 200, 100, 0, $3 }
    NF == 4 { print $0, (x[$2] + x[$3] + x[$4] > 0 ? 7 : 4) }' source.off >"$1"
}

@test "the target gets the properties of the source, and gives them back" {
  painted painted.ply
  transfer map.ply --attributes painted.ply -o there.ply
  jq -e '.metrics.transfer.properties == ["red", "green", "blue", "height", "side"]' there.json
  grep -q 'comment TextureFile skin.png' there.ply
  document --check there.ply
  transfer map.ply --reverse --attributes there.ply -o back.ply
  jq -e '.metrics.transfer.properties == ["red", "green", "blue", "height", "side"]' back.json
  [ "$(grep -c 'element vertex 386' back.ply)" = 1 ]
  # A viewer gets the colour: linear light of 200, 100, 0.
  transfer map.ply --attributes painted.ply -o there.glb
  grep -aq COLOR_0 there.glb
  transfer map.ply --attributes painted.ply --property side -o side.ply
  jq -e '.metrics.transfer.properties == ["side"]' side.json
}

@test "texture coordinates come from OBJ and go to OBJ and glTF" {
  # The unwrapped cube: every facet has places of its own, so every edge is a seam.
  awk 'NF == 3 && FNR > 2 { print "v", $0 }
    NF == 4 { print "vt 0 0\nvt 1 0\nvt 0 1"
      printf "f %d/%d %d/%d %d/%d\n", $2 + 1, 3 * n + 1, $3 + 1, 3 * n + 2, $4 + 1, 3 * n + 3; ++n }' source.off >source.obj
  transfer map.ply --attributes source.obj -o there.ply
  jq -e '.metrics.transfer.properties == ["texcoord"]' there.json
  grep -aq 'property list uchar float texcoord' there.ply
  convert-mesh there.ply -o there.obj
  [ "$(grep -c '^v ' there.obj)" = 786 ]
  [ "$(grep -c '^vt ' there.obj)" -gt 786 ]
  transfer map.ply --attributes source.obj -o there.glb
  grep -aq TEXCOORD_0 there.glb
}

@test "properties that are missing are named, with those that are there" {
  painted painted.ply
  run transfer map.ply --attributes painted.ply --property colour -o x.ply
  expect_code 3
  expect_text "painted.ply: neither vertices nor facets have a property 'colour' to transfer; there are: red, green, blue, height, side"
  run transfer map.ply --attributes source.off -o x.ply
  expect_code 3
  expect_text "no property to transfer but its geometry; PLY files have them"
  convert-mesh source.off -o bare.ply
  run transfer map.ply --attributes bare.ply -o x.ply
  expect_code 3
  expect_text "no property to transfer"
  run transfer cross.ply --attributes painted.ply -o x.ply
  expect_code 3
  expect_text "need a compatible mesh"
  run transfer map.ply -o x.ply
  expect_code 2
  expect_text "nothing to transfer"
  [ ! -e x.ply ]
}
