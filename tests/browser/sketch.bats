# The page of the tool sketch in headless browsers, on camel and cow.
load browser.bash
load ../pipelines/pipelines.bash

setup() {
  local model
  cd "$BATS_TEST_TMPDIR"
  for model in camel cow; do cp "$(demo_mesh "$model")" .; done
  "$PARTWISE_BIN/sketch" camel.off cow.off >address 2>messages 3>&- &
  server=$!
  for _ in {1..100}; do
    grep -q http address && break
    sleep 0.05
  done
}

teardown() {
  [ -z "${server:-}" ] || kill "$server"
}

@test "strokes become parts, markers and a file that segment cuts alike" {
  ! grep -q "has no pages" messages || missing_browser "$(cat messages)"
  browser_test sketch.cjs "$(cat address)" labels
  kill -KILL "$server" # loses nothing
  server=
  "$PARTWISE_BIN/convert-mesh" camel.off -o camel.ply
  "$PARTWISE_BIN/segment" camel.ply --sketch camel.sketch.json -o camel.segment.ply
  cmp <("$PARTWISE_BIN/sample_mesh" labels camel.segment.ply) labels
}

@test "the same in Firefox" {
  ! grep -q "has no pages" messages || missing_browser "$(cat messages)"
  PARTWISE_BROWSER=firefox-esr browser_test sketch.cjs "$(cat address)" labels
}
