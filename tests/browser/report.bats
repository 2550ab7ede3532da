# The report's pages in headless Chromium: a small pair with two parts, an incomplete one, a batch; and the pair's
# animation in three.js.
load browser.bash
load ../pipelines/pipelines.bash

setup_file() {
  load ../pipelines/pipelines.bash
  cd "$BATS_FILE_TMPDIR"
  sphere 14 20 1 1 2 >egg.off
  sphere 16 18 1 1.2 2.4 >bean.off
  sketch 2 >egg.sketch.json
  sketch 2.4 >bean.sketch.json
  mkdir batch
  cross_parameterize egg.off egg.sketch.json bean.off bean.sketch.json batch/a-b >/dev/null
}

# Two parts and two markers of an ellipsoid that is so high: sketch HEIGHT
sketch() {
  cat <<END
{"schema": "partwise/sketch-1",
 "parts": [{"name": "top", "strokes": [{"points": [[0, 0, $1]]}]}, {"name": "bottom", "strokes": [{"points": [[0, 0, -$1]]}]}],
 "markers": [{"name": "north", "point": [0, 0, $1]}, {"name": "side", "point": [1, 0, 0]}]}
END
}

setup() {
  cd "$BATS_FILE_TMPDIR"
}

@test "a finished pair" {
  make_page batch/a-b batch/a-b/report.html
  browser_test finished-pair.cjs "$PWD/batch/a-b/report.html" "$PWD/batch/a-b/measure.json"
}

@test "an animation in three.js" {
  "$PARTWISE_BIN/morph" batch/a-b/compatible.ply --frames 4 --seconds 3 --force -o morph.glb
  "$PARTWISE_BIN/morph" batch/a-b/compatible.ply --frames 4 --force -o frames/
  for frame in frames/*.ply; do "$PARTWISE_BIN/convert-mesh" "$frame" --force -o "${frame%.ply}.off"; done
  browser_test animation.cjs "$(page_modules)" "$PWD/morph.glb" 3 frames/*.off
}

@test "an incomplete pair with folds" {
  mkdir -p incomplete
  "$PARTWISE_BIN/sample_hullmap" incomplete/source.hullmap.ply
  make_page incomplete incomplete/report.html
  browser_test incomplete-pair.cjs "$PWD/incomplete/report.html"
}

@test "a batch" {
  make_page batch/a-b batch/a-b/report.html
  mkdir -p batch/a-c batch/a-d/.settings
  cp batch/a-b/*.ply batch/a-b/*.json batch/a-c
  rm batch/a-c/compatible.ply
  touch batch/a-d/.settings/crossmap
  make_page batch batch/index.html --index
  browser_test batch.cjs "$PWD/batch/index.html"
}
