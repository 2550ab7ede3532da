# The tool report: pages of pairs and batches, whatever of them is missing. tests/browser/ opens such pages.
bats_require_minimum_version 1.5.0
load setup

# A whole pair of two small spheres, as cross-parameterize.mk leaves it; made once for all tests.
setup_file() {
  load setup
  PATH="$PARTWISE_BIN:$PATH"
  cd "$BATS_FILE_TMPDIR"
  mkdir pair
  sphere 4 source.off
  sphere 5 target.off
  for side in source target; do
    convert-mesh "$side.off" | segment -o pair/$side.segment.ply
    hull pair/$side.segment.ply -o pair/$side.hull.ply
    map-to-hull pair/$side.hull.ply -o pair/$side.hullmap.ply
  done
  hull-to-hull pair/source.hullmap.ply pair/target.hullmap.ply -o pair/crossmap.ply
  reconstruct pair/crossmap.ply -o pair/reconstructed.ply
  critical-points pair/reconstructed.ply -o pair/critical.ply
  relocate pair/critical.ply --profile -o pair/compatible.ply
  measure pair/compatible.ply -o pair/measure.json
  export NO_PAGES=
  report pair -o page.html 2>message || NO_PAGES=$(grep 'has no pages' message)
}

setup() {
  if [ -n "$NO_PAGES" ]; then
    [ -z "${PARTWISE_REQUIRE_BROWSER:-}" ] || { echo "$NO_PAGES"; return 1; }
    skip "$NO_PAGES"
  fi
  PATH="$PARTWISE_BIN:$PATH"
  cd "$BATS_TEST_TMPDIR"
}

# pair FOLDER: a copy of it.
pair() {
  mkdir -p "$1"
  cp "$BATS_FILE_TMPDIR"/pair/* "$1"
}

# The facts of a page, as JSON: facts PAGE
facts() {
  sed -n 's,^<script type="application/json" id="facts">\(.*\)</script>$,\1,p' "$1"
}

@test "a finished pair has every surface, its figures and its history" {
  pair out
  report out -o page.html
  facts page.html >facts.json
  jq -e '.name == "out" and (.findings | map(select(.weight != "note")) == [])' facts.json
  jq -e '.surfaces | keys == ["compatible", "critical", "crossmap", "reconstructed", "source", "source_hullmap",
    "source_hulls", "target", "target_hullmap", "target_hulls"]' facts.json
  jq -e '.models.source.facets == 128 and .models.target.facets == 200 and .models.source.shown == 128' facts.json
  jq -e '.figures[0] == {"pointer": "/source_faces", "heading": "source", "meaning": "facets of the source",
    "value": "128"}' facts.json
  jq -e '[.history[].tool] == ["convert-mesh", "segment", "hull", "map-to-hull", "convert-mesh", "segment", "hull",
    "map-to-hull", "hull-to-hull", "reconstruct", "critical-points", "relocate", "measure"]' facts.json
  jq -e '[.history[].side] == ["source", "source", "source", "source", "target", "target", "target", "target", "",
    "", "", "", ""]' facts.json
  # Timings of what ran with --profile, and of nothing else.
  jq -e '[.history[] | select(.seconds != null) | .tool] == ["relocate"]' facts.json
}

@test "the same bytes on every run, and none of this machine" {
  pair out
  report out -o first.html
  report "$PWD/out" >second.html
  cmp first.html second.html
  run ! grep -qF "$PWD" first.html
}

@test "a page asks for nothing from elsewhere" {
  pair out
  report out -o page.html
  # Namespaces are names, not addresses.
  run grep -oE "https?://[^\"' )]+" page.html
  [ -z "$(printf '%s\n' "${lines[@]}" | grep -v '^http://www.w3.org/1999/xhtml$')" ]
  run ! grep -qE '<(link|img|script)[^>]+(src|href)="[^d]' page.html
  grep -q "default-src 'none'" page.html
}

@test "a missing stage is a failure, said on the page and on stderr" {
  pair out
  rm out/critical.ply out/compatible.ply out/measure.json
  run report out -o page.html
  expect_code 0
  expect_text "report: warning: relocate: compatible.ply: there is no such file"
  facts page.html >facts.json
  jq -e '[.findings[] | select(.weight == "failure") | .stage] == ["critical-points", "relocate", "measure"]' facts.json
  jq -e '(.surfaces | has("compatible") | not) and (.surfaces | has("crossmap"))' facts.json
}

@test "of a shell pipeline the result alone is enough" {
  pair out
  mkdir alone
  cp out/compatible.* out/measure.json alone
  report alone -o page.html
  facts page.html >facts.json
  jq -e '.findings | map(select(.text | contains("not kept"))) | length == 9' facts.json
  jq -e '.findings | all(.weight == "note")' facts.json
  jq -e '.surfaces | keys == ["compatible", "source", "target"]' facts.json
}

@test "a broken document is named and does not stop the page" {
  pair out
  head -c 1000 out/crossmap.ply >short
  mv short out/crossmap.ply
  echo '{' >out/measure.json
  run report out -o page.html
  expect_code 0
  expect_text "hull-to-hull: crossmap.ply: "
  expect_text "measure: measure.json: is no JSON"
  facts page.html | jq -e '(.surfaces | has("crossmap") | not) and (.surfaces | has("compatible")) and .figures == []'
}

@test "documents that were not made from one another are found out" {
  pair out
  sphere 4 source.off
  echo '{"schema": "partwise/sketch-1", "parts": [{"name": "all", "strokes": [{"vertices": [0]}]}]}' >sketch.json
  convert-mesh source.off | segment --sketch sketch.json --force -o out/source.segment.ply
  run report out -o page.html
  expect_code 0
  facts page.html | jq -e '[.findings[] | select(.weight == "warning") | .stage] == ["hull (source)"]'
}

@test "folded facets are counted and drawn" {
  mkdir out
  sample_hullmap out/source.hullmap.ply
  report out -q -o page.html
  facts page.html >facts.json
  jq -e '.surfaces.source_hullmap.folds > 0' facts.json
  jq -e '.surfaces.source_hullmap | .folded.positions.count == 9 * .folds' facts.json
}

@test "large models are decimated for display, and the page has both numbers" {
  pair out
  report out --facets 100 -o page.html
  facts page.html >facts.json
  jq -e '.models.source.facets == 128 and .models.source.shown <= 100' facts.json
  jq -e '.surfaces.compatible.facets.count == 3 * .models.source.shown and .surfaces.compatible.total == 128' facts.json
}

@test "names cannot break out of the page" {
  pair '<script>alert(1)<!--&amp;"'
  report '<script>alert(1)<!--&amp;"' -o page.html
  run ! grep -q '<script>alert' page.html
  [ "$(facts page.html | jq -r .name)" = '<script>alert(1)<!--&amp;"' ]
}

@test "a batch is a table with failures first to be found" {
  pair batch/a-b
  cp -r batch/a-b batch/a-c
  rm batch/a-c/compatible.ply
  mkdir -p batch/a-d/.settings batch/models
  touch batch/a-d/.settings/crossmap
  report batch/a-b -o batch/a-b/report.html
  report --index batch -o batch/index.html
  facts batch/index.html >facts.json
  jq -e '[.rows[] | [.name, .verdict, .link]] == [["a-b", "done", "a-b/report.html"], ["a-c", "failed", null],
    ["a-d", "failed", null]]' facts.json
  jq -e '.rows[0].surfaces | keys == ["compatible", "source", "target"]' facts.json
}

@test "bad input is refused" {
  mkdir empty
  run report empty
  expect_code 3
  expect_text "report: empty: there is no document of a pair in it"
  run report nowhere
  expect_code 4
  expect_text "nowhere: is no folder"
  run report --index nowhere
  expect_code 4
  run report --index empty
  expect_code 3
  expect_text "holds no pair"
  run report
  expect_code 2
  run report empty --facets 0
  expect_code 2
}

@test "existing output is kept without --force" {
  pair out
  echo mine >page.html
  run report out -o page.html
  expect_code 4
  [ "$(cat page.html)" = mine ]
  report out --force -o page.html
  grep -q '<!doctype html>' page.html
}
