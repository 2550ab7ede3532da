# The makefiles by themselves: what is made, what is made again, what is refused. Stubs stand in for the tools.

setup() {
  pipelines=$(cd "$BATS_TEST_DIRNAME/../../pipelines" && pwd)
  cd "$BATS_TEST_TMPDIR"
  mkdir bin models
  for tool in convert-mesh segment hull map-to-hull hull-to-hull reconstruct critical-points relocate measure; do
    ln -s "$BATS_TEST_DIRNAME/stub-tool" "bin/$tool"
  done
  export PARTWISE_BIN=$PWD/bin STUB_LOG=$PWD/log
  unset MAKEFLAGS MAKELEVEL MFLAGS
  for name in a b c; do
    echo "mesh $name" >models/$name.ply
    echo "sketch $name" >models/$name.sketch.json
  done
}

pair() {
  make -f "$pipelines/cross-parameterize.mk" SOURCE=models/a.ply SOURCE_SKETCH=models/a.sketch.json \
    TARGET=models/b.ply TARGET_SKETCH=models/b.sketch.json OUT=out "$@"
}

batch() {
  make -f "$pipelines/batch.mk" MODELS=models OUT=out "$@"
}

# The tools that ran since the last call.
ran() {
  cut -d' ' -f1 log | tr '\n' ' '
  : >log
}

@test "a pair has every intermediate, the result and its figures" {
  pair
  for document in source.segment source.hull source.hullmap target.segment target.hull target.hullmap crossmap \
    reconstructed critical compatible; do
    [ -f out/$document.ply ]
    [ -f out/$document.json ]
  done
  [ -f out/measure.json ]
  [ "$(wc -l <log)" = 11 ]
}

@test "a finished pair is not made again" {
  pair
  : >log
  pair -q
  pair
  [ ! -s log ]
}

@test "side by side makes the same" {
  pair
  mv out first
  pair -j4
  diff -r first out
}

@test "a pair resumes where it was interrupted" {
  pair
  ran
  rm out/crossmap.ply
  pair
  [ "$(ran)" = "hull-to-hull reconstruct critical-points relocate measure " ]
}

@test "a lost sidecar is made again" {
  pair
  ran
  rm out/reconstructed.json
  pair
  [ "$(ran)" = "reconstruct critical-points relocate measure " ]
}

@test "a changed sketch remakes its model and the pair, not the other model" {
  pair
  ran
  sleep 0.02
  echo more >>models/b.sketch.json
  pair
  [ "$(ran)" = "segment hull map-to-hull hull-to-hull reconstruct critical-points relocate measure " ]
}

@test "changed options of a stage remake it and what follows" {
  pair
  ran
  pair RELOCATE_FLAGS=--rounds=3
  [ "$(ran)" = "relocate measure " ]
  pair RELOCATE_FLAGS=--rounds=3
  [ "$(ran)" = "" ]
  pair
  [ "$(ran)" = "relocate measure " ]
}

@test "another source in the same folder is noticed although its file is older" {
  touch -d '1 hour ago' models/c.ply models/c.sketch.json
  pair
  ran
  pair SOURCE=models/c.ply SOURCE_SKETCH=models/c.sketch.json
  [[ "$(ran)" = "segment hull map-to-hull hull-to-hull "* ]]
}

@test "other formats go through convert-mesh, sketches may be missing" {
  mv models/a.ply models/a.obj
  pair SOURCE=models/a.obj SOURCE_SKETCH= TARGET_SKETCH=
  [ -f out/source.mesh.ply ]
  [ ! -f out/target.mesh.ply ]
  pair -q SOURCE=models/a.obj SOURCE_SKETCH= TARGET_SKETCH=
}

@test "a failing stage fails the pair and leaves no result" {
  echo BROKEN >models/b.ply
  run pair
  [ "$status" -ne 0 ]
  [[ "$output" = *"segment: models/b.ply: broken"* ]]
  [ ! -e out/measure.json ]
}

@test "missing and unusable paths are refused with a word" {
  run pair SOURCE=
  [ "$status" -ne 0 ]
  [[ "$output" = *"SOURCE="*"say SOURCE=mesh"* ]]
  run pair TARGET=none.ply
  [ "$status" -ne 0 ]
  [[ "$output" = *'TARGET="none.ply": there is no such file'* ]]
  run pair SOURCE="a b.ply"
  [ "$status" -ne 0 ]
  [[ "$output" = *"cannot handle paths with spaces"* ]]
  run pair OUT=
  [ "$status" -ne 0 ]
  [[ "$output" = *"say OUT=folder"* ]]
  run pair PARTWISE_BIN=/nowhere
  [ "$status" -ne 0 ]
  [[ "$output" = *'no executables in "/nowhere"'* ]]
}

@test "a batch makes each model once and every pair" {
  run batch PAIRS=all -j3
  [ "$status" = 0 ]
  [ "$(grep -c ^segment log)" = 3 ]
  [ "$(grep -c ^hull-to-hull log)" = 6 ]
  [ "$(grep -c '^row' <<<"$output")" = 6 ]
}

@test "a batch makes the pairs of the list and adds others later" {
  batch PAIRS="a:b b:a"
  ran
  batch PAIRS="a:b b:a a:c"
  [ "$(ran)" = "segment hull map-to-hull hull-to-hull reconstruct critical-points relocate measure measure " ]
  batch -q results PAIRS="a:b b:a a:c"
}

@test "a pair of a batch has the bytes of the pair made alone" {
  pair
  mv out alone
  batch PAIRS=a:b
  cmp alone/compatible.ply out/a-b/compatible.ply
  cmp alone/measure.json out/a-b/measure.json
}

@test "a failing pair does not stop the others, is named, and makes the exit code nonzero" {
  echo BROKEN >models/c.ply
  run batch PAIRS="a:b a:c b:a c:b"
  [ "$status" -ne 0 ]
  [[ "$output" = *"segment: models/c.ply: broken"* ]]
  [[ "$output" = *"row out/a-b/measure.json"* ]]
  [[ "$output" = *"row out/b-a/measure.json"* ]]
  [[ "$output" = *"failed: a-c"* ]]
  [[ "$output" = *"failed: c-b"* ]]
  [[ "$output" != *"failed: a-b"* ]]
}

@test "a pair that fails now is named even when it has figures from before" {
  batch PAIRS="a:b b:c"
  sleep 0.02
  echo BROKEN >models/c.sketch.json
  run batch PAIRS="a:b b:c"
  [ "$status" -ne 0 ]
  [[ "$output" = *"failed: b-c"* ]]
  [[ "$output" != *"failed: a-b"* ]]
}

@test "documents of stages beside the models are no models" {
  touch models/a.segment.ply
  batch PAIRS=all
  [ ! -d out/a.segment-b ]
  [ "$(ls -d out/*-* | wc -l)" = 6 ]
}

@test "unknown and ill-formed pairs are refused with a word" {
  run batch PAIRS="a:b a"
  [ "$status" -ne 0 ]
  [[ "$output" = *'"a" is not SOURCE:TARGET'* ]]
  run batch PAIRS="a:z"
  [ "$status" -ne 0 ]
  [[ "$output" = *"there is no models/z.ply"* ]]
}
