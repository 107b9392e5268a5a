#!/usr/bin/env bash
# lamella bench on one small net: what it prints, never how long it took.
set -u
cd "$(dirname "$0")/../.." || exit 1
lamella=$(realpath -m "${LAMELLA:-build/lamella}")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
number=0

run() {
  "$lamella" "$@" >"$scratch/out" 2>"$scratch/err"
  status=$?
}

ok() {
  local good=$?
  number=$((number + 1))
  if [[ $good -eq 0 ]]; then
    echo "ok $number - $1"
  else
    echo "not ok $number - $1"
    sed 's/^/# out: /' "$scratch/out" | head -5
    sed 's/^/# err: /' "$scratch/err" | head -5
    echo "# exit status $status"
  fi
}

run bench --net chebyshev --most 500
[[ $status -eq 0 && $(grep -c '^  chebyshev  *441  *1323 ' "$scratch/out") -eq 1 ]]; ok "a table with one net of one size"
run bench --json --net chebyshev --most 2000
[[ $status -eq 0 ]] && python3 - "$scratch/out" <<'P'; ok "the same as JSON, converged, with what was measured"
import json, sys
rows = json.load(open(sys.argv[1]))
assert [r["vertices"] for r in rows] == [441, 1681]
for r in rows:
    assert r["net"] == "chebyshev" and r["converged"] and r["residual"] <= 1e-8 and r["iterations"] > 0
    assert r["edge_variation"] < 1e-7 and r["unknowns"] == 3 * r["vertices"] and r["step_ms"] > 0
P
run bench --net nowhere
[[ $status -eq 2 && ! -s $scratch/out ]] && grep -q 'there is no net called nowhere' "$scratch/err"; ok "an unknown net is refused"
run bench --most few
[[ $status -eq 2 && ! -s $scratch/out ]] && grep -q -- '--most few' "$scratch/err"; ok "a size that is no number is refused"
run bench --help
[[ $status -eq 0 ]] && grep -q '^usage: lamella bench' "$scratch/out"; ok "bench --help shows how to use it"

echo "1..$number"
