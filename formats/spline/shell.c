/* Vertices, edges and connected parts of surfaces that are joined along their sides. Called by
 * the STEP writer (formats/step/step.c). */
#include "formats/spline/shell.h"

#include <stdlib.h>

/* A corner to be matched. */
typedef struct corner {
  double height; /* along a direction that no edges are likely to be normal to */
  int index;     /* 4 * surface + k */
  lam_vec3 x;
} corner;

/* A side to be matched: its vertices, the lower first, and where it stands. */
typedef struct span {
  int low, high, index; /* 4 * surface + side */
  lam_spline_side side;
} span;

/* The shell while it is made, and what it is made of. */
typedef struct maker {
  lam_arena *arena;
  int count;
  const lam_spline_surface *surfaces;
  double tolerance;
  int *vertex; /* per corner */
  lam_shell shell;
} maker;

int lam_shell_corner(const lam_spline_surface *s, int k) {
  int n = s->count[0], m = s->count[1], corners[4] = {0, (n - 1) * m, n * m - 1, m - 1};
  return corners[k];
}

/* ---- vertices ---- */

/* For qsort: by height, then by index, so that the order is always the same. */
static int by_height(const void *a, const void *b) {
  const corner *x = a, *y = b;
  return x->height != y->height ? (x->height > y->height) - (x->height < y->height)
                                : x->index - y->index;
}

/* All corners, sorted by their height along one direction. size: the largest distance of a control
 * point from the first one. */
static corner *sort_corners(const maker *m, double *size) {
  int total = 4 * m->count;
  corner *corners = LAM_NEW(m->arena, corner, total);
  *size = 0;
  for (int i = 0; i < total; i++) {
    const lam_spline_surface *s = &m->surfaces[i / 4];
    lam_vec3 x = s->points[lam_shell_corner(s, i % 4)];
    corners[i] = (corner){lam_dot(x, lam_v3(0.53, 0.64, 0.56)), i, x};
    for (int k = 0; k < s->count[0] * s->count[1]; k++)
      *size = fmax(*size, lam_distance(s->points[k], m->surfaces[0].points[0]));
  }

  qsort(corners, (size_t)total, sizeof *corners, by_height);
  return corners;
}

/* Makes the first corner that has no vertex yet a vertex, for itself and the corners near it.
 * Corners within the tolerance t of each other differ in height by little more than t, because
 * the direction is about of unit length: twice the tolerance is searched. */
static void find_vertices(maker *m) {
  double size;
  int total = 4 * m->count;
  const corner *corners = sort_corners(m, &size);
  m->tolerance = 1e-9 * fmax(size, 1);
  m->vertex = LAM_NEW(m->arena, int, total);
  m->shell.vertices = LAM_NEW(m->arena, int, total);
  for (int i = 0; i < total; i++) m->vertex[i] = -1;

  for (int i = 0; i < total; i++) {
    if (m->vertex[corners[i].index] >= 0) continue;
    int vertex = m->shell.vertex_count++;
    m->shell.vertices[vertex] = corners[i].index;
    for (int j = i; j < total && corners[j].height - corners[i].height <= 2 * m->tolerance; j++)
      if (m->vertex[corners[j].index] < 0 &&
          lam_distance(corners[i].x, corners[j].x) <= m->tolerance)
        m->vertex[corners[j].index] = vertex;
  }
}

/* ---- edges ---- */

/* Whether b at corresponding parameters is where a is, at the nodes that divide each piece of a.
 * Two rational curves of degrees p and q that agree at p + q + 1 parameters of a piece are one
 * there. */
static bool agree_on_pieces(const maker *m, const lam_spline_side *a, const lam_spline_side *b,
                            bool reversed) {
  double a0 = a->knots[a->degree], a1 = a->knots[a->count], b0 = b->knots[b->degree],
         b1 = b->knots[b->count];
  int samples = a->degree + b->degree + 1;

  for (int i = a->degree; i < a->count; i++)
    for (int k = 0; k <= samples && a->knots[i] < a->knots[i + 1]; k++) {
      double t = a->knots[i] + (a->knots[i + 1] - a->knots[i]) * k / samples,
             s = (t - a0) / (a1 - a0);
      lam_vec3 x = lam_spline_side_point(m->arena, a, t);
      lam_vec3 y = lam_spline_side_point(m->arena, b, b0 + (b1 - b0) * (reversed ? 1 - s : s));
      if (!(lam_distance(x, y) <= m->tolerance)) return false;
    }
  return true;
}

/* Both ways, because the knots of either divide the other. */
static bool coincide(const maker *m, const lam_spline_side *a, const lam_spline_side *b,
                     bool reversed) {
  return agree_on_pieces(m, a, b, reversed) && agree_on_pieces(m, b, a, reversed);
}

/* For qsort: spans between the same vertices stand together. */
static int by_vertices(const void *a, const void *b) {
  const span *x = a, *y = b;
  return x->low != y->low     ? x->low - y->low
         : x->high != y->high ? x->high - y->high
                              : x->index - y->index;
}

/* The vertex at an end (0 or 1) of a side, along its curve; index: 4 * surface + side. */
static int end_vertex(const maker *m, int index, int end) {
  static const int ends[4][2] = {{0, 1}, {1, 2}, {3, 2}, {0, 3}}; /* corners, along the curve */
  return m->vertex[index / 4 * 4 + ends[index % 4][end]];
}

/* Gives a side an edge of its own, which runs with it. */
static void add_edge(maker *m, int index) {
  m->shell.uses[index] = (lam_shell_use){m->shell.edge_count, true};
  m->shell.edges[m->shell.edge_count++] =
      (lam_shell_edge){index / 4, index % 4, {end_vertex(m, index, 0), end_vertex(m, index, 1)}, 1};
}

/* Joins a side to the first edge from `first` on that it coincides with and that has one use
 * only; false: there is none. */
static bool join(maker *m, const span *s, int first) {
  for (int e = first; e < m->shell.edge_count; e++) {
    lam_shell_edge *edge = &m->shell.edges[e];
    lam_spline_side side = lam_spline_side_of(&m->surfaces[edge->surface], edge->side);
    for (int reversed = 0; reversed < 2 && edge->uses == 1; reversed++) {
      if (!coincide(m, &side, &s->side, reversed)) continue;
      edge->uses++;
      m->shell.uses[s->index] = (lam_shell_use){e, !reversed};
      return true;
    }
  }
  return false;
}

/* Sides that are points have no edge. Only sides between the same vertices can coincide: the
 * edges of a run of such spans begin at `first`. */
static void find_edges(maker *m) {
  int total = 4 * m->count, n = 0, first = 0;
  span *spans = LAM_NEW(m->arena, span, total);
  m->shell.edges = LAM_NEW(m->arena, lam_shell_edge, total);
  m->shell.uses = LAM_NEW(m->arena, lam_shell_use, total);

  for (int i = 0; i < total; i++) {
    lam_spline_side side = lam_spline_side_of(&m->surfaces[i / 4], i % 4);
    int a = end_vertex(m, i, 0), b = end_vertex(m, i, 1);
    m->shell.uses[i] = (lam_shell_use){-1, false};
    if (!lam_spline_side_is_point(&side))
      spans[n++] = (span){a < b ? a : b, a < b ? b : a, i, side};
  }

  if (n) qsort(spans, (size_t)n, sizeof *spans, by_vertices);
  for (int i = 0; i < n; i++) {
    bool apart = i == 0 || spans[i].low != spans[i - 1].low || spans[i].high != spans[i - 1].high;
    if (apart) first = m->shell.edge_count;
    if (!join(m, &spans[i], first)) add_edge(m, spans[i].index);
  }
}

/* ---- parts ---- */

/* Whether the boundary of the surface as it lies passes the edge forward. */
static bool passes_forward(const lam_shell *shell, int index) {
  return shell->uses[index].forward == (index % 4 < 2);
}

/* The other side that uses the edge of side `index`; -1: none. other: the two sides of each
 * edge. */
static int across(const lam_shell *shell, int (*other)[2], int index) {
  int edge = shell->uses[index].edge;
  if (edge < 0 || shell->edges[edge].uses < 2) return -1;
  return other[edge][0] == index ? other[edge][1] : other[edge][0];
}

/* The sides that use each edge, one or two, in the order of the surfaces. */
static void list_sides(const maker *m, int (*sides)[2]) {
  const lam_shell *shell = &m->shell;
  int *seen = LAM_NEW(m->arena, int, shell->edge_count);
  for (int i = 0; i < 4 * m->count; i++) {
    int edge = shell->uses[i].edge;
    if (edge >= 0) sides[edge][seen[edge]++] = i;
  }
}

/* Goes from surface `at` across its sides. A neighbor that is met for the first time joins the
 * part, turned so that both pass their edge in opposite directions, and the queue; where one that
 * was met before lies the other way, the second side of the edge gets an edge of its own. Returns
 * the new end of the queue. */
static int cross_sides(maker *m, int (*other)[2], int at, int *queue, int tail) {
  lam_shell *shell = &m->shell;
  for (int k = 0; k < 4; k++) {
    int index = 4 * at + k, to = across(shell, other, index);
    if (to < 0) continue;

    bool same = passes_forward(shell, index) == passes_forward(shell, to);
    bool flipped = shell->flipped[at] != same;
    if (shell->part[to / 4] < 0) {
      shell->part[to / 4] = shell->part[at];
      shell->flipped[to / 4] = flipped;
      queue[tail++] = to / 4;
    } else if (shell->flipped[to / 4] != flipped) {
      int second = other[shell->uses[to].edge][1];
      shell->edges[shell->uses[to].edge].uses = 1;
      add_edge(m, second);
    }
  }
  return tail;
}

/* Finds the connected parts, breadth first, and how many edges of each are used once. */
static void find_parts(maker *m) {
  lam_shell *shell = &m->shell;
  int(*other)[2] = (int(*)[2])lam_arena_alloc(m->arena, (size_t)shell->edge_count, sizeof *other);
  int *queue = LAM_NEW(m->arena, int, m->count);
  list_sides(m, other);
  shell->flipped = LAM_NEW(m->arena, bool, m->count);
  shell->part = LAM_NEW(m->arena, int, m->count);
  shell->border = LAM_NEW(m->arena, int, m->count);
  for (int s = 0; s < m->count; s++) shell->part[s] = -1;

  for (int s = 0; s < m->count; s++) {
    if (shell->part[s] >= 0) continue;
    int head = 0, tail = 0;
    shell->part[s] = shell->part_count++;
    queue[tail++] = s;
    while (head < tail) tail = cross_sides(m, other, queue[head++], queue, tail);
  }

  for (int e = 0; e < shell->edge_count; e++)
    if (shell->edges[e].uses == 1) shell->border[shell->part[shell->edges[e].surface]]++;
}

/* Edges need vertices, parts need edges. */
lam_shell lam_shell_make(lam_arena *arena, int count, const lam_spline_surface *surfaces) {
  maker m = {.arena = arena, .count = count, .surfaces = surfaces};
  find_vertices(&m);
  find_edges(&m);
  find_parts(&m);
  return m.shell;
}
