# The tool segment: its documents, --check, and what it says of sketches that do not fit.

setup() {
  cd "$BATS_TEST_TMPDIR"
  PATH=$PARTWISE_BIN:$PATH
  sample_mesh capsule capsule.ply
  sample_mesh torus torus.ply
  # The capsule's axis is z; vertex 0 is its south pole, 1057 the north pole.
  sketch good <<<'{"name": "south", "strokes": [{"vertices": [0, 60]}]},
                  {"name": "north", "strokes": [{"vertices": [1057, 1000]}]}'
}

# Writes NAME.sketch.json with the parts on standard input and, optionally, further members.
sketch() {
  printf '{"schema": "partwise/sketch-1", "parts": [%s]%s}\n' "$(cat)" "${2:+, $2}" >"$1.sketch.json"
}

# fails CODE TEXT COMMAND...: the command ends with CODE, its message contains TEXT, nothing is left behind.
fails() {
  local code=$1 text=$2
  shift 2
  run "$@"
  [ "$status" -eq "$code" ] || { echo "exit $status: $output"; return 1; }
  [[ "$output" == segment:*"$text"* ]] || { echo "$output"; return 1; }
  ! compgen -G '*out*' || return 1
}

@test "a sketch cuts the mesh into parts" {
  segment capsule.ply --sketch good.sketch.json -o out.ply
  jq -e '.schema == "partwise/segment-1" and .history[-1].tool == "segment"' out.json
  jq -e '.metrics.segment | .parts == 2 and .curves == 1 and .cross_points == 0' out.json
  jq -e '.curves[0].roughness > 1 and .curves[0].roughness < 1.2' out.json
  jq -e '(.metrics.segment.mean_roughness - .curves[0].roughness) | fabs < 1e-9' out.json
}

@test "the same bytes on every run, by file and by pipe" {
  segment capsule.ply --sketch good.sketch.json -o a.ply
  sample_mesh capsule - | segment - --sketch good.sketch.json -o b.ply
  cmp a.ply b.ply
  cmp a.json b.json
  segment capsule.ply --sketch good.sketch.json >c.ply
  segment --check a.ply c.ply
}

@test "growth as in the paper" {
  segment capsule.ply --sketch good.sketch.json --method growth -o grown.ply
  jq -e '.metrics.segment.curves == 1 and .history[-1].arguments.method == "growth"' grown.json
  segment capsule.ply --sketch good.sketch.json -o walked.ply
  segment --check grown.ply walked.ply
  segment capsule.ply --sketch good.sketch.json --method growth --refine-boundaries off -o raw.ply
  jq -en --slurpfile raw raw.json --slurpfile grown grown.json '$grown[0].curves[0].length <= $raw[0].curves[0].length'
}

@test "without a sketch the mesh is one part" {
  segment torus.ply -o out.ply
  jq -e '.metrics.segment | .parts == 1 and .curves == 0' out.json
  echo '{"schema": "partwise/sketch-1"}' >empty.sketch.json
  segment torus.ply --sketch empty.sketch.json -o empty.ply
  segment --check out.ply empty.ply
}

@test "a stroke on the screen seeds what it covers" {
  # Orthographic, from +x: screen x is y of the model, screen y (down) is -z. The capsule spans z from -3 to 3.
  camera='"camera": {"view": [0,1,0,0, 0,0,1,0, 1,0,0,-10, 0,0,0,1],
                     "projection": [0.25,0,0,0, 0,0.25,0,0, 0,0,-0.05,-1, 0,0,0,1], "viewport": [400, 400]}'
  sketch screen <<<"{\"name\": \"south\", \"strokes\": [{\"screen\": [[200, 280], [200, 340]], $camera}]},
                    {\"name\": \"north\", \"strokes\": [{\"screen\": [[200, 120], [200, 60]], $camera}]}"
  segment capsule.ply --sketch screen.sketch.json -o screen.ply
  segment capsule.ply --sketch good.sketch.json -o vertices.ply
  segment --check screen.ply vertices.ply
  # Neither the order of strokes and points nor repetition matters.
  sketch turned <<<"{\"name\": \"south\", \"strokes\": [{\"screen\": [[200, 340], [200, 280], [200, 340]], $camera}]},
                    {\"name\": \"north\", \"strokes\": [{\"screen\": [[200, 60], [200, 120]], $camera}]}"
  segment capsule.ply --sketch turned.sketch.json -o turned.ply
  cmp <(sample_mesh labels screen.ply) <(sample_mesh labels turned.ply)
  sketch beside <<<"{\"name\": \"south\", \"strokes\": [{\"screen\": [[1, 1], [9, 9]], $camera}]},
                    {\"name\": \"north\", \"strokes\": [{\"vertices\": [1057]}]}"
  fails 3 "part 'south', stroke 0: the polyline misses the mesh" segment capsule.ply -s beside.sketch.json -o out.ply
}

@test "bad sketches are refused with part, stroke and entry" {
  sketch unknown <<<'{"name": "south", "strokes": [{"vertices": [0]}, {"vertices": [3, 999999]}]},
                     {"name": "north", "strokes": [{"vertices": [1057]}]}'
  fails 3 "unknown.sketch.json: part 'south', stroke 1, entry 1: there is no vertex 999999" \
    segment capsule.ply -s unknown.sketch.json -o out.ply
  sketch far <<<'{"name": "south", "strokes": [{"points": [[0, 0, -30]]}]},
                 {"name": "north", "strokes": [{"vertices": [1057]}]}'
  fails 3 "far.sketch.json: part 'south', stroke 0, entry 0: the point lies" \
    segment capsule.ply -s far.sketch.json -o out.ply
  sketch bare <<<'{"name": "south"}, {"name": "north", "strokes": [{"vertices": [1057]}]}'
  fails 3 "part 'south' has no stroke" segment capsule.ply -s bare.sketch.json -o out.ply
  sketch twice <<<'{"name": "south"}, {"name": "south"}'
  fails 3 "the name 'south' is used twice" segment capsule.ply -s twice.sketch.json -o out.ply
  sketch lost '"markers": [{"name": "m", "face": 1, "barycentric": [0.5, 0.4, 0.4]}]' <<<''
  fails 3 "marker 'm': barycentric coordinates" segment capsule.ply -s lost.sketch.json -o out.ply
  sketch other '"mesh": {"vertices": 5, "faces": 6}' <<<''
  fails 3 "drawn for a mesh of 5 vertices" segment capsule.ply -s other.sketch.json -o out.ply
  echo '{"schema": "partwise/sketch-1", "parts": [' >broken.sketch.json
  fails 3 "broken.sketch.json: this is not JSON" segment capsule.ply -s broken.sketch.json -o out.ply
  fails 4 "nowhere.sketch.json" segment capsule.ply -s nowhere.sketch.json -o out.ply
}

@test "components without stroke, or with one part, are refused" {
  sample_mesh two-spheres two.ply
  fails 3 "the mesh has 2 components" segment two.ply -o out.ply
  sketch half <<<'{"name": "a", "strokes": [{"vertices": [0]}]}, {"name": "b", "strokes": [{"vertices": [5]}]}'
  fails 3 "has no stroke" segment two.ply -s half.sketch.json -o out.ply
}

@test "--check names every difference and where" {
  segment capsule.ply --sketch good.sketch.json -o a.ply
  sketch three '"markers": [{"name": "m", "vertex": 5}]' <<<'{"name": "south", "strokes": [{"vertices": [0, 60]}]},
    {"name": "waist", "strokes": [{"vertices": [500, 530]}]}, {"name": "north", "strokes": [{"vertices": [1057, 1000]}]}'
  segment capsule.ply --sketch three.sketch.json -o b.ply
  fails 3 "a.ply and b.ply: part 'waist' exists only in the second model" segment --check a.ply b.ply
  [[ "$output" == *"the parts 'north' and 'south' meet only in the first model (at vertex "* ]]
  [[ "$output" == *"marker 'm' exists only in the second model"* ]]
  fails 3 "a.ply and b.ply" segment --check a.ply a.ply b.ply
  fails 3 "kind mesh" segment --check a.ply capsule.ply
  fails 2 "" segment --check a.ply
}

@test "hints: parts to decompose, boundaries without anchors" {
  run segment capsule.ply --sketch good.sketch.json --tau 0.001 -o one.ply
  [ "$status" -eq 0 ]
  [[ "$output" == *"warning: part 'south': decompose further near vertex "* ]]
  [[ "$output" == *"warning: the boundary between 'south' and 'north'"*"has no anchor"* ]]
  run segment capsule.ply --sketch good.sketch.json --tau 0.001 --quiet -o two.ply
  [ "$output" = "" ]
  cmp one.ply two.ply
}

@test "--labels-from copies to equal connectivity, and adds landmarks" {
  sketch full '"markers": [{"name": "m", "vertex": 5}], "anchors": [{"name": "a", "between": ["south", "north"], "vertex": 500}]' \
    <<<'{"name": "south", "strokes": [{"vertices": [0, 60]}]}, {"name": "north", "strokes": [{"vertices": [1057, 1000]}]}'
  segment capsule.ply --sketch full.sketch.json -o from.ply
  run segment capsule.ply --labels-from from.ply -o to.ply --verbose
  [ "$status" -eq 0 ]
  [[ "$output" == *"equal connectivity: labels, markers and anchors are copied"* ]]
  segment --check from.ply to.ply
  cmp <(sample_mesh labels from.ply) <(sample_mesh labels to.ply)
  jq -e '.metrics.segment.labels | .copied and .moved_area == 0' to.json
  jq -e '(.history[-1].inputs | length) == 2' to.json
  [ "$(jq -c '[.markers, [.anchors[].vertex]]' from.json)" = "$(jq -c '[.markers, [.anchors[].vertex]]' to.json)" ]
  printf '{"schema": "partwise/sketch-1", "markers": [{"name": "m", "vertex": 9}, {"name": "n", "vertex": 8}]}' >more.sketch.json
  segment capsule.ply --labels-from from.ply --sketch more.sketch.json -o more.ply
  jq -e '[.markers[].name] == ["m", "n"] and (.anchors | length) == 1' more.json
  run segment capsule.ply --labels-from from.ply --sketch good.sketch.json -o strokes.ply
  [[ "$output" == *"warning: the sketch's strokes are not used"* ]]
}

@test "--labels-from carries parts to other triangles in the same place, and refuses other shapes" {
  sample_mesh fine-capsule fine.ply
  segment capsule.ply --sketch good.sketch.json -o from.ply
  segment fine.ply --labels-from from.ply -o to.ply
  segment --check from.ply to.ply
  jq -e '.metrics.segment.labels | (.copied | not) and .moved_area < 0.03' to.json
  fails 3 "torus.ply: the mesh lies" segment torus.ply --labels-from from.ply -o out.ply
  fails 3 "kind mesh" segment fine.ply --labels-from capsule.ply -o out.ply
  fails 2 "" segment fine.ply --align-boxes -o out.ply
}

@test "--propose-anchors writes proposals that decide nothing" {
  sketch marked '"markers": [{"name": "navel", "point": [0, 1, 0.4]}]' \
    <<<'{"name": "south", "strokes": [{"vertices": [0, 60]}]}, {"name": "north", "strokes": [{"vertices": [1057, 1000]}]}'
  segment capsule.ply --sketch marked.sketch.json --propose-anchors -o a.ply
  jq -e '[.anchors[] | .proposed] == [true, true] and .metrics.segment.proposed_anchors == 2' a.json
  jq -e '.anchors[0].name == "north-south near navel (proposed)"' a.json
  segment capsule.ply --sketch marked.sketch.json -o b.ply
  jq -e '.anchors == []' b.json
  segment --check a.ply b.ply
}

@test "--auto suggests a sketch that replays, and says that it is a suggestion" {
  run segment capsule.ply --auto 3 -o auto.sketch.json
  [ "$status" -eq 0 ]
  [[ "$output" == *"a suggestion"*"not a decision"* ]]
  jq -e '.schema == "partwise/sketch-1" and [.parts[].name] == ["core", "part 1", "part 2"]' auto.sketch.json
  segment capsule.ply --auto 3 -o - --quiet | cmp - auto.sketch.json
  segment capsule.ply --sketch auto.sketch.json -o auto.ply
  jq -e '.metrics.segment | .parts == 3 and .curves == 2' auto.json
  fails 4 "auto.sketch.json" segment capsule.ply --auto 3 -o auto.sketch.json
  fails 2 "" segment capsule.ply --auto 1 -o out.sketch.json
  sample_mesh two-spheres two.ply
  fails 3 "several components" segment two.ply --auto 3 -o out.sketch.json
}

@test "strokes that touch, parts that end empty, sketches of other meshes: who, where, what to do" {
  # The same vertex in two parts: nothing is left of the shorter stroke.
  sketch both <<<'{"name": "south", "strokes": [{"vertices": [0]}, {"vertices": [500]}]},
                  {"name": "north", "strokes": [{"vertices": [1057]}, {"vertices": [500]}]}'
  fails 3 "both.sketch.json: part 'south', stroke 1: strokes of other parts touch every facet it touches (near vertex 500)" \
    segment capsule.ply -s both.sketch.json -o out.ply
  [[ "$output" == *"move it away from them"* ]]
  # Touching strokes that both keep facets are no error.
  sketch touching <<<'{"name": "south", "strokes": [{"vertices": [0, 500]}]},
                      {"name": "north", "strokes": [{"vertices": [1057, 500]}]}'
  segment capsule.ply -s touching.sketch.json -o touching.ply
  jq -e '.metrics.segment.parts == 2' touching.json
  # A part all of whose strokes other parts cover would end empty.
  sketch covered <<<'{"name": "south", "strokes": [{"vertices": [0]}]}, {"name": "spot", "strokes": [{"vertices": [0]}]},
                     {"name": "north", "strokes": [{"vertices": [1057]}]}'
  fails 3 "part 'south', stroke 0: strokes of other parts" segment capsule.ply -s covered.sketch.json -o out.ply
  sketch foreign <<<'{"name": "south", "strokes": [{"vertices": [999999]}]}, {"name": "north", "strokes": [{"vertices": [1057]}]}'
  fails 3 "is this the sketch of another mesh?" segment capsule.ply -s foreign.sketch.json -o out.ply
  # Also where the parts come from elsewhere.
  segment capsule.ply --sketch good.sketch.json -o from.ply
  sketch other '"mesh": {"vertices": 5, "faces": 6}' <<<''
  fails 3 "drawn for a mesh of 5 vertices" segment capsule.ply --labels-from from.ply -s other.sketch.json -o out.ply
  sketch wing <<<'{"name": "wing"}'
  fails 3 "wing.sketch.json: part 'wing' is not among the parts of the labels" \
    segment capsule.ply --labels-from from.ply -s wing.sketch.json -o out.ply
}

@test "one stroke on each of two components is enough, and a part on both is refused" {
  sample_mesh two-spheres two.ply
  sketch each <<<"{\"name\": \"a\", \"strokes\": [{\"vertices\": [0]}]}, {\"name\": \"b\", \"strokes\": [{\"vertices\": [131]}]}"
  segment two.ply -s each.sketch.json -o each.ply
  jq -e '.metrics.segment | .parts == 2 and .curves == 0' each.json
  sketch across <<<"{\"name\": \"a\", \"strokes\": [{\"vertices\": [0, 131]}]}, {\"name\": \"b\", \"strokes\": [{\"vertices\": [5]}]}"
  fails 3 "part 'a' has strokes on two unconnected components of the mesh (vertices 0 and 131)" \
    segment two.ply -s across.sketch.json -o out.ply
}

@test "--split-edges lets boundaries cross facets and says what that adds" {
  sketch full '"markers": [{"name": "m", "vertex": 5}, {"name": "f", "face": 7, "barycentric": [0.2, 0.3, 0.5]}]' \
   <<<'{"name": "south", "strokes": [{"vertices": [0, 60]}]}, {"name": "north", "strokes": [{"vertices": [1057, 1000]}]}'
  segment capsule.ply --sketch full.sketch.json -o whole.ply
  run segment capsule.ply --sketch full.sketch.json --split-edges -o split.ply
  [ "$status" -eq 0 ]
  [[ "$output" == *"warning: edges are split: "*" are added to the mesh's own "* ]]
  added=$(jq '.metrics.segment.added_vertices' split.json)
  [ "$added" -gt 0 ]
  before=$(sed -n 's/^element vertex //p;/end_header/q' whole.ply)
  [ "$(sed -n 's/^element vertex //p;/end_header/q' split.ply)" -eq $((before + added)) ]
  segment --check whole.ply split.ply
  hull split.ply | map-to-hull -o mapped.ply
  jq -e '.metrics["map-to-hull"].folds == 0' mapped.json
  fails 2 "excludes" segment capsule.ply --labels-from whole.ply --split-edges -o out.ply
}

@test "--propose-cuts writes where to cut concave parts, as a sketch that replays" {
  sample_mesh jack jack.ply
  run segment jack.ply --tau 0.05 --propose-cuts cuts.sketch.json -o whole.ply
  [ "$status" -eq 0 ]
  [[ "$output" == *"warning: part 'whole': decompose further near vertex "*"; suggestion: cut it into "* ]]
  [[ "$output" == *"parts in cuts.sketch.json are a suggestion, not a decision"* ]]
  jq -e '.proposed_cuts | length == 1' whole.json
  jq -e '.parts[0].concavity.largest as $before | .proposed_cuts[0].pieces | all(.concavity.largest < $before)' whole.json
  jq -e '.proposed_cuts[0].curves | length > 0 and all((.vertices | length) > 2 and .length > 0)' whole.json
  segment jack.ply --sketch cuts.sketch.json -o cut.ply
  [ "$(jq '.parts | length' cut.json)" -eq "$(jq '.proposed_cuts[0].pieces | length' whole.json)" ]
  jq -e --argjson before "$(jq .parts[0].concavity.largest whole.json)" 'all(.parts[]; .concavity.largest < $before)' cut.json
  # A hint alone is in every document; nothing is written twice, and later stages do not carry it on.
  segment jack.ply --tau 0.05 --quiet -o again.ply
  cmp whole.json again.json
  hull again.ply -o hull.ply
  jq -e 'has("proposed_cuts") | not' hull.json
  fails 4 "cuts.sketch.json" segment jack.ply --tau 0.05 --propose-cuts cuts.sketch.json -o out.ply
  fails 2 "excludes" segment jack.ply --split-edges --propose-cuts out.sketch.json -o out.ply
  run segment capsule.ply --sketch good.sketch.json --propose-cuts same.sketch.json -o fine.ply
  [[ "$output" == *"no cut is proposed: same.sketch.json has no new part"* ]]
  jq -e '[.parts[].name] == ["south", "north"] and .parts[0].strokes == [{"vertices": [0, 60]}]' same.sketch.json
  jq -e 'has("proposed_cuts") | not' fine.json
}
