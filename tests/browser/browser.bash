# For tests that drive pages in a headless browser.

# make_page FOLDER PAGE [OPTION...]: the page of a pair or, with --index, of a batch.
make_page() {
  local message
  message=$("$PARTWISE_BIN/report" "$1" --force -o "$2" "${@:3}" 2>&1) && return
  [[ "$message" != *"has no pages"* ]] || missing_browser "$message"
  echo "$message"
  return 1
}

# browser_test SCRIPT [ARGUMENT...]
# Runs tests/browser/SCRIPT by node, in PARTWISE_BROWSER: chromium, unless it says firefox-esr. Where that, node or npm's
# registry is missing the test is skipped, unless PARTWISE_REQUIRE_BROWSER is set.
browser_test() {
  local here=$BATS_TEST_DIRNAME/../browser script=$1 browser=${PARTWISE_BROWSER:-chromium}
  shift
  command -v "$browser" >/dev/null || missing_browser "there is no $browser"
  command -v npm >/dev/null || missing_browser "there is no npm"
  browser_driver "$here" || missing_browser "npm could not bring playwright-core"
  NODE_PATH="$PARTWISE_BUILD/tests/browser/node_modules" node --test-reporter=spec "$here/$script" "$@"
}

# The npm packages that the report's pages were bundled from: three.js and esbuild.
page_modules() {
  local modules=$PARTWISE_BUILD/libcommon/report/pages/node_modules
  [ -d "$modules/three" ] || missing_browser "this build has no npm packages"
  echo "$modules"
}

missing_browser() {
  [ -z "${PARTWISE_REQUIRE_BROWSER:-}" ] || { echo "$1, and PARTWISE_REQUIRE_BROWSER is set"; return 1; }
  skip "$1"
}

# Installs the driver, in the version of the lock, once per build.
browser_driver() (
  folder=$PARTWISE_BUILD/tests/browser
  mkdir -p "$folder"
  exec 9>"$folder/lock"
  flock 9
  ! cmp -s "$1/package-lock.json" "$folder/installed-lock.json" || exit 0
  cp "$1/package.json" "$1/package-lock.json" "$folder"
  (cd "$folder" && npm ci --ignore-scripts --no-audit --no-fund --loglevel=error) >&2 &&
    cp "$1/package-lock.json" "$folder/installed-lock.json"
)
