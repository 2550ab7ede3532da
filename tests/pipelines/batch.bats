# Several pairs over shared models, real tools.
load pipelines.bash
load ../browser/browser.bash

setup() {
  cd "$BATS_TEST_TMPDIR"
  mkdir models
  sphere 10 20 1 1 1 >models/ball.off
  sphere 12 16 1 1.5 2 >models/egg.off
}

batch() {
  make -f "$pipelines/batch.mk" MODELS=models OUT=out "$@"
}

@test "two meshes without parts, both ways" {
  run batch PAIRS=all -j2
  echo "$output"
  [ "$status" = 0 ]
  check_result out/ball-egg 360 352
  check_result out/egg-ball 352 360
  [[ "$output" = *ball*egg* ]]
  batch -q results PAIRS=all
}

@test "one failing pair does not stop the others and stands in the table" {
  printf 'OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 7\n' >models/broken.off
  run batch PAIRS="ball:egg ball:broken" -j2
  echo "$output"
  [ "$status" -ne 0 ]
  [[ "$output" = *"models/broken.off"* ]]
  [[ "$output" = *"failed: ball-broken"* ]]
  check_result out/ball-egg 360 352
  [ ! -e out/ball-broken/measure.json ]
}

@test "a batch has a page for each pair, one for all, and a contact sheet" {
  batch results PAIRS="ball:egg" -j2
  make_page out/ball-egg page.html
  make -f "$pipelines/report.mk" OUT=out
  cmp page.html out/ball-egg/report.html
  grep -q '"link":"ball-egg/report.html"' out/index.html
  make -f "$pipelines/report.mk" contact-sheet OUT=out SHEET_WIDTH=600
  [ "$(od -An -tx1 -j1 -N3 out/contact-sheet.png)" = " 50 4e 47" ]
  make -q -f "$pipelines/report.mk" contact-sheet OUT=out SHEET_WIDTH=600
  run make -f "$pipelines/report.mk" OUT=models
  [ "$status" -ne 0 ]
  [[ "$output" = *"there is no pair in this folder"* ]]
}
