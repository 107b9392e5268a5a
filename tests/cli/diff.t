#!/usr/bin/env bash
# lamella diff: meshes and pictures that are the same, that differ, and bad input.
set -u
. "$(dirname "$0")/scratch.sh"
skip() { number=$((number + 1)) && echo "ok $number # SKIP $1"; }
says() { [[ $status -eq $1 ]] && grep -qE -- "$2" out; }
complains() { [[ $status -eq 2 ]] && grep -qE -- "$1" err; }

vertices() { printf 'v %s\n' "$1 $2 $3" "$4 $2 $3" "$1 $5 $3" "$4 $5 $3" "$1 $2 $6" "$4 $2 $6" "$1 $5 $6" "$4 $5 $6"; }
faces='f -8 -6 -5 -7\nf -4 -3 -1 -2\nf -8 -7 -3 -4\nf -6 -2 -1 -5\nf -8 -4 -2 -6\nf -7 -5 -1 -3\n'
# box FROM TO: an OBJ box, in meters
box() { vertices "$@"; printf "$faces"; }
box 0 0 0 .1 .1 .1 >box.obj
box 0 0 0 .1 .1 .10004 >near.obj
box 0 0 0 .1 .1 .101 >far.obj
sed '$d' box.obj >open.obj
{ box 0 0 0 .1 .1 .1; box .04 .04 .04 .040001 .040001 .040001; } >crumb.obj
# the same box with its faces cut along the other diagonals
sed -E 's/^f (\S+) (\S+) (\S+) (\S+)/f \2 \3 \4 \1/' box.obj >other_cut.obj
# a dent that volume and area hardly show: one vertex in the middle of a face moved by 0.2 mm
{
  vertices 0 0 0 .1 .1 .1
  echo 'v .05 .05 .1002'
  printf 'f 1 3 4 2\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\nf 5 6 9\nf 6 8 9\nf 8 7 9\nf 7 5 9\n'
} >bump.obj

run diff box.obj box.obj
ok "a mesh is the same as itself" says 0 '^the same$'
run diff box.obj other_cut.obj
ok "another triangulation of the same surface is the same" says 0 '^the same$'
run diff box.obj far.obj
ok "1 mm of 100 mm differs" says 1 '^different: volume, area, bounding box, from A to B, from B to A$'
run diff box.obj near.obj
ok "0.04 mm is within the tolerance, but 4e-4 of the volume is not" says 1 '^different: volume, area$'
run diff box.obj bump.obj
ok "a bump of 0.2 mm differs" says 1 '^different: .*from B to A'
run diff box.obj bump.obj --tolerance 0.01
ok "the distance is 0.2 mm" says 1 '^from B to A +0\.2 '
run diff box.obj open.obj
ok "an open mesh differs from a closed one" says 1 '^different: closed'
run diff box.obj crumb.obj
ok "a crumb of a micrometer inside differs in components" says 1 '^different: components, Euler number'
cat >tetra.stl <<END
solid corner of a cube of 10 mm
facet normal 0 0 -1 outer loop vertex 0 0 0 vertex 0 10 0 vertex 10 0 0 endloop endfacet
facet normal 0 -1 0 outer loop vertex 0 0 0 vertex 10 0 0 vertex 0 0 10 endloop endfacet
facet normal -1 0 0 outer loop vertex 0 0 0 vertex 0 0 10 vertex 0 10 0 endloop endfacet
facet normal 1 1 1 outer loop vertex 10 0 0 vertex 0 10 0 vertex 0 0 10 endloop endfacet
endsolid
END
printf 'v 0 0 0\nv .01 0 0\nv 0 .01 0\nv 0 0 .01\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n' >tetra.obj
run diff --tolerance 1e-9 tetra.stl tetra.obj
ok "STL in millimeters and OBJ in meters are the same" says 0 '^the same$'
run diff --json box.obj far.obj
if command -v python3 >/dev/null; then
  ok "JSON says what differs, in SI units" python3 -c '
import json
f = json.load(open("out"))
assert f["same"] is False and "volume" in f["different"] and abs(f["b_to_a"] - .001) < 1e-9
assert abs(f["a"]["volume"] - .001) < 1e-12 and f["tolerance"] == 5e-5'
else
  skip python3
fi
cp out first && run diff --json box.obj far.obj
ok "two runs print the same" cmp -s out first

# ---- pictures, made with ImageMagick ----
if command -v convert >/dev/null; then
  convert -size 100x100 gradient:navy-white PNG24:a.png
  convert a.png -depth 8 -define png:compression-level=1 -interlace PNG PNG24:same.png
  convert a.png -fill red -draw 'point 50,50' PNG24:dot.png
  convert a.png -fill red -draw 'rectangle 10,10 14,13' PNG24:patch.png
  convert a.png -crop 90x100+0+0 +repage PNG24:small.png
  run diff a.png same.png
  ok "the same pixels in another file are the same" says 0 '^the same$'
  ok "their hashes are equal" test "$(grep -oE 'hash [0-9a-f]{16}' out | sort -u | wc -l)" -eq 1
  run diff a.png dot.png
  ok "one pixel of 10000 is within 0.02 %" says 0 '^differing pixels +0\.01 %'
  ok "its hash differs" test "$(grep -oE 'hash [0-9a-f]{16}' out | sort -u | wc -l)" -eq 2
  run diff a.png dot.png --tolerance 0
  ok "one pixel is too much for a tolerance of 0" says 1 '^different: pixels$'
  run diff --mask mask.png a.png patch.png
  ok "5 x 4 pixels are 0.2 %" says 1 '^differing pixels +0\.2 %'
  ok "the mask shows them in red" test "$(convert mask.png -fill black +opaque red -fill white -opaque red -format '%[fx:round(mean*10000)]' info:)" = 20
  run diff a.png small.png
  ok "another size differs" says 1 '^different: size$'
  run diff a.png box.obj
  ok "a picture is not compared with a mesh" complains 'a picture cannot be compared with a mesh'
  head -c 100 a.png >cut.png
  run diff a.png cut.png
  ok "a picture cut off is told" complains '^cut.png: is not a readable PNG picture'
else
  for _ in 1 2 3 4 5 6 7 8 9 10; do skip convert; done
fi

run diff box.obj missing.stl
ok "a missing file is told" complains '^missing.stl: cannot be opened: No such file or directory$'
echo 'v 0 0 x' >bad.obj
run diff bad.obj missing.obj
ok "both files' errors are told at once" test "$(wc -l <err)" -eq 2
run diff box.obj
ok "one file is not enough" complains 'diff: expected two files'
run diff box.obj box.obj --tolerance much
ok "a wrong tolerance is told" complains '--tolerance "much"; expected a number'
run diff box.obj box.obj --tolerance
ok "a missing value is told" complains '--tolerance needs a value'
run diff --help
ok "--help explains" says 0 '^usage: lamella diff'
echo "1..$number"
