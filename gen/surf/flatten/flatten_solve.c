/* Laying flat in three stages. Called by texture.c, surf/developable, fab/parts/flat_pattern.c
 * and net/measures/distortion_measures.c.
 *
 * First, unfolding triangle after triangle tells how each is turned (unfold.c). Then, as rigid
 * as possible: every triangle with gradient J of the map from its own plane asks for its
 * rotation R, sum of area |J - R|^2; points and nearest rotations are improved in turn. At last
 * Gauss-Newton on sum (l - L)^2, damped:
 *   r = |x_b - x_a| - L,  dr = (x_b - x_a)/l on b, the opposite on a.
 * One point is held; turning costs nothing, which the damping takes care of. */
#include "surf/flatten/flatten_parts.h"
#include <string.h>

/* Rounds of local rotations; steps of Gauss-Newton at most. */
enum { ROTATIONS = 20, MOST_STEPS = 200 };

/* r = sqrt(area) ([x1 - x0, x2 - x0] B - R), by rows.
 *
 * x  three points
 * p  sqrt(area), B (2 x 2, by rows: inverse of the edges at rest, as columns), cosine, sine of R
 */
static void rotation_kernel(int n, const double *x, const double *p, double *r, double *J) {
  const double R[2][2] = {{p[5], -p[6]}, {p[6], p[5]}};
  (void)n;

  for (int i = 0; i < 2; i++)
    for (int k = 0; k < 2; k++) {
      double b1 = p[1 + k], b2 = p[3 + k];
      r[2 * i + k] = p[0] * ((x[2 + i] - x[i]) * b1 + (x[4 + i] - x[i]) * b2 - R[i][k]);
      if (!J) continue;
      double *row = J + 6 * (2 * i + k);
      for (int c = 0; c < 6; c++) row[c] = 0;
      row[i] = -p[0] * (b1 + b2);
      row[2 + i] = p[0] * b1;
      row[4 + i] = p[0] * b2;
    }
}

/* r = |x1 - x0| - L, p: L. Where the points coincide, the edge is taken to lie along x. */
static void length_kernel(int n, const double *x, const double *p, double *r, double *J) {
  double dx = x[2] - x[0], dy = x[3] - x[1], l = hypot(dx, dy);
  (void)n;
  r[0] = l - p[0];
  if (!J) return;

  J[2] = l > 0 ? dx / l : 1;
  J[3] = l > 0 ? dy / l : 0;
  J[0] = -J[2];
  J[1] = -J[3];
}

/* The shape of a triangle at rest, p[0..4] of rotation_kernel, from its side lengths; false: it
 * has no area. */
static bool rest(const lam_vec3 *x, const int t[3], double *p) {
  lam_vec3 a = lam_sub(x[t[1]], x[t[0]]), b = lam_sub(x[t[2]], x[t[0]]);
  double base = lam_length(a), along = lam_dot(a, b) / base,
         height = lam_length(lam_cross(a, b)) / base;
  p[0] = sqrt(base * height / 2);

  /* edges (base, 0), (along, height): inverse [[1/base, -along/(base height)], [0, 1/height]] */
  p[1] = 1 / base;
  p[2] = -along / (base * height);
  p[3] = 0;
  p[4] = 1 / height;
  return base > 0 && height > 0;
}

/* The rotation nearest to J: the angle of (J11 + J22, J21 - J12). Fills p[5], p[6]. */
static void rotate(const double *x, const int t[3], double *p) {
  double J[2][2];
  for (int i = 0; i < 2; i++)
    for (int k = 0; k < 2; k++)
      J[i][k] = (x[2 * t[1] + i] - x[2 * t[0] + i]) * p[1 + k] +
                (x[2 * t[2] + i] - x[2 * t[0] + i]) * p[3 + k];

  double c = J[0][0] + J[1][1], s = J[1][0] - J[0][1], l = hypot(c, s);
  p[5] = l > 0 ? c / l : 1;
  p[6] = l > 0 ? s / l : 0;
}

/* The triangles with an area, as a block: nodes and parameters of rotation_kernel. angles: of the
 * first rotations; NULL: they are still to be found. */
static lam_block rigid_triangles(lam_arena *arena, const lam_flat_mesh *mesh,
                                 const double *angles) {
  double(*params)[7] = lam_arena_alloc(arena, (size_t)mesh->triangle_count, sizeof *params);
  int(*nodes)[3] = lam_arena_alloc(arena, (size_t)mesh->triangle_count, sizeof *nodes), count = 0;
  for (int t = 0; t < mesh->triangle_count; t++) {
    if (!rest(mesh->vertices, mesh->triangles[t], params[count])) continue;
    if (angles) params[count][5] = cos(angles[t]), params[count][6] = sin(angles[t]);
    memcpy(nodes[count++], mesh->triangles[t], sizeof *nodes);
  }

  return (lam_block){.name = "rotation",
                     .kernel = rotation_kernel,
                     .rows = 4,
                     .role = LAM_HARD,
                     .weight = 1,
                     .count = count,
                     .arity = 3,
                     .nodes = nodes[0],
                     .param_count = 7,
                     .params = params[0]};
}

/* As rigid as possible: points and nearest rotations are improved in turn. The matrix never
 * changes, so it is factored once. angles: of the first rotations; NULL: from the points. */
static void make_rigid(lam_arena *arena, const lam_flat_mesh *mesh, const double *angles,
                       lam_vec2 *points) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_problem *problem = lam_flat_problem(arena, mesh->vertex_count, points);
  lam_block block = rigid_triangles(arena, mesh, angles);
  lam_problem_add(problem, block);
  problem->fixed[0] = true;

  lam_flat_system s = lam_flat_system_make(arena, problem);
  for (int k = 0; s.size && k < ROTATIONS; k++) {
    for (int t = 0; (k || !angles) && t < block.count; t++)
      rotate(problem->x, block.nodes + 3 * t, block.params + 7 * t);
    lam_flat_system_assemble(&s);
    if (k)
      lam_flat_system_again(&s);
    else if (!lam_flat_system_step(&s, 0))
      break;
    lam_flat_system_move(&s, 1);
  }

  lam_flat_positions(problem, points);
  lam_arena_release(arena, mark);
}

/* The problem of edges with their wanted lengths, one point held. */
static lam_problem *length_problem(lam_arena *arena, const lam_flat_mesh *mesh,
                                   const lam_vec2 *points) {
  lam_problem *problem = lam_flat_problem(arena, mesh->vertex_count, points);
  double *lengths = LAM_NEW(arena, double, mesh->edge_count);
  memcpy(lengths, mesh->lengths, (size_t)mesh->edge_count * sizeof *lengths);

  lam_problem_add(problem, (lam_block){.name = "length",
                                       .kernel = length_kernel,
                                       .rows = 1,
                                       .role = LAM_HARD,
                                       .weight = 1,
                                       .count = mesh->edge_count,
                                       .arity = 2,
                                       .nodes = mesh->edges[0],
                                       .param_count = 1,
                                       .params = lengths});

  problem->fixed[0] = true;
  return problem;
}

/* Gauss-Newton with damping that is raised tenfold when a step fails and lowered when it
 * succeeds. floor: the energy below which rounding of coordinates hides all progress, m^2.
 * Counts the steps that were taken and says whether it has converged. */
static void descend(lam_flat_system *s, double floor, lam_flattening *result) {
  lam_problem *problem = s->problem;
  double damping = 1e-6;
  for (int tries = 0; s->size && !result->converged && tries < 2 * MOST_STEPS; tries++) {
    double now = lam_flat_system_assemble(s);
    if (!lam_flat_system_step(s, damping)) {
      damping *= 10;
      continue;
    }

    /* What the linear model promises: nothing more to gain. */
    double expected = 0;
    for (int i = 0; i < s->size; i++) expected -= s->step[i] * s->gradient[i];
    if (expected <= 1e-13 * now + floor) {
      result->converged = true;
      break;
    }

    lam_flat_system_move(s, 1);
    if (lam_flat_system_sum(s) < now) {
      damping = fmax(1e-12, damping / 10);
      result->iterations++;
      continue;
    }

    /* The step is taken back; when it promised little, nothing but rounding keeps the energy from
     * falling. */
    memcpy(problem->x, s->kept, (size_t)problem->offset[problem->node_count] * sizeof *s->kept);
    result->converged = expected <= 1e-9 * now;
    damping *= 10;
  }
}

/* The least energy near the points, which are moved. */
static void equalize(lam_arena *arena, const lam_flat_mesh *mesh, lam_vec2 *points,
                     lam_flattening *result) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_problem *problem = length_problem(arena, mesh, points);
  double extent = 0;
  for (int v = 0; v < mesh->vertex_count; v++)
    extent = fmax(extent, hypot(points[v].x - points[0].x, points[v].y - points[0].y));

  lam_flat_system s = lam_flat_system_make(arena, problem);
  descend(&s, mesh->edge_count * pow(2e-16 * extent, 2), result);

  lam_flat_positions(problem, points);
  lam_arena_release(arena, mark);
}

/* The unfolded mesh, made rigid; where that turns triangles over or strains the sheet, the
 * start of the mesh, made rigid, if that is better. */
static void begin(lam_arena *arena, const lam_flat_mesh *mesh, lam_vec2 *points) {
  lam_flattening unfolded = {.points = points}, other = {0};
  lam_arena_mark mark = lam_arena_mark_get(arena);
  double *angles = LAM_NEW(arena, double, mesh->triangle_count);
  size_t size = (size_t)mesh->vertex_count * sizeof *points;
  memcpy(points, mesh->start, size);

  lam_flat_unfold(arena, mesh, angles);
  make_rigid(arena, mesh, angles, points);
  lam_flat_measure(mesh, &unfolded);

  if (unfolded.flips || unfolded.rms_strain > 1e-3) {
    lam_vec2 *started = LAM_NEW(arena, lam_vec2, mesh->vertex_count);
    memcpy(started, mesh->start, size);
    make_rigid(arena, mesh, NULL, started);
    other.points = started;
    lam_flat_measure(mesh, &other);

    if (other.flips < unfolded.flips ||
        (other.flips == unfolded.flips && other.energy < unfolded.energy))
      memcpy(points, started, size);
  }
  lam_arena_release(arena, mark);
}

/* The measures are computed from the final points, not taken from the solver. */
lam_flattening lam_flatten(lam_arena *arena, const lam_flat_mesh *mesh) {
  lam_vec2 *points = LAM_NEW(arena, lam_vec2, mesh->vertex_count);
  lam_flattening result = {.points = points};
  begin(arena, mesh, points);
  equalize(arena, mesh, points, &result);
  lam_flat_measure(mesh, &result);
  return result;
}
