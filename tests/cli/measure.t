#!/usr/bin/env bash
# lamella measure: what it prints, references, color maps; and the plots of a design.
set -u
cd "$(dirname "$0")/../.." || exit 1
lamella=$(realpath -m "${LAMELLA:-build/lamella}")
. tests/cli/node_package.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
number=0
ok() { # NAME: reports the last command's success
  local good=$?
  number=$((number + 1))
  if [ $good -eq 0 ]; then echo "ok $number - $1"; else echo "not ok $number - $1"; sed 's/^/# /' "$work/out" "$work/err" | head -12; fi
}
skip() { number=$((number + 1)); echo "ok $number # SKIP $1"; }
run() { "$lamella" "$@" >"$work/out" 2>"$work/err"; status=$?; }
refused_with() { [ $status -eq 2 ] && grep -qF -- "$1" "$work/err"; }
# json EXPRESSION of the object d printed last
json() { /usr/bin/python3 -c "import json, math, sys; d = json.load(open('$work/out'))['measures']; sys.exit(not ($1))"; }

# A net of 4 x 3 unit squares on z = 0, and the same plane .25 higher as two triangles that reach 1 further.
for i in 0 1 2 3 4; do for j in 0 1 2 3; do echo "v $i $j 0"; done; done >"$work/net.obj"
for i in 0 1 2 3; do for j in 1 2 3; do echo "f $((4 * i + j)) $((4 * i + j + 4)) $((4 * i + j + 5)) $((4 * i + j + 1))"; done; done >>"$work/net.obj"
printf 'v %s\n' '-1 -1 .25' '5 -1 .25' '5 4 .25' '-1 4 .25' >"$work/plane.obj"
printf 'f 1 2 3\nf 1 3 4\n' >>"$work/plane.obj"
printf 'v %s\n' '0 0 0' '1 0 0' '1 1 0' '0 1 0' >"$work/quad.obj"
echo 'f 1 2 3 4' >>"$work/quad.obj"

run measure "$work/net.obj"
[ $status -eq 0 ] && grep -qE '^  edge_length +min 1 +mean 1 +max 1 +count 31  m$' "$work/out"; ok "the table has min, mean, max, count and unit"
run measure "$work/quad.obj"
grep -qE '^  crossing_angle +undefined$' "$work/out"; ok "what no element has is undefined in the table"
run measure "$work/quad.obj" --json
json 'd["crossing_angle"]["max"] is None and d["crossing_angle"]["count"] == 0 and d["edge_length"]["min"] == 1'; ok "and null in JSON"
run measure "$work/net.obj" --json
json 'd["distance_to_reference"]["max"] is None'; ok "without a reference there is no distance"
run measure "$work/net.obj" --json --reference "$work/plane.obj"
json 'd["distance_to_reference"]["min"] == d["distance_to_reference"]["max"] == .25 and d["distance_to_reference"]["count"] == 20'
ok "distances of the vertices to a reference"
json 'abs(d["distance_from_reference"]["max"] - math.sqrt(2 + 1 / 16)) < 1e-7'; ok "and back, from its farthest corner"
run measure "$work/net.obj" --axis 0,0,0,0,0
refused_with '--axis 0,0,0,0,0; expected six numbers'; ok "an axis of five numbers is refused"
run measure "$work/net.obj" --axis 0,0,0,0,0,0
refused_with 'expected six numbers'; ok "an axis without a direction is refused"
run measure "$work/net.obj" --axis 0,0,0,0,0,1
[ $status -eq 0 ]; ok "an axis is accepted"
run measure "$work/net.obj" --angle
refused_with '--angle needs a value'; ok "a missing value is noticed"

# ---- color maps ----
run measure "$work/net.obj" --map edge_lenght -o "$work/map.svg"
refused_with '(did you mean edge_length?)'; ok "a misspelled measure is corrected"
run measure "$work/net.obj" --map flatness -o "$work/map.svg"
refused_with 'flatness is one number for the whole net'; ok "one number cannot be mapped"
run measure "$work/net.obj" --map edge_length -o "$work/map.pdf"
refused_with 'map.pdf; expected a name that ends with .svg, .png or .glb'; ok "an unknown ending is refused"
run measure "$work/net.obj" --map edge_length
refused_with '--map MEASURE and -o FILE are given together'; ok "a map needs a file"
[ -z "$(ls "$work" | grep '^map')" ]; ok "nothing was written by then"

# A drawing: valid XML, as many bins as say so whose numbers add up, no text that runs into another or off the page.
cat >"$work/svg.py" <<'SCRIPT'
import sys, xml.etree.ElementTree as tree
path, counted, undefined, cells = sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), int(sys.argv[4])
root = tree.parse(path).getroot()
svg = "{http://www.w3.org/2000/svg}"
bad = []
bins = [int(r.find(svg + "title").text.split()[0]) for r in root.iter(svg + "rect") if r.get("class") == "bin"]
if sum(bins) != counted: bad.append(f"the bins {bins} have {sum(bins)} elements, expected {counted}")
paths = [p for g in root.iter(svg + "g") if g.get("class") == "view" for p in g.iter(svg + "path")]
if len(paths) != cells: bad.append(f"{len(paths)} paths, expected {cells}")
texts = ["".join(t.itertext()) for t in root.iter(svg + "text")]
if undefined and f"{undefined}" not in texts: bad.append(f"{undefined} undefined elements are not said: {texts}")
width, height = (float(x) for x in root.get("viewBox").split()[2:])
boxes = []
for t in root.iter(svg + "text"):
    words, size = "".join(t.itertext()), float(t.get("font-size"))
    x, y, w = float(t.get("x")), float(t.get("y")), .55 * size * len(words)
    x -= {"start": 0, "middle": w / 2, "end": w}[t.get("text-anchor")]
    boxes.append((x, y - .75 * size, x + w, y + .2 * size, words))
for i, a in enumerate(boxes):
    if a[0] < 0 or a[2] > width or a[1] < 0 or a[3] > height: bad.append(f"'{a[4]}' leaves the page: {a[:4]}")
    for b in boxes[:i]:
        if a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]: bad.append(f"'{a[4]}' lies on '{b[4]}'")
for line in bad: print("#", line)
sys.exit(bool(bad))
SCRIPT
wavy=tests/cases/nets/10_anet_enneper_final.obj # 289 vertices, 225 of them inside; 544 edges; 256 faces
# name, counted, undefined, paths: a face has four quarters and an outline; a fill and an outline; a fill and four edges
while read -r name counted undefined cells; do
  run measure $wavy --map $name -o "$work/$name.svg"
  [ $status -eq 0 ] && /usr/bin/python3 "$work/svg.py" "$work/$name.svg" $counted $undefined $cells >>"$work/out"
  ok "the drawing of $name is valid and complete"
done <<'ROWS'
gauss_curvature 225 64 1280
mean_curvature 225 64 1280
crossing_angle 225 64 1280
face_planarity 256 0 512
edge_length 544 0 1280
ROWS
run measure "$work/quad.obj" --map crossing_angle -o "$work/none.svg"
[ $status -eq 0 ] && grep -q 'No element has a value' "$work/none.svg"; ok "a drawing without values says so"
run measure $wavy --map mean_curvature -o "$work/again.svg"
cmp -s "$work/again.svg" "$work/mean_curvature.svg"; ok "a second drawing has the same bytes"

if command -v rsvg-convert >/dev/null; then
  run measure $wavy --map mean_curvature -o "$work/map.png"
  [ $status -eq 0 ] && [ "$(head -c 8 "$work/map.png" | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a ]; ok "a PNG is written"
  [ "$(ls "$work" | grep -c part)" = 0 ]; ok "and nothing is left beside it"
else
  skip "rsvg-convert is not installed"
fi
PATH=$work run measure $wavy --map mean_curvature -o "$work/missing.png"
[ $status -eq 1 ] && grep -q librsvg2-bin "$work/err" && [ ! -e "$work/missing.png" ]; ok "without rsvg-convert the message names its package"

# ---- glTF ----
cat >"$work/glb.py" <<'SCRIPT'
import json, struct, sys
path, vertices, mode = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
data = open(path, "rb").read()
length = struct.unpack("<I", data[12:16])[0]
scene, binary = json.loads(data[20:20 + length]), data[28 + length:]
p = scene["meshes"][0]["primitives"][0]
colors = scene["accessors"][p["attributes"]["COLOR_0"]]
view = scene["bufferViews"][colors["bufferView"]]
at = view.get("byteOffset", 0) + colors.get("byteOffset", 0)
values = struct.unpack_from(f"<{3 * colors['count']}f", binary, at)
extras = scene["nodes"][1]["extras"]
good = (colors["count"] == vertices and p.get("mode", 4) == mode and len(set(values)) > 20
        and min(values) >= 0 and max(values) <= 1 and extras["min"] < extras["mean"] < extras["max"])
print("#", colors["count"], p.get("mode"), len(set(values)), min(values), max(values), extras)
sys.exit(not good)
SCRIPT
cat >"$work/validate.js" <<'SCRIPT'
const fs = require('fs');
const validator = require(process.argv[2] + '/node_modules/gltf-validator');
validator.validateBytes(new Uint8Array(fs.readFileSync(process.argv[3]))).then((report) => {
  for (const m of report.issues.messages) console.log(`# ${m.code} ${m.pointer}: ${m.message}`);
  process.exit(report.issues.numErrors || report.issues.numWarnings ? 1 : 0);
});
SCRIPT
packages=$(node_package gltf-validator@2.0.0-dev.3.10 2>"$work/reason") || reason=$(cat "$work/reason")
while read -r name vertices mode; do # a face has four vertices of its own, an edge two; 4: triangles, 1: lines
  run measure $wavy --map $name -o "$work/$name.glb"
  [ $status -eq 0 ] && /usr/bin/python3 "$work/glb.py" "$work/$name.glb" $vertices $mode >"$work/out"; ok "the glTF of $name has its colors"
  if [ -n "$packages" ]; then
    node "$work/validate.js" "$packages" "$work/$name.glb" >"$work/out"; ok "Khronos' validator finds nothing in it"
  else
    skip "Khronos' validator: $reason"
  fi
done <<'ROWS'
mean_curvature 289 4
face_planarity 1024 4
edge_length 1088 1
ROWS

# ---- plots and further measures of a design ----
cat >"$work/design.yaml" <<DESIGN
lamella: 1
name: plotted
surface: {kind: enneper, size: 30 cm}
net: {kind: asymptotic, grid: [8, 8], measures: [angle_defect, star_planarity], reference: {file: $work/plane.obj, weight: 0.001}}
plots: [mean_curvature, distance_to_reference]
DESIGN
run build "$work/design.yaml" -o "$work/plotted" --only report,plot,plot-gltf
[ "$(cd "$work/plotted/plots" && echo *)" = "distance_to_reference.glb distance_to_reference.svg mean_curvature.glb mean_curvature.svg" ]
ok "a design's plots are written"
/usr/bin/python3 "$work/svg.py" "$work/plotted/plots/distance_to_reference.svg" 81 0 320 >"$work/out"; ok "its drawings are complete"
/usr/bin/python3 - "$work/plotted/report.json" >"$work/out" <<'SCRIPT'
import json, sys
m = json.load(open(sys.argv[1]))["stages"][0]["measures"]
print(list(m))
sys.exit(not (m["angle_defect"]["count"] == 49 and m["distance_to_reference"]["count"] == 81
              and m["distance_to_reference"]["min"] < m["distance_to_reference"]["mean"] < m["distance_from_reference"]["max"]))
SCRIPT
ok "the report has the further measures and the distances to the reference"
sed -e 's/angle_defect/angel_defect/' -e 's/plots: .mean_curvature/plots: [flatness/' "$work/design.yaml" >"$work/wrong.yaml"
for verb in check build; do
  run $verb "$work/wrong.yaml"
  refused_with '(did you mean angle_defect?)' && refused_with 'plots: flatness is one number for the whole net'; ok "$verb refuses wrong names"
done
run list measures
[ $status -eq 0 ] && grep -q '^principal_deviation ' "$work/out"; ok "list shows the measures"

echo "1..$number"
