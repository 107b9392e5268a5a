#!/usr/bin/env bash
# What ends a build in the middle, and what stands in its way: signals, kill -9, a second build into the same folder, inputs under
# the names of outputs, a full disk behind stdout, programs that hang.
set -u
export LAMELLA_TEMPLATES=$PWD/templates
. "$(dirname "$0")/scratch.sh"
status=0

# A net of 2 x 2 cells beside its design, and a stand-in for POV-Ray that writes half a picture and its state, says who it is, and
# goes on for ever.
cp "$project/tests/cases/meshes/roof.obj" .
printf 'lamella: 1\nname: tent\nnet: {kind: free, from: {file: roof.obj}}\n' >tent.yaml
mkdir bin
printf '#!/bin/sh\necho half >.lamella-part.png\necho state >.lamella-part.pov-state\necho $$ >%s/pid\nexec sleep 100\n' "$scratch" >bin/povray
chmod +x bin/povray
PATH=$scratch/bin:$PATH

# begin: a build in the background, which waits for its picture; leaves job and child.
begin() {
  rm -f pid
  # the shell lets programs in the background ignore SIGINT, and whoever runs the tests may have it ignore SIGHUP
  perl -e '$SIG{INT} = $SIG{HUP} = "DEFAULT"; exec @ARGV' "$lamella" build tent.yaml -o made >/dev/null 2>&1 &
  job=$!
  for _ in $(seq 200); do [[ -s pid ]] && break; sleep .02; done
  child=$(cat pid)
}
# Whether the program is gone, or is nobody's child any more and will be collected: looked for during two seconds.
gone() {
  for _ in $(seq 100); do
    state=$(sed 's/.*) //; s/ .*//' "/proc/$1/stat" 2>/dev/null)
    [[ -z $state || $state == Z ]] && return 0
    sleep .02
  done
  return 1
}
temporary() { find made -name '.lamella-part*'; }

# 128 + 2, 15 and 1: a shell's word for a program that a signal has ended
for signal in INT:130 TERM:143 HUP:129; do
  rm -rf made
  begin
  kill -"${signal%:*}" $job
  wait $job 2>/dev/null
  status=$?
  ok "SIG${signal%:*} ends the program as a signal does" [ $status = "${signal#*:}" ]
  ok "and the program that it started" gone "$child"
  ok "and leaves nothing temporary" [ -z "$(temporary)" ]
  ok "and no report, as the folder is not complete" [ ! -e made/report.json ]
done

begin
kill -9 $job
wait $job 2>/dev/null
ok "kill -9 ends the program that was started too" gone "$child"
ok "what is left then" [ -n "$(temporary)" ]
run build tent.yaml -o made --only obj
ok "goes with the next build" [ -z "$(temporary)" ]

begin

run build tent.yaml -o other --only obj
ok "a build into another folder goes on" [ $status = 0 ]
(sleep 1; kill $job) &
before=$(date +%s%N)
run build tent.yaml -o made --only obj
ok "a second build into the same folder waits for the first" [ $status = 0 -a $((($(date +%s%N) - before) / 1000000)) -ge 800 ]
wait $job 2>/dev/null

# ---- inputs and names ----
printf 'lamella: 1\nname: dome\nsurface: {kind: bezier}\n' >dome.yaml
run build dome.yaml -o . --only step
cp dome.step first.step
printf 'lamella: 1\nname: dome\nsurface: {kind: file, file: dome.step}\n' >again.yaml
run build again.yaml -o .
ok "an output that is the input ends with 2" [ $status = 2 ]
ok "in one line that names it" grep -qx "./dome.step: the model is made from this file, and would overwrite it; .*" err
ok "and the input is as it was" cmp -s dome.step first.step
ok "nothing else was written" [ ! -e report.json ]
ln -s ../again.yaml made/rule
run build again.yaml -o made --deps made/rule --only report
ok "a link to an input is none either" [ $status = 2 ]
for option in "build tent.yaml -o" "build tent.yaml --deps" "measure roof.obj --map edge_ratio -o" "new hypar-roof -o"; do
  run $option ''
  ok "${option%% *} ${option##* } with an empty name ends with 2" [ $status = 2 ]
done
run measure roof.obj --map edge_ratio -o roof.obj.svg
ln -sf "$scratch/roof.obj" map.svg
run measure roof.obj --map edge_ratio -o map.svg
ok "a map does not replace the mesh that it shows, nor a link to it" [ $status = 2 ]
if command -v convert >/dev/null; then
  convert -size 4x4 xc:red a.png && convert -size 4x4 xc:blue b.png && cp a.png kept.png
  run diff a.png b.png --mask a.png
  ok "a mask does not replace a picture that is compared" [ $status = 2 ]
  ok "which is as it was" cmp -s a.png kept.png
fi

# ---- what does not arrive ----
printf '#!/bin/sh\nexit 1\n' >bin/povray
run build tent.yaml -o made
ok "a picture that fails is status 1" [ $status = 1 ]
ok "and all else is there" [ -s made/report.json -a -s made/net.obj ]
run build tent.yaml -o made --skip png
ok "a picture that nobody wants is not missed" [ $status = 0 ]
for verb in "--help" "--version" "list" "show enneper" "check tent.yaml" "build tent.yaml -o made --skip png" "measure roof.obj" \
            "inspect roof.obj --json" "diff roof.obj roof.obj" "new hypar-roof -o h.yaml"; do
  rm -f h.yaml
  $lamella $verb >/dev/full 2>err
  status=$?
  ok "a full disk behind stdout is status 1: $verb" [ $status = 1 ]
  ok "in one line" grep -qx "lamella: stdout cannot be written.*" err
done

# ---- check finds what build would refuse, in the same status ----
mkfifo pipe.obj; mkdir folder.obj; : >empty.obj; ln -s /etc/passwd link.obj
for file in pipe.obj folder.obj empty.obj link.obj /etc/passwd missing.obj; do
  for key in "from: {file: $file}" "from: {file: roof.obj}, reference: {file: $file}"; do
    printf 'lamella: 1\nname: bad\nnet: {kind: free, %s}\n' "$key" >bad.yaml
    timeout 10 "$lamella" check bad.yaml >out 2>err
    status=$?
    ok "check refuses $key, in 20 lines at most" [ $status = 2 -a -s err -a "$(wc -l <err)" -le 21 ]
    cp err checked
    timeout 10 "$lamella" build bad.yaml -o none >out 2>err
    status=$?
    ok "and build in the same words" [ $status = 2 -a ! -e none -a "$(cat err)" = "$(cat checked)" ]
  done
done
picture() { printf 'lamella: 1\nname: tent\nsurface: {kind: enneper}\nrender: {%s}\n' "$1" >picture.yaml; run check picture.yaml; }
for view in entrance auto overview detail; do
  picture "setting: plaza, view: $view"
  ok "the plaza has the view $view" [ $status = 0 ]
done
for view in nosuch also from table; do
  picture "setting: plaza, view: $view"
  ok "but no view $view" grep -q "^picture.yaml:.* render.view: given $view; expected a view that plaza has: entrance" err
done
for setting in camera materials people; do
  picture "setting: $setting"
  ok "$setting is a part of settings, and none" grep -q "render.setting: given $setting" err
done

# ---- without templates ----
for verb in "list designs" "new hypar-roof -o h.yaml" "build tent.yaml -o none --skip png"; do
  LAMELLA_TEMPLATES=$scratch/nowhere "$lamella" $verb >out 2>err
  status=$?
  ok "a missing folder of templates is said: $verb" [ $status != 0 -a "$(grep -c 'the templates folder is not found; set LAMELLA_TEMPLATES' err)" = 1 ]
done
LAMELLA_TEMPLATES=$scratch/nowhere run list
ok "and in the list of everything" grep -q '^no designs: the templates folder is not found' out
LAMELLA_TEMPLATES=$scratch/nowhere run show hypar-roof
ok "and where a design is asked for" grep -q 'the templates folder with the designs is not found' err
echo "1..$number"
