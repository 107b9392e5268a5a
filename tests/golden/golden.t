#!/usr/bin/env bash
# Golden files of the designs that have a folder here. tests/golden/NAME holds
#   NAME.stl    the first lamella, compared by shape (volume, area, 0.05 mm)
#   mask.png    every part in a flat color: the decoded pixels must be the same, all of them (by hash)
#   draft.png   the scene without indirect light: at most .02 % of the pixels may differ by more than 4 of 255
# One sheet of a pair covers as little as .01 % of the pavilion's picture, so only the exact mask can miss nothing; a picture without
# a sheet must be told from the golden one. LAM_ACCEPT=1 records new golden files.
set -u
lamella=${LAMELLA:-build/lamella}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
count=0 failed=0
report() { # status, words
  count=$((count + 1))
  if [ "$1" = 0 ]; then echo "ok $count - $2"; else echo "not ok $count - $2"; failed=1; fi
}
skip() { count=$((count + 1)); echo "ok $count - $1 # SKIP povray is not installed"; }
same_pixels() { # A B: the hashes of the decoded pixels, as lamella diff prints them
  "$lamella" diff "$1" "$2" | tee "$work/log" | perl -ne 'push @h, $1 if /hash ([0-9a-f]+)/; END { exit !(@h == 2 && $h[0] eq $h[1]) }'
}
size='render.size=[480,270]'

for golden in tests/golden/*/; do
  golden=${golden%/}
  name=$(basename "$golden")
  file=templates/designs/$name.yaml
  out=$work/$name
  "$lamella" build "$file" -o "$out" --only report,stl,pov --set render.quality=golden --quiet >"$work/log" 2>&1
  report $? "$name builds"
  part=$(cd "$out/parts" 2>/dev/null && ls | sort | head -n 1)
  pictures=no
  if command -v povray >/dev/null; then
    pictures=yes
    for quality in mask golden; do
      "$lamella" build "$file" -o "$work/$quality" --only pov,png --set "$size" --set render.quality=$quality --quiet >>"$work/log" 2>&1
    done
  fi
  if [ -n "${LAM_ACCEPT:-}" ]; then
    mkdir -p "$golden"
    cp "$out/parts/$part" "$golden/part.stl"
    if [ $pictures = yes ]; then cp "$work/mask/$name.png" "$golden/mask.png"; cp "$work/golden/$name.png" "$golden/draft.png"; fi
    continue
  fi
  "$lamella" diff "$golden/part.stl" "$out/parts/$part" >"$work/log" 2>&1; status=$?
  report $status "$name: $part has the golden shape"; [ $status = 0 ] || sed 's/^/# /' "$work/log"
  if [ $pictures = no ]; then skip "$name: part mask"; skip "$name: draft"; continue; fi
  same_pixels "$golden/mask.png" "$work/mask/$name.png"; status=$?
  report $status "$name: part mask"; [ $status = 0 ] || sed 's/^/# /' "$work/log"
  "$lamella" diff "$golden/draft.png" "$work/golden/$name.png" >"$work/log" 2>&1; status=$?
  report $status "$name: draft"; [ $status = 0 ] || sed 's/^/# /' "$work/log"
done

# the guard itself: scenes without one sheet must be noticed, a card lamella and single sheets of the pavilion's pairs
if [ -z "${LAM_ACCEPT:-}" ] && command -v povray >/dev/null; then
  for missing in enneper-model:9 asymptotic-pavilion:9 asymptotic-pavilion:10 asymptotic-pavilion:40; do
    name=${missing%:*} part=${missing#*:}
    perl -0pe "s/object \\{ Part_$part\\b[^\\n]*\\n/\\n/" "$work/mask/$name.pov" >"$work/mask/missing.pov"
    cmp -s "$work/mask/$name.pov" "$work/mask/missing.pov" && report 1 "$name has a part $part"
    (cd "$work/mask" && povray 'render.ini[mask]' +Imissing.pov +Omissing.png +W480 +H270 -D +L. >/dev/null 2>&1)
    [ -s "$work/mask/missing.png" ] && ! same_pixels "tests/golden/$name/mask.png" "$work/mask/missing.png"
    report $? "$name without part $part is noticed in the mask"
    rm -f "$work/mask/missing.png"
  done
fi
echo "1..$count"
exit $failed
