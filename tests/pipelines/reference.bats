# Pairs of meshes that may not be passed on; they run where PARTWISE_REFERENCE_DATA says where these are.
load pipelines.bash
load ../browser/browser.bash

setup() {
  cd "$BATS_TEST_TMPDIR"
}

# pair SOURCE TARGET SOURCE_SKETCH TARGET_SKETCH [MAKE ARGUMENT...]
pair() {
  cross_parameterize "$1" "$sketches/$3.sketch.json" "$2" "$sketches/$4.sketch.json" out -j2 "${@:5}"
  jq . out/measure.json
}

@test "cat -> lion within half a percent" {
  pair "$(reference_mesh cat-reference)" "$(reference_mesh lion-reference)" cat lion
  check_result out 14410 9996
  jq -e '.markers == 18 and .rms_distance <= 0.005 and .max_distance <= 0.03' out/measure.json
  make_page out page.html
  browser_test finished-pair.cjs "$PWD/page.html" "$PWD/out/measure.json"
}

@test "lion -> cat" {
  pair "$(reference_mesh lion-reference)" "$(reference_mesh cat-reference)" lion cat
  check_result out 9996 14410
  jq -e '.markers == 18 and .rms_distance <= 0.005' out/measure.json
}

@test "triceratops -> diplodocus" {
  pair "$(demo_mesh triceratops)" "$(demo_mesh diplodocus)" triceratops diplodocus
  check_result out 5660 47960
  jq -e '.markers == 18 and .rms_distance <= 0.005' out/measure.json
}

@test "man -> baby, against the ground truth" {
  pair "$(reference_mesh man)" "$(reference_mesh baby)" man baby "MEASURE_FLAGS=--truth identity"
  check_result out 26756 26756
  jq -e '.rms_distance <= 0.005 and .truth.vertices == 13380 and .truth.mean <= 0.03' out/measure.json
}

@test "baby -> man, against the ground truth" {
  pair "$(reference_mesh baby)" "$(reference_mesh man)" baby man "MEASURE_FLAGS=--truth identity"
  check_result out 26756 26756
  jq -e '.rms_distance <= 0.005 and .truth.vertices == 13380 and .truth.mean <= 0.03' out/measure.json
}
