# What `cmake --install` brings, installed under a temporary prefix.
load pipelines.bash

setup_file() {
  export PREFIX=$BATS_FILE_TMPDIR/prefix
  cmake --install "$PARTWISE_BUILD" --prefix "$PREFIX" >/dev/null
}

@test "one command on the path, the tools behind it" {
  [ "$(ls "$PREFIX/bin")" = partwise ]
  for tool in convert-mesh segment hull map-to-hull hull-to-hull reconstruct critical-points relocate measure morph transfer \
    picture report; do
    [ -x "$PREFIX/libexec/partwise/$tool" ]
  done
}

@test "partwise runs a tool with its arguments and exit code" {
  run "$PREFIX/bin/partwise" hull --help
  [ "$status" = 0 ]
  [[ "$output" = *"Usage: "*hull* ]]
  run "$PREFIX/bin/partwise" hull "$BATS_TEST_TMPDIR/no such file.ply" -o "$BATS_TEST_TMPDIR/out.ply"
  [ "$status" = 4 ]
  [[ "$output" = "hull: "*"no such file.ply"* ]]
}

@test "partwise works through a link and from a moved installation" {
  mkdir "$BATS_TEST_TMPDIR/elsewhere"
  cp -r "$PREFIX" "$BATS_TEST_TMPDIR/elsewhere/moved"
  ln -s "$BATS_TEST_TMPDIR/elsewhere/moved/bin/partwise" "$BATS_TEST_TMPDIR/pw"
  "$BATS_TEST_TMPDIR/pw" segment --help
}

@test "partwise lists its tools and refuses others" {
  run "$PREFIX/bin/partwise"
  [ "$status" = 0 ]
  [[ "$output" = *map-to-hull* ]]
  run "$PREFIX/bin/partwise" rm -rf
  [ "$status" = 2 ]
  [[ "$output" = *'"rm" is no tool of partwise'* ]]
  run "$PREFIX/bin/partwise" ../../bin/partwise
  [ "$status" = 2 ]
}

@test "schemas and pipelines lie beside, and the pipelines use the installed tools" {
  [ -f "$PREFIX/share/partwise/schemas/sketch-1.schema.json" ]
  [ -f "$PREFIX/share/partwise/pipelines/sketches/camel.sketch.json" ]
  cd "$BATS_TEST_TMPDIR"
  sphere 6 8 1 1 1 >ball.off
  sphere 6 9 1 1.2 1 >egg.off
  run env -u PARTWISE_BIN "$PREFIX/bin/partwise" cross-parameterize SOURCE=ball.off TARGET=egg.off OUT=out -n
  echo "$output"
  [ "$status" = 0 ]
  [[ "$output" = *"libexec/partwise/hull-to-hull"* ]]
}

@test "every tool has a man page" {
  command -v help2man >/dev/null || skip "there is no help2man"
  for tool in "$PREFIX"/libexec/partwise/*; do
    page=$PREFIX/share/man/man1/partwise-${tool##*/}.1
    grep -q '^.B partwise' "$page"
  done
}
