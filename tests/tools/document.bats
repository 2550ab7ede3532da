load setup

bats_require_minimum_version 1.5.0

# A bare PLY of another program, mesh.ply, and a document made of it, parts.ply with parts.json.
documents() {
  tetrahedron
  {
    printf '%s\n' ply 'format ascii 1.0' 'element vertex 4' 'property float x' 'property float y' \
      'property float z' 'element face 4' 'property list uchar int vertex_index' end_header
    tail -n +3 tetrahedron.off
  } > mesh.ply
  segment mesh.ply --output parts.ply
}

# Replaces the byte at offset $2 of file $1 by $3.
patch_byte() {
  printf "$3" | dd of="$1" bs=1 seek="$2" conv=notrunc status=none
}

@test "document shows kind, elements, facts and history" {
  documents
  run -0 document parts.ply
  [[ "$output" == *"segment (partwise/segment-1)"* ]]
  [[ "$output" == *"vertex            4: x y z (double)"* ]]
  [[ "$output" == *"0  segment "* ]]
}

@test "document shows the same of a file and of a pipe" {
  documents
  document parts.ply > file.txt
  segment mesh.ply | document > pipe.txt
  diff file.txt pipe.txt
}

@test "document --json prints the metadata" {
  documents
  document --json parts.ply > metadata.json
  diff metadata.json parts.json
}

@test "document reads a PLY of others" {
  documents
  run -0 document mesh.ply
  [[ "$output" == *"kind              mesh"* ]]
  document --check mesh.ply
}

@test "document --check passes what a stage wrote, without a word" {
  documents
  run -0 document --check parts.ply
  [ -z "$output" ]
  segment mesh.ply | document --check
}

@test "document --check refuses a changed byte in the tables" {
  documents
  size=$(stat -c %s parts.ply)
  patch_byte parts.ply $((size - 60)) 'Z'
  run -3 document --check parts.ply
  [[ "$output" == *"document: parts.ply: "* ]]
}

@test "document --check refuses a truncated file" {
  documents
  truncate -s -1 parts.ply
  run -3 document --check parts.ply
  [[ "$output" == *"parts.ply"* ]]
}

@test "document --check refuses a changed sidecar" {
  documents
  sed -i 's/"faces": 4/"faces": 5/' parts.json
  run -3 document --check parts.ply
  [[ "$output" == *"parts.json"* ]]
}

@test "document --check refuses metadata that contradict the tables, although all checksums fit" {
  documents
  segment mesh.ply | document --json | sed 's/"faces": 4/"faces": 5/' > parts.json
  digest=$(sha256sum < parts.json | cut -d ' ' -f 1)
  sed -i "s/^comment partwise sidecar sha256:.*/comment partwise sidecar sha256:$digest/" parts.ply
  run -3 document --check parts.ply
  [[ "$output" == *"/parts/0/faces"* ]]
}

@test "document --check refuses metadata that violate the schema" {
  documents
  segment mesh.ply | document --json | sed 's/"faces": 4/"faces": -4/' > parts.json
  digest=$(sha256sum < parts.json | cut -d ' ' -f 1)
  sed -i "s/^comment partwise sidecar sha256:.*/comment partwise sidecar sha256:$digest/" parts.ply
  run -3 document parts.ply
  [[ "$output" == *"/parts/0/faces"* ]]
}

@test "document of a missing file is an I/O error" {
  run -4 document none.ply
  [[ "$output" == *"none.ply"* ]]
}

@test "document refuses --json together with --check" {
  documents
  run -2 document --json --check parts.ply
}

@test "document ends quietly when nobody reads on" {
  documents
  { sleep 0.3; document parts.ply 2> complaints.txt || true; } | true
  [ ! -s complaints.txt ]
}
