# morph.mk, transfer.mk and blend.mk: the rules with stubs for tools, then real models.
load pipelines.bash

setup_file() {
  load pipelines.bash
  [ -n "${PARTWISE_REFERENCE_DATA:-}" ] || return 0
  export MODELS=$BATS_FILE_TMPDIR/models BATCH=$BATS_FILE_TMPDIR/batch
  export PAIR=$BATCH/cat-lion
  mkdir "$MODELS"
  ln -s "$(reference_mesh cat-reference)" "$MODELS/cat.ply"
  ln -s "$(reference_mesh lion-reference)" "$MODELS/lion.ply"
  make -j2 -f "$pipelines/batch.mk" MODELS="$MODELS" SKETCHES="$sketches" OUT="$BATCH" PAIRS=cat:lion
}

setup() {
  cd "$BATS_TEST_TMPDIR"
}

# Stubs for tools, models a, b, c, and a pair of them in the folder "out".
stubs() {
  mkdir bin models
  for tool in convert-mesh segment hull map-to-hull hull-to-hull reconstruct critical-points relocate measure morph transfer; do
    ln -s "$BATS_TEST_DIRNAME/stub-tool" "bin/$tool"
  done
  export PARTWISE_BIN=$PWD/bin STUB_LOG=$PWD/log
  for name in a b c; do
    echo "mesh $name" >models/$name.ply
    echo "sketch $name" >models/$name.sketch.json
  done
}

pair=(SOURCE=models/a.ply SOURCE_SKETCH=models/a.sketch.json TARGET=models/b.ply TARGET_SKETCH=models/b.sketch.json OUT=out)

# The tools that ran since the last call.
ran() {
  cut -d' ' -f1 log | tr '\n' ' '
  : >log
}

@test "a morph makes the pair first, and itself again only for other options" {
  stubs
  make -f "$pipelines/morph.mk" "${pair[@]}"
  [ -f out/morph.glb ]
  [ "$(wc -l <log)" = 11 ]  # ten stages, and no measure
  : >log
  make -f "$pipelines/morph.mk" OUT=out
  [ "$(ran)" = "" ]
  make -f "$pipelines/morph.mk" OUT=out FRAMES=7
  [ "$(ran)" = "morph " ]
}

@test "a transfer makes what is asked for, each on its own" {
  stubs
  make -f "$pipelines/cross-parameterize.mk" "${pair[@]}"
  : >log
  echo pose >p1.ply
  echo pose >p2.off
  make -f "$pipelines/transfer.mk" OUT=out POSES="p1.ply p2.off"
  [ "$(ran)" = "transfer transfer " ]
  [ -f out/transfer/poses/p1.ply ] && [ -f out/transfer/poses/p2.json ] && [ -f out/transfer/poses.glb ]
  make -f "$pipelines/transfer.mk" OUT=out POSES="p1.ply p2.off"
  [ "$(ran)" = "" ]
  make -f "$pipelines/transfer.mk" OUT=out ATTRIBUTES=p1.ply REVERSE=yes
  [ "$(ran)" = "transfer " ]
  [ -f out/transfer-reverse/attributes.ply ]
  run make -f "$pipelines/transfer.mk" OUT=out
  [ "$status" != 0 ]
  [[ "$output" = *"nothing to transfer"* ]]
  run make -f "$pipelines/transfer.mk" OUT=out POSES=p3.ply
  [ "$status" != 0 ]
  [[ "$output" = *"no file p3.ply"* ]]
}

@test "a blend maps one model to the others, and shares the folder of a batch" {
  stubs
  make -f "$pipelines/batch.mk" MODELS=models OUT=out PAIRS=b:a
  : >log
  make -f "$pipelines/blend.mk" MODELS=models OUT=out NAMES="a b c" CONNECTIVITY=b WEIGHTS=0.2,0.3,0.5
  [ "$(ran)" = "segment hull map-to-hull hull-to-hull reconstruct critical-points relocate morph morph " ]
  [ -f out/b-c/compatible.ply ] && [ -f out/blend.ply ] && [ -f out/blend.glb ]
  make -f "$pipelines/blend.mk" MODELS=models OUT=out NAMES="a b c" CONNECTIVITY=b WEIGHTS=1,0,0
  [ "$(ran)" = "morph " ]
  run make -f "$pipelines/blend.mk" MODELS=models OUT=out NAMES=a
  [ "$status" != 0 ]
  run make -f "$pipelines/blend.mk" MODELS=models OUT=out NAMES="a b" CONNECTIVITY=d
  [ "$status" != 0 ]
  [[ "$output" = *"CONNECTIVITY=d is none of"* ]]
}

@test "cow, camel and triceratops blend without more folds than the models have" {
  demo=$(dirname "$(demo_mesh cow)")
  make -j2 -f "$pipelines/blend.mk" MODELS="$demo" SKETCHES="$sketches" NAMES="cow camel triceratops" \
    WEIGHTS=0.5,0.3,0.2 OUT=out
  [ "$(head -c 4 out/blend.glb)" = glTF ]
  jq -e '.metrics.morph | .weights == [0.5, 0.3, 0.2] and .inverted_faces <= 0.005 * 5804' out/blend.json
  "$PARTWISE_BIN/document" --check out/blend.ply
}

@test "cat, lion and camel blend without more folds than the models have" {
  reference_mesh cat-reference >/dev/null
  ln -s "$(demo_mesh camel)" "$MODELS/camel.off"
  make -j2 -f "$pipelines/blend.mk" MODELS="$MODELS" SKETCHES="$sketches" NAMES="cat lion camel" \
    WEIGHTS=0.4,0.3,0.3 FRAMES=7 OUT="$BATCH"
  jq -e '.metrics.morph | .weights == [0.4, 0.3, 0.3] and .inverted_faces <= 0.005 * 14410' "$BATCH/blend.json"
  [ "$(head -c 4 "$BATCH/blend.glb")" = glTF ]
}

# excess METADATA...: facets against their surroundings, beyond what pose or rest bring with them, over all
excess() {
  jq --argjson facets 9996 --argjson giver 14410 '.metrics.transfer |
    ((.inverted_faces - .inverted_faces_at_rest) / $facets) as $made |
    ((.inverted_faces_of_pose - .inverted_faces_of_giver_at_rest) / $giver) as $given |
    $made - ([$given, 0] | max)' "$@" | sort -g | tail -n 1
}

@test "the lion takes the cat's poses as Sumner and Popovic's does" {
  poses=$(dirname "$(reference_mesh cat-01)")
  make -f "$pipelines/transfer.mk" OUT="$PAIR" RESULTS=here POSES="$(echo "$poses"/cat-0[1-9].ply)"
  [ "$(ls here/poses/*.ply | wc -l)" = 9 ]
  excess=$(excess here/poses/*.json)
  awk -v e="$excess" 'BEGIN { exit !(e <= 0.002) }'
  for i in 1 2 3 4 5; do
    "$PARTWISE_BIN/shape_difference" here/poses/cat-0$i.ply "$poses/lion-0$i.ply"
  done | tee differences
  awk '$2 > 0.025 { exit 1 }' differences
}

@test "properties of the cat go to the lion, and the two morph" {
  [ -n "${PAIR:-}" ] || skip "PARTWISE_REFERENCE_DATA names no folder with the reference meshes"
  make -f "$pipelines/transfer.mk" OUT="$PAIR" RESULTS=there ATTRIBUTES="$BATCH/models/cat.segment.ply"
  make -f "$pipelines/morph.mk" OUT="$PAIR" MORPH_FLAGS=--quiet
  "$PARTWISE_BIN/document" there/attributes.ply | grep -q part
  [ "$(head -c 4 "$PAIR/morph.glb")" = glTF ]
}
