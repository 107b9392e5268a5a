# Sourced by tests of the program's verbs: a scratch folder to run in, and TAP.
cd "$(dirname "$0")/../.." || exit 1
project=$PWD
lamella=$(realpath -m "${LAMELLA:-build/lamella}")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
number=0

# run ARGUMENTS: leaves status, out and err.
run() {
  "$lamella" "$@" >out 2>err
  status=$?
}
# ok NAME CONDITION...: a test that passes when the condition, a command, succeeds.
ok() {
  local name=$1
  shift
  number=$((number + 1))
  if "$@"; then
    echo "ok $number - $name"
  else
    echo "not ok $number - $name"
    echo "# exit code $status"
    sed 's/^/# /' out err | head -30
  fi
}
