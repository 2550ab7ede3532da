load setup

@test "brings a mesh in: one document, two files" {
  tetrahedron
  run convert-mesh tetrahedron.off -o a.ply
  expect_code 0
  [ -z "$output" ]
  expect_files . tetrahedron.off a.ply a.json
  grep -q '"facets": 4' a.json
  grep -q '"schema": "partwise/mesh-1"' a.json
  ! grep -q "$PWD" a.json a.ply
}

@test "a rerun gives the same bytes" {
  sphere 8 s.off
  convert-mesh s.off -o a.ply
  convert-mesh s.off -o b.ply
  cmp a.ply b.ply
  cmp a.json b.json
}

@test "OBJ and OFF come back as they went" {
  sphere 5 s.off
  convert-mesh s.off -o a.ply
  convert-mesh a.ply -o a.off
  convert-mesh a.ply -o a.obj
  convert-mesh a.off -o b.ply
  convert-mesh a.obj -o c.ply
  cmp <(convert-mesh a.ply --plain) <(convert-mesh b.ply --plain)
  cmp <(convert-mesh a.ply --plain) <(convert-mesh c.ply --plain)
}

@test "texture coordinates go from OBJ to PLY and back, through repairs" {
  cat >seam.obj <<'END'
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
v 9 9 9
vt 0 0
vt 1 0
vt 0 1
vt 0.5 0.5
vt 9 9
vt 0.75 0.25
f 1/1 3/3 2/2
f 1/1 2/2 4/6
f 2/2 3/3 4/6
f 3/3 1/4 4/6
f 1/1 2/2 2/2
END
  run convert-mesh seam.obj -o a.ply --drop-degenerate --drop-unused
  expect_code 0
  grep -aq 'property list uchar float texcoord' a.ply
  document --check a.ply
  convert-mesh a.ply -o b.ply  # documents keep it, too
  convert-mesh b.ply -o b.obj
  convert-mesh b.obj -o c.ply
  convert-mesh c.ply -o c.obj
  cmp b.obj c.obj
  [ "$(grep -c '^vt' b.obj)" = 5 ]
  grep -q '^vt 0.75 0.25$' b.obj
  sed 's|^f 1/1 3/3|f 1 3/3|' seam.obj >bare.obj
  run convert-mesh bare.obj -o bare.ply --drop-degenerate --drop-unused
  expect_code 0
  expect_text "1 facets have no texture coordinates although others have"
}

@test "STL: corners are merged and it is said" {
  sphere 3 s.off
  convert-mesh s.off -o s.stl
  run convert-mesh s.stl -o s.ply
  expect_code 0
  expect_text "178 corners equal to an earlier one were merged"
  grep -q '"vertices": 38' s.json
}

@test "through pipes nothing is lost" {
  tetrahedron
  convert-mesh tetrahedron.off -o a.ply
  convert-mesh a.ply -o b.ply
  convert-mesh a.ply | convert-mesh - > piped.ply
  convert-mesh b.ply -o c.ply
  convert-mesh piped.ply -o d.ply --force
  convert-mesh - -o e.ply < piped.ply
  cmp d.json e.json
  convert-mesh tetrahedron.off | convert-mesh - | convert-mesh - -o f.ply
  cmp f.ply c.ply
  cmp f.json c.json
}

@test "polygons are cut with a word about it" {
  printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n' > quad.obj
  run convert-mesh quad.obj -o quad.ply
  expect_code 0
  expect_text "1 facets with more than three corners"
  grep -q '"polygons_triangulated": 1' quad.json
  run convert-mesh quad.obj -o quiet.ply --quiet
  [ -z "$output" ]
}

@test "defects are refused, repaired on request, and reported" {
  tetrahedron
  sed 's/^4 4 6/5 5 6/; s/^3 0 2 1/9 9 9\n3 0 2 1/; s/^3 0 1 3/3 1 0 3/' tetrahedron.off > bad.off
  echo '3 1 1 2' >> bad.off
  run convert-mesh bad.off -o a.ply
  expect_code 3
  expect_text "convert-mesh: bad.off: facet 4 names vertex 1 twice"
  expect_text "--drop-degenerate"
  run convert-mesh bad.off -o a.ply --drop-degenerate
  expect_code 3
  expect_text "--orient"
  run convert-mesh bad.off -o a.ply --drop-degenerate --orient
  expect_code 3
  expect_text "--drop-unused"
  expect_files . tetrahedron.off bad.off
  run convert-mesh bad.off -o a.ply --drop-degenerate --orient --drop-unused
  expect_code 0
  expect_text "facets turned over: 1"
  grep -q '"facets": 4' a.json
  grep -q '"unused_vertices_dropped": 1' a.json
}

@test "messages name the file and the line" {
  tetrahedron
  sed 's/^-1 1 -1/-1 one -1/' tetrahedron.off > word.off
  run convert-mesh word.off -o a.ply
  expect_code 3
  expect_text "convert-mesh: word.off: line 5: a vertex needs three numbers"
  printf 'v 0 0 0\nf 1 2 zero\n' > bad.obj
  run convert-mesh bad.obj -o a.ply
  expect_code 3
  expect_text "bad.obj: line 2"
  run convert-mesh none.obj -o a.ply
  expect_code 4
  expect_text "none.obj: cannot be opened"
}

@test "usage errors end with 2 and say where help is" {
  tetrahedron
  run convert-mesh tetrahedron.off --no-such-option
  expect_code 2
  expect_text "convert-mesh --help"
  run convert-mesh
  expect_code 2
  run convert-mesh tetrahedron.off -o a.doc
  expect_code 2
  run convert-mesh --help
  expect_code 0
  expect_text "Example:"
}

@test "existing output stays unless forced" {
  tetrahedron
  echo precious > a.ply
  run convert-mesh tetrahedron.off -o a.ply
  expect_code 4
  expect_text "--force"
  [ "$(cat a.ply)" = precious ]
  convert-mesh tetrahedron.off -o a.ply --force
  echo '{"precious": true}' > b.json
  run convert-mesh tetrahedron.off -o b.ply --force
  expect_code 4
  grep -q precious b.json
}

@test "a truncated document is refused" {
  sphere 4 s.off
  convert-mesh s.off -o a.ply
  mkdir cut
  cp a.json cut/
  head -c 3000 a.ply > cut/a.ply
  run convert-mesh cut/a.ply -o b.ply
  expect_code 3
  expect_text "cut/a.ply: the file ends in element"
}

@test "a pair that does not belong together is refused" {
  tetrahedron
  sphere 2 s.off
  convert-mesh tetrahedron.off -o a.ply
  convert-mesh s.off -o b.ply
  cp b.json a.json
  run convert-mesh a.ply -o c.ply
  expect_code 3
  expect_text "a.json belongs to another PLY"
  rm a.json
  run convert-mesh a.ply -o c.ply
  expect_code 3
  expect_text "missing"
}

@test "a killed tool leaves nothing" {
  mkdir out
  mkfifo slow.ply
  sphere 4 s.off
  convert-mesh s.off -o whole.ply
  (head -c 2000 whole.ply; sleep 5) > slow.ply &
  writer=$!
  convert-mesh slow.ply -o out/a.ply &
  tool=$!
  sleep 0.3
  kill -TERM $tool
  ! wait $tool
  kill $writer 2> /dev/null || true
  expect_files out
}

@test "a failing disk leaves nothing and ends with 4" {
  [ -e /dev/full ] || skip "no /dev/full here"
  tetrahedron
  run convert-mesh tetrahedron.off -o /dev/full
  expect_code 4
  sphere 40 s.off
  mkdir out
  run bash -c 'trap "" XFSZ; ulimit -f 2; convert-mesh s.off -o out/a.ply'
  expect_code 4
  expect_files out
}

@test "a reader that ends early is no tragedy" {
  sphere 60 s.off
  run bash -c 'convert-mesh s.off | head -c 10 > /dev/null; echo "code ${PIPESTATUS[0]}"'
  [ "$output" = "code 4" ]
}
