#!/usr/bin/env bash
# The library as a program meets it: installed into a prefix of its own, its headers alone, its symbols, and the programs
# of templates/c, of README.md and of lamella.h, which are compiled by the commands that stand beside them.
set -u
case ${LAM_TESTS:-build/tests} in build/tests | */build/tests) ;; *) echo "ok 1 - examples # SKIP only for the release build" && exit ;; esac
root=$(realpath "$(dirname "$0")/../..")
. "$root/tests/cli/scratch.sh"
unset LAMELLA_TEMPLATES MAKEFLAGS MFLAGS MAKELEVEL

# try COMMAND...: the same as run, for any command.
try() {
  "$@" >out 2>err
  status=$?
}
says() { [[ $status -eq $1 ]] && grep -qE -- "$2" out; }
complains() { [[ $status -eq $1 ]] && grep -qE -- "$2" err; }
# same A B: two files with the same lines; what differs is shown.
same() { diff "$1" "$2" >out 2>&1; }
exist() { for file; do [[ -s $file ]] || { echo "no $file" >>err; return 1; }; done; }

# Commands are carried out as they are written, without a warning.
strict='-Wall -Wextra -pedantic -Werror'
cc() { command cc $strict "$@"; }
c++() { command c++ $strict "$@"; }
# written FILE WORD: the first command in a comment of FILE that begins with WORD.
written() { sed -nE "s,^ *(\*|//) +($2 .*),\2,p" "$1" | sed 's,  *\*/$,,; 1q'; }
# readme WORDS: the command in README.md that begins with WORDS, without its remark.
readme() { sed -nE "s,^    ($1.*[^ ]) +# .*,\1,p" "$root/README.md" | sed 1q; }

# ---- the prefix ----
prefix=$scratch/usr
make -C "$root" all >log 2>&1 || sed 's/^/# /' log
try make -C "$root" install prefix="$prefix"
installed() { [[ $status -eq 0 ]] && exist usr/bin/lamella usr/lib/liblamella.{a,so} usr/share/man/man1/lamella.1 usr/share/lamella/templates/pov/plaza.inc; }
ok "installing puts program, libraries, manual page and templates into the prefix" installed
nothing_built() { [[ $status -eq 0 ]] && ! grep -E '^  (cc|c\+\+|link) ' out >err; }
ok "installing builds nothing that is up to date" nothing_built

(cd "$root/gen/include" && find . -type f | sort) >expected
(cd usr/include && find . -type f | sort) >found
ok "the headers that are installed are those of the face, and no others" same expected found

alone() { # LANGUAGE COMPILER...: every header, twice, is a whole file
  local header language=$1
  shift
  : >err
  for header in usr/include/lamella/*.h; do
    header=lamella/${header##*/}
    printf '#include <%s>\n#include <%s>\nextern int something;\n' "$header" "$header" |
      "$@" $strict -fsyntax-only -Iusr/include -x "$language" - 2>>err || echo "$header" >>err
  done
  [[ ! -s err ]]
}
ok "every header compiles alone as C11, without a warning" alone c command cc -std=c11
ok "every header compiles alone as C++17, without a warning" alone c++ command c++ -std=c++17

# ---- symbols ----
nm -D --defined-only usr/lib/liblamella.so | awk '{print $NF}' | sort >found
perl -0777 -ne 's{/\*.*?\*/|^\#.*?$}{}gms; print "$1\n" while /\bLAM_API\b[^;]*?\b(lam_\w+)\s*\(/g' usr/include/lamella/*.h | sort >expected
ok "the shared library shows the functions that the headers declare, and nothing else" same expected found

# ---- pkg-config, as in README.md ----
where=$(sed -nE 's,^    (export PKG_CONFIG_PATH=[^#]*[^# ]).*,\1,p' "$root/README.md")
eval "${where//DIR/$prefix}"
sed -nE 's/^#define LAM_VERSION "(.*)"/\1/p' usr/include/lamella/api.h >expected
pkg-config --modversion lamella >found 2>err
ok "pkg-config tells the version of the headers" same expected found

# ---- the programs compile as they say ----
cp "$root"/templates/c/* .
for program in build_design.c own_surface.c optimize_net.cc; do
  try eval "$(written "$program" 'c(c|\+\+)')"
  ok "$program compiles by the command in its comment" exist "${program%.*}"
done
# The rule of README.md, for my.c; the C++ program says its own language.
link=$(readme 'c\+\+ my.o') compile=$(sed -nE 's,^    c\+\+ my.o .*after (cc .*my\.c)$,\1,p' "$root/README.md")
for program in build_design.c own_surface.c optimize_net.cc; do
  cp "$program" "my.${program##*.}"
  case $program in *.cc) compile=${compile/#cc/c++ -std=c++17} compile=${compile/%my.c/my.cc} ;; esac
  rm -f my.o a.out
  try eval "$compile && $link && mv a.out static_${program%.*}"
  ok "$program links statically as README.md says" exist "static_${program%.*}"
done
needs_no_library() { exist static_{build_design,own_surface,optimize_net} && ! readelf -d static_* | grep liblamella >err; }
ok "what is linked statically needs no liblamella.so" needs_no_library

# ---- building a design ----
cat >roof.yaml <<'END'
lamella: 1
name: roof
surface: {kind: hyperbolic-paraboloid, size: 2 m}
net: {kind: asymptotic, grid: [5, 4]}
parts: [{kind: lamella, height: 60 mm, thickness: 2 mm}]
sheets: {stock: [3 m, 1 m]}
END
try ./build_design roof.yaml out.shared
ok "build_design builds a design" says 0 '^roof: 11 parts, [1-9][0-9]* sheets, [0-9]+ files, converged$'
ok "build_design writes solids and cutting sheets" exist out.shared/{assembly.stl,parts/A01.stl,parts/B05.stl,sheets/sheet-01.dxf}
valid() {
  for solid in out.shared/*.stl out.shared/parts/*.stl; do
    run inspect "$solid"
    says 0 '^valid solid +yes' || return
  done
}
ok "what build_design wrote are valid solids" valid
LAMELLA_TEMPLATES=$(pkg-config --variable=templates lamella) try ./static_build_design roof.yaml out.static
same_files() { [[ $status -eq 0 ]] && diff -r out.shared out.static >out; }
ok "linked statically and told where templates are, build_design writes the same files" same_files

sed 's/grid: .5, 4./gird: [5, 4]/' roof.yaml >wrong.yaml
try ./build_design wrong.yaml out.wrong
ok "a wrong design is exit status 1, and told with file, line and key" complains 1 '^wrong\.yaml:4: net\.gird: no such key; .*did you mean grid'
nothing_in() { [[ $status -eq $1 && ! -e $2 ]]; }
ok "a wrong design writes nothing" nothing_in 1 out.wrong
try ./build_design nowhere.yaml out.wrong
ok "a design that is not there is exit status 2, and told with its name" complains 2 '^nowhere\.yaml: '

# ---- a program's own surface ----
try ./own_surface out.wave
small() { [[ $status -eq 0 ]] && awk '/planarity at most/ && $6 + 0 < 1e-9 { found = 1 } END { exit !found }' out; }
ok "own_surface makes planar quads, planar within 1e-9" small
ok "own_surface writes panels and their sheets" exist out.wave/{assembly.stl,parts/P001.stl,parts/P192.stl,sheets/sheet-01.dxf,bom.csv}
ok "the installed library finds its templates: own_surface sets a picture" exist out.wave/{wave-roof.pov,plaza.inc,sky.inc}
sed -i 's/-h \* k \* s}/h * k * s}/' own_surface.c
try eval "$(written own_surface.c cc) && ./own_surface out.false"
ok "a wrong derivative of one's own surface is refused" complains 1 'derivative'

# ---- a net from arrays ----
try ./optimize_net
ok "optimize_net converges" says 0 '^converged after [0-9]+ iterations'
planar_stars() { [[ $status -eq 0 ]] && awk '$1 == "star_planarity" && $3 + 0 < 1e-9 { found = 1 } END { exit !found }' out; }
ok "optimize_net makes an asymptotic net: vertex stars planar within 1e-9" planar_stars
cp out expected
try ./static_optimize_net && cp out found
ok "linked statically, optimize_net computes the same" eval '[[ $status -eq 0 && -s found ]] && same expected found'

# ---- the program on top of lamella.h ----
mkdir whole && cp roof.yaml whole/my.yaml
sed -nE '/^ \* +#include </,/^ \* +}$/ s,^ \* {0\,3},,p' usr/include/lamella/lamella.h >whole/my.c
command=$(sed -nE 's,.*`(cc my\.c [^`]*)`.*,\1,p' usr/include/lamella/lamella.h)
# POV-Ray is not found: a picture would take minutes.
try eval "cd whole && $command && PATH=$scratch/none ./a.out"
cd "$scratch" || exit 1
whole() { [[ $status -eq 0 && ! -s out ]] && exist whole/out/{report.json,roof.scad,roof.step,assembly.stl}; }
ok "the whole program on top of lamella.h compiles by its command and writes all formats" whole

# ---- running out of memory ----
# 130 MB are enough for the library and a small design. 810,000 vertices are refused before the net is built, 90 lamellas with 30 crossings each do not
# fit while their solids are written. A program that hangs is stopped, which is wrong.
cat >field.yaml <<'END'
lamella: 1
name: field
surface: {kind: hyperbolic-paraboloid, size: 30 m}
net: {kind: free, grid: [900, 900]}
END
cat >large.yaml <<'END'
lamella: 1
name: large
surface: {kind: enneper, order: 2, u: [0, 0.5], size: 3 m}
net: {kind: asymptotic, grid: [30, 30], hole: 2, orthogonal: yes}
parts: [{kind: lamella, height: 30 mm, thickness: 1 mm}]
END
in_130_MB() { (ulimit -v 130000 && exec timeout 120 "$@"); }
try in_130_MB ./build_design roof.yaml out.little
ok "a small design is built in 130 MB" says 0 '^roof: 11 parts'
exhausted() { [[ $status -eq 3 && ! -s out && $(cat err) == 'out of memory' ]]; }
refused() { [[ $status -eq 1 && ! -s out && $(cat err) =~ ^field.yaml:4:.*'810000 vertices take about 11.2 GB, and there are 0.1 GB of memory' ]]; }
try in_130_MB ./build_design field.yaml out.field
ok "a net that memory does not hold is bad input, told with what would fit" refused
ok "it leaves no file" nothing_in 1 out.field
try in_130_MB ./build_design large.yaml out.large
ok "memory that runs out while writing is exit status 3 and a message, and no signal" exhausted
whole_files() { [[ $status -eq 3 && -d out.large ]] && ! find out.large -name '*.part' -o -empty | grep . >err; }
ok "memory that runs out while writing leaves whole files alone" whole_files
# whatever the limit: done, or a status and a message
every_limit() {
  local megabytes
  for megabytes in 40 60 80 100 130 160 200 250 300; do
    (ulimit -v ${megabytes}000 && exec timeout 60 ./build_design "$1" "out.$megabytes") >/dev/null 2>err
    case $? in
    0) ;;
    1) grep -q 'vertices take about .* GB, and there are .* GB of memory' err || return 1 ;;
    3) [[ $(cat err) == 'out of memory' ]] || return 1 ;;
    *) return 1 ;;
    esac
  done
}
ok "with any limit a small design is built, or memory runs out with a status" every_limit roof.yaml
ok "with any limit a larger one is built, or memory runs out with a status" every_limit large.yaml
echo "1..$number"
