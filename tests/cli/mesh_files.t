#!/usr/bin/env bash
# Nets that start from mesh files as other programs write them: what is mended, what is told, what is refused; their unit
# and size. All files of tests/cases/meshes but soup.obj are the same 4 x 4 m of 16 faces, written in different ways.
. "$(dirname "$0")/scratch.sh"
cases=$OLDPWD/tests/cases/meshes
# design MESH [KEYS...]: a net that starts from a mesh; builds its report.
build() {
  local mesh=$1
  shift
  printf 'lamella: 1\nname: t\nnet: {kind: planar-quads, from: {file: %s%s}}\n' "$mesh" "$*" >t.yaml
  rm -rf o
  run build t.yaml -o o --only report,obj
}
built() { [ "$status" = 0 ]; }
notes() { built && grep -qF -- "$1" o/report.json; }
silent() { built && ! grep -qE 'left out|turned to agree|two places|welded|net.from' o/report.json; }
refused() { [ "$status" = 2 ] && grep -qF -- "$1" err && [ ! -e o ]; }
# extent AXIS LENGTH: of the vertices of net.obj, within 1e-4 of it
extent() {
  awk -v k="$1" -v want="$2" '$1 == "v" { x = $(k + 1); if (!n++ || x < low) low = x; if (n == 1 || x > high) high = x }
    END { d = (high - low - want) / want; exit !(d < 1e-4 && d > -1e-4) }' o/net.obj
}

for name in cont cont_crlf bom cr lod curve_in_mesh plain; do
  build "$cases/$name.obj"; ok "$name.obj is read" silent
done
build "$cases/unref.obj"; ok "vertices in no face are left out, with a note" notes '2 vertices in no face left out'
build "$cases/degen_rep.obj"; ok "a face that names a vertex twice is refused" refused 'face 16 names vertex 25 twice'
build "$cases/dupface.obj"; ok "a face that stands twice is refused" refused 'the edge of vertices 4 and 9 has more than two faces'
build "$cases/nonman.obj"; ok "an edge of three faces is refused" refused 'the edge of vertices 13 and 14 has more than two faces'

awk '$1 == "f" && n++ % 5 == 0 { print $1, $5, $4, $3, $2; next } { print }' "$cases/plain.obj" >turned.obj
build turned.obj; ok "4 of 16 faces that look the other way are turned" notes '4 faces turned to agree with the others'

# the third row of vertices (11 to 15) stands in the file once more (26 to 30), for the faces behind it
awk '$1 == "v" { print; v[++n] = $0; next }
  $1 == "f" && !seam++ { for (i = 11; i <= 15; i++) print v[i] }
  { late = 0; for (k = 2; k <= 5; k++) late += $k > 15
    for (k = 2; k <= 5; k++) if (late && $k >= 11 && $k <= 15) $k += 15
    print }' "$cases/plain.obj" >seam.obj
build seam.obj; ok "a seam is told" notes '5 vertices lie in two places; 2 pieces'
build seam.obj ', weld: 0'; ok "and welded" notes '5 vertices welded'
ok "to the 25 vertices of the whole" [ "$(grep -c '^v ' o/net.obj)" = 25 ]
build "$cases/soup.obj" ', weld: 1 mm'; ok "quads with vertices of their own become a net" notes '25 vertices, 16 faces'
build seam.obj ', weld: 2 m'; ok "not beyond the size of faces" refused 'net.from.weld: 2 m given, which joins corners of face 1'

build "$cases/mm.obj"; ok "a mesh of 4 km makes the hint to its unit" notes 'the mesh is 4000 m long'
build "$cases/mm.obj" ', unit: mm'; ok "in millimeters it says nothing" silent
ok "and is 4 m long" extent 1 4
build "$cases/mm.obj" ', size: 40 cm'; ok "a size may be given instead" extent 2 .4
build "$cases/plain.obj" ', unit: ft'; ok "feet" extent 1 1.2192
build "$cases/plain.obj" ', unit: km'; ok "units that are not known are refused" refused 'net.from.unit'
cp "$cases/plain.obj" . && build plain.obj && sed 's/name: t/name: s/; s/file: plain.obj/design: t, size: 2 m/' t.yaml >s.yaml
run build s.yaml -o o --only report,obj; ok "the net of another design may get another size" extent 1 2

# the same mesh as OFF, and as PLY of text
awk '$1 == "v" { v = v $2 " " $3 " " $4 "\n"; n++ } $1 == "f" { f = f 4 " " $2 - 1 " " $3 - 1 " " $4 - 1 " " $5 - 1 "\n"; m++ }
  END { printf "OFF\n%d %d 0\n%s%s", n, m, v, f }' "$cases/plain.obj" >plain.off
{ printf 'ply\nformat ascii 1.0\nelement vertex 25\nproperty float x\nproperty float y\nproperty float z\n'
  printf 'element face 16\nproperty list uchar int vertex_indices\nend_header\n'; sed 1,2d plain.off; } >plain.ply
build "$cases/plain.obj"; sed 1d o/net.obj >net.obj
for format in off ply; do
  build plain.$format; ok "the same net from $format" cmp -s net.obj <(sed 1d o/net.obj)
done
build plain.obj ", size: 4 cm}, reference: {file: plain.ply, unit: cm"; ok "a reference may have a unit" built
run measure plain.off; ok "OFF is measured" grep -q '25 vertices, 16 faces' out
run measure "$cases/unref.obj"; ok "notes are told there, too" grep -q '2 vertices in no face left out' err
run diff plain.off plain.ply; ok "OFF and PLY are compared" [ "$status" = 0 ]
run inspect plain.ply; ok "PLY is inspected: open" [ "$status" = 1 ]
echo "1..$number"
