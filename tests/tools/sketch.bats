# shellcheck shell=bash disable=SC2154  # bats sets status and output
# The server of sketch, attacked over real sockets. What it answers to whom is tested in tests/unit/sketching, too.
bats_require_minimum_version 1.5.0
load setup

teardown() {
  [ -z "${server:-}" ] || kill -9 "$server" 2>/dev/null || true
}

# Starts sketch and sets server (its process), address, and its parts: start [argument...]
start() {
  : >address.txt
  sketch "$@" >address.txt 2>errors.txt 3>&- &
  server=$!
  for _ in $(seq 500); do
    address=$(cat address.txt)
    [ -z "$address" ] || break
    kill -0 "$server" 2>/dev/null || { cat errors.txt; return 1; }
    sleep 0.01
  done
  [[ "$address" =~ ^http://127\.0\.0\.1:([0-9]+)/([0-9a-f]{32})/$ ]] || { echo "no address: $address"; return 1; }
  port=${BASH_REMATCH[1]} token=${BASH_REMATCH[2]}
}

# HTTP status of a request, the answer in answer.txt: ask [option of curl...]
ask() {
  curl --silent --max-time 20 --path-as-is --output answer.txt --write-out '%{http_code}' "$@"
}

# The same that changes the sketch of the first mesh: put BODY [option of curl...]
put() {
  put_as "http://127.0.0.1:$port" application/json "$@"
}

# The same with another origin or type, which may be empty: put_as ORIGIN TYPE BODY [option of curl...]
put_as() {
  ask -X PUT -H "Origin:${1:+ $1}" -H "Content-Type:${2:+ $2}" --data-binary "$3" "${@:4}" \
    "${address}models/0/sketch"
}

# Expects two words to be equal: expect_equal <found> <wanted>
expect_equal() {
  [ "$1" = "$2" ] || { echo "$1 instead of $2: $(head -c 300 answer.txt 2>/dev/null)"; return 1; }
}

# Ends the server by a signal and expects its exit code: expect_end <signal> <code>
expect_end() {
  local code=0
  kill -"$1" "$server"
  wait "$server" || code=$?
  server=
  expect_equal "$code" "$2"
}

# The part of every facet of a segment document, one per line: labels_of <file.ply>
labels_of() {
  local header vertices facets
  header=$(grep -a -b -m 1 '^end_header' "$1" | cut -d: -f1)
  vertices=$(sed -n 's/^element vertex //p;/^end_header/q' "$1")
  facets=$(sed -n 's/^element face //p;/^end_header/q' "$1")
  # Vertices have 3 doubles and 3 octets; facets an octet and 3 + 1 integers, the last of them the part, and 3 octets.
  tail -c +$((header + 12 + vertices * 27)) "$1" | head -c $((facets * 20)) |
    od -An -v -tu1 -w20 | awk '{ print $14 }'
}

two_parts='{"schema": "partwise/sketch-1", "parts": [
  {"name": "top", "strokes": [{"points": [[0, 0, 1]]}]}, {"name": "bottom", "strokes": [{"points": [[0, 0, -1]]}]}]}'

@test "what is drawn is saved at once, and segment cuts the saved sketch likewise" {
  sphere 6 ball.off
  start ball.off
  expect_equal "$(put "$two_parts")" 200
  jq -r .labels answer.txt | base64 -d | od -An -v -tu1 -w1 | tr -d ' ' >shown.txt
  expect_equal "$(wc -l <shown.txt)" 288
  expect_end KILL 137
  expect_files . ball.off ball.sketch.json address.txt errors.txt answer.txt shown.txt
  segment <(convert-mesh ball.off) --sketch ball.sketch.json --quiet -o cut.ply
  labels_of cut.ply >cut.txt
  diff shown.txt cut.txt
}

@test "only who knows the token, from the page itself, is answered" {
  sphere 2 ball.off
  start ball.off
  expect_equal "$(ask "$address")" 200
  expect_equal "$(ask "http://127.0.0.1:$port/")" 403
  expect_equal "$(ask "http://127.0.0.1:$port/${token:0:31}/")" 403
  expect_equal "$(ask "http://127.0.0.1:$port/$(tr 0-9a-f 1-9a-f0 <<<"$token")/models/0/mesh")" 403
  expect_equal "$(ask -H "Host: evil.example:$port" "$address")" 403
  expect_equal "$(ask -H 'Host:' "$address")" 403
  expect_equal "$(ask -H 'Origin: http://evil.example' "${address}models")" 403
  expect_equal "$(put_as http://evil.example application/json "$two_parts")" 403
  expect_equal "$(put_as '' application/json "$two_parts")" 403
  expect_equal "$(put_as "http://127.0.0.1:$port" text/plain "$two_parts")" 415
  expect_equal "$(ask -X OPTIONS -H 'Origin: http://evil.example' -D headers.txt "$address")" 403
  run ! grep -i access-control-allow headers.txt
  [ ! -e ball.sketch.json ]
}

@test "no path of a request is opened" {
  sphere 2 ball.off
  start ball.off
  for path in ../ball.off ball.off models/0/../../ball.off ..%2f..%2fetc%2fpasswd %2e%2e/%2e%2e/etc/passwd \
    /etc/passwd models/0/mesh%00.txt models/../../../../../etc/passwd; do
    expect_equal "$(ask "$address$path")" 404
    run ! grep -E 'OFF|root:' answer.txt
  done
  expect_equal "$(ask "http://127.0.0.1:$port/../../../../etc/passwd")" 403
}

@test "bodies and addresses are bounded, and broken ones do no harm" {
  sphere 2 ball.off
  start ball.off
  put "$two_parts"
  cp ball.sketch.json before.json
  truncate -s 65M large.json
  expect_equal "$(put @large.json -H 'Expect:')" 413
  expect_equal "$(put "$two_parts" -H 'Transfer-Encoding: chunked')" 411
  expect_equal "$(gzip <<<"$two_parts" | put @- -H 'Content-Encoding: gzip')" 411
  expect_equal "$(ask "$address$(printf 'x%.0s' $(seq 9000))")" 414
  for body in '' '{' '[]' 'null' '{"schema": "partwise/sketch-9"}' '{"schema": "partwise/sketch-1", "parts": 7}'; do
    expect_equal "$(put "$body")" 400
    jq -e '.error | length > 0' answer.txt
  done
  { printf '{"note":'; head -c 2000000 /dev/zero | tr '\0' '['; } >deep.json
  expect_equal "$(put @deep.json)" 400
  printf '\377\376\000{' >octets.json
  expect_equal "$(put @octets.json)" 400
  printf 'nonsense\r\n\r\n' >/dev/tcp/127.0.0.1/"$port"
  cmp ball.sketch.json before.json
  expect_equal "$(ask "$address")" 200
}

@test "a marker's place is mirrored, and nothing else is taken for one" {
  sphere 6 ball.off
  start ball.off
  local change=(-X POST -H "Origin: http://127.0.0.1:$port" -H 'Content-Type: application/json')
  expect_equal "$(ask "${change[@]}" -d '{"face": 5, "barycentric": [0.2, 0.3, 0.5]}' "${address}models/0/mirror")" 200
  jq -e '.face >= 0 or . == {}' answer.txt
  expect_equal "$(ask "${change[@]}" -d '{"face": 9999, "barycentric": [1, 0, 0]}' "${address}models/0/mirror")" 400
  truncate -s 1001 large.json
  expect_equal "$(ask "${change[@]}" --data-binary @large.json "${address}models/0/mirror")" 413
  expect_equal "$(ask -X POST -d '{"face": 5}' "${address}models/0/mirror")" 403
}

@test "answers are sent as they are, which is quicker than compressing them" {
  sphere 6 ball.off
  start ball.off
  expect_equal "$(ask -H 'Accept-Encoding: br, gzip' -D headers.txt "${address}models/0/result")" 200
  run ! grep -i content-encoding headers.txt
  jq -e .parts answer.txt
}

@test "nothing listens but the loopback address" {
  sphere 2 ball.off
  start ball.off
  run -0 ss -Hltn "sport = :$port"
  expect_equal "${#lines[@]}" 1
  expect_text "127.0.0.1:$port"
}

@test "signals end it, unread connections or not" {
  sphere 2 ball.off
  start ball.off
  exec 7<>/dev/tcp/127.0.0.1/"$port"
  printf 'GET / HTTP/1.1\r\n' >&7
  expect_end TERM 0
  exec 7>&-
  start ball.off
  expect_end INT 0
}

@test "a port that is taken" {
  sphere 2 ball.off
  start ball.off
  run timeout 10 sketch ball.off --port "$port"
  expect_code 4
  expect_text "port $port of 127.0.0.1 is taken"
}

@test "meshes that would share a sketch, sketches of other meshes" {
  sphere 2 ball.off
  mkdir other
  sphere 3 other/ball.off
  run timeout 10 sketch ball.off other/ball.off --sketch-b ./ball.sketch.json
  expect_code 2
  echo '{"schema": "partwise/sketch-1", "mesh": {"vertices": 4, "faces": 4}}' >ball.sketch.json
  run timeout 10 sketch ball.off
  expect_code 3
  expect_text "ball.sketch.json"
}

@test "a run is cancelled with all its processes" {
  sphere 16 a.off
  cp a.off b.off
  start a.off b.off --out results
  local change=(-H "Origin: http://127.0.0.1:$port" -H 'Content-Type: application/json')
  expect_equal "$(put "$two_parts")" 200
  expect_equal "$(ask -X POST -d '{}' "${change[@]}" "${address}run")" 200
  expect_equal "$(jq -r .state answer.txt)" running
  group=$(pgrep -P "$server" make)
  [ -n "$group" ]
  expect_equal "$(ask -X DELETE "${change[@]}" "${address}run")" 200
  expect_equal "$(jq -r .state answer.txt)" cancelled
  run ! pgrep -g "$group"
  expect_equal "$(ask -X POST -d '{}' "${change[@]}" "${address}run")" 200
  group=$(pgrep -P "$server" make)
  expect_end TERM 0
  run ! pgrep -g "$group"
}
