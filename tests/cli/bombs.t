#!/usr/bin/env bash
# Small inputs that ask for endless work or memory are refused at once, with what was given and what would go.
set -u
export LAMELLA_TEMPLATES=$PWD/templates
. "$(dirname "$0")/scratch.sh"
status=0

# refused NAME PATTERN ARGUMENTS...: status 2 and not the work of minutes, in lines that all fit the pattern.
refused() {
  local name=$1 pattern=$2
  shift 2
  timeout 60 "$lamella" "$@" >out 2>err
  status=$?
  ok "$name: status 2, and an end" [ $status = 2 ]
  ok "and why" [ "$(grep -cE "$pattern" err)" = "$(grep -c . err)" -a -s err ]
}

# failed NAME PATTERN ARGUMENTS...: status 1 and not the work of minutes, with a stage that failed for what the pattern says.
failed() {
  local name=$1 pattern=$2
  shift 2
  timeout 60 "$lamella" "$@" >out 2>err
  status=$?
  ok "$name: status 1, and an end" [ $status = 1 ]
  ok "and why" grep -qE "FAILED: .*$pattern" out
}

net='surface: {kind: enneper, size: 4 m}\nnet: {kind: asymptotic, grid: [8, 8], orthogonal: yes}\n'
printf 'lamella: 1\nname: grid\nsurface: {kind: enneper, size: 4 m}\nnet: {kind: asymptotic, grid: [600, 600]}\n' >grid.yaml
(ulimit -v 2000000 2>/dev/null || exit 3
 exec "$lamella" build grid.yaml -o none) >out 2>err
status=$?
# 4.7 GB of 2.0 GB: the largest square grid has about 600 sqrt(2 / 4.7) = 390 cells a side, some more as n log n says
if nm -D "$lamella" 2>/dev/null | grep -qE '__[at]san'; then
  number=$((number + 1)); echo "ok $number # SKIP sanitizers take all addresses"
else
  ok "a grid that does not fit the memory is refused before it is made" [ $status = 2 -a ! -e none ]
  ok "with what it takes, what there is and what would fit" \
    grep -qE 'net.grid: 360000 vertices take about 4\.7 GB, and there are 2\.0 GB of memory; a grid of \[4[0-9]{2}, 4[0-9]{2}\] would fit' err
  # 30 x 30 faces, each cut into 4 six times: 900 x 4096
  printf 'lamella: 1\nname: fine\nsurface: {kind: enneper, size: 4 m}\nnet: {kind: asymptotic, grid: [30, 30], subdivide: 6}\n' >fine.yaml
  (ulimit -v 2000000 && exec timeout 10 "$lamella" check fine.yaml) >out 2>err
  status=$?
  ok "so is one that is subdivided too often" grep -q 'net: 3686400 vertices take about .* vertices would fit' err
fi

# The nearest crossings of this net are 564 mm apart.
printf "lamella: 1\nname: pair\n${net}parts: [{kind: lamella, height: 60 mm, thickness: 1 mm, pair: 10 m}]\n" >pair.yaml
failed "sheets of a pair farther apart than crossings" 'pair: 10000 mm; expected less than 563 mm' build pair.yaml -o pair --only report

printf "lamella: 1\nname: far\n${net/4 m/10000 m}parts: [{kind: lamella, height: 60 mm, thickness: 1 mm}]\n" >far.yaml
failed "strips of kilometers" 'A01 is [0-9]+ m long, .*expected parts of at most 200 sheets' build far.yaml -o far --only report

awk 'BEGIN {srand(1); for (i = 0; i < 300000; i++) printf "%.4f %.4f %.4f\n", x = rand(), y = rand(), x * y}' >cloud.xyz
printf 'lamella: 1\nname: scan\nsurface: {kind: approximation, file: cloud.xyz, unit: m}\nnet: {kind: free, grid: [4, 4]}\n' >scan.yaml
refused "a cloud of 300,000 points" 'file: cloud.xyz has 300000 points; expected at most 100000' check scan.yaml
refused "and when it is built" 'file: cloud.xyz has 300000 points; expected at most 100000' build scan.yaml -o none

# Every two of 16,000 triangles around one point have boxes that overlap: 128 million pairs.
awk 'BEGIN {print "solid fan"; for (i = 0; i < 16000; i++) {a = i * 6.283185 / 16000; b = a + 2.5
  printf "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex %.7f %.7f .001\nvertex %.7f %.7f .002\nendloop\nendfacet\n",
    cos(a), sin(a), cos(b), sin(b)} print "endsolid fan"}' >fan.stl
timeout 60 "$lamella" inspect fan.stl >out 2>err
status=$?
ok "a fan of 16,000 overlapping triangles: no valid solid, and an end" [ $status = 1 ]
ok "said so, with all other facts" grep -q 'self-intersections   not counted: millions' out
timeout 60 "$lamella" inspect fan.stl --json >out 2>err
ok "in JSON the number is left out" [ "$(grep -c self_intersections out)" = 0 -a "$(grep -c '"valid": false' out)" = 1 ]

if command -v python3 >/dev/null; then
  python3 - <<'SCRIPT'
import struct, zlib
def chunk(kind, data): return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
side, packer = 32768, zlib.compressobj(1)
rows = b"".join([packer.compress(bytes(side // 8 + 1)) for _ in range(side)]) + packer.flush()
open("huge.png", "wb").write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 1, 0, 0, 0, 0))
                             + chunk(b"IDAT", rows) + chunk(b"IEND", b""))
SCRIPT
  refused "pictures of 32768 x 32768 pixels" 'huge.png: the picture has 32768 x 32768 pixels; expected at most 100 million' \
    diff huge.png huge.png
fi
echo "1..$number"
