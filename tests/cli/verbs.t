#!/usr/bin/env bash
# The verbs that need no solver: list, show, new, check, --help and --version.
set -u
cd "$(dirname "$0")/../.." || exit 1
lamella=$(realpath -m "${LAMELLA:-build/lamella}")
export LAMELLA_TEMPLATES=$PWD/templates
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
number=0

# run ARGUMENTS: leaves status, $scratch/out and $scratch/err.
run() {
  (cd "$scratch" && "$lamella" "$@") >"$scratch/out" 2>"$scratch/err"
  status=$?
}

# ok NAME: reports the last command's success.
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

good_with() { [[ $status -eq 0 && ! -s $scratch/err ]] && grep -q -- "$1" "$scratch/out"; }
refused_with() { [[ $status -eq 2 && ! -s $scratch/out ]] && grep -qF -- "$1" "$scratch/err"; }

run --version
good_with '^lamella [0-9]'; ok "--version names the program and its version"

run --help
good_with '^usage: lamella'; ok "--help shows how to use the program"
missing=0
for verb in build check list show new measure diff inspect; do grep -q "^  $verb " "$scratch/out" || missing=1; done
[[ $missing -eq 0 ]]; ok "--help shows all eight verbs"

run frobnicate
refused_with 'is not a verb'; ok "an unknown verb is refused"

run list
good_with '^surfaces$'; ok "list shows the surfaces"
missing=0
for word in surfaces nets constraints parts materials formats designs; do grep -qx "$word" "$scratch/out" || missing=1; done
for word in enneper asymptotic planar-star lamella card stl enneper-model; do grep -q "^  $word  " "$scratch/out" || missing=1; done
[[ $missing -eq 0 ]]; ok "list shows all sections and what they hold"

run list surfaces
good_with '^catenoid  *Catenoid$'; ok "list surfaces shows names and titles"
awk '{ if (match($0, /  +/)) at[RSTART + RLENGTH]++ } END { exit length(at) != 1 }' "$scratch/out"; ok "titles are aligned"

run list designs
good_with "^enneper-model  *Desk model"; ok "list designs shows titles"
! grep -q 'not valid' "$scratch/out"; ok "every shipped design is valid"

run list surface
refused_with 'did you mean surfaces?'; ok "list corrects a misspelled section"

run show enneper
good_with '^enneper (surface): '; ok "show prints a page"
missing=0
for word in Equation Source 'In a design' Keys 'Keys of every surface'; do grep -qx "$word" "$scratch/out" || missing=1; done
[[ $missing -eq 0 ]]; ok "the page has equation, source, usage, keys and common keys"
grep -q '^  order  a whole number from 1 to 9; default: 1$' "$scratch/out"; ok "the page says type, range and default of a key"

run show design
good_with '^  surface  a map with a kind out of '; ok "show design prints the top-level keys"
grep -q '^      kerf .*default: 0$' "$scratch/out"; ok "nested keys are shown"

run show enneper-model
good_with '^lamella: 1$'; ok "show prints a shipped design"

wide=0 empty=0
for section in surfaces nets constraints parts materials formats; do
  run list "$section"
  while read -r name _; do
    "$lamella" show "$name" >"$scratch/page" 2>&1 || empty=1
    [[ $(LC_ALL=C.UTF-8 awk 'length > 80 { n++ } END { print n + 0 }' "$scratch/page") -eq 0 ]] || { wide=1; echo "# wide: $name"; }
  done <"$scratch/out"
done
[[ $empty -eq 0 ]]; ok "everything listed has a page"
[[ $wide -eq 0 ]]; ok "pages fit in 80 columns"

run show eneper
refused_with 'did you mean enneper?'; ok "show corrects a misspelled name"

run new enneper-model
[[ $status -eq 0 && ! -s $scratch/err ]] && cmp -s "$scratch/enneper-model.yaml" templates/designs/enneper-model.yaml
ok "new copies a shipped design"
echo mine >"$scratch/enneper-model.yaml"
run new enneper-model
refused_with 'exists' && [[ $(cat "$scratch/enneper-model.yaml") == mine ]]; ok "new overwrites nothing"
run new enneper-model -o other.yaml
[[ $status -eq 0 ]] && cmp -s "$scratch/other.yaml" templates/designs/enneper-model.yaml; ok "new -o chooses the name"
# every shipped design, in a folder of its own, with the files that it names
mkdir "$scratch/new" && wrong=''
for design in $(cd templates/designs && ls ./*.yaml); do
  design=$(basename "$design" .yaml)
  run new "$design" -o "new/$design.yaml"
  [[ $status -eq 0 || -e $scratch/new/$design.yaml ]] || wrong="$wrong $design"
done
[[ -z $wrong ]] && missing=$(cd templates/designs && for file in *; do [[ -e $scratch/new/$file ]] || echo "$file"; done)
echo "$wrong: $missing" >"$scratch/out"
[[ -z $wrong && -z $missing ]]; ok "new copies the files that a design names: all that are shipped"
echo mine >"$scratch/hypar.obj"
run new hypar-roof
refused_with 'hypar.obj exists and differs' && [[ ! -e $scratch/hypar-roof.yaml ]]; ok "new does not overwrite a file that a design names"
run new eneper-model
refused_with 'did you mean enneper-model?'; ok "new corrects a misspelled design"
run new enneper-model -o no/such/folder.yaml
[[ $status -eq 1 && ! -s $scratch/out ]]; ok "new says when a file cannot be written"

run check other.yaml
good_with '^net  *asymptotic: '; ok "check says what would be built"
grep -q '^part  *lamella: ' "$scratch/out"; ok "check names the parts"
[[ $(ls "$scratch" | sort | tr "\n" " ") == "enneper-model.yaml err hypar.obj new other.yaml out page " ]]; ok "check writes no file"
run check other.yaml --set 'net.grid=[6, 7]' --set 'parts[0].height=3 cm' --set sheets.kerf=0.2\ mm
tr -s ' \n' ' ' <"$scratch/out" | grep -q 'grid \[6, 7\]' && grep -q 'height 30 mm' "$scratch/out" && grep -q 'kerf 0.2 mm' "$scratch/out"
ok "--set overrides keys"
run check other.yaml --set net.gird=3 --set 'parts[0].height=3'
[[ $status -eq 2 && $(wc -l <"$scratch/err") -eq 2 ]] && grep -q '^--set net.gird: no such key; .*(did you mean grid?)$' "$scratch/err" &&
  grep -q '^--set parts\[0\].height: given 3; expected a length' "$scratch/err"
ok "messages about overrides name the override, all at once"
run check other.yaml --set
refused_with 'check: --set needs a value'; ok "--set needs a value"
run check other.yaml --set render.setting=moon
refused_with '--set render.setting: given moon; expected the name of a file in templates/pov'; ok "an unknown setting is refused"
run check nowhere.yaml
refused_with 'nowhere.yaml: cannot be opened: No such file or directory'; ok "a missing design is said to be missing"
run check .
[[ $status -eq 2 && ! -s $scratch/out && -s $scratch/err ]]; ok "a folder is not a design"
for verb in list show new check; do
  run "$verb" --help
  good_with "^usage: lamella $verb"; ok "$verb --help shows how to use it"
done

invalid=0
for design in templates/designs/*.yaml; do "$lamella" check "$design" >/dev/null 2>"$scratch/err" || invalid=1; done
[[ $invalid -eq 0 ]]; ok "every shipped design passes check"

echo "1..$number"
