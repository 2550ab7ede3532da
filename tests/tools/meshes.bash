# Small meshes as ASCII PLY, for tests that need a shape and no more. Usage: octahedron >file.ply

# ply VERTICES FACETS: the header.
ply() {
  printf 'ply\nformat ascii 1.0\nelement vertex %d\n' "$1"
  printf 'property double %s\n' x y z
  printf 'element face %d\nproperty list uchar int vertex_indices\nend_header\n' "$2"
}

octahedron() {
  ply 6 8
  printf '%s\n' '1 0 0' '-1 0 0' '0 1 0' '0 -1 0' '0 0 1' '0 0 -1'
  printf '3 %s\n' '0 2 4' '2 1 4' '1 3 4' '3 0 4' '2 0 5' '1 2 5' '3 1 5' '0 3 5'
}

# A square cut in two: flat, with a boundary.
square() {
  ply 4 2
  printf '%s\n' '0 0 0' '1 0 0' '1 1 0' '0 1 0'
  printf '3 %s\n' '0 1 2' '0 2 3'
}

# torus AROUND ACROSS: a tube of radius 1 around a circle of radius 3.
torus() {
  ply $(($1 * $2)) $((2 * $1 * $2))
  awk -v around="$1" -v across="$2" 'BEGIN {
    turn = 8 * atan2(1, 1)
    for (i = 0; i < around; ++i) for (j = 0; j < across; ++j) {
      r = 3 + cos(turn * j / across)
      printf "%.17g %.17g %.17g\n", r * cos(turn * i / around), r * sin(turn * i / around), sin(turn * j / across)
    }
    for (i = 0; i < around; ++i) for (j = 0; j < across; ++j) {
      a = i * across + j; b = (i + 1) % around * across + j
      c = (i + 1) % around * across + (j + 1) % across; d = i * across + (j + 1) % across
      printf "3 %d %d %d\n3 %d %d %d\n", a, b, c, a, c, d
    }
  }'
}
