#!/usr/bin/env bash
# Memory that runs out anywhere: a sample of the allocations of every verb and of a dozen designs fails, in libraries
# too. `tests/torture/allocations.py LIBRARY PROGRAM 0` fails all of them, which takes half an hour.
set -u
cd "$(dirname "$0")/../.." || exit 1
program=${LAMELLA:-build/lamella}
export LAMELLA_TEMPLATES=$PWD/templates
skip() { echo "1..0"; echo "ok 1 # SKIP $1"; exit 0; }
nm -D "$program" 2>/dev/null | grep -qE '__[at]san' && skip "sanitizers have an allocator of their own"
command -v python3 >/dev/null || skip "python3 is not installed"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
${CC:-cc} -O2 -std=c11 -D_GNU_SOURCE -shared -fPIC -o "$scratch/fail.so" tests/torture/preload/fail_allocation.c || exit 1
python3 tests/torture/allocations.py "$scratch/fail.so" "$program" 4
