#!/usr/bin/env bash
# What a build says of its own results is true: of nets without equations, of traced nets that leave much bare or would lie on
# themselves. Expected numbers are those of hand counts on the inputs in tests/cases/verdicts.
set -u
cd "$(dirname "$0")/../.." || exit 1
lamella=$(realpath -m "${LAMELLA:-build/lamella}")
cases=tests/cases/verdicts
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
count=0 failed=0
check() { # words, command...
  local words=$1
  shift
  count=$((count + 1))
  if "$@" >"$work/log" 2>&1; then echo "ok $count - $words"; else echo "not ok $count - $words"; sed 's/^/# /' "$work/log"; failed=1; fi
}
# build NAME ARGUMENTS: leaves $work/NAME.out, $work/NAME.err and status.
build() {
  local name=$1
  shift
  "$lamella" build "$cases/$name.yaml" -o "$work/$name" --only report "$@" >"$work/$name.out" 2>"$work/$name.err"
  status=$?
}
# measure NAME STAGE MEASURE FIELD: a number of its report
measure() {
  perl -MJSON::PP -e 'local $/; my ($file, $stage, $name, $field) = @ARGV; open my $f, "<", $file or die; my $r = decode_json(<$f>);
    for my $s (@{$r->{stages}}) { print $s->{measures}{$name}{$field} if index($s->{stage}, $stage) == 0 }' "$work/$1/report.json" "$2" "$3" "$4"
}
within() { perl -e 'exit !($ARGV[0] ne "" && $ARGV[0] >= $ARGV[1] && $ARGV[0] <= $ARGV[2])' "$@" || { echo "$1 is not in [$2, $3]"; return 1; }; }

# Sixteen quads, each with its own vertices: no star, so that nothing is asymptotic.
build soup
check "a soup of quads does not converge" [ $status = 1 ]
check "because there is nothing to solve" grep -q "NOT CONVERGED: nothing to solve: star_planarity" "$work/soup.out"

# Hills with umbilics: principal lines around the middle reach less than a quarter.
build w1
check "a net that leaves much of its surface bare converges" [ $status = 0 ]
check "it measures how much it covers" within "$(measure w1 net coverage max)" .1 .4
check "and says so" grep -qE "the net covers [0-9]+ % of the surface" "$work/w1.out"
build w1 --set 'net.from={lines: natural}'
check "parameter lines are not traced, and have no coverage" [ -z "$(measure w1 net coverage max)" ]

# Lines that go around a hill came back onto themselves: 42 faces over others.
build w2 --set net.grid=[12,12]
check "lines end where others are laid already" [ $status = 0 ]
check "so that no face lies on another" within "$(measure w2 net overlaps value)" 0 0

# The area falls by a billionth per step for ever, and by a hundred thousandth with finer knots.
build wavy-film
check "a film that is stationary to less than its knots allow converges" [ $status = 0 ]
check "and the report estimates how far above the least area it is" \
  within "$(measure wavy-film surface area_excess mean)" 1e-4 2e-3

# A part that does not fit the net is a stage that failed, after the others and before those behind it.
stages() { perl -MJSON::PP -e 'local $/; open my $f, "<", shift or die; print join " ", map { "$_->{stage}:" . ($_->{converged} ? "yes" : "no") }
  @{decode_json(<$f>)->{stages}}' "$work/$1/report.json"; }
build late --only report,stl,dxf
check "a part that does not fit is status 1" [ $status = 1 ]
check "the report has all that ran, the net first" [ "$(stages late)" = "net: asymptotic:no lamellas:yes node-connector:no bars:yes clash:no sheets:yes" ]
check "the net's verdict stands first in the table, too" [ "$(grep -nE 'CONVERGED|FAILED' "$work/late.out" | sed 's/:.*CONV.*/ net/;s/:.*FAILED.*/ part/' | head -2 | cut -d' ' -f2 | tr '\n' ' ')" = "net part " ]
check "with key and line of what does not fit" grep -q 'node-connector: FAILED: parts\[1\].arm: 20 mm does not reach .* (line 8)$' "$work/late.out"
check "the other parts are written" [ -e "$work/late/parts/A01a.stl" -a -e "$work/late/assembly.stl" ]
check "and no half of the one that failed" [ -z "$(ls "$work/late/parts" | grep -i -E 'washer|bolt')" ]
# One line for the edge of the sheet, and the strokes of the letters.
lines() { awk '/^POLYLINE/ { new = 1 } new && /^DEFPOINTS/ { n++; new = 0 } END { print n }' "$1"; }
check "sheets of parts that overlap say so" [ "$(lines "$work/late/sheets/sheet-01.dxf")" -gt 30 ]
# A count has neither minimum nor mean.
check "a count has its value and no spread" perl -MJSON::PP -e 'local $/; open my $f, "<", shift or die;
  my ($c) = map { $_->{measures} } grep { $_->{stage} eq "clash" } @{decode_json(<$f>)->{stages}};
  exit !(join(" ", sort keys %{$c->{pairs_checked}}) eq "unit value" && $c->{clash_count}{value} =~ /^\d+$/)' "$work/late/report.json"
check "also in the table" grep -qE '^  pairs_checked +[0-9]+$' "$work/late.out"
# Shares of sheets: the fullest is used at least as much as the mean, and that as the emptiest.
check "sheet_used is the used share" perl -MJSON::PP -e 'local $/; open my $f, "<", shift or die;
  my ($s) = map { $_->{measures}{sheet_used} } grep { $_->{stage} eq "sheets" } @{decode_json(<$f>)->{stages}};
  exit !(0 < $s->{min} && $s->{min} <= $s->{mean} && $s->{mean} <= $s->{max} && $s->{max} < 1)' "$work/late/report.json"
check "no number of the table is nan" sh -c '! grep -w nan "$0"' "$work/late.out"
build late --quiet
check "--quiet leaves what failed" grep -q '^lamella: node-connector: failed: parts' "$work/late.err"
check "in the order of the stages" grep -q '^lamella: net: asymptotic: not converged' <(head -1 "$work/late.err")

# Eight of sixteen panels are larger than the stock inside its margins, 980 mm x 980 mm: the boxes of the others are on sheets.
build large --only report,dxf,stl,bom
check "parts larger than the stock are status 1" [ $status = 1 ]
check "the others are on sheets" [ "$(ls "$work/large/sheets" | wc -l)" = 8 ]
check "all parts are written" [ "$(ls "$work/large/parts" | wc -l)" = 16 ]
check "each one that is too large is told" [ "$(grep -c 'sheets.stock: P[0-9]* needs .* mm, the sheet has room for 980.0 mm x 980.0 mm' "$work/large.out")" = 8 ]
check "and how many there are" grep -q '8 pieces lie on no sheet' "$work/large.out"
check "they have no sheet in the bill of materials" [ "$(grep -c 'sheet-' "$work/large/bom.csv")" = 8 ]
build large --only report,dxf --set 'sheets.stock=[1.2 m, 1.1 m]'
check "larger stock holds all" [ $status = 0 ]
check "and sheets of sound parts say nothing" [ "$(lines "$work/large/sheets/sheet-01.dxf")" = 1 ]

echo "1..$count"
exit $failed
