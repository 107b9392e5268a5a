#!/usr/bin/env bash
# What the texts of shipped designs claim, against what their reports measure.
# Needs: $LAMELLA (the program)
lamella=${LAMELLA:-build/lamella}
root=$(cd "$(dirname "$0")/../.." && pwd)
designs=$root/templates/designs
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
count=0
failed=0

check() { # words, command...
  local words=$1
  shift
  count=$((count + 1))
  if "$@" >"$work/log" 2>&1; then echo "ok $count - $words"; else echo "not ok $count - $words"; sed 's/^/# /' "$work/log"; failed=1; fi
}
# ratio NAME PART WHOLE: the quotient of two counts of its report, which is built once.
ratio() {
  [ -e "$work/$1/report.json" ] || "$lamella" build "$designs/$1.yaml" -o "$work/$1" --only report >/dev/null 2>&1
  perl -MJSON::PP -e 'local $/; my ($file, @names) = @ARGV; open my $f, "<", $file or die; my %m = map { %{$_->{measures}} } @{decode_json(<$f>)->{stages}};
    printf "%.6f", $m{$names[0]}{value} / $m{$names[1]}{value}' "$work/$1/report.json" "$2" "$3"
}
within() { perl -e 'exit !($ARGV[0] ne "" && $ARGV[0] >= $ARGV[1] && $ARGV[0] <= $ARGV[2])' "$@" || { echo "$1 is not in [$2, $3]"; return 1; }; }
says() { tr '\n#' '  ' <"$1" | tr -s ' ' | grep -q "$2"; }

# Bounds are those of the words: "nearly all" nine tenths, "three quarters" to five hundredths, "most" a half.
check "molding-canopy: beams nearly all differ" says "$designs/molding-canopy.yaml" "nearly all differ"
check "and do" within "$(ratio molding-canopy distinct_supports support_count)" .9 1
check "its plates are flat, as it says" within "$(ratio molding-canopy twisted_panels panel_count)" 0 0
check "near-developable-strips: three quarters of the planks are twisted" says "$designs/near-developable-strips.yaml" "Three quarters .* no flat pattern"
check "and are" within "$(ratio near-developable-strips twisted_panels panel_count)" .7 .8
check "geodesic-roof: most planks are twisted" says "$designs/geodesic-roof.yaml" "most are twisted"
check "and are" within "$(ratio geodesic-roof twisted_panels panel_count)" .5 1
check "dog-planar: its panels are flat" within "$(ratio dog-planar twisted_panels panel_count)" 0 0
check "but are not said to be square" sh -c '! grep -qi "title.*square" "$0"' "$designs/dog-planar.yaml"
check "helicoid-lobby has no lamellas and promises none" sh -c '! grep -qi lamellas "$0"' "$designs/helicoid-lobby.yaml"
check "the README says that this is geometry, not statics" grep -q "geometry, not statics" "$root/README.md"
check "so does what show says of the pavilion" sh -c '"$0" show asymptotic-pavilion | grep -q "geometry, not statics"' "$lamella"

echo "1..$count"
exit $failed
