#!/usr/bin/env bash
# The glTF binaries satisfy Khronos' validator without an error or a warning, and carry what a viewer needs: a node per
# part with its facts, instances of one mesh, one rotation to y up.
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

packages=$(node_package gltf-validator@2.0.0-dev.3.10 2>"$work/reason") || reason=$(cat "$work/reason")

cat >"$work/validate.js" <<'SCRIPT'
const fs = require('fs');
const validator = require(process.argv[2] + '/node_modules/gltf-validator');
validator.validateBytes(new Uint8Array(fs.readFileSync(process.argv[3]))).then((report) => {
  const { numErrors, numWarnings, messages } = report.issues;
  for (const m of messages) console.log(`# ${m.code} ${m.pointer}: ${m.message}`);
  process.exit(numErrors || numWarnings ? 1 : 0);
});
SCRIPT

# The structure, read from the bytes: prints a line for everything that is not as it should be.
cat >"$work/structure.py" <<'SCRIPT'
import glob, json, math, os, struct, sys
folder, name = sys.argv[1:]
data = open(f"{folder}/{name}.glb", "rb").read()
length = struct.unpack("<I", data[12:16])[0]
scene, binary = json.loads(data[20:20 + length]), data[28 + length:]
bad = []
def expect(condition, text):
    if not condition: bad.append(text)
nodes = scene["nodes"]
named = {n["name"]: n for n in nodes}
expect(scene["asset"] == {"version": "2.0", "generator": "lamella"}, f"asset {scene['asset']}")
expect(len(named) == len(nodes), "two nodes have one name")
root = nodes[scene["scenes"][0]["nodes"][0]]
expect(root["name"] == name, f"the root is {root['name']}")
# z up becomes y up: the third column of the matrix is the image of z
expect(root["matrix"][8:11] == [0, 1, 0] and root["matrix"][4:7] == [0, 0, -1], f"root matrix {root['matrix']}")

def stl(path):
    d = open(path, "rb").read()
    count = struct.unpack("<I", d[80:84])[0]
    return [struct.unpack("<9f", d[96 + 50 * i:132 + 50 * i]) for i in range(count)]
def accessor(i, code, width):
    a = scene["accessors"][i]
    view = scene["bufferViews"][a["bufferView"]]
    at = view.get("byteOffset", 0) + a.get("byteOffset", 0)
    return struct.unpack_from(f"<{a['count'] * width}{code}", binary, at), a
def volume(triangles):
    return sum(a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
               for a, b, c, d, e, f, g, h, i in triangles) / 6

parts = [os.path.basename(p)[:-4] for p in sorted(glob.glob(f"{folder}/parts/*.stl"))]
expect(parts, "no parts")
for part in parts:
    if part not in named:
        bad.append(f"no node {part}")
        continue
    node = named[part]
    extras = node.get("extras", {})
    wanted = ["kind", "material", "mass", "congruence"]
    if "mesh" in node:
        wanted += ["family", "number", "length"]
        expect(extras.get("family") == part[0], f"{part}: family {extras.get('family')}")
        expect(extras.get("number") == int("".join(filter(str.isdigit, part))), f"{part}: number {extras.get('number')}")
        mesh = scene["meshes"][node["mesh"]]
    else:
        children = [nodes[c] for c in node["children"]]
        expect(len(children) == extras.get("count"), f"{part}: {len(children)} instances, {extras.get('count')} counted")
        expect(len({c["mesh"] for c in children}) == 1, f"{part}: instances have several meshes")
        for c in children:
            m = c["matrix"]
            x, y, z = m[0:3], m[4:7], m[8:11]
            det = sum(x[i] * (y[(i + 1) % 3] * z[(i + 2) % 3] - y[(i + 2) % 3] * z[(i + 1) % 3]) for i in range(3))
            expect(abs(det - 1) < 1e-6, f"{c['name']}: determinant {det}")
        mesh = scene["meshes"][children[0]["mesh"]]
    for key in wanted: expect(key in extras, f"{part}: no {key} in extras")
    p = mesh["primitives"][0]
    points, a = accessor(p["attributes"]["POSITION"], "f", 3)
    normals, _ = accessor(p["attributes"]["NORMAL"], "f", 3)
    component = scene["accessors"][p["indices"]]["componentType"]
    index, _ = accessor(p["indices"], "H" if component == 5123 else "I", 1)
    expect(component == 5123 or a["count"] > 65000, f"{part}: 32-bit indices for {a['count']} vertices")
    for k in range(3):
        expect(min(points[k::3]) == a["min"][k] and max(points[k::3]) == a["max"][k], f"{part}: bounds on axis {k}")
    # every normal is within 90 deg of the triangles that use it, by a good margin
    triangles, worst = [], 1
    for t in range(0, len(index), 3):
        c = [points[3 * i:3 * i + 3] for i in index[t:t + 3]]
        triangles.append(sum(c, ()))
        u, v = [[c[j][k] - c[0][k] for k in range(3)] for j in (1, 2)]
        n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        size = math.sqrt(sum(k * k for k in n))
        for i in index[t:t + 3]:
            worst = min(worst, sum(n[k] * normals[3 * i + k] for k in range(3)) / size)
    expect(worst > math.cos(math.radians(30)), f"{part}: a normal is {math.degrees(math.acos(worst)):.1f} deg off its face")
    reference = volume(stl(f"{folder}/parts/{part}.stl")) * 1e-9
    expect(abs(volume(triangles) - reference) <= 1e-4 * reference, f"{part}: volume {volume(triangles)} m3, STL {reference}")
for line in bad[:20]: print("#", line)
sys.exit(bool(bad))
SCRIPT

check_design() { # NAME
  local name=$1 out=$work/$1
  "$program" build "templates/designs/$name.yaml" -o "$out" --only gltf,stl --quiet >"$work/build" 2>&1
  ok $? "$name: builds"
  [ -f "$out/$name.glb" ] || { sed 's/^/# /' "$work/build"; return; }
  if [ -n "$packages" ]; then
    node "$work/validate.js" "$packages" "$out/$name.glb"
    ok $? "$name: Khronos' validator finds no error and no warning"
  else
    skip "Khronos' validator: $reason"
  fi
  /usr/bin/python3 "$work/structure.py" "$out" "$name"
  ok $? "$name: nodes, extras, instances, bounds, normals and volumes are right"
  "$program" build "templates/designs/$name.yaml" -o "$work/again" --only gltf --quiet >/dev/null 2>&1
  cmp "$out/$name.glb" "$work/again/$name.glb"
  ok $? "$name: a second run has the same bytes"
}

for design in enneper-model asymptotic-pavilion; do check_design "$design"; done
echo "1..$number"
