/* What a skin promises, measured from its patches alone. Called by skin.c. Sides r1, r2, r3, r4
 * have the numbers 0 to 3 and lie at v = 0, u = 0, v = 1, u = 1. */
#include "fab/parts/skin.h"
#include "surf/spline/spline_surface.h"

/* Parameters that are sampled: along a side, and inside a patch in each direction. */
enum { SIDE_SAMPLES = 17, INNER_SAMPLES = 8 };

/* Point and unit normal at the parameter t of a side of a patch over the unit square. */
static void side_at(const lam_nurbs *nurbs, int number, double t, lam_vec3 *point,
                    lam_vec3 *normal) {
  lam_jet jet;
  lam_nurbs_eval(nurbs, number % 2 ? number / 2 : t, number % 2 ? t : number / 2, &jet);
  *point = jet.x;
  *normal = lam_unit(lam_cross(jet.u, jet.v));
}

/* The side of `to` that lies on side `number` of `from`, and whether it runs the other way; -1:
 * none. Their ends must agree to 1e-9 of the side's chord. */
static int side_of(const lam_skin_mesh *mesh, const lam_nurbs *const *nurbs, int from, int number,
                   int to, bool *reversed) {
  lam_vec3 a[2], b[2], normal;
  for (int e = 0; e < 2; e++) side_at(nurbs[from], number, e, &a[e], &normal);
  for (int k = 0; k < 4; k++) {
    if (mesh->neighbors[to][k] != from) continue;
    for (int e = 0; e < 2; e++) side_at(nurbs[to], k, e, &b[e], &normal);
    double same = lam_distance(a[0], b[0]) + lam_distance(a[1], b[1]);
    double crossed = lam_distance(a[0], b[1]) + lam_distance(a[1], b[0]);
    *reversed = crossed < same;
    if (fmin(same, crossed) <= 1e-9 * lam_distance(a[0], a[1])) return k;
  }
  return -1;
}

/* Distance and angle of the normals across every common side, once per pair of neighbors. */
static void measure_seams(const lam_skin_mesh *mesh, const lam_nurbs *const *nurbs,
                          lam_skin_facts *facts) {
  for (int c = 0; c < mesh->cell_count; c++)
    for (int s = 0; s < 4; s++) {
      bool reversed;
      int next = mesh->neighbors[c][s], other;
      if (next <= c || (other = side_of(mesh, nurbs, c, s, next, &reversed)) < 0) continue;

      facts->seams++;
      for (int g = 0; g < SIDE_SAMPLES; g++) {
        double t = (double)g / (SIDE_SAMPLES - 1);
        lam_vec3 p[2], n[2];
        side_at(nurbs[c], s, t, &p[0], &n[0]);
        side_at(nurbs[next], other, reversed ? 1 - t : t, &p[1], &n[1]);
        facts->gap = fmax(facts->gap, lam_distance(p[0], p[1]));
        double jump = lam_angle(n[0], n[1]);
        facts->jump = fmax(facts->jump, jump);
        facts->jump_sum += jump / SIDE_SAMPLES;
      }
    }
}

/* The unit tangent of a side at an end (0, 1), away from the corner there. */
static lam_vec3 leaving(const lam_nurbs *nurbs, int number, int end) {
  lam_jet jet;
  lam_nurbs_eval(nurbs, number % 2 ? number / 2 : end, number % 2 ? end : number / 2, &jet);
  return lam_scale(lam_unit(number % 2 ? jet.v : jet.u), end ? -1 : 1);
}

/* Where a side of a patch ends on another one with a neighbor beyond, that has a side which
 * continues it: the angle between them. crossing[side][end] is the side that is met at that end,
 * and the end of it that lies there. */
static void measure_kink(const lam_skin_mesh *mesh, const lam_nurbs *const *nurbs, int cell,
                         int side, int end, lam_skin_facts *facts) {
  static const struct {
    int side, end;
  } crossing[4][2] = {{{1, 0}, {3, 0}}, {{0, 0}, {2, 0}}, {{1, 1}, {3, 1}}, {{0, 1}, {2, 1}}};
  int cross = crossing[side][end].side, there = crossing[side][end].end,
      next = mesh->neighbors[cell][cross], other;
  bool reversed;
  if (next < 0 || (other = side_of(mesh, nurbs, cell, cross, next, &reversed)) < 0) return;

  if (reversed) there = 1 - there;
  lam_vec3 ahead = leaving(nurbs[next], crossing[other][there].side, crossing[other][there].end);
  lam_vec3 back = leaving(nurbs[cell], side, end);
  facts->kink = fmax(facts->kink, lam_angle(ahead, lam_scale(back, -1)));
  facts->joints++;
}

/* Normal curvature along the sides of a patch against the curvature of the surface: |k_n| /
 * sqrt(|K|). The corners are left out. */
static void measure_sides(const lam_nurbs *nurbs, lam_skin_facts *facts) {
  for (int s = 0; s < 4; s++) {
    double most = 0;
    for (int g = 1; g < SIDE_SAMPLES - 1; g++) {
      lam_jet jet;
      double t = (double)g / (SIDE_SAMPLES - 1);
      lam_nurbs_eval(nurbs, s % 2 ? s / 2 : t, s % 2 ? t : s / 2, &jet);
      lam_curvature at = lam_jet_curvature(&jet);
      double kn = s % 2 ? at.N / at.G : at.L / at.E, slant = fabs(kn) / sqrt(fabs(at.K));
      most = fmax(most, slant);
      facts->slant_sum += slant / (SIDE_SAMPLES - 2);
    }

    facts->slant = fmax(facts->slant, most);
    facts->sides++;
    facts->exact += most <= 1e-8;
  }
}

/* Gaussian curvature and the angle of the parameter lines at samples inside a patch. */
static void measure_inside(const lam_nurbs *nurbs, lam_skin_facts *facts) {
  for (int g = 0; g < INNER_SAMPLES * INNER_SAMPLES; g++) {
    lam_jet jet;
    lam_nurbs_eval(nurbs, (g / INNER_SAMPLES + 0.5) / INNER_SAMPLES,
                   (g % INNER_SAMPLES + 0.5) / INNER_SAMPLES, &jet);
    lam_curvature at = lam_jet_curvature(&jet);
    double sine = lam_length(lam_cross(jet.u, jet.v)) / (lam_length(jet.u) * lam_length(jet.v));

    facts->samples++;
    facts->domes += !(at.K < 0);
    facts->largest_k = fmax(facts->largest_k, at.K);
    facts->least_k = fmin(facts->least_k, at.K);
    facts->least_sine = fmin(facts->least_sine, sine);
  }
}

/* Sides, energy and curvature patch by patch; seams and joints when all patches are at hand. */
lam_skin_facts lam_skin_measure(lam_arena *arena, const lam_skin_mesh *mesh,
                                const lam_spline_surface *surfaces) {
  lam_skin_facts facts = {.largest_k = -INFINITY, .least_k = INFINITY, .least_sine = 1};
  const lam_nurbs **nurbs = LAM_NEW(arena, const lam_nurbs *, mesh->cell_count);
  for (int c = 0; c < mesh->cell_count; c++) {
    nurbs[c] = lam_nurbs_make(arena, &surfaces[c]);
    measure_sides(nurbs[c], &facts);
    double energy = lam_thin_plate_energy(arena, &surfaces[c], 10);
    facts.energy += energy;
    facts.largest_energy = fmax(facts.largest_energy, energy);
    measure_inside(nurbs[c], &facts);
  }

  measure_seams(mesh, nurbs, &facts);
  for (int k = 0; k < 8 * mesh->cell_count; k++)
    measure_kink(mesh, nurbs, k / 8, k / 2 % 4, k % 2, &facts);
  return facts;
}

/* The distance of a point from a curve near parameter t: three steps of Newton's method without
 * the second derivative towards the foot of the perpendicular. */
static double distance_from(const lam_quad_curve *curve, double t, lam_vec3 point) {
  lam_vec3 jet[4];
  for (int step = 0; step < 3; step++) {
    lam_quad_curve_eval(curve, t, jet);
    t += lam_dot(lam_sub(point, jet[0]), jet[1]) / lam_dot(jet[1], jet[1]);
  }
  lam_quad_curve_eval(curve, t, jet);
  return lam_distance(point, jet[0]);
}

/* Vertex k of `every` on a side is compared with the curve from the parameter k/every on. */
double lam_skin_distance(const lam_net *net, const lam_skin_net *cells,
                         const lam_asymptotic_patch *patches) {
  double most = 0;
  for (int c = 0; c < cells->cell_count; c++)
    for (int s = 0; s < 4 && patches[c].surface.points; s++)
      for (int k = 1; k < cells->every; k++) {
        int back, v = lam_skin_walk(net, cells->sides[c][s][0], cells->sides[c][s][1], k, &back);
        double t = (double)k / cells->every;
        most = fmax(most, distance_from(&patches[c].boundary.curve[s], t, net->mesh.vertices[v]));
      }
  return most;
}
