#!/usr/bin/env bash
# Every part has a file of its own, however many rows of parts there are.
set -u
cases=$(realpath "$(dirname "$0")/../cases/names")
. "$(dirname "$0")/scratch.sh"

# four: 4 rows of 16 panels, and a beam on each of the 40 edges of 4 x 4 quads; many: 13 rows of 9 panels
for case in four:104 many:117; do
  name=${case%:*} parts=${case#*:}
  run build "$cases/$name.yaml" -o $name --only stl,bom
  ok "$name: $parts parts are $parts files" [ "$(ls $name/parts | wc -l)" = "$parts" ]
  ok "and as many lines of the bill of materials" [ "$(($(wc -l <$name/bom.csv) - 1))" = "$parts" ]
done
ok "panels and beams have letters of their own" [ "$(ls four/parts | sed 's/[0-9].*//' | sort -u | tr -d '\n')" = PQRST ]
ok "letters go on behind Z" [ -e many/parts/AB9.stl ]
echo "1..$number"
