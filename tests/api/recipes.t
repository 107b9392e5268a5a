#!/usr/bin/env bash
# CONTRIBUTING.md followed to the letter in a copy of the project. Its four recipes: a surface, a constraint, a part and a
# format, one new file and one line each, are used from one design. Then what breaks the house is planted, one thing at a
# time, and tests/layers has to find and name it.
set -u
case ${LAM_TESTS:-build/tests} in build/tests | */build/tests) ;; *) echo "ok 1 - recipes # SKIP only for the release build" && exit ;; esac
root=$(realpath "$(dirname "$0")/../..")
. "$root/tests/cli/scratch.sh"
unset LAMELLA_TEMPLATES MAKEFLAGS MFLAGS MAKELEVEL

# try COMMAND...: the same as run, for any command.
try() {
  "$@" >out 2>err
  status=$?
}
says() { [[ $status -eq $1 ]] && grep -qE -- "$2" out; }
make_copy() { make -C "$scratch/copy" --no-print-directory -j2 "$@"; }

# ---- the copy: with the objects and their times, so that make builds only what is new ----
mkdir -p copy/build
(cd "$root" && cp -a Makefile CONTRIBUTING.md gen formats templates tests "$scratch/copy" &&
  cp -a build/obj build/lamella build/liblamella.a build/liblamella.so "$scratch/copy/build")
mkdir before && cp -a copy/gen copy/formats before
lamella=$scratch/copy/build/lamella
make_copy all >log 2>&1 || sed "s/^/# /" log

# ---- the recipes ----
# recipe WORD NAME FOLDER: what CONTRIBUTING.md says under WORD: file, symbol and list, with NAME put in. The file's text
# comes from standard input.
recipe() {
  local text
  text=$(tr -s '\n ' ' ' <copy/CONTRIBUTING.md | grep -oE "\* \*\*$1\*\*: [^*]*")
  file=$(grep -oE '`[A-Za-z/]+/NAME\.c`' <<<"$text" | tr -d '`' | sed "s/NAME/$2/; s,FOLDER,$3,")
  symbol=$(grep -oE 'called `lam_[a-z_]+NAME`' <<<"$text" | sed "s/called .//; s/NAME./$2/")
  list=$(grep -oE '`row\(NAME\)` in `[a-z/_]+\.c`' <<<"$text" | sed 's/.* in .//; s/.$//')
  cat >text
  echo "file: $file, symbol: $symbol, list: $list" >out && : >err && status=-
  ok "CONTRIBUTING.md says where a ${1,,} belongs: file, symbol and list" told
  new+=("$file") lists+=("$list")
  cp text "copy/$file"
  sed -i "/^  row([a-z_]*)\$/i\\  row($2) \\\\" "copy/$list"
}
told() { grep -q " $symbol = {" text && [[ ! -e copy/$file && -d copy/${file%/*} && -f copy/$list ]]; }
new=() lists=()

recipe Surface conoid - <<'END'
/* The conoid x = (u, v, rise u cos v), one line in surfaces.c: straight rulings from a beam on the
 * ground, u = 0, to a wave. Straight lines are asymptotic: L = 0, so that K <= 0. */
#include "surf/surface_kind.h"

/* The parameters of a row, and the data. */
typedef struct lam_conoid {
  double rise;
} lam_conoid;

/* Lines of constant v are straight: x_uu = 0. */
static void eval(const void *data, double u, double v, lam_jet *jet) {
  double rise = ((const lam_conoid *)data)->rise, c = rise * cos(v), s = rise * sin(v);
  jet->x = lam_v3(u, v, u * c);
  jet->u = lam_v3(1, 0, c);
  jet->v = lam_v3(0, 1, -u * s);
  jet->uu = lam_v3(0, 0, 0);
  jet->uv = lam_v3(0, 0, -s);
  jet->vv = lam_v3(0, 0, -u * c);
}

/* Beside the beam, and the crest of one wave. */
static bool domain(const void *data, lam_chart chart, double p[2], double q[2], bool closed[2]) {
  (void)data;
  static const lam_domain crest = {{0.5, 2.5}, {-1.2, 1.2}, {false, false}};
  return chart == LAM_CHART_NATURAL && lam_domain_give(crest, p, q, closed);
}

static const lam_key keys[] = {
    LAM_NUMBER_KEY(lam_conoid, "rise", rise, "0.4", 1e-3, 1e3, "Slope of the steepest ruling."),
    {0}};

const lam_surface_kind lam_surface_conoid = {
    .head = {.name = "conoid",
             .title = "Conoid",
             .doc = "The roof of Gaudi's school in Barcelona: straight boards lie on a beam at one "
                    "end and on a wave at the other. The boards are asymptotic lines.",
             .equation = "x = (u, v, rise u cos v)",
             .source = "do Carmo, Differential Geometry of Curves and Surfaces, 3-5",
             .keys = keys,
             .params_size = sizeof(lam_conoid)},
    .eval = eval,
    .domain = domain};
END

recipe Constraint equal_diagonals - <<'END'
/* The constraint `equal-diagonals`. Listed in constraints.c; designs ask for it by name. */
#include "con/constraint.h"
#include "con/kernel.h"

/* The diagonals of a quad are equally long. With d1 = v2 - v0, d2 = v3 - v1 and q = |d|^2:
 *   r = (q1 - q2) / (q1 + q2)
 * dimensionless: close to equality the relative difference of the lengths.
 * dr/dq1 = 2 q2 / (q1 + q2)^2, dr/dq2 = -2 q1 / (q1 + q2)^2, and dq = 2 d. */
static void equal_diagonals(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  lam_vec3 d1 = lam_sub(lam_local(x, 2), lam_local(x, 0));
  lam_vec3 d2 = lam_sub(lam_local(x, 3), lam_local(x, 1));
  double q1 = lam_dot(d1, d1), q2 = lam_dot(d2, d2), sum = q1 + q2;
  r[0] = (q1 - q2) / sum;
  if (!J) return;

  for (int c = 0; c < n; c++) J[c] = 0;
  lam_vec3 r1 = lam_scale(d1, 4 * q2 / (sum * sum)), r2 = lam_scale(d2, -4 * q1 / (sum * sum));
  lam_add_to(J, 0, lam_scale(r1, -1));
  lam_add_to(J, 1, lam_scale(r2, -1));
  lam_add_to(J, 2, r1);
  lam_add_to(J, 3, r2);
}

static void add(lam_scope *scope, const void *params, double weight, lam_location location) {
  (void)params, (void)location;
  lam_face_block_add(scope, "equal-diagonals", equal_diagonals, 1, weight);
}

const lam_constraint_kind lam_con_equal_diagonals = {
    {"equal-diagonals", "Equal diagonals",
     "In every quad both diagonals are equally long: together with equal opposite edges a net of "
     "rectangles.",
     "(|v2 - v0|^2 - |v3 - v1|^2) / (|v2 - v0|^2 + |v3 - v1|^2) = 0", NULL, NULL, 0},
    add};
END

recipe Part markers - <<'END'
/* The row `markers`: an octahedron at every vertex of the net, to be seen by a survey. Called
 * through the registry (part_kinds.c) by design/parts_stage.c. */
#include "core/solid/triangles.h"
#include "fab/mesh_fill.h"
#include "fab/workshop.h"

/* The keys of a row, in meters. */
typedef struct markers_keys {
  double size;
  int material;
} markers_keys;

/* The octahedron around the origin: four corners around the middle, then top and bottom. */
static lam_trimesh octahedron(lam_arena *arena, double size) {
  lam_trimesh solid = lam_trimesh_empty(arena, 6, 8);
  static const double corner[6][3] = {{1, 0, 0},  {0, 1, 0}, {-1, 0, 0},
                                      {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (int i = 0; i < 6; i++)
    solid.vertices[i] = lam_scale(lam_v3(corner[i][0], corner[i][1], corner[i][2]), size / 2);

  for (int i = 0; i < 4; i++) {
    int next = (i + 1) % 4;
    lam_trimesh_triangle(&solid, i, next, 4);
    lam_trimesh_triangle(&solid, next, i, 5);
  }
  return solid;
}

/* One part, with an upright instance at every vertex. */
static void make(lam_workshop *shop, const void *params, lam_location location) {
  const markers_keys *k = params;
  const lam_mesh *mesh = &shop->net->mesh;
  (void)location;
  lam_part part = {.name = "marker", .kind = "markers", .family = -1, .group = -1};
  part.congruence = lam_workshop_next_class(shop);
  part.material = &lam_materials[k->material];
  part.solid = octahedron(shop->arena, k->size);
  part.mass = lam_trimesh_volume(&part.solid) * part.material->density;

  part.instance_count = mesh->vertex_count;
  part.instances = LAM_NEW(shop->arena, lam_pose, mesh->vertex_count);
  for (int v = 0; v < mesh->vertex_count; v++)
    part.instances[v] = (lam_pose){mesh->vertices[v], {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

  double count = mesh->vertex_count;
  lam_stage *stage = lam_workshop_stage(shop, "markers");
  lam_stage_measure(shop->arena, stage, "marker_count", "", count, count, mesh->vertex_count);
  stage->converged = lam_part_is_sound(shop->arena, &part);
  lam_workshop_part(shop, part);
}

static const lam_key keys[] = {
    LAM_LENGTH_KEY(markers_keys, "size", size, "40 mm", 1e-3, 10, "From corner to corner."),
    LAM_CHOICE_KEY(markers_keys, "material", material, "plywood", lam_material_names,
                   "What they are made of."),
    {0}};

const lam_part_kind lam_part_markers = {
    .head = {.name = "markers",
             .title = "Markers at the vertices",
             .doc = "An octahedron at every vertex of the net. All are one part.",
             .keys = keys,
             .params_size = sizeof(markers_keys)},
    .make = make};
END

recipe Format vertices tables <<'END'
/* The vertices of the net (vertices.csv; listed in formats/list/formats.c), for setting out. */
#include "formats/format.h"
#include "formats/tables/csv.h"

static const char *const columns[] = {"vertex", "x_mm", "y_mm", "z_mm"};

static int count_files(const lam_model *model) { return model->net != NULL; }
static void path_of(const lam_model *model, int i, lam_text *path) {
  (void)model, (void)i;
  lam_text_add(path, "vertices.csv");
}

/* In the order of the model, from 1 on. */
static lam_status write_file(const lam_model *model, int i, lam_text *out) {
  (void)i;
  lam_csv_header(out, columns, sizeof columns / sizeof *columns);
  for (int v = 0; v < model->net->vertex_count; v++) {
    lam_vec3 x = model->net->vertices[v];
    lam_csv_integer(out, v + 1);
    lam_csv_number(out, x.x * 1e3, 3);
    lam_csv_number(out, x.y * 1e3, 3);
    lam_csv_number(out, x.z * 1e3, 3);
    lam_csv_end_row(out);
  }
  return LAM_OK;
}

const lam_format lam_format_vertices = {
    .name = "vertices",
    .doc = "The vertices of the net as CSV, in millimeters.",
    .count = count_files,
    .path = path_of,
    .write = write_file,
};
END

try make_copy all
ok "the new files compile without a warning and link" eval '[[ $status -eq 0 && ! -s err ]]'
only_new() { grep -oE '^  (cc|c\+\+)  .*' out | sort >built && printf '  cc   %s\n' "${new[@]}" "${lists[@]}" | sort | diff - built >err; }
ok "nothing but the new files and their lists is compiled" only_new
one_line() {
  local i
  for i in 0 1 2 3; do
    [[ $(diff "before/${lists[i]}" "copy/${lists[i]}" | grep -c '^[<>]') -eq 1 ]] || return
  done
  [[ $(diff -rq before/gen copy/gen | wc -l) -eq 6 && $(diff -rq before/formats copy/formats | wc -l) -eq 2 ]]
}
ok "each recipe is one new file and one line" one_line

# ---- one design uses all four ----
cat >school.yaml <<'END'
lamella: 1
name: school
surface: {kind: conoid, rise: 0.5}
net: {kind: free, grid: [6, 8], constraints: [equal-diagonals]}
parts: [{kind: markers, size: 50 mm}]
END
run build school.yaml -o plain --skip png --set 'net.constraints=[]'
# z - x cos(y) / 2 is the same everywhere: the net is moved up or down to the ground. Millimeters, three decimals.
on_surface() {
  [[ $status -eq 0 ]] && awk -F, 'NR > 1 { z = $4 - $2 * cos($3 / 1000) / 2; if (NR == 2) at = z; d = z - at; if (d * d > 1e-5) wrong++ }
    END { exit wrong || NR != 64 }' plain/vertices.csv
}
ok "a design's net lies on the new surface" on_surface
# The largest relative difference of two diagonals.
diagonals() {
  awk 'function q(a, b) { return (x[a] - x[b]) ^ 2 + (y[a] - y[b]) ^ 2 + (z[a] - z[b]) ^ 2 }
    $1 == "v" { n++; x[n] = $2; y[n] = $3; z[n] = $4 }
    $1 == "f" { for (i = 2; i <= 5; i++) sub(/\/.*/, "", $i); d = sqrt(q($2, $4) / q($3, $5)) - 1; if (d < 0) d = -d; if (d > most) most = d }
    END { print most }' "$1/net.obj"
}
run build school.yaml -o made --skip png
equal() {
  [[ $status -eq 0 ]] &&
    awk -v with="$(diagonals made)" -v without="$(diagonals plain)" 'BEGIN { exit !(with < 1e-9 && without > 1e-3) }'
}
ok "a net keeps the new constraint" equal
placed() {
  grep -q '^marker,markers,,63,' made/bom.csv && run inspect made/parts/marker.stl && says 0 '^volume +20833\.33' && says 0 '^valid solid +yes'
}
ok "the new part is made: 63 markers of a sixth of (50 mm)^3, a valid solid" placed
written() {
  awk -F'[ ,\r]+' '$1 == "v" { x[++n] = $2 } FNR != NR && FNR > 1 { d = $2 - 1000 * x[$1]; if (d * d > 1e-6) wrong++; rows++ }
    END { exit wrong || rows != 63 || n != 63 }' made/net.obj made/vertices.csv
}
ok "the new format is written: the vertices of the net" written
run build school.yaml -o some --only vertices
ok "the new format can be asked for alone" eval '[[ $status -eq 0 && $(ls some) == vertices.csv ]]'
run check school.yaml --set surface.rise=-1 --set 'parts[0].size=3'
checked() {
  [[ $status -eq 2 ]] && grep -q '^--set surface.rise: .*expected from 0.001 to 1000' err &&
    grep -q '^--set parts\[0\].size: given 3; expected a length' err
}
ok "keys of the new kinds are checked" checked
for page in "conoid (surface): Conoid" "equal-diagonals (constraint): Equal diagonals" "markers (part): Markers at the vertices" "vertices (format): The vertices"; do
  run show "${page%% *}"
  ok "lamella show ${page%% *} prints its page" eval '[[ $status -eq 0 ]] && head -1 out | grep -qF "$page"'
done

# ---- the tests check what is listed ----
tests=$(cd copy/tests && echo unit/*/test_surface.c unit/*/test_constraints.c) && tests=${tests//.c/}
checks() {
  local test failed=0
  make_copy ${tests//unit/build/tests/unit} || return
  for test in $tests; do (cd copy && "build/tests/$test") || failed=1; done
  return $failed
}
try checks
ok "the unit tests of surfaces and constraints accept the new ones" test $status -eq 0
sed -i 's/jet->uv = lam_v3(0, 0, -s)/jet->uv = lam_v3(0, 0, s)/' "copy/${new[0]}"
sed -i 's/-4 \* q1/-4 * q2/' "copy/${new[1]}"
try checks
ok "a wrong second derivative of the new surface is found and named" grep -q 'conoid.*x_uv' out err
ok "a wrong Jacobian of the new constraint is found and named" grep -q 'equal-diagonals.*by differences' out err

# ---- the house ----
# Sources, and the objects of the new files and of a room below them: tests/layers looks into every object there is.
house=$scratch/house
mkdir house && (cd copy && cp -a --parents gen formats tests/layers "$house" &&
  cp -a --parents $(printf 'build/obj/%s\n' "${new[@]/%c/o}") build/obj/gen/net/*.o "$house")
# layers ARGUMENT...: its messages, without the table.
layers() {
  perl "$@" >table
  local found=$?
  grep -v ' files  ' table
  return $found
}
try layers "$root/tests/layers" "$house"
ok "tests/layers accepts what follows the recipes" says 0 '^layers: no include breaks the rule$'

# finds SENTENCE MESSAGE FILE...: the message is the only one; the files are then as they were, or gone.
finds() {
  local file sentence=$1 message=$2
  shift 2
  try layers "$root/tests/layers" "$house"
  ok "tests/layers finds $sentence" broken "$message"
  for file; do
    rm -f "house/$file"
    [[ ! -e copy/$file ]] || cp -a "copy/$file" "house/$file"
  done
}
broken() { [[ $status -eq 1 ]] && grep -qxF -- "$1" out && grep -qx '1 broken' out; }
# add FILE LINE...: appends lines.
add() { printf '%s\n' "${@:2}" >>"house/$1"; }

# What no include shows: a declaration of one's own.
called=$(nm copy/build/obj/gen/net/optimize.o | awk '$2 == "T" { print $3; exit }')
printf '%s\n' '/* Calls. */' "int $called(void);" 'int lam_caller(void);' "int lam_caller(void) { return $called(); }" >copy/gen/mesh/caller.c
make_copy build/obj/gen/mesh/caller.o >log 2>&1 || sed 's/^/# /' log
(cd copy && cp -a --parents gen/mesh/caller.c build/obj/gen/mesh/caller.o "$house")
rm copy/gen/mesh/caller.c copy/build/obj/gen/mesh/caller.o
finds "a call of a room below without its header" "gen/mesh/caller.c calls $called of net, which stands below it" gen/mesh/caller.c build/obj/gen/mesh/caller.o
rm -r house/build # the others need no objects

add gen/core/grow.c '#include "net/optimize.h"'
finds "an include of a room below" 'gen/core/grow.c includes net/optimize.h: core may not' gen/core/grow.c
add gen/mesh/coarsen.h '#include "mesh/offset.h"'
add gen/mesh/offset.h '#include "mesh/coarsen.h"'
finds "two headers that include each other" 'a circle: mesh/coarsen.h -> mesh/offset.h -> mesh/coarsen.h' gen/mesh/coarsen.h gen/mesh/offset.h
mkdir house/gen/extras && add gen/extras/extra.c '/* Extra. */'
finds "a file in a folder that is no room" 'gen/extras/extra.c lies in no room of the table' gen/extras/extra.c
add gen/cli/main.c '#include "core/text.h"'
finds "a verb that includes more than the face" 'gen/cli/main.c includes core/text.h: cli may not' gen/cli/main.c
add gen/mesh/bare.c 'int lam_bare;'
finds "a file that says nothing about itself" 'gen/mesh/bare.c does not open with a comment' gen/mesh/bare.c
add gen/mesh/wide.c '/* Wide. */' "$(printf '/* %095d */' 0)"
finds "a line of 101 columns" 'gen/mesh/wide.c:2 has over 100 columns' gen/mesh/wide.c
add gen/mesh/talk.c '/* Talks. */' '#include <stdio.h>' 'int lam_talk(void) { return printf("hello"); }'
finds "a printf where nothing is printed" 'gen/mesh/talk.c calls printf' gen/mesh/talk.c
add gen/mesh/sparse.c '/* Sparse. */' '#include <amd.h>'
finds "an outside library out of its place" 'gen/mesh/sparse.c includes amd.h: not its business' gen/mesh/sparse.c
add gen/mesh/optimize.c '/* Again. */'
finds "two files of one name" 'gen/net/optimize.c and gen/mesh/optimize.c have the same name' gen/mesh/optimize.c

sed -i -E 's/^(mesh +: )/\1net /' house/tests/layers
try layers house/tests/layers
ok "tests/layers finds a row of its own table that names a room below it" broken 'the table: mesh names net, which does not stand above it'
echo "1..$number"
