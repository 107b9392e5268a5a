/* Asymptotic curves from conormals. Along an asymptotic curve of torsion tau the vector nu = N / sqrt|tau| satisfies
 *   r' = s nu x nu',  s = sign(tau)
 * (Lelieuvre's formula for one curve; N the normal of the surface). The other way round, every nu(t) gives a curve with
 * r'.nu = r''.nu = 0: its osculating planes are perpendicular to nu, and they stay so where the curve is straight or
 * bends the other way, where r' x r'' says nothing. With nu of degree 4, the curve has degree 7:
 *   r' = s sum_(i<j) C(4,i) C(4,j) (j-i) / C(6,i+j-1)  c_i x c_j  B_(i+j-1)^6.
 * At an end nu = N / sqrt|tau| and nu' = a nu + s r' x N sqrt|tau| with any a. Unknown are a at both ends and the
 * middle point c_2: five numbers for the chord (3) and the curvatures at both ends, r''.across = k |r'|^2.
 *
 * An edge that is nearly straight lets its osculating planes turn hardly more than by one rule, and data that are not
 * quite those of an asymptotic curve give none. It becomes the quintic with these ends, with tangent planes spanned by
 * r' and a cubic W between the other tangents of its ends; W' there is such that the planes turn by the given torsions,
 * W'.N = tau |r'| W.across. Such an edge is asymptotic at its ends and nearly so between.
 *
 * The tangents across the edge are T = sum z_k F_k with z of degree 5 and the fields F = nu x e_1, e_2, e_3, or r' and
 * W, so that both patches along it share their tangent planes. With conormals z = q nu gives nothing: q, of degree 1,
 * is kept at 0. */
#include "surf/asymptotic_conormal.h"
#include "core/dense.h"
#include "curve/collocation.h"

enum { DEGREE = LAM_SKIN_DEGREE, CROSS = LAM_CONORMAL_SURFACE - LAM_CONORMAL_DEGREE, UNKNOWNS = 5, STEPS = 30 };

static const double choose4[] = {1, 4, 6, 4, 1}, choose6[] = {1, 6, 15, 20, 15, 6, 1},
                    choose7[] = {1, 7, 21, 35, 35, 21, 7, 1};
static const double strays = 1e-3; /* of its length, from the quintic */

/* The coefficients of r' for conormals c. */
static void derivative_of(const lam_vec3 *c, double sign, lam_vec3 q[DEGREE]) {
  for (int k = 0; k < DEGREE; k++) q[k] = lam_v3(0, 0, 0);
  for (int i = 0; i < 5; i++)
    for (int j = i + 1; j < 5; j++) {
      int k = i + j - 1;
      q[k] = lam_along(q[k], sign * choose4[i] * choose4[j] * (j - i) / choose6[k], lam_cross(c[i], c[j]));
    }
}

typedef struct ends {
  const lam_skin_vertex *vertex[2];
  lam_vec3 normal[2], across[2];
  double sign, length;
} ends;

/* The conormals for the unknowns x: a at both ends and the middle point in units of scale. */
static void set_conormals(const ends *e, const double *x, lam_vec3 c[5]) {
  for (int i = 0; i < 2; i++) {
    double root = sqrt(fabs(e->vertex[i]->torsion)), way = i ? -0.25 : 0.25;
    lam_vec3 at = lam_scale(e->normal[i], 1 / root), slope = lam_scale(at, x[i]);
    slope = lam_along(slope, e->sign * root, lam_cross(e->vertex[i]->tangent[0], e->normal[i]));
    c[4 * i] = at;
    c[i ? 3 : 1] = lam_along(at, way, slope);
  }
  c[2] = lam_v3(x[2], x[3], x[4]);
}

/* What is to vanish: the error of the chord and of the curvatures, as lengths. */
static void errors_of(const ends *e, const double *x, double error[UNKNOWNS]) {
  lam_vec3 c[5], q[DEGREE], chord = lam_sub(e->vertex[0]->point, e->vertex[1]->point);
  set_conormals(e, x, c);
  derivative_of(c, e->sign, q);
  for (int k = 0; k < DEGREE; k++) chord = lam_along(chord, 1.0 / DEGREE, q[k]);
  error[0] = chord.x;
  error[1] = chord.y;
  error[2] = chord.z;
  for (int i = 0; i < 2; i++) {
    lam_vec3 second = lam_scale(lam_sub(i ? q[6] : q[1], i ? q[5] : q[0]), DEGREE - 1);
    lam_vec3 t = e->vertex[i]->tangent[0];
    error[3 + i] = (lam_dot(second, e->across[i]) - e->vertex[i]->curvature[0] * lam_dot(t, t)) / 6;
  }
}

/* Newton's method; the errors are quadratic, so that central differences are exact. */
static bool solve(const ends *e, double scale, double x[UNKNOWNS]) {
  double size = INFINITY;
  for (int step = 0; step < STEPS; step++) {
    double error[UNKNOWNS], jacobian[UNKNOWNS * UNKNOWNS], side[2][UNKNOWNS];
    int pivot[UNKNOWNS];
    errors_of(e, x, error);
    double before = size;
    size = 0;
    for (int i = 0; i < UNKNOWNS; i++) size = fmax(size, fabs(error[i]) / e->length);
    if (size <= 1e-15 || (size <= 1e-12 && size >= before)) return true;
    if (!isfinite(size)) return false;
    for (int k = 0; k < UNKNOWNS; k++) {
      double h = k < 2 ? 1e-3 : 1e-3 * scale, kept = x[k];
      for (int s = 0; s < 2; s++) {
        x[k] = kept + (s ? h : -h);
        errors_of(e, x, side[s]);
      }
      x[k] = kept;
      for (int i = 0; i < UNKNOWNS; i++) jacobian[i * UNKNOWNS + k] = (side[1][i] - side[0][i]) / (2 * h);
    }
    if (!lam_lu_factor(UNKNOWNS, jacobian, pivot)) return false;
    lam_lu_solve(UNKNOWNS, jacobian, pivot, error);
    for (int i = 0; i < UNKNOWNS; i++) x[i] -= error[i];
  }
  return size <= 1e-12;
}

/* nu x e_k for the axes e_k, and the curve. */
static bool make_exact(const ends *e, lam_conormal_edge *edge) {
  lam_vec3 c[5], q[DEGREE];
  double a = 0.5 * log(e->vertex[0]->torsion / e->vertex[1]->torsion), x[UNKNOWNS] = {a, a};
  set_conormals(e, x, c);
  for (int d = 0; d < 3; d++) { /* as the cubic with the same ends, of degree 4 */
    const double *p = &c[0].x + d;
    x[2 + d] = (4 * (p[3] + p[9]) - p[0] - p[12]) / 6;
  }
  if (!solve(e, lam_length(c[0]), x)) return false;
  set_conormals(e, x, c);
  derivative_of(c, e->sign, q);
  for (int k = 0; k < 3; k++) {
    edge->points[k + 1] = lam_along(edge->points[k], 1.0 / DEGREE, q[k]);
    edge->points[DEGREE - 1 - k] = lam_along(edge->points[DEGREE - k], -1.0 / DEGREE, q[6 - k]);
    for (int i = 0; i < 5; i++) edge->field[k][i] = lam_cross(c[i], lam_v3(k == 0, k == 1, k == 2));
  }
  edge->field_count = 3;
  return true;
}

/* r' and W, and the quintic. */
static void make_near(const ends *e, lam_conormal_edge *edge) {
  lam_vec3 r[LAM_SKIN_POINTS], w[5], turn = lam_sub(e->vertex[1]->tangent[1], e->vertex[0]->tangent[1]);
  double speed[2] = {lam_length(e->vertex[0]->tangent[0]), lam_length(e->vertex[1]->tangent[0])};
  double faster = (speed[1] * speed[1] - speed[0] * speed[0]) / 2; /* r'.r'' */
  for (int i = 0; i < 2; i++) {
    const lam_skin_vertex *v = e->vertex[i];
    lam_vec3 n = e->normal[i], t = v->tangent[0], other = v->tangent[1];
    lam_vec3 second = lam_scale(e->across[i], v->curvature[0] * speed[i] * speed[i]);
    second = lam_along(second, faster / (speed[i] * speed[i]), t);
    int at = i ? 5 : 0, step = i ? -1 : 1;
    r[at] = v->point;
    r[at + step] = lam_along(v->point, step / 5.0, t);
    r[at + 2 * step] = lam_along(lam_sub(lam_scale(r[at + step], 2), r[at]), 1.0 / 20, second);
    lam_vec3 slope = lam_along(turn, -lam_dot(turn, n), n);
    slope = lam_along(slope, v->torsion * speed[i] * lam_dot(other, e->across[i]), n);
    w[i ? 3 : 0] = other;
    w[i ? 2 : 1] = lam_along(other, step / 3.0, slope);
  }
  for (int k = 0; k < 5; k++) edge->field[0][k] = lam_scale(lam_sub(r[k + 1], r[k]), 5);
  lam_bezier_elevate(5, DEGREE, 3, &r[0].x);
  lam_bezier_elevate(3, 4, 3, &w[0].x);
  for (int k = 1; k < DEGREE; k++) edge->points[k] = r[k];
  for (int k = 0; k < 5; k++) edge->field[1][k] = w[k];
  edge->field_count = 2;
}

lam_conormal_edge lam_conormal_edge_make(const lam_skin_vertex *from, const lam_skin_vertex *to) {
  lam_conormal_edge edge = {.points = {from->point}};
  ends e = {.vertex = {from, to}, .sign = from->torsion < 0 ? -1 : 1, .length = lam_distance(from->point, to->point)};
  edge.points[DEGREE] = to->point;
  for (int i = 0; i < 2; i++) {
    const lam_vec3 *t = e.vertex[i]->tangent;
    double area = lam_length(lam_cross(t[0], t[1]));
    if (!(area > 1e-6 * lam_length(t[0]) * lam_length(t[1]))) edge.trouble = "the lines at a vertex are parallel";
    e.normal[i] = lam_unit(lam_cross(t[0], t[1]));
    e.across[i] = lam_unit(lam_cross(e.normal[i], t[0]));
  }
  lam_conormal_edge exact = edge;
  make_near(&e, &edge);
  if (!(from->torsion * to->torsion > 0) || !make_exact(&e, &exact)) return edge;
  lam_vec3 off = {0, 0, 0}; /* in the middle; a curve that strays from the calm one winds about it */
  for (int k = 0; k <= DEGREE; k++) off = lam_along(off, choose7[k] / 128, lam_sub(exact.points[k], edge.points[k]));
  return lam_length(off) < strays * e.length ? exact : edge;
}

/* ---- the patch ---- */

enum { EACH = 3 * (CROSS + 1), COUNT = 4 * EACH, ROWS = 36 + 8 };

/* Bernstein polynomials of a degree with first derivatives. */
static void bernstein(int degree, double t, double *value, double *slope) {
  value[0] = 1;
  for (int n = 1; n <= degree; n++) {
    if (n == degree)
      for (int i = 0; i <= n; i++) slope[i] = n * ((i ? value[i - 1] : 0) - (i < n ? value[i] : 0));
    value[n] = 0;
    for (int i = n; i >= 0; i--) value[i] = (1 - t) * value[i] + (i ? t * value[i - 1] : 0);
  }
}

/* What coefficient k of z adds to T and T' of its curve at t. */
static void shape_eval(const lam_conormal_edge *edges, int k, double t, lam_vec3 *value, lam_vec3 *slope) {
  const lam_vec3 *c = edges[k / EACH].field[k % 3];
  int index = k % EACH / 3;
  double own[2][CROSS + 1], of_field[2][LAM_CONORMAL_POINTS];
  bernstein(CROSS, t, own[0], own[1]);
  bernstein(LAM_CONORMAL_DEGREE, t, of_field[0], of_field[1]);
  lam_vec3 field = {0, 0, 0}, change = {0, 0, 0};
  for (int i = 0; i < LAM_CONORMAL_POINTS; i++) {
    field = lam_along(field, of_field[0][i], c[i]);
    change = lam_along(change, of_field[1][i], c[i]);
  }
  *value = lam_scale(field, own[0][index]);
  *slope = lam_along(lam_scale(change, own[0][index]), own[1][index], field);
}

/* T at the ends of every curve, equal T' where curves meet, no part along nu in z: rows z = right. */
static void list_conditions(const lam_quad_boundary *b, const lam_conormal_edge *edges, double *rows, double *right) {
  for (int corner = 0; corner < 4; corner++) {
    lam_vec3 jet[2][4];
    double size = 0;
    for (int k = 0; k < 2; k++) {
      lam_quad_end end = lam_quad_meeting[corner][k];
      lam_quad_curve_eval(&b->curve[end.curve], end.end, jet[k]);
      size = fmax(size, lam_length(jet[k][1]));
    }
    for (int side = 0; side < 2; side++) {
      lam_quad_end end = lam_quad_meeting[corner][side];
      for (int k = end.curve * EACH; k < (end.curve + 1) * EACH; k++) {
        lam_vec3 value, slope;
        shape_eval(edges, k, end.end, &value, &slope);
        for (int c = 0; c < 3; c++) {
          rows[(9 * corner + 3 * side + c) * COUNT + k] = (&value.x)[c] / size;
          rows[(9 * corner + 6 + c) * COUNT + k] = (side ? -1 : 1) * (&slope.x)[c] / size;
        }
      }
      for (int c = 0; c < 3; c++) right[9 * corner + 3 * side + c] = (&jet[1 - side][1].x)[c] / size;
    }
  }
  for (int i = 0; i < 4; i++) {
    if (edges[i].field_count < 3) continue;
    double size = 0;
    for (int k = 0; k < 3; k++) size += lam_length(edges[i].field[k][0]);
    for (int q = 0; q < 2; q++)
      for (int j = 0; j < LAM_CONORMAL_POINTS; j++) {
        const lam_vec3 nu = {edges[i].field[1][j].z, edges[i].field[2][j].x, edges[i].field[0][j].y};
        for (int c = 0; c < 3; c++)
          rows[(36 + 2 * i + q) * COUNT + i * EACH + 3 * (j + q) + c] =
              (q ? j + 1.0 : CROSS - j) / CROSS * (&nu.x)[c] / size;
      }
  }
}

/* T stays on one side of its curve, or the surface folds over: r' x T keeps near its own direction from place to place.
 */
static bool folds(const lam_quad_boundary *b, const lam_conormal_edge *edges, int curve, const double *z) {
  enum { PLACES = 32 };
  lam_vec3 last = {0, 0, 0};
  for (int g = 0; g <= PLACES; g++) {
    lam_vec3 jet[4], tangent = {0, 0, 0}, value, slope;
    double t = (double)g / PLACES;
    for (int k = curve * EACH; k < (curve + 1) * EACH; k++) {
      shape_eval(edges, k, t, &value, &slope);
      tangent = lam_along(tangent, z[k], value);
    }
    lam_quad_curve_eval(&b->curve[curve], t, jet);
    lam_vec3 normal = lam_cross(jet[1], tangent);
    if (g && !(lam_dot(normal, last) > 0)) return true;
    last = normal;
  }
  return false;
}

bool lam_conormal_patch_make(lam_arena *arena, const lam_conormal_edge edges[4], lam_place place, lam_errors *errors,
                             lam_asymptotic_patch *patch) {
  static const lam_quad_recipe recipe = {.degree = DEGREE, .surface = LAM_CONORMAL_SURFACE};
  const lam_quad_boundary *b = &patch->boundary;
  lam_quad_spaces spaces;
  lam_thin_plate plate;
  for (int i = 0; i < 4; i++)
    if (edges[i].trouble) {
      lam_error_add(errors, place, "kind", "%s", edges[i].trouble);
      return false;
    }
  lam_quad_spaces_make(arena, b, &recipe, &spaces);
  if (!lam_quad_plate(arena, &spaces, &plate)) return false;
  int total = plate.count[0] * plate.count[1];
  lam_vec3 *net = lam_quad_rings(arena, &spaces), *part[COUNT];
  lam_quad_net_fill(arena, &plate, net);
  const lam_vec3 *pull = lam_quad_net_gradient(arena, &plate, net);
  double *h = LAM_NEW(arena, double, COUNT *COUNT), g[COUNT] = {0}, z[COUNT];
  for (int k = 0; k < COUNT; k++) {
    const lam_collocation *space = &spaces.space[k / EACH % 2];
    lam_vec3 *values = LAM_NEW(arena, lam_vec3, space->count), slope;
    for (int j = 0; j < space->count; j++) shape_eval(edges, k, space->places[j], &values[j], &slope);
    lam_collocation_solve(arena, space, 3, &values[0].x);
    part[k] = LAM_NEW(arena, lam_vec3, total);
    h[k * COUNT + k] = 1; /* of a field that is not there */
    if (k % 3 >= edges[k / EACH].field_count) continue;
    lam_quad_ring_add(&spaces, k / EACH, values, part[k]);
    lam_quad_net_fill(arena, &plate, part[k]);
    const lam_vec3 *gradient = lam_quad_net_gradient(arena, &plate, part[k]);
    g[k] = lam_quad_net_product(total, part[k], pull);
    for (int l = 0; l <= k; l++) h[k * COUNT + l] = h[l * COUNT + k] = lam_quad_net_product(total, part[l], gradient);
  }
  double *rows = LAM_NEW(arena, double, ROWS *COUNT), right[ROWS] = {0};
  list_conditions(b, edges, rows, right);
  if (lam_least_energy(arena, COUNT, h, g, ROWS, rows, right, 1e-9, z) != LAM_LEAST_FOUND) {
    lam_error_add(errors, place, "kind", "no tangents of least energy across the edges of a cell");
    return false;
  }
  for (int k = 0; k < COUNT; k++)
    for (int i = 0; i < total; i++) net[i] = lam_along(net[i], z[k], part[k][i]);
  patch->energy = lam_quad_net_product(total, net, lam_quad_net_gradient(arena, &plate, net));
  lam_quad_patch_finish(&spaces, net, &patch->surface);
  for (int i = 0; i < 4; i++)
    if (folds(b, edges, i, z)) {
      lam_error_add(errors, place, "kind", "the surface of least energy folds over along an edge of a cell");
      return false;
    }
  return true;
}
