# camel -> cow, the demo, by make and by pipe.
load pipelines.bash
load ../browser/browser.bash

# The pair is made once for all tests of this file, on as many jobs as there are processors.
setup_file() {
  [ -n "${PARTWISE_DEMO_MESHES:-}" ] || return 0
  load pipelines.bash
  export PAIR=$BATS_FILE_TMPDIR/camel-cow
  camel_to_cow "$PAIR" -j2
}

setup() {
  demo_mesh camel >/dev/null
  cd "$BATS_TEST_TMPDIR"
}

camel_to_cow() {
  cross_parameterize "$PARTWISE_DEMO_MESHES/camel.off" "$sketches/camel.sketch.json" \
    "$PARTWISE_DEMO_MESHES/cow.off" "$sketches/cow.sketch.json" "$@"
}

@test "camel -> cow has complete figures" {
  check_result "$PAIR" 19536 5804
  jq -e '.markers == 18 and .boundary_gap_max < 1e-6' "$PAIR/measure.json"
}

@test "the connectivity of the camel is untouched" {
  "$PARTWISE_BIN/convert-mesh" "$PAIR/compatible.ply" -o result.off
  facets='$1 == 3 && NF == 4 { print $2, $3, $4 }'
  awk "$facets" "$PARTWISE_DEMO_MESHES/camel.off" >before
  awk "$facets" result.off >after
  [ "$(wc -l <after)" = 19536 ]
  cmp before after
}

@test "a finished pair is not made again" {
  camel_to_cow "$PAIR" -q
}

@test "made again on one processor it has the same bytes" {
  camel_to_cow out -j1
  diff -rq --exclude=.settings out "$PAIR"
}

@test "the shell pipeline has the bytes that make has" {
  demo=$PARTWISE_DEMO_MESHES
  mkdir out
  piped "$demo/camel.off" "$sketches/camel.sketch.json" "$demo/cow.off" "$sketches/cow.sketch.json" out
  cmp out/compatible.ply "$PAIR/compatible.ply"
  cmp out/compatible.json "$PAIR/compatible.json"
  cmp out/measure.json "$PAIR/measure.json"
}

@test "an interrupted pair resumes and ends with the same bytes" {
  camel_to_cow out -j2 &
  job=$!
  # Wait until some stage is done, then kill the rest in the middle.
  for _ in $(seq 600); do
    [ ! -f out/source.segment.ply ] || break
    sleep 0.1
  done
  kill -INT $job || true
  wait $job || true
  camel_to_cow out -j2
  camel_to_cow out -q
  diff -rq --exclude=.settings out "$PAIR"
}

@test "nothing but finished documents lies in the folder" {
  run find "$PAIR" -type f ! -path '*/.settings/*' ! -name '*.ply' ! -name '*.json'
  [ -z "$output" ]
}

@test "its report, by make, in a browser" {
  cp -r "$PAIR" out
  make_page out page.html
  make -f "$pipelines/report.mk" OUT=out
  cmp page.html out/report.html
  make -q -f "$pipelines/report.mk" OUT=out
  browser_test finished-pair.cjs "$PWD/out/report.html" "$PWD/out/measure.json"
}

@test "triceratops -> cow by markers alone, without strokes, is certified" {
  for name in triceratops cow; do
    jq '{schema, markers}' "$sketches/$name.sketch.json" >"$name.sketch.json"
  done
  cross_parameterize "$(demo_mesh triceratops)" triceratops.sketch.json "$(demo_mesh cow)" cow.sketch.json out
  check_result out 5660 5804
  "$PARTWISE_BIN/measure" out/compatible.ply --certify --require-certificate
  jq -e '.one_to_one and .markers == 18 and .marker_error_max < 1e-9' out/measure.json
}
