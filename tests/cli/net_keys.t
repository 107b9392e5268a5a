#!/usr/bin/env bash
# Keys that change where a net starts and what is kept of it: nets of other designs, diagonals and coarser nets, traced
# lines, animations.
program=$(realpath -m "${LAMELLA:-build/lamella}")
here=$(cd "$(dirname "$0")" && pwd)
. "$here/node_package.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
number=0
ok() { # STATUS NAME
  number=$((number + 1))
  if [ "$1" -eq 0 ]; then echo "ok $number - $2"; else echo "not ok $number - $2"; fi
}
design() { # NAME NET...
  local name=$1
  shift
  printf 'lamella: 1\nname: %s\n%s\n' "$name" "$*" >"$work/$name.yaml"
}
build() { "$program" build "$work/$1.yaml" -o "$work/$1" --quiet --deps "$work/$1.d" --only obj,frames,animation "${@:2}" >"$work/out" 2>&1; }
vertices() { grep -c '^v ' "$work/$1/net.obj"; }

design first 'surface: {kind: enneper, size: 4 m}
net: {kind: asymptotic, grid: [8, 8]}'
design second 'net: {kind: asymptotic, from: {design: first}, subdivide: 1}'
design third 'net: {kind: free, from: {design: second.yaml}, coarsen: 1}'
design loop 'net: {kind: free, from: {design: pool}}'
design pool 'net: {kind: free, from: {design: loop}}'
design lost 'net: {kind: free, from: {design: nowhere}}'
for name in first second third; do build $name; ok $? "$name builds"; done
[ "$(vertices second)" = 289 ]; ok $? "a net of 9 x 9 vertices from another design, subdivided, has 17 x 17"
[ "$(vertices third)" = 81 ]; ok $? "coarsened, it has 9 x 9 again"
grep -q second.yaml "$work/third.d" && grep -q first.yaml "$work/third.d"; ok $? "the designs it comes from are dependencies"
build loop; [ $? = 2 ] && grep -q 'starts from itself' "$work/out"; ok $? "a circle of designs is refused"
build lost; [ $? = 2 ] && grep -q 'nowhere.yaml' "$work/out"; ok $? "a design that is not there is named"

build first --set net.kind=free --set net.diagonalize=yes; [ $? = 0 ] && [ "$(grep -c '^f ' "$work/first/net.obj")" = 24 ]
ok $? "diagonals of 8 x 8 cells: 24 faces" # around the inner vertices with i + j odd: 24 of 49
build first --set net.coarsen=3 ; [ $? = 1 ] && [ "$(vertices first)" = 4 ] && grep -q 'nothing to solve' "$work/out"
ok $? "coarsened three times, 8 x 8 cells are one, in which nothing is left to solve"
build first --set net.coarsen=4 ; [ $? = 2 ] && grep -q 'single face' "$work/out"; ok $? "and no more"

design traced 'surface: {kind: torus, v: [1.8, 4.4]}
net: {kind: asymptotic, grid: [12, 10]}'
build traced && [ "$(vertices traced)" = 143 ]; ok $? "an asymptotic net on a torus, which has no formula for it"
build traced --set surface.v=[-1,1]; [ $? = 2 ] && grep -q 'K < 0' "$work/out"; ok $? "refused where it bulges"
build traced --set net.kind=free --set 'net.from={lines: geodesic-polar, at: [1, 3]}' && [ "$(vertices traced)" = 120 ]
ok $? "12 rings of 10 geodesics around a pole"
build first --set 'net.from={at: [0, 0]}'; [ $? = 2 ] && grep -q 'trace: yes' "$work/out"
ok $? "a point for lines that are not traced is refused"

build first --set net.animate=6 --set 'net.handles=[{vertex: [4, 4], by: [0, 0, 40 cm], steps: 5}]'
[ $? = 0 ] && [ "$(ls "$work/first/frames")" = "$(printf 'first-%03d.obj\n' 0 1 2 3 4 5)" ]
ok $? "a start and five steps are six frames"
cmp -s <(sed 1d "$work/first/frames/first-005.obj") <(sed 1d "$work/first/net.obj"); ok $? "the last frame is the net"
python3 - "$work/first/first-animation.glb" <<'PYTHON'
import json, struct, sys
data = open(sys.argv[1], "rb").read()
length = struct.unpack("<I", data[12:16])[0]
scene, binary = json.loads(data[20:20 + length]), data[28 + length:]
def values(i):
    a = scene["accessors"][i]
    width = {"SCALAR": 1, "VEC3": 3}[a["type"]]
    view = scene["bufferViews"][a["bufferView"]]
    return struct.unpack_from(f"<{a['count'] * width}f", binary, view.get("byteOffset", 0) + a.get("byteOffset", 0))
sampler = scene["animations"][0]["samplers"][0]
times, weights = values(sampler["input"]), values(sampler["output"])
assert len(times) == 11 and len(weights) == 55 and times[0] == 0 and list(times) == sorted(times)
assert sum(weights[:5]) == 0 == sum(weights[50:]) and weights[29] == 1  # there and back
primitive = scene["meshes"][0]["primitives"][0]
base, last = values(primitive["attributes"]["POSITION"]), values(primitive["targets"][4]["POSITION"])
net = [float(w) for l in open(sys.argv[1].replace("first-animation.glb", "net.obj")) if l[:2] == "v " for w in l.split()[1:]]
assert max(abs(a + b - c) for a, b, c in zip(base, last, net)) < 1e-6
PYTHON
ok $? "the animation ends at the net, after five targets, and returns"
if packages=$(node_package gltf-validator@2.0.0-dev.3.10 2>"$work/reason"); then
  cat >"$work/validate.js" <<'NODE'
const validator = require(process.argv[2] + '/node_modules/gltf-validator');
const bytes = new Uint8Array(require('fs').readFileSync(process.argv[3]));
validator.validateBytes(bytes).then((r) => process.exit(r.issues.numErrors || r.issues.numWarnings ? 1 : 0));
NODE
  node "$work/validate.js" "$packages" "$work/first/first-animation.glb"
  ok $? "Khronos' validator finds no error and no warning"
else
  number=$((number + 1))
  echo "ok $number # SKIP Khronos' validator: $(cat "$work/reason")"
fi
rm -rf "$work/first"; build first; [ ! -e "$work/first/frames" ] && [ ! -e "$work/first/first-animation.glb" ]
ok $? "no frames, no files"
echo "1..$number"
