#!/usr/bin/env bash
# lamella inspect: what it measures, what it calls a valid solid, its exit codes.
set -u
. "$(dirname "$0")/scratch.sh"
says() { [[ $status -eq $1 ]] && grep -qE -- "$2" out; }
complains() { [[ $status -eq 2 && ! -s out ]] && grep -qE -- "$1" err; }

vertices() { printf 'v %s\n' "$1 $2 $3" "$4 $2 $3" "$1 $5 $3" "$4 $5 $3" "$1 $2 $6" "$4 $2 $6" "$1 $5 $6" "$4 $5 $6"; }
faces='f -8 -6 -5 -7\nf -4 -3 -1 -2\nf -8 -7 -3 -4\nf -6 -2 -1 -5\nf -8 -4 -2 -6\nf -7 -5 -1 -3\n'
# box FROM TO: an OBJ box, in meters
box() { vertices "$@"; printf "$faces"; }
box 0 0 0 2 3 4 >box.obj
{ box 0 0 0 1 1 1; box 3 0 0 4 1 1; } >two.obj
{ box 0 0 0 2 2 2; box 1 1 1 3 3 3; } >crossing.obj
sed '$d' box.obj >open.obj
sed -E 's/^f (\S+) (\S+) (\S+) (\S+)/f \4 \3 \2 \1/' box.obj >inverted.obj
cat >tetra.stl <<END
solid corner of a cube of 10 mm
facet normal 0 0 -1 outer loop vertex 0 0 0 vertex 0 10 0 vertex 10 0 0 endloop endfacet
facet normal 0 -1 0 outer loop vertex 0 0 0 vertex 10 0 0 vertex 0 0 10 endloop endfacet
facet normal -1 0 0 outer loop vertex 0 0 0 vertex 0 0 10 vertex 0 10 0 endloop endfacet
facet normal 1 1 1 outer loop vertex 10 0 0 vertex 0 10 0 vertex 0 0 10 endloop endfacet
endsolid
END

run inspect box.obj
ok "a box is a valid solid" says 0 '^valid solid +yes'
ok "its volume is 2 x 3 x 4" says 0 '^volume +24 m\^3'
ok "its area is 52" says 0 '^area +52 m\^2'
ok "its Euler number is 2" says 0 '^Euler number +2$'
ok "its inertia is V (b^2 + c^2) / 12" says 0 '^inertia +xx 50, yy 40, zz 26,'
run inspect tetra.stl
ok "an STL file is read in millimeters" says 0 '^volume +166\.66666[67][0-9]* mm\^3'
run inspect two.obj
ok "two boxes are two components" says 0 '^components +2$'
run inspect crossing.obj
ok "two boxes that cross each other are no valid solid" says 1 '^self-intersections +[1-9]'
run inspect open.obj
ok "an open mesh is no valid solid" says 1 '^closed +no, 4 boundary edges'
run inspect inverted.obj
ok "an inverted mesh is no valid solid" says 1 '^oriented +no'

if command -v python3 >/dev/null; then
  run inspect --json box.obj
  ok "JSON has the same figures" python3 -c '
import json
f = json.load(open("out"))
assert f["valid"] is True and f["genus"] == 0 and f["components"] == 1 and f["self_intersections"] == 0
assert abs(f["volume"] - 24) < 1e-9 and f["centroid"] == [1, 1.5, 2] and f["max"] == [2, 3, 4]'
else
  number=$((number + 1)) && echo "ok $number # SKIP python3"
fi
run inspect box.obj --json
ok "options may follow the file" says 0 '"valid": true'

run inspect missing.obj
ok "a missing file is told" complains '^missing.obj: cannot be opened: No such file or directory$'
printf 'v 0 0 0\nf 1 2 3\n' >bad.obj
run inspect bad.obj
ok "a bad file is told with its line" complains '^bad.obj:2: face: vertex 2 given, but the file has 1$'
echo hello >notes.txt
run inspect notes.txt
ok "another kind of file is told" complains '^notes.txt: not a mesh file that is read; expected .obj, .stl, .off or .ply$'
printf 'v 0 0 0\nv 1 0 0\nf 1 2 2\n' >flat.obj
run inspect flat.obj
ok "a mesh without triangles is told" complains 'flat.obj: has no triangles'
run inspect --jsn box.obj
ok "an unknown option is told" complains -- '--jsn'
run inspect
ok "no file is told" complains 'inspect: expected a mesh file'
run inspect --help
ok "--help explains" says 0 '^usage: lamella inspect'
echo "1..$number"
