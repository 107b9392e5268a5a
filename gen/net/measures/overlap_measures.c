/* Faces of a net that lie on other faces of it. A row of the list in net/measures/measure.c, which
 * calls it; degenerate.c judges by it.
 *
 * Face f lies on face g when they share no vertex, the line through the center of f along a
 * triangle of g hits that triangle within a quarter of the side of f, and their planes differ by
 * less than 30 degrees. The side of f is the root of its area: two layers of one surface are
 * nearer than that, as the faces' own sagitta is; passages through each other are steeper. */
#include "core/numbers.h"
#include "net/measures/measure.h"

#include <math.h>
#include <stdlib.h>

/* What is looked at of a face. Meters. */
typedef struct outline {
  int face;
  lam_vec3 center, low, high, normal; /* low, high: its box */
  double side;                        /* root of the area */
} outline;

static outline outline_of(const lam_measuring *in, int f) {
  const int *corner = in->net->mesh.faces[f];
  const lam_vec3 *x = in->positions;
  lam_vec3 twice =
      lam_cross(lam_sub(x[corner[2]], x[corner[0]]), lam_sub(x[corner[3]], x[corner[1]]));
  outline o = {f, {0, 0, 0}, x[corner[0]], x[corner[0]], lam_unit(twice), 0};
  o.side = sqrt(lam_length(twice) / 2);

  for (int k = 0; k < 4; k++) {
    lam_vec3 p = x[corner[k]];
    o.center = lam_along(o.center, .25, p);
    o.low = lam_v3(fmin(o.low.x, p.x), fmin(o.low.y, p.y), fmin(o.low.z, p.z));
    o.high = lam_v3(fmax(o.high.x, p.x), fmax(o.high.y, p.y), fmax(o.high.z, p.z));
  }
  return o;
}

/* By the left side of their boxes, then by their numbers: the order is the same everywhere. */
static int by_left_side(const void *a, const void *b) {
  const outline *p = a, *q = b;
  if (p->low.x != q->low.x) return p->low.x < q->low.x ? -1 : 1;
  return p->face - q->face;
}

static bool share_a_vertex(const lam_net *net, int f, int g) {
  for (int i = 0; i < 4; i++)
    for (int k = 0; k < 4; k++)
      if (net->mesh.faces[f][i] == net->mesh.faces[g][k]) return true;
  return false;
}

/* Whether the line through p along the normal of the triangle hits it within reach. */
static bool is_over(lam_vec3 p, const lam_vec3 corner[3], double reach) {
  lam_vec3 n = lam_unit(lam_cross(lam_sub(corner[1], corner[0]), lam_sub(corner[2], corner[0])));
  if (!(fabs(lam_dot(n, lam_sub(p, corner[0]))) <= reach)) return false;
  for (int k = 0; k < 3; k++) {
    lam_vec3 along = lam_sub(corner[(k + 1) % 3], corner[k]);
    if (!(lam_dot(n, lam_cross(along, lam_sub(p, corner[k]))) > 0)) return false;
  }
  return true;
}

/* Whether face f lies on face g. */
static bool lies_on(const lam_measuring *in, const outline *f, const outline *g) {
  double reach = f->side / 4;
  lam_vec3 c = f->center;
  if (c.x < g->low.x - reach || c.y < g->low.y - reach || c.z < g->low.z - reach ||
      c.x > g->high.x + reach || c.y > g->high.y + reach || c.z > g->high.z + reach)
    return false;
  if (!(fabs(lam_dot(f->normal, g->normal)) > cos(LAM_PI / 6)) ||
      share_a_vertex(in->net, f->face, g->face))
    return false;

  const int *q = in->net->mesh.faces[g->face];
  const lam_vec3 *x = in->positions;
  return is_over(c, (lam_vec3[3]){x[q[0]], x[q[1]], x[q[2]]}, reach) ||
         is_over(c, (lam_vec3[3]){x[q[0]], x[q[2]], x[q[3]]}, reach);
}

/* Faces from left to right: only those whose boxes, grown by their reach, overlap along x are
 * compared. */
static void overlaps(const lam_measuring *in, double *values) {
  int count = in->net->mesh.face_count;
  outline *faces = LAM_NEW(in->arena, outline, count);
  bool *lies = LAM_NEW(in->arena, bool, count);
  double reach = 0;
  for (int f = 0; f < count; f++) {
    faces[f] = outline_of(in, f);
    if (faces[f].side / 4 > reach) reach = faces[f].side / 4;
  }
  qsort(faces, (size_t)count, sizeof *faces, by_left_side);

  values[0] = 0;
  for (int i = 0; i < count; i++)
    for (int k = i + 1; k < count && faces[k].low.x <= faces[i].high.x + reach; k++) {
      lies[i] = lies[i] || lies_on(in, &faces[i], &faces[k]);
      lies[k] = lies[k] || lies_on(in, &faces[k], &faces[i]);
    }
  for (int i = 0; i < count; i++) values[0] += lies[i];
}

const lam_measure_kind lam_measure_overlaps = {
    "overlaps", LAM_UNIT_COUNT,
    "number of faces whose center lies on another face: within a quarter of their side, planes "
    "within 30 degrees, no vertex shared",
    LAM_ON_NET, overlaps};
