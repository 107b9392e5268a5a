#!/usr/bin/env bash
# The OpenSCAD model is the model: what OpenSCAD makes of it agrees with the solids that the program writes, within the
# limits of `lamella diff` (volume and area 1e-4, distance 0.05 mm). Flat outlines are checked against their area, computed
# here from the stations in the data file.
program=${LAMELLA:-build/lamella}
here=$(dirname "$0")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
number=0

ok() { # STATUS NAME
  number=$((number + 1))
  if [ "$1" -eq 0 ]; then echo "ok $number - $2"; else echo "not ok $number - $2"; fi
}
skip() { number=$((number + 1)); echo "ok $number # SKIP $1"; }

# export_scad MAIN OUTPUT [-D name=value]...: everything OpenSCAD says goes to OUTPUT.log
export_scad() {
  local main=$1 output=$2 kind=()
  shift 2
  case $output in *.stl) kind=(--export-format binstl) ;; esac
  openscad "${kind[@]}" "$@" -o "$output" "$main" >"$output.log" 2>&1
}
quiet() { ! grep -iE 'warning|error|echo|deprecated' "$1" | sed 's/^/# /' | grep .; }
same() { "$program" diff "$1" "$2" >"$work/diff" 2>&1 || { sed 's/^/# /' "$work/diff"; return 1; }; }

# area_of SVG: the area that its paths enclose, mm^2 (holes run against their outline)
area_of() {
  /usr/bin/python3 - "$1" <<'PYTHON'
import re, sys
area = 0
for path in re.findall(r'<path d="([^"]*)"', open(sys.argv[1]).read()):
    for loop in path.split("z"):
        p = [tuple(map(float, m)) for m in re.findall(r"(-?[\d.e+-]+),(-?[\d.e+-]+)", loop)]
        area += sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(p, p[1:] + p[:1])) / 2
print(abs(area))
PYTHON
}

# expected_area MAIN PART: length x height, less a slot at each crossing: thickness (1 + |cos a|) / sin a + 2 clearance and
# the sweep wide, height/2 + clearance deep
expected_area() {
  /usr/bin/python3 - "$@" <<'PYTHON'
import json, math, re, sys
main = open(sys.argv[1]).read()
data = open(sys.argv[1].replace(".scad", "_data.scad")).read()
value = {n: float(v) for n, v in re.findall(r"^(height|thickness|clearance) = ([\d.]+);", main, re.M)}
rows = re.search(r'\["%s", \d, (\[.*?\]\])\]' % sys.argv[2], data, re.S).group(1)
rows = json.loads(rows)
area = rows[-1][9] * value["height"]
for r in rows:
    if r[10] >= 0:
        a = math.radians(r[11])
        width = value["thickness"] * (1 + abs(math.cos(a))) / math.sin(a) + 2 * value["clearance"] + r[13] - r[12]
        area -= width * (value["height"] / 2 + value["clearance"])
print(area)
PYTHON
}
near() { awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN { d = a - b; if (d < 0) d = -d; exit !(b > 0 && d <= t * b) }' ||
  { echo "# $1 found, $2 expected"; return 1; }; }

command -v openscad >/dev/null || { echo "1..1"; echo "ok 1 # SKIP openscad is missing"; exit 0; }

check_design() { # NAME
  local name=$1 out=$work/$1 main=$work/$1/$1.scad
  "$program" build "templates/designs/$name.yaml" -o "$out" --only scad,stl --quiet >"$work/build" 2>&1
  ok $? "$name: builds"
  [ -f "$main" ] || { sed 's/^/# /' "$work/build"; return; }
  [ -f "$out/lamella.scad" ] && [ -f "$out/parts.scad" ]
  ok $? "$name: the templates stand beside the model"

  TIMEFORMAT="# $name: OpenSCAD took %U s of CPU"
  { time export_scad "$main" "$work/all.stl"; } 2>&1
  same "$work/all.stl" "$out/assembly.stl"
  ok $? "$name: OpenSCAD's model agrees with assembly.stl"
  quiet "$work/all.stl.log"
  ok $? "$name: OpenSCAD has nothing to complain about"
  export_scad "$main" "$work/again.stl"
  cmp "$work/all.stl" "$work/again.stl"
  ok $? "$name: a second export has the same bytes"

  local part
  for part in $(ls "$out/parts" | sed -n 's/^\([AB]0*1[ab]*\)\.stl$/\1/p'); do
    export_scad "$main" "$work/part.stl" -D 'show="one part"' -D "part=\"$part\""
    same "$work/part.stl" "$out/parts/$part.stl"
    ok $? "$name: part $part agrees with parts/$part.stl"
    export_scad "$main" "$work/part.svg" -D 'show="one outline"' -D "part=\"$part\""
    near "$(area_of "$work/part.svg")" "$(expected_area "$main" "$part")" 1e-4
    ok $? "$name: the flat outline of $part has the area of its rectangle less its slots"
  done

  export_scad "$main" "$work/swollen.stl" -D clearance=0
  grep -q 'ECHO: "clearance 0 would let parts touch' "$work/swollen.stl.log"
  ok $? "$name: a clearance of 0 is refused aloud"
}

check_design enneper-model
[ -f templates/designs/asymptotic-pavilion.yaml ] && check_design asymptotic-pavilion
echo "1..$number"
