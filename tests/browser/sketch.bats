# The page of the tool sketch in headless browsers, on camel and cow.
load browser.bash
load ../pipelines/pipelines.bash

setup() {
  cd "$BATS_TEST_TMPDIR"
}

teardown() {
  [ -z "${server:-}" ] || kill "$server"
}

# Starts sketch on demo meshes: serve MODEL...
serve() {
  local model
  for model in "$@"; do cp "$(demo_mesh "$model")" .; done
  "$PARTWISE_BIN/sketch" "${@/%/.off}" >address 2>messages 3>&- &
  server=$!
  for _ in {1..100}; do
    grep -q http address && break
    sleep 0.05
  done
  ! grep -q "has no pages" messages || missing_browser "$(cat messages)"
}

@test "strokes become parts, markers and a file that segment cuts alike" {
  serve camel cow
  browser_test sketch.cjs "$(cat address)" labels
  kill -KILL "$server" # loses nothing
  server=
  "$PARTWISE_BIN/convert-mesh" camel.off -o camel.ply
  "$PARTWISE_BIN/segment" camel.ply --sketch camel.sketch.json -o camel.segment.ply
  cmp <("$PARTWISE_BIN/sample_mesh" labels camel.segment.ply) labels
}

@test "the same in Firefox" {
  serve camel cow
  PARTWISE_BROWSER=firefox-esr browser_test sketch.cjs "$(cat address)" labels
}

@test "undo, cameras, what a run lacks" {
  serve camel cow
  browser_test sketch-controls.cjs "$(cat address)"
}

@test "one model alone" {
  serve camel
  browser_test sketch-alone.cjs "$(cat address)"
}
