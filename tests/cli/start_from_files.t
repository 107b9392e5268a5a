#!/usr/bin/env bash
# Nets that start from meshes of files: how far they move, how closely they follow a reference, and which key is named
# where one fails. The meshes are formulas; limits of distances are what the keys' defaults are chosen for, and what was
# measured without them stands beside the tests.
. "$(dirname "$0")/scratch.sh"
# mesh N M X Y Z: a grid of N x M faces, by awk expressions in u and v (0 to 1)
mesh() {
  awk -v n="$1" -v m="$2" "function noise() { return .04 * (rand() - .5) }
    BEGIN { srand(1); pi = 3.141592653589793
      for (i = 0; i <= n; i++) for (j = 0; j <= m; j++) { u = i / n; v = j / m; printf \"v %.9f %.9f %.9f\\n\", $3, $4, $5 }
      for (i = 0; i < n; i++) for (j = 0; j < m; j++) { a = i * (m + 1) + j + 1; print \"f\", a, a + m + 1, a + m + 2, a + 1 } }"
}
mesh 16 16 '8*u' '8*v' '.6*sin(5*u)*cos(4*v)' >wave.obj
mesh 14 14 '10*u-5+.6*sin(3*v)' '10*v-5+.5*sin(4*u)' '3*cos(2.4*u-1.2)*cos(2.2*v-1.1)+.25*sin(6*u+3*v)' >dome.obj
mesh 20 12 '10*u' '6*v+.8*sin(5*u)' '1.2*exp(-8*((u-.4)^2+(v-.5)^2))-.8*exp(-12*((u-.75)^2+(v-.3)^2))' >bump.obj
mesh 18 18 '9*u+noise()' '9*v+noise()' 'sin(3*u+1)*sin(4*v)+.3*sin(9*u*v)+noise()' >scan.obj
mesh 12 12 '6*u+.2*sin(7*v)' '6*v+.2*sin(5*u)' '.004*sin(9*u)*cos(7*v)' >flat.obj
build() { # MESH KIND KEYS
  printf 'lamella: 1\nname: t\nnet: {kind: %s, from: {file: %s.obj}%s}\n' "$2" "$1" "$3" >t.yaml
  run build t.yaml -o o --only report
}
# measured NAME COLUMN: a figure of the table (min mean max)
measured() { sed -n "s/.* $1 .* $2 *\([-0-9.e+]*\).*/\1/p" out; }
below() { [ "$status" = 0 ] && awk -v a="$1" -v b="$2" 'BEGIN { exit !(a != "" && a + 0 <= b) }'; }
move() { sed -n 's/.*largest move from the start: \([-0-9.e+]*\).*/\1/p' out; }

# without closeness 7.57, 5.36, 8.09, 5.71 and .0927 mean edges
for row in 'wave 1.6' 'dome .5' 'bump .7' 'scan 3' 'flat .015'; do
  set -- $row
  build "$1" planar-quads ''; ok "planar quads from $1.obj move at most $2 mean edges" below "$(move)" "$2"
done
run show planar-quads; ok "the page tells" grep -q 'closeness 0.3 where it starts from a mesh' out

# a weight of .1 folds or collapses 11 of these 12
for name in wave dome bump scan; do
  for kind in planar-quads circular conical; do
    build $name $kind ", reference: {file: $name.obj}"
    ok "$kind net of $name.obj follows a reference" grep -q 'the reference was followed with a weight of' out
  done
done
build flat planar-quads ', reference: {file: flat.obj}'
ok "nearly planar nets too, within their waves of 4 mm" below "$(measured distance_to_reference max)" .0045
build bump conical ', reference: {file: bump.obj, weight: 0.001}'; first=$(measured distance_to_reference mean)
build bump conical ', reference: {file: bump.obj}'
ok "as closely as it can: less than half the distance at the first weight" \
  below "$(measured distance_to_reference mean)" "$(awk -v d="$first" 'BEGIN { print d / 2 }')"

build bump conical ', reference: {file: bump.obj, weight: 0.1}'
[ "$status" = 1 ] && grep -q 'net.reference.weight: a smaller one than 0.1' out
ok "a weight that is too large is named" [ $? = 0 ]
build scan asymptotic ''
[ "$status" = 1 ] && grep -q 'net.solver.fairness: 0.1 smooths the first steps' out
ok "a net that collapses without guidance names the key" [ $? = 0 ]
build scan asymptotic ', solver: {fairness: 0.1}'; ok "which helps" [ "$status" = 0 ]
echo "1..$number"
