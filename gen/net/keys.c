#include "net/kind.h"

static const char *const stages[] = {"surface", NULL};
static const char *const boundaries[] = {"free", "fixed", "glide", NULL};

#define AT(type, member) .offset = offsetof(type, member)

static const lam_key source_keys[] = {
    {.name = "stage", .type = LAM_KEY_CHOICE, AT(lam_net_source, stage), .count = 1, .initial = "surface", .choices = stages,
     .doc = "The surface of this design, in the parameterization that the net needs."},
    {.name = "file", .type = LAM_KEY_TEXT, AT(lam_net_source, file), .count = 1, .initial = "~",
     .doc = "A quad mesh (OBJ, meters) instead, relative to the design file."},
    {0}};

static const lam_key handle_keys[] = {
    {.name = "vertex", .type = LAM_KEY_INTEGER, AT(lam_handle, vertex), .count = 2,
     .doc = "Grid position [i, j]; [index, -1] on a mesh from a file or around a flat point."},
    {.name = "to", .type = LAM_KEY_NUMBER, .unit = LAM_UNIT_LENGTH, AT(lam_handle, to), .count = 3,
     .doc = "Where the vertex has to be."},
    {.name = "steps", .type = LAM_KEY_INTEGER, AT(lam_handle, steps), .count = 1, .initial = "1", .min = 1, .max = 1000,
     .doc = "The handle is moved there in this many steps; the net is solved after each."},
    {0}};

static const lam_key reference_keys[] = {
    {.name = "file", .type = LAM_KEY_TEXT, AT(lam_reference_keys, file), .count = 1, .initial = "~",
     .doc = "A mesh (OBJ or STL) that the net is to stay near, relative to the design file. OBJ in meters, STL in millimeters."},
    {.name = "weight", .type = LAM_KEY_NUMBER, AT(lam_reference_keys, weight), .count = 1, .initial = "0.1", .min = 1e-6,
     .max = 1e3, .doc = "Weight of the distance against the constraints."},
    {0}};

static const lam_key solver_keys[] = {
    {.name = "fairness", .type = LAM_KEY_NUMBER, AT(lam_solver_keys, fairness), .count = 1, .initial = "0", .min = 0,
     .max = 100, .given_offset = offsetof(lam_solver_keys, fairness_given),
     .doc = "Weight of fairness at the start; it fades to 0. Left out: the net's own."},
    {.name = "fair", .type = LAM_KEY_CHOICE, AT(lam_solver_keys, fair), .count = 1, .initial = "positions",
     .choices = lam_fairness_choices, .given_offset = offsetof(lam_solver_keys, fair_given),
     .doc = "What fairness is put on: positions, or displacements from the start. Left out: the net's own."},
    {.name = "closeness", .type = LAM_KEY_NUMBER, AT(lam_solver_keys, closeness), .count = 1, .initial = "0", .min = 0,
     .max = 100, .given_offset = offsetof(lam_solver_keys, closeness_given),
     .doc = "Closeness of the vertices to the start relative to fairness; it fades with it. Left out: the net's own."},
    {.name = "stiffness", .type = LAM_KEY_NUMBER, AT(lam_solver_keys, stiffness), .count = 1, .initial = "0", .min = 0,
     .max = 100, .given_offset = offsetof(lam_solver_keys, stiffness_given),
     .doc = "Stiffness of the edges against changes of length, relative to fairness; it fades with it. Left out: the net's own."},
    {.name = "tolerance", .type = LAM_KEY_NUMBER, AT(lam_solver_keys, tolerance), .count = 1, .initial = "1e-12",
     .min = 1e-15, .max = 1e-1, .given_offset = offsetof(lam_solver_keys, tolerance_given),
     .doc = "Largest residual of a converged net; lengths are relative to the mean edge."},
    {.name = "iterations", .type = LAM_KEY_INTEGER, AT(lam_solver_keys, iterations), .count = 1, .initial = "100", .min = 1,
     .max = 100000, .doc = "Limit of iterations."},
    {.name = "smooth", .type = LAM_KEY_FLAG, AT(lam_solver_keys, smooth), .count = 1, .initial = "no",
     .doc = "One smoothing step before the solver: for noisy meshes."},
    {0}};

const lam_key lam_net_common_keys[] = {
    {.name = "from", .type = LAM_KEY_MAP, AT(lam_net_common, from), .count = 1, .initial = "surface", .keys = source_keys,
     .size = sizeof(lam_net_source), .doc = "What the net starts from."},
    {.name = "grid", .type = LAM_KEY_INTEGER, AT(lam_net_common, grid), .count = 2, .initial = "[16, 16]", .min = 1,
     .max = 2000,
     .doc = "Cells along the two families. Around a flat point: cells along the two sides of every sector, equal numbers."},
    {.name = "hole", .type = LAM_KEY_INTEGER, AT(lam_net_common, hole), .count = 1, .initial = "0", .min = 0, .max = 1000,
     .doc = "Rings of cells left out around a flat point: an oculus."},
    {.name = "subdivide", .type = LAM_KEY_INTEGER, AT(lam_net_common, subdivide), .count = 1, .initial = "0", .min = 0,
     .max = 6, .doc = "Interpolating subdivisions of the start (four-point rule along the polylines)."},
    {.name = "boundary", .type = LAM_KEY_CHOICE, AT(lam_net_common, boundary), .count = 1, .initial = "free",
     .choices = boundaries,
     .doc = "free; fixed: boundary vertices stay; glide: they slide along the boundary curve, corners stay."},
    {.name = "handles", .type = LAM_KEY_MAP, AT(lam_net_common, handles), .count = 0, .initial = "[]", .keys = handle_keys,
     .size = sizeof(lam_handle), .doc = "Vertices that have to be at given places."},
    {.name = "constraints", .type = LAM_KEY_ROW, AT(lam_net_common, constraints), .count = 0, .initial = "[]",
     .rows = &lam_constraints, .doc = "Further constraints beside the net's own."},
    {.name = "reference", .type = LAM_KEY_MAP, AT(lam_net_common, reference), .count = 1, .initial = "{}",
     .keys = reference_keys, .size = sizeof(lam_reference_keys), .given_offset = offsetof(lam_net_common, reference_given),
     .doc = "A surface that the net stays near."},
    {.name = "solver", .type = LAM_KEY_MAP, AT(lam_net_common, solver), .count = 1, .initial = "{}", .keys = solver_keys,
     .size = sizeof(lam_solver_keys), .doc = "How the net is solved."},
    {.name = "noise", .type = LAM_KEY_NUMBER, AT(lam_net_common, noise), .count = 1, .initial = "0", .min = 0, .max = 1,
     .doc = "Random displacement of the start, relative to the mean edge: for trying how robust a net is."},
    {.name = "seed", .type = LAM_KEY_INTEGER, AT(lam_net_common, seed), .count = 1, .initial = "1", .min = 0, .max = 1e9,
     .doc = "Of the noise: the same seed gives the same net."},
    {0}};
