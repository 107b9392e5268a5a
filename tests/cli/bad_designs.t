#!/usr/bin/env bash
# Every file in tests/cases/bad-designs is refused: exit status 2, exactly the messages that its first lines expect, nothing on
# stdout, nothing written. An expectation is "# expect: LINE:COLUMN: KEY: TEXT"; "..." in it stands for a list of names that
# grows with the registries.
set -u
cd "$(dirname "$0")/../.." || exit 1
lamella=$(realpath -m "${LAMELLA:-build/lamella}")
root=$PWD
export LAMELLA_TEMPLATES=$root/templates
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# matches LINE EXPECTED: "..." matches anything.
matches() {
  local line=$1 expected=$2
  [[ $expected == *...* ]] || { [[ $line == "$expected" ]]; return; }
  [[ $line == "${expected%%...*}"*"${expected#*...}" ]]
}

# check_messages NAME: compares the lines of $scratch/err with the expectations; prints what differs.
check_messages() {
  local name=$1 status=0 i
  mapfile -t expected < <(LC_ALL=C sed -n '/^# expect: /!q;s/^# expect: //p' "$name")
  mapfile -t given < "$scratch/err"
  if [[ ${#expected[@]} -eq 0 || ${#expected[@]} -ne ${#given[@]} ]]; then
    echo "# ${#expected[@]} messages expected, ${#given[@]} given"
    printf '# %s\n' "${given[@]}"
    return 1
  fi
  for i in "${!expected[@]}"; do
    matches "${given[i]}" "$name:${expected[i]}" && continue
    matches "${given[i]}" "$name: ${expected[i]}" && continue
    echo "# expected $name:${expected[i]}"
    echo "# given    ${given[i]}"
    status=1
  done
  return "$status"
}

# refused NAME: checks everything that the file promises.
refused() {
  local name=$1 status
  cd "$scratch/work" || return 1
  "$lamella" check "$name" >"$scratch/out" 2>"$scratch/err"
  status=$?
  [[ $status -eq 2 ]] || { echo "# check: exit status $status, expected 2"; cat "$scratch/err"; return 1; }
  [[ ! -s $scratch/out ]] || { echo "# check: wrote to stdout"; return 1; }
  check_messages "$name" || return 1
  "$lamella" build "$name" -o "$scratch/work/made" >/dev/null 2>&1
  status=$?
  [[ $status -eq 2 ]] || { echo "# build: exit status $status, expected 2"; return 1; }
  [[ $(ls "$scratch/work") == tests ]] || { echo "# something was written: $(ls "$scratch/work")"; return 1; }
}

# The names in messages are those given: a link gives the scratch folder the same relative names.
mkdir -p "$scratch/work"
ln -s "$root/tests" "$scratch/work/tests"
files=(tests/cases/bad-designs/*.yaml)
before=$(ls tests/cases/bad-designs)
echo "1..$((${#files[@]} + 1))"
number=0
for name in "${files[@]}"; do
  number=$((number + 1))
  if (refused "$name"); then echo "ok $number - $(basename "$name" .yaml)"; else echo "not ok $number - $(basename "$name" .yaml)"; fi
done
number=$((number + 1))
if [[ $(ls tests/cases/bad-designs) == "$before" && ${#files[@]} -ge 30 ]]; then
  echo "ok $number - at least 30 bad designs, none of them touched"
else
  echo "not ok $number - at least 30 bad designs, none of them touched"
fi
