#!/usr/bin/env bash
# What a build promises: the pavilion's measures, clash with and without slots, the same bytes again, rules for make, clean failure.
set -u
lamella=${LAMELLA:-build/lamella}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
count=0 failed=0
check() { # words, command...
  local words=$1
  shift
  count=$((count + 1))
  if "$@" >"$work/log" 2>&1; then echo "ok $count - $words"; else echo "not ok $count - $words"; sed 's/^/# /' "$work/log"; failed=1; fi
}
# measure STAGE NAME FIELD of a report, as a number
measure() {
  perl -MJSON::PP -e 'local $/; my ($file, $stage, $name, $field) = @ARGV; open my $f, "<", $file or die; my $r = decode_json(<$f>);
    for my $s (@{$r->{stages}}) { print $s->{measures}{$name}{$field} if index($s->{stage}, $stage) == 0 }' "$@"
}
within() { perl -e 'exit !($ARGV[0] ne "" && $ARGV[0] >= $ARGV[1] && $ARGV[0] <= $ARGV[2])' "$@" || { echo "$1 is not in [$2, $3]"; return 1; }; }
same_folder() { diff -r "$1" "$2"; }

pavilion=templates/designs/asymptotic-pavilion.yaml
report=$work/pavilion/report.json
check "the pavilion builds" "$lamella" build $pavilion -o "$work/pavilion" --only report,obj,bom,svg,pov --quiet
check "its stars are planar to 1e-9 of an edge" within "$(measure "$report" net star_planarity max)" 0 1e-9
check "its families cross at 90 degrees within 1e-6" within "$(measure "$report" net angle_deviation max)" 0 1e-6
check "its nodes do so too" within "$(measure "$report" lamellas crossing_angle_deviation max)" 0 1e-6
check "its lamellas unroll straight within 5e-5 of their length" within "$(measure "$report" lamellas unrolled_straightness max)" 0 5e-5
check "no two of its parts overlap" within "$(measure "$report" clash clash_volume_sum max)" 0 0
check "more than a thousand pairs were checked for that" within "$(measure "$report" clash pairs_checked value)" 1000 1e9
for fault in open_parts unoriented_parts self_intersecting_parts; do
  check "it has no $fault" within "$(measure "$report" lamellas $fault value)" 0 0
done
check "it has at least 15 + 15 lamellas" perl -e 'my %f; for (glob "$ARGV[0]/sheets/*.svg") { open my $s, "<", $_; while (<$s>) { $f{$1}{$2} = 1 while /\b([AB])(\d\d)a\b/g } }
  exit !(keys %{$f{A}} >= 15 && keys %{$f{B}} >= 15)' "$work/pavilion"

desk=templates/designs/enneper-model.yaml
all=report,obj,stl,scad,dxf,svg,gltf,bom,nodes,assembly,pov
check "without slots the build ends with 1" bash -c "'$lamella' build $desk -o '$work/none' --only report --quiet --set 'parts[0].joint=none'; [ \$? = 1 ]"
check "because the lamellas overlap" within "$(measure "$work/none/report.json" clash clash_volume max)" 1e-12 1
"$lamella" build $desk -o "$work/one" --only $all --quiet
"$lamella" build $desk -o "$work/two" --only $all --quiet --deps "$work/deps.d"
check "the same bytes every time" same_folder "$work/one" "$work/two"
check "the rule names the design and the OpenSCAD library" grep -qE "enneper-model.yaml|lamella.scad" "$work/deps.d"
printf 'all: %s/two/report.json\ninclude %s/deps.d\n' "$work" "$work" >"$work/Makefile"
check "make reads the rule and has nothing to do" make -q -f "$work/Makefile" all

# a folder that is built into again
again() { "$lamella" build $desk -o "$work/again" --quiet --set render.quality=thumb --set 'render.size=[64,36]' "$@"; }
again && touch "$work/again/parts/mine.stl"
last=$work/again/parts/$(ls "$work/one/parts" | tail -1)
again --set 'parts[0].every=4' --only report
check "a build of some formats removes nothing" test -e "$last"
again --set 'parts[0].every=4'
check "a build with fewer parts removes those that are gone" test ! -e "$last"
check "what the program did not write stays" test -e "$work/again/parts/mine.stl"
again --set name=other --set 'parts=[]'
check "another design in the same folder removes nothing" test "$(ls "$work/again/parts" | wc -l)" -gt 10

check "a wrong design ends with 2" bash -c "'$lamella' build $desk -o '$work/bad' --set net.grid=[0,4] >/dev/null 2>&1; [ \$? = 2 ]"
check "and leaves nothing behind" test ! -e "$work/bad"
check "a net that cannot exist ends with 1" bash -c "'$lamella' build $desk -o '$work/dome' --only report,obj --quiet \
  --set 'surface={kind: monge, x2: -0.3, y2: -0.3, size: 10 m}' --set 'net={kind: free, grid: [12, 12], constraints: [planar-star], solver: {fairness: 0.1}}' --set 'parts=[]'; [ \$? = 1 ]"
check "and the report names the state" grep -q "flattened" "$work/dome/report.json"
check "a missing folder for templates is one line and 1" bash -c "LAMELLA_TEMPLATES=/nonexistent '$lamella' build $desk -o '$work/t' --only scad 2>&1 | wc -l | grep -qx 1"
mkdir "$work/empty"
check "without POV-Ray only the picture is missing, with one line that names the package" bash -c "PATH='$work/empty' '$lamella' build $desk -o '$work/nopov' --only report,pov,png --quiet 2>'$work/err'; \
  /usr/bin/grep -q 'package povray\|povray' '$work/err' && [ -e '$work/nopov/report.json' ] && [ ! -e '$work/nopov/enneper-model.png' ]"
for file in templates/designs/*.yaml; do check "$(basename "$file") passes check" "$lamella" check "$file"; done
echo "1..$count"
exit $failed
