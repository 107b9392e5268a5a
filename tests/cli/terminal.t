#!/usr/bin/env bash
# What a person at a terminal sees: progress of the picture, time left, the quality that was asked for.
set -u
export LAMELLA_TEMPLATES=$PWD/templates
. "$(dirname "$0")/scratch.sh"
status=0

# A net of one cell, and a stand-in for POV-Ray that is a quarter done at once, and half done after 3.2 seconds: then as much time
# is left as was spent.
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n' >cell.obj
printf 'lamella: 1\nname: cell\nnet: {kind: free, from: {file: cell.obj}}\n' >cell.yaml
mkdir bin
cat >bin/povray <<'SH'
#!/bin/sh
echo "$1" >said
sleep .2
printf 'Rendered 25 of 100 pixels (25%%)\r' >&2
sleep 3.2
printf 'Rendered 50 of 100 pixels (50%%)\r' >&2
echo picture >.lamella-part.png
SH
chmod +x bin/povray
PATH=$scratch/bin:$PATH

script -qec "$lamella build cell.yaml -o made --picture final" typescript >out 2>err
status=$?
tr '\r' '\n' <typescript >lines
ok "the picture's progress is shown" grep -q 'render  *\[#####\.\.\.\.\.\.\.\.\.\.\.\.\.\.\.\] final$' lines
ok "and after some seconds the time left" grep -q 'render  *\[##########\.\.\.\.\.\.\.\.\.\.\] final, about [34] s left' lines
ok "--picture names the quality" grep -qF 'render.ini[final]' made/said

sed -i 's/^sleep.*//' bin/povray
run build cell.yaml -o made --set render.quality=print
ok "render.quality names it too" grep -qF 'render.ini[print]' made/said
run build cell.yaml -o made --set render.quality=print --picture middle
ok "--picture comes after --set" grep -qF 'render.ini[middle]' made/said
run build cell.yaml -o made
ok "a draft is made when nothing is said" grep -qF 'render.ini[draft]' made/said
ok "nothing is told of progress when stderr is no terminal" test ! -s err
run build cell.yaml -o made --picture fnal
ok "a quality that is not known is refused" test $status -eq 2
ok "with what is expected" grep -q 'render.quality: given fnal; expected one of draft.*(did you mean final?)' err

echo "1..$number"
