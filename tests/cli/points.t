#!/usr/bin/env bash
# Surfaces near the points of a file: text, a mesh, units, and what is refused.
set -u
. "$(dirname "$0")/scratch.sh"

# z = x y / 4 on 12 x 10 places, 4 x 3 in size, in centimeters and in no order of rows.
for i in 5 0 9 3 11 1 7 2 10 4 8 6; do
  for j in 0 1 2 3 4 5 6 7 8 9; do
    awk "BEGIN {x = $i * 400 / 11; y = $j * 300 / 9; printf \"%.6f;%.6f;%.6f;128\n\", x, y, x * y / 400}"
  done
done >body
{ echo 'X;Y;Z;intensity' && cat body; } >scan.csv
tr ';' ' ' <body | awk '{print "v", $1, $2, $3}' >scan.obj
echo 'f 1 2 3' >>scan.obj
design() { # FILE KEYS
  printf 'lamella: 1\nname: scan\nsurface: {kind: approximation, file: %s, unit: cm, %s}\nnet: {kind: free, grid: [4, 3]}\n' "$1" "$2" >scan.yaml
}
# The vertices of the net lie on z = x y / 4, with x and y running from 0 to 4 and from 0 to 3.
on_the_surface() {
  awk '/^v / {n++; d = $4 - $2 * $3 / 4; if (d * d > 1e-10) bad++; if ($2 > m) m = $2} END {exit !(n == 20 && !bad && m > 3.9999 && m < 4.0001)}' "$1"
}

design scan.csv 'fairness: 0'
run build scan.yaml -o text --only obj,report --deps rule
ok "text with a heading and further columns is read" test $status -eq 0
ok "the surface is the one of the points, in centimeters" on_the_surface text/net.obj
ok "--deps names the file" grep -q 'scan.csv' rule
design scan.obj 'fairness: 0'
run build scan.yaml -o mesh --only obj,report
ok "the vertices of a mesh are points" on_the_surface mesh/net.obj
sort -s -t';' -g -k1,1 body >sorted.csv
design sorted.csv 'fairness: 0, grid: [12, 10]'
run build scan.yaml -o grid --only obj,report
ok "a file may hold the rows of a grid" on_the_surface grid/net.obj
design scan.csv 'grid: [12, 11]'
run check scan.yaml
ok "and says when they are others" grep -qF '12 x 11 with 120 points' err
design none.xyz 'fairness: 0'
run check scan.yaml
ok "a file that is not there is named" grep -qF 'none.xyz' err
cp scan.csv bad.txt
echo '1 2' >>bad.txt
design bad.txt 'fairness: 0'
run check scan.yaml
ok "a bad line is named" grep -qE 'bad.txt:122: .*x, y and z' err
tr . , <body >comma.txt
design comma.txt 'fairness: 0'
run check scan.yaml
ok "decimal commas are told once" test "$(grep -c 'expected a decimal point' err)" = 1
design scan.yaml 'fairness: 0'
run check scan.yaml
ok "other files are refused, with those that are read" grep -qF 'not a file of points; expected .obj, .stl, .off, .ply, .xyz, .pts, .csv, .txt or .asc' err
printf 'lamella: 1\nname: scan\nsurface: {kind: interpolation, file: sorted.csv, unit: cm, count: [12, 10]}\nnet: {kind: free, grid: [4, 3]}\n' >scan.yaml
run build scan.yaml -o through --only obj,report
ok "a surface through the points of a file" on_the_surface through/net.obj
echo "1..$number"
