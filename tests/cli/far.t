#!/usr/bin/env bash
# What lies far from the origin of its coordinates: built about a local origin, which every file carries in its own way.
# far.obj is the mesh of plain.obj (4 x 4 m, 16 faces) 10 km east and 5 km north; numbers follow from that.
. "$(dirname "$0")/scratch.sh"
cases=$OLDPWD/tests/cases/meshes
awk '$1 == "v" { printf "v %.6f %.6f %s\n", $2 + 10000, $3 + 5000, $4; next } { print }' "$cases/plain.obj" >far.obj
cp "$cases/plain.obj" near.obj
design() { # NAME: the lamellas of NAME.obj
  printf 'lamella: 1\nname: %s\nnet: {kind: planar-quads, from: {file: %s.obj}}\nparts:\n' "$1" "$1"
  printf '  - {kind: lamella, height: 60 mm, thickness: 1 mm, extend: 60 mm}\n'
}
design far >far.yaml
design near >near.yaml
# vertices FILE DX DY: the vertices of an OBJ, moved and rounded to micrometers
vertices() { awk -v x="$2" -v y="$3" '$1 == "v" { printf "%.6f %.6f %.6f\n", $2 + x + 1e-9, $3 + y + 1e-9, $4 + 1e-9 }' "$1" | sed 's/-0\.000000/0.000000/g'; }
# near_to FILE FILE: whether all numbers of two lists agree within 2 micrometers
near_to() { paste -d ' ' "$1" "$2" | awk '{ for (k = 1; k <= 3; k++) { d = $k - $(k + 3); if (d > 2e-6 || d < -2e-6) bad++ } } END { exit bad > 0 || NR == 0 }'; }

run build near.yaml -o near --skip png; ok "near the origin no origin is named" [ "$(grep -c 'local origin' near/report.json near/near.scad | grep -c ':0')" = 2 ]
run build far.yaml -o far --skip png; ok "far away it builds" [ "$status" = 0 ]
ok "the report names the origin" grep -qF 'local origin: (10000, 5000, 0) m' far/report.json
bad=0
for part in far/parts/*.stl; do "$lamella" inspect "$part" >/dev/null || bad=$((bad + 1)); done
ok "every STL file is a valid solid" [ "$bad" = 0 ]
run inspect far/assembly.stl; ok "and so is the assembly" [ "$status" = 0 ]
run diff far/assembly.stl near/assembly.stl; ok "which is that of the mesh near the origin" [ "$status" = 0 ]
vertices far/net.obj -10000 -5000 >a; vertices near/net.obj 0 0 >b
ok "net.obj stands in its place" near_to a b
vertices far/parts.obj -10000 -5000 >a; vertices near/parts.obj 0 0 >b
ok "parts.obj too" near_to a b
ok "and nodes.csv, in millimeters" grep -q '^2,10001000,5000000,' far/nodes.csv
grep -qF 'origin = [10000000, 5000000, 0];' far/far.scad && grep -qF 'translate(in_place ? origin : [0, 0, 0])' far/far.scad
ok "OpenSCAD has it as a translation" [ $? = 0 ]
python3 - far/far.glb <<'PYTHON'
import json, struct, sys
data = open(sys.argv[1], "rb").read()
scene = json.loads(data[20:20 + struct.unpack("<I", data[12:16])[0]])
# y up: (x, y, z) of the design is (x, z, -y)
assert scene["nodes"][0]["matrix"][12:15] == [10000, 0, -5000]
positions = [scene["accessors"][p["attributes"]["POSITION"]] for m in scene["meshes"] for p in m["primitives"]]
assert all(abs(x) < 5 for a in positions for x in a["min"] + a["max"])
PYTHON
ok "glTF has it in its root" [ $? = 0 ]

# as far as survey coordinates are: places that keys name are those of the file
awk '$1 == "v" { printf "v %.6f %.6f %s\n", $2 + 500000, $3 + 5000000, $4; next } { print }' "$cases/plain.obj" >survey.obj
cat >survey.yaml <<'YAML'
lamella: 1
name: survey
net: {kind: chebyshev, from: {file: survey.obj}, handles: [{at: [500002 m, 5000002 m, 0], to: [500002 m, 5000002 m, 0.25 m]}]}
YAML
run build survey.yaml -o survey --only report,obj; ok "a Chebyshev net 5,000 km away converges" [ "$status" = 0 ]
ok "its handle is where it has to be" grep -qE '^v 500002(\.0+)? 5000002(\.0+)? 0\.25(0+)?[0-9]{0,3}$' survey/net.obj
printf 'lamella: 1\nname: next\nnet: {kind: free, from: {design: survey}}\n' >next.yaml
run build next.yaml -o next --only obj; vertices next/net.obj -500000 -5000000 >a; vertices survey/net.obj -500000 -5000000 >b
ok "a design that starts from it stands in the same place" near_to a b

# a surface that was saved there: 11 x 11 points of z = x y / 20
awk 'BEGIN { for (i = 0; i <= 10; i++) for (j = 0; j <= 10; j++) printf "%d %d %g\n", 20000 + i, j, (i - 5) * (j - 5) / 20 }' >far.xyz
cat >points.yaml <<'YAML'
lamella: 1
name: points
surface: {kind: approximation, file: far.xyz, count: [6, 6], ground: no}
net: {kind: asymptotic, grid: [6, 6]}
YAML
run build points.yaml -o points --only report,obj; ok "points 20 km away give a surface" [ "$status" = 0 ]
ok "whose net is there" awk '$1 == "v" { n++; if ($2 < 19999.99 || $2 > 20010.01 || ($4 - ($2 - 20005) * ($3 - 5) / 20) ^ 2 > 1e-6) bad++ } END { exit bad > 0 || n == 0 }' points/net.obj

# sheets of .1 mm on a net of 10 km: no origin is near all of it, and the files say so
cat >thin.yaml <<'YAML'
lamella: 1
name: thin
surface: {kind: enneper, u: [-0.9, 0.9], v: [-0.9, 0.9], size: 10000 m}
net: {kind: asymptotic, grid: [4, 4], orthogonal: yes}
parts: [{kind: panels, thickness: 0.1 mm, gap: 1 mm}]
YAML
run build thin.yaml -o thin --only report,stl; ok "solids that files of 32 bits cannot hold are told" grep -q 'files: FAILED: solids lose their shape' out
ok "as a failure" [ "$status" = 1 ]
echo "1..$number"
