#!/usr/bin/env bash
# The shipped asymptotic quadrilaterals report the energies that were computed for the same corner data independently (with respect to
# u, v of the unit square; tests/unit compares more digits), and boundaries that are asymptotic; the skin of the pavilion is smooth and complete.
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
# measure NAME FIELD of the stage whose name begins with STAGE is in [LOW, HIGH]
within() { # design, stage, name, field, low, high
  perl -MJSON::PP -e 'local $/; my ($file, $stage, $name, $field, $low, $high) = @ARGV; open my $f, "<", $file or die; my $r = decode_json(<$f>);
    for my $s (@{$r->{stages}}) { next if index($s->{stage}, $stage) || !$s->{measures}{$name}; my $x = $s->{measures}{$name}{$field};
      print "$name $field is $x, expected $low to $high\n"; exit !($x >= $low && $x <= $high) } print "no $name\n"; exit 1' "$work/$1/report.json" "${@:2}"
}
surfaces() { [ "$(grep -c '"knots_u"' "$work/$1/surface.json")" = "$2" ]; }

for design in asymptotic-quad-enneper asymptotic-quad-roof asymptotic-pavilion-skin; do
  check "$design builds" "$lamella" build templates/designs/$design.yaml -o "$work/$design" --only report,surface --quiet
done
check "Enneper's patch has its energy" within asymptotic-quad-enneper surface thin_plate_energy max 3.89035 3.89037
check "the roof has its energy" within asymptotic-quad-roof surface thin_plate_energy max 21.3495 21.3497
for design in asymptotic-quad-enneper asymptotic-quad-roof; do
  check "the boundary of $design is asymptotic" within $design surface normal_curvature_ratio max 0 1e-10
  check "its frames lie in the osculating planes" within $design frames normal_binormal_sine max 0 1e-10
  check "its control net is written" surfaces $design 1
done
skin=asymptotic-pavilion-skin
check "the pavilion has a patch in every cell: 6 (8 x 8 - 1)" within $skin skin patch_count value 378 378
check "none is left out" within $skin skin cells_left_out value 0 0
check "neighbors have the same normals" within $skin skin normal_jump max 0 1e-9
check "and the same edges" within $skin skin gap max 0 1e-12
check "all edges are asymptotic curves of the skin" within $skin skin edge_normal_curvature max 0 1e-9
check "and run on through the vertices" within $skin skin edge_kink max 0 1e-9
check "the skin is a saddle everywhere" within $skin skin gaussian_curvature max -1 -0.001
check "it stays within 2 mm of the net" within $skin skin net_distance max 0 0.002
check "it touches no lamella" within $skin clash clash_volume_sum max 0 0
check "all patches are written" surfaces $skin 378
echo "1..$count"
exit $failed
