/* The keys that every net accepts beside its own: lam_net_common_keys. Read by
 * design/design_keys.c, library/reference/sections.c (the reference pages) and cli/verb_check.c. */
#include "net/handles.h"

/* Words of the choices, in the order of their enums in net/net_kind.h. line_choices: after auto
 * lam_chart_names in their order. */
static const char *const stages[] = {"surface", NULL};
static const char *const line_choices[] = {"auto",           "natural",  "asymptotic",
                                           "principal",      "diagonal", "geodesic-parallel",
                                           "geodesic-polar", NULL};
static const char *const unit_choices[] = {"auto", "m", "cm", "mm", "in", "ft", NULL};
const lam_file_unit lam_file_units[] = {{"auto", 0},   {"m", 1},      {"cm", .01},  {"mm", .001},
                                        {"in", .0254}, {"ft", .3048}, {NULL, 0}};
static const char *const base_choices[] = {"u", "v", NULL};
static const char *const boundaries[] = {"free", "fixed", "glide", NULL};

static const lam_key source_keys[] = {
    LAM_CHOICE_KEY(lam_net_source, "stage", stage, "surface", stages,
                   "The surface of this design, in the parameterization that the net needs."),
    LAM_TEXT_KEY(lam_net_source, "file", file, "~",
                 "A quad mesh (OBJ, OFF or PLY) instead, relative to the design file. Vertices in "
                 "no face are left out, and faces that are turned the other way are turned."),
    LAM_CHOICE_KEY(lam_net_source, "unit", unit, "auto", unit_choices,
                   "The unit of the file's coordinates. auto: meters."),
    LAM_LENGTH_KEY(lam_net_source, "size", size, "0", 0, 1e5,
                   "Scales the mesh of the file or design so that its largest extent along an axis "
                   "is this. 0: as it is."),
    LAM_LENGTH_KEY(lam_net_source, "weld", weld, "0", 0, 1e3,
                   "Joins vertices of the file that are closer than this, after scaling: for "
                   "meshes in pieces. 0 joins those at the same place. Left out: none is joined.",
                   LAM_GIVEN(lam_net_source, weld_given)),
    LAM_TEXT_KEY(
        lam_net_source, "design", design, "~",
        "The finished net of another design: the name of a design beside this one, or its file."),
    LAM_CHOICE_KEY(lam_net_source, "lines", lines, "auto", line_choices,
                   "The lines of the surface that the net follows; auto: those that its kind "
                   "starts from. Where the surface has no formula for them they are traced: u and "
                   "v of the surface are its own ranges then, and the net is the largest piece of "
                   "lines that all cross. geodesic-parallel: geodesics at right angles to a "
                   "parameter line, and points at equal distance from it. geodesic-polar: grid "
                   "[rings, spokes] around a point; `hole` rings, at least one, are left out."),
    LAM_FLAG_KEY(lam_net_source, "trace", trace, "no",
                 "Traces the lines even where there is a formula."),
    LAM_NUMBER_KEY(lam_net_source, "at", at, "", 0, 0,
                   "Traced lines: the point (u, v) that both base lines run through; the pole of "
                   "geodesic-polar. Left out: the middle.",
                   LAM_GIVEN(lam_net_source, at_given)),
    LAM_LENGTH_KEY(
        lam_net_source, "spacing", spacing, "0", 0, 1e6,
        "Traced lines: their distance on the base lines, before `size` scales the surface; the net "
        "has at most `grid` cells then. 0: `grid` cells over the whole length."),
    LAM_CHOICE_KEY(lam_net_source, "base", base, "u", base_choices,
                   "geodesic-parallel: the geodesics start from the line of constant u or of "
                   "constant v through `at`."),
    {0}};

static const lam_key reference_keys[] = {
    LAM_TEXT_KEY(lam_reference_keys, "file", file, "~",
                 "A mesh (OBJ, OFF, PLY or STL) that the net is to stay near, relative to the "
                 "design file."),
    LAM_CHOICE_KEY(lam_reference_keys, "unit", unit, "auto", unit_choices,
                   "The unit of the file's coordinates. auto: millimeters in STL, else meters."),
    LAM_NUMBER_KEY(lam_reference_keys, "weight", weight, "0.1", 1e-6, 1e3,
                   "Weight of the distance against the constraints. Left out: as large as the net "
                   "follows without folding or collapsing, from 0.001 to 0.1.",
                   LAM_GIVEN(lam_reference_keys, weight_given)),
    {0}};

static const char *const methods[] = {"lamella", "thesis", NULL};

static const lam_key solver_keys[] = {
    LAM_CHOICE_KEY(lam_solver_keys, "method", method, "lamella", methods,
                   "lamella: the vertices are the unknowns, and damped steps never raise the "
                   "residual. thesis: auxiliary unknowns, equations that are at most quadratic, "
                   "full Gauss-Newton steps (thesis 3.7): for comparison."),
    LAM_NUMBER_KEY(lam_solver_keys, "epsilon", epsilon, "1e-3", 1e-8, 1,
                   "Damping of the method thesis: how strongly a step is held back, the same in "
                   "all steps. The thesis takes 1e-3; sphere centers need 1e-6."),
    LAM_NUMBER_KEY(lam_solver_keys, "fairness", fairness, "0", 0, 100,
                   "Weight of fairness at the start; it fades to 0. Left out: the net's own.",
                   LAM_GIVEN(lam_solver_keys, fairness_given)),
    LAM_CHOICE_KEY(lam_solver_keys, "fair", fair, "positions", lam_fairness_choices,
                   "What fairness is put on: positions, or displacements from the start. Left out: "
                   "the net's own.",
                   LAM_GIVEN(lam_solver_keys, fair_given)),
    LAM_NUMBER_KEY(lam_solver_keys, "closeness", closeness, "0", 0, 100,
                   "Closeness of the vertices to the start relative to fairness; it fades with it. "
                   "Left out: the net's own.",
                   LAM_GIVEN(lam_solver_keys, closeness_given)),
    LAM_NUMBER_KEY(lam_solver_keys, "stiffness", stiffness, "0", 0, 100,
                   "Stiffness of the edges against changes of length, relative to fairness; it "
                   "fades with it. Left out: the net's own.",
                   LAM_GIVEN(lam_solver_keys, stiffness_given)),
    LAM_NUMBER_KEY(lam_solver_keys, "tolerance", tolerance, "1e-12", 1e-15, 1e-1,
                   "Largest residual of a converged net; lengths are relative to the mean edge.",
                   LAM_GIVEN(lam_solver_keys, tolerance_given)),
    LAM_INTEGER_KEY(lam_solver_keys, "iterations", iterations, "100", 1, 100000,
                    "Limit of iterations."),
    LAM_FLAG_KEY(lam_solver_keys, "smooth", smooth, "no",
                 "One smoothing step before the solver: for noisy meshes."),
    {0}};

const lam_key lam_net_common_keys[] = {
    LAM_MAP_KEY(lam_net_common, "from", from, "surface", source_keys, "What the net starts from."),
    LAM_INTEGER_KEY(lam_net_common, "grid", grid, "[16, 16]", 1, 2000,
                    "Cells along the two families. Around a flat point: cells along the two sides "
                    "of every sector, equal numbers."),
    LAM_INTEGER_KEY(lam_net_common, "hole", hole, "0", 0, 1000,
                    "Rings of cells left out around a flat point: an oculus."),
    LAM_FLAG_KEY(lam_net_common, "diagonalize", diagonalize, "no",
                 "The diagonals of the start's faces become its lines: every other vertex stays, "
                 "triangles at the boundary are left out. Done before coarsen and subdivide."),
    LAM_INTEGER_KEY(lam_net_common, "coarsen", coarsen, "0", 0, 10,
                    "So many times every other line of each family of the start is left out. Done "
                    "before subdivide."),
    LAM_INTEGER_KEY(
        lam_net_common, "subdivide", subdivide, "0", 0, 6,
        "Interpolating subdivisions of the start (four-point rule along the polylines)."),
    LAM_INTEGER_KEY(
        lam_net_common, "levels", levels, "0", 0, 8,
        "Coarser nets, every other line left out, that are solved first; as many as the grid can "
        "be halved. Left out: the net's own, and none with fewer than 64 faces.",
        LAM_GIVEN(lam_net_common, levels_given)),
    LAM_CHOICE_KEY(lam_net_common, "boundary", boundary, "free", boundaries,
                   "free; fixed: boundary vertices stay; glide: they slide along the boundary "
                   "curve, corners stay."),
    LAM_MAPS_KEY(lam_net_common, "handles", handles, "[]", lam_handle_keys, lam_handle,
                 "Vertices and sides that have to be at given places."),
    LAM_ROW_KEY(lam_net_common, "constraints", constraints, "[]", &lam_constraints,
                "Further constraints beside the net's own."),
    LAM_TEXT_KEY(lam_net_common, "measures", measures, "[]",
                 "Further measures for the report: names of `lamella list measures`."),
    LAM_MAP_KEY(lam_net_common, "reference", reference, "{}", reference_keys,
                "A surface that the net stays near.", LAM_GIVEN(lam_net_common, reference_given)),
    LAM_MAP_KEY(lam_net_common, "solver", solver, "{}", solver_keys, "How the net is solved."),
    LAM_INTEGER_KEY(lam_net_common, "animate", animate, "0", 0, 500,
                    "Keeps at most so many states of the net, from the start to the result: after "
                    "the steps of the handles, or without steps along the solver's iterations. "
                    "They are written as single nets and as an animation."),
    LAM_NUMBER_KEY(lam_net_common, "noise", noise, "0", 0, 1,
                   "Random displacement of the start, relative to the mean edge: for trying how "
                   "robust a net is."),
    LAM_INTEGER_KEY(lam_net_common, "seed", seed, "1", 0, 1e9,
                    "Of the noise: the same seed gives the same net."),
    {0}};
