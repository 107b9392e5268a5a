#include "net/measure.h"
#include "core/mesh.h"

#include <assert.h>
#include <math.h>
#include <string.h>

static const double degrees = 180 / 3.14159265358979323846;

/* A value that is not a number stays the largest. */
static void note(lam_measure *out, double value) {
  if (out->count == 0 || (!(value <= out->max) && !isnan(out->max))) out->max = value;
  out->mean += value;
  out->count++;
}

static void finish(lam_measure *out) {
  if (out->count) out->mean /= (double)out->count;
}

/* Eigenvalues (ascending) and eigenvectors (columns) of a symmetric 3 x 3 matrix by Jacobi rotations. */
static void eigen(double a[3][3], double value[3], double vector[3][3]) {
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) vector[i][j] = i == j;
  for (int sweep = 0; sweep < 60; sweep++) {
    for (int p = 0; p < 2; p++)
      for (int q = p + 1; q < 3; q++) {
        if (a[p][q] == 0) continue;
        double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
        double t = copysign(1, theta) / (fabs(theta) + sqrt(theta * theta + 1));
        double c = 1 / sqrt(t * t + 1), s = t * c;
        for (int k = 0; k < 3; k++) {
          double x = a[k][p], y = a[k][q];
          a[k][p] = c * x - s * y, a[k][q] = s * x + c * y;
        }
        for (int k = 0; k < 3; k++) {
          double x = a[p][k], y = a[q][k];
          a[p][k] = c * x - s * y, a[q][k] = s * x + c * y;
          x = vector[k][p], y = vector[k][q];
          vector[k][p] = c * x - s * y, vector[k][q] = s * x + c * y;
        }
      }
    if (fabs(a[0][1]) + fabs(a[0][2]) + fabs(a[1][2]) < 1e-300) break;
  }
  for (int i = 0; i < 3; i++) value[i] = a[i][i];
}

/* Whether a vertex is the center of a star or a neighbor of one. */
static bool in_a_star(const lam_net *net, int v) {
  bool is = !net->boundary[v];
  for (int i = net->ring_start[v]; i < net->ring_start[v + 1]; i++) is |= !net->boundary[net->ring[i]];
  return is;
}

/* The plane of best fit: its unit normal and the standard deviations across and along it (ascending). With a net,
 * points are its vertices, and only those of stars count. */
static lam_vec3 fit_plane(const lam_vec3 *points, int count, const lam_net *net, lam_vec3 *center, double spread[3]) {
  lam_vec3 c = {0, 0, 0};
  int used = 0;
  for (int i = 0; i < count; i++)
    if (!net || in_a_star(net, i)) {
      c = lam_add(c, points[i]);
      used++;
    }
  c = lam_scale(c, 1.0 / used);
  double a[3][3] = {{0}}, value[3], vector[3][3];
  for (int i = 0; i < count; i++) {
    if (net && !in_a_star(net, i)) continue;
    lam_vec3 d = lam_sub(points[i], c);
    double x[3] = {d.x, d.y, d.z};
    for (int k = 0; k < 3; k++)
      for (int l = 0; l < 3; l++) a[k][l] += x[k] * x[l] / used;
  }
  eigen(a, value, vector);
  int order[3] = {0, 1, 2};
  for (int i = 0; i < 2; i++)
    for (int j = 0; j < 2 - i; j++)
      if (value[order[j]] > value[order[j + 1]]) {
        int swap = order[j];
        order[j] = order[j + 1];
        order[j + 1] = swap;
      }
  for (int i = 0; i < 3; i++) spread[i] = sqrt(fmax(value[order[i]], 0));
  *center = c;
  return lam_v3(vector[0][order[0]], vector[1][order[0]], vector[2][order[0]]);
}

/* Largest distance to the plane of best fit, relative to the mean edge around. */
enum { most_points = 64 };

static void star_planarity(const lam_measuring *in, lam_measure *out) {
  const lam_net *net = in->net;
  for (int v = 0; v < net->mesh.vertex_count; v++) {
    int valence = net->ring_start[v + 1] - net->ring_start[v];
    if (net->boundary[v] || valence >= most_points) continue;
    lam_vec3 points[most_points], center;
    double spread[3], edge = 0, worst = 0;
    points[0] = in->positions[v];
    for (int k = 0; k < valence; k++) {
      points[k + 1] = in->positions[net->ring[net->ring_start[v] + k]];
      edge += lam_distance(points[0], points[k + 1]) / valence;
    }
    lam_vec3 normal = fit_plane(points, valence + 1, NULL, &center, spread);
    for (int k = 0; k <= valence; k++) worst = fmax(worst, fabs(lam_dot(normal, lam_sub(points[k], center))));
    note(out, worst / edge);
  }
  finish(out);
}

/* Distance of the diagonals over their mean length. */
static void face_planarity(const lam_measuring *in, lam_measure *out) {
  const lam_mesh *mesh = &in->net->mesh;
  for (int f = 0; f < mesh->face_count; f++) {
    const int *c = mesh->faces[f];
    const lam_vec3 *x = in->positions;
    lam_vec3 d1 = lam_sub(x[c[2]], x[c[0]]), d2 = lam_sub(x[c[3]], x[c[1]]);
    lam_vec3 n = lam_unit(lam_cross(d1, d2));
    note(out, fabs(lam_dot(n, lam_sub(x[c[1]], x[c[0]]))) / ((lam_length(d1) + lam_length(d2)) / 2));
  }
  finish(out);
}

static double star_angle(const lam_measuring *in, const lam_star *star) {
  lam_vec3 e[4];
  for (int k = 0; k < 4; k++) e[k] = lam_unit(lam_sub(in->positions[star->neighbor[k]], in->positions[star->center]));
  return lam_angle(lam_sub(e[0], e[2]), lam_sub(e[1], e[3]));
}

static void angle_deviation(const lam_measuring *in, lam_measure *out) {
  for (int s = 0; s < in->net->star_count; s++)
    note(out, fabs(star_angle(in, &in->net->stars[s]) - in->target_angle) * degrees);
  finish(out);
}

static void crossing_angle(const lam_measuring *in, lam_measure *out) {
  for (int s = 0; s < in->net->star_count; s++) note(out, star_angle(in, &in->net->stars[s]) * degrees);
  finish(out);
}

static void edge_length(const lam_measuring *in, lam_measure *out) {
  for (int e = 0; e < in->net->edge_count; e++)
    note(out, lam_distance(in->positions[in->net->edges[e].vertex[0]], in->positions[in->net->edges[e].vertex[1]]));
  finish(out);
}

static void shortest_edge(const lam_measuring *in, lam_measure *out) {
  double least = INFINITY;
  for (int e = 0; e < in->net->edge_count; e++) {
    const int *v = in->net->edges[e].vertex;
    least = fmin(least, lam_distance(in->positions[v[0]], in->positions[v[1]]));
  }
  note(out, in->mean_edge > 0 ? least / in->mean_edge : 0);
}

/* Angle between the edge that arrives at a star and the one that leaves it, along both families. */
static void turning_angle(const lam_measuring *in, lam_measure *out) {
  for (int s = 0; s < in->net->star_count; s++) {
    const lam_star *star = &in->net->stars[s];
    lam_vec3 c = in->positions[star->center];
    for (int k = 0; k < 2; k++)
      note(out,
           lam_angle(lam_sub(in->positions[star->neighbor[k]], c), lam_sub(c, in->positions[star->neighbor[k + 2]])) *
               degrees);
  }
  finish(out);
}

static lam_vec3 face_normal(const lam_measuring *in, int f) {
  const int *c = in->net->mesh.faces[f];
  return lam_unit(
      lam_cross(lam_sub(in->positions[c[2]], in->positions[c[0]]), lam_sub(in->positions[c[3]], in->positions[c[1]])));
}

/* Edges whose two faces turn by more than 120 degrees. */
static void foldovers(const lam_measuring *in, lam_measure *out) {
  long folded = 0;
  for (int e = 0; e < in->net->edge_count; e++) {
    const int *f = in->net->edges[e].face;
    if (f[1] >= 0 && lam_dot(face_normal(in, f[0]), face_normal(in, f[1])) < -.5) folded++;
  }
  *out = (lam_measure){out->name, out->unit, (double)folded, (double)folded, in->net->edge_count};
}

/* Thickness of the net over its length: standard deviation across and along the plane of best fit. Corners of an open
 * net, which belong to no star, do not count when a net has stars: constraints on stars leave them where they were. */
static void flatness(const lam_measuring *in, lam_measure *out) {
  lam_vec3 center;
  double spread[3];
  bool has_stars = in->net->star_count + in->net->irregular_count > 0;
  fit_plane(in->positions, in->net->mesh.vertex_count, has_stars ? in->net : NULL, &center, spread);
  note(out, spread[2] > 0 ? spread[0] / spread[2] : 0);
}

const lam_measure_kind lam_measures[] = {
    {"star_planarity", "",
     "largest distance of a vertex and its neighbors to their plane of best fit, over the mean edge around",
     star_planarity},
    {"face_planarity", "", "distance of a face's diagonals over their mean length", face_planarity},
    {"angle_deviation", "deg",
     "crossing angle of the families at regular vertices, against the angle aimed at (90 degrees by default)",
     angle_deviation},
    {"crossing_angle", "deg", "crossing angle of the families at regular vertices", crossing_angle},
    {"turning_angle", "deg", "angle by which a polyline turns at a regular vertex", turning_angle},
    {"edge_length", "m", "length of the edges", edge_length},
    {"shortest_edge", "", "shortest edge over the mean edge", shortest_edge},
    {"foldovers", "", "edges whose two faces turn by more than 120 degrees", foldovers},
    {"flatness", "", "spread of the vertices of all stars across their common plane over the spread along it",
     flatness},
};
const int lam_measure_count = sizeof lam_measures / sizeof *lam_measures;

static lam_measure run_one(const lam_measure_kind *kind, const lam_measuring *in) {
  lam_measure out = {.name = kind->name, .unit = kind->unit};
  kind->run(in, &out);
  return out;
}

static const lam_measure_kind *find(const char *name) {
  for (int i = 0; i < lam_measure_count; i++)
    if (strcmp(lam_measures[i].name, name) == 0) return &lam_measures[i];
  assert(!"a measure that is not in the list");
  return NULL;
}

static lam_measuring prepare(const lam_net *net, const lam_vec3 *positions, double target) {
  return (lam_measuring){net, positions, lam_net_mean_edge(net, positions), target};
}

lam_measure *lam_net_measure(lam_arena *arena, const lam_net *net, const lam_vec3 *positions, double target_angle,
                             const char *const *names, int *count) {
  lam_measuring in = prepare(net, positions, target_angle);
  *count = lam_measure_count;
  if (names)
    for (*count = 0; names[*count];) (*count)++;
  lam_measure *out = LAM_NEW(arena, lam_measure, *count);
  for (int i = 0; i < *count; i++) out[i] = run_one(names ? find(names[i]) : &lam_measures[i], &in);
  return out;
}

lam_measure lam_net_measure_one(const lam_net *net, const lam_vec3 *positions, const char *name) {
  lam_measuring in = prepare(net, positions, 0);
  return run_one(find(name), &in);
}

static double extent(const lam_net *net, const lam_vec3 *positions) {
  lam_vec3 low, high;
  lam_points_bounds(positions, net->mesh.vertex_count, &low, &high);
  return lam_distance(low, high);
}

const char *lam_net_degenerate(const lam_net *net, const lam_vec3 *before, const lam_vec3 *after) {
  lam_measure edge[2] = {lam_net_measure_one(net, before, "shortest_edge"),
                         lam_net_measure_one(net, after, "shortest_edge")};
  lam_measure flat[2] = {lam_net_measure_one(net, before, "flatness"), lam_net_measure_one(net, after, "flatness")};
  lam_measure fold[2] = {lam_net_measure_one(net, before, "foldovers"), lam_net_measure_one(net, after, "foldovers")};
  double size[2] = {extent(net, before), extent(net, after)};
  if (!isfinite(lam_net_mean_edge(net, after))) return "not a number: vertices have no place any more";
  if (!(size[1] > .05 * size[0])) return "shrunk: the net is less than a twentieth of its size at the start";
  if (!(size[1] < 20 * size[0])) return "flown apart: the net is more than twenty times its size at the start";
  if (!(edge[1].max > .02) && edge[1].max < .2 * edge[0].max) return "collapsed: edges have shrunk to nothing";
  if (flat[0].max > 1e-6 && flat[1].max < .05 * flat[0].max) return "flattened: the net is a plane";
  if (fold[1].max > fold[0].max) return "folded: faces have turned over";
  return NULL;
}
