# Sourced by tests that need an npm package. node_package NAME@VERSION installs it once into build/node and prints that
# folder; it fails, with the reason on stderr, when node or npm is missing or the package cannot be fetched.
node_package() {
  local folder=build/node name=${1%@*}
  command -v node >/dev/null || { echo "node is missing" >&2; return 1; }
  command -v npm >/dev/null || { echo "npm is missing" >&2; return 1; }
  mkdir -p "$folder"
  (
    flock 9
    if ! grep -qsF "\"version\": \"${1##*@}\"" "$folder/node_modules/$name/package.json"; then
      npm install --prefix "$folder" --no-audit --no-fund --fetch-retries 0 --fetch-timeout 30000 --silent "$1" \
        >/dev/null 2>&1 || { echo "npm cannot install $1 (offline?)" >&2; exit 1; }
    fi
  ) 9>"$folder/lock" || return 1
  (cd "$folder" && pwd)
}
