#!/usr/bin/env bash
# Golden files of every shipped design. tests/golden/NAME holds
#   NAME.stl    the first lamella, compared by shape (volume, area, 0.05 mm)
#   mask.png    every part in a flat color: compared pixel by pixel
#   draft.png   the scene without indirect light: at most .02 % of the pixels may differ by more than 4 of 255
# A picture without one sheet must be told from the golden one. LAM_ACCEPT=1 records new golden files.
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
size='render.size=[480,270]'

for file in templates/designs/*.yaml; do
  name=$(basename "$file" .yaml)
  golden=tests/golden/$name
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
  "$lamella" diff "$golden/mask.png" "$work/mask/$name.png" >"$work/log" 2>&1; status=$?
  report $status "$name: part mask"; [ $status = 0 ] || sed 's/^/# /' "$work/log"
  "$lamella" diff "$golden/draft.png" "$work/golden/$name.png" >"$work/log" 2>&1; status=$?
  report $status "$name: draft"; [ $status = 0 ] || sed 's/^/# /' "$work/log"
done

# the guard itself: a scene without one of its sheets must be noticed
if [ -z "${LAM_ACCEPT:-}" ] && command -v povray >/dev/null; then
  name=enneper-model
  missing=$work/mask
  "$lamella" build templates/designs/$name.yaml -o "$missing" --only pov --set render.quality=mask --quiet
  perl -0pi -e 's/object \{ Part_9\b[^\n]*\n/\n/' "$missing/$name.pov"
  (cd "$missing" && povray 'render.ini[mask]' +I$name.pov +O$name.png +W480 +H270 -D +L. >/dev/null 2>&1)
  "$lamella" diff "tests/golden/$name/mask.png" "$missing/$name.png" >"$work/log" 2>&1
  [ $? = 1 ]; report $? "a missing lamella is noticed in the mask"
fi
echo "1..$count"
exit $failed
