# shellcheck shell=bash disable=SC2154  # bats sets status and output
# For every .bats file: `load setup`, then each test runs in an empty folder of its own, with the tools of the
# build on the path.

setup() {
  : "${PARTWISE_BIN:?names the folder with the executables}"
  PATH="$PARTWISE_BIN:$PATH"
  cd "$BATS_TEST_TMPDIR" || return 1
}

# A regular tetrahedron, as text to edit: tetrahedron [file.off]
tetrahedron() {
  cat > "${1:-tetrahedron.off}" <<'END'
OFF
4 4 6
1 1 1
-1 -1 1
-1 1 -1
1 -1 -1
3 0 2 1
3 0 1 3
3 0 3 2
3 1 2 3
END
}

# A sphere of 8 n^2 facets from a subdivided octahedron: sphere <n> <file.off>
sphere() {
  awk -v n="$1" '
    function vertex(x, y, z,    key, r) {
      key = x " " y " " z
      if (!(key in index_of)) {
        index_of[key] = count++
        r = sqrt(x * x + y * y + z * z)
        points = points sprintf("%.17g %.17g %.17g\n", x / r, y / r, z / r)
      }
      return index_of[key]
    }
    function facet(a, b, c) { facets = facets "3 " (mirrored ? a " " c " " b : a " " b " " c) "\n"; size++ }
    function corner(i, j) { return vertex(sx * i, sy * j, sz * (n - i - j)) }
    BEGIN {
      for (sx = -1; sx <= 1; sx += 2) for (sy = -1; sy <= 1; sy += 2) for (sz = -1; sz <= 1; sz += 2) {
        mirrored = sx * sy * sz < 0
        for (i = 0; i < n; i++) for (j = 0; j < n - i; j++) {
          facet(corner(i, j), corner(i + 1, j), corner(i, j + 1))
          if (j + 1 < n - i) facet(corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1))
        }
      }
      printf "OFF\n%d %d 0\n%s%s", count, size, points, facets
    }' > "$2"
}

# Expects the last `run` to have ended with this exit code, else shows what it said: expect_code <code>
expect_code() {
  if [ "$status" -ne "$1" ]; then
    echo "exit code $status instead of $1: $output"
    return 1
  fi
}

# Expects the output of the last `run` to contain a text: expect_text <text>
expect_text() {
  if [[ "$output" != *"$1"* ]]; then
    echo "\"$1\" is missing in: $output"
    return 1
  fi
}

# Expects a folder to hold exactly these files, hidden ones included: expect_files <folder> [name]...
expect_files() {
  local folder=$1 found
  shift
  found=$(cd "$folder" && find . -mindepth 1 -printf '%P\n' | sort | tr '\n' ' ')
  if [ "$found" != "$(printf '%s\n' "$@" | sort | sed '/^$/d' | tr '\n' ' ')" ]; then
    echo "$folder holds: $found"
    return 1
  fi
}
