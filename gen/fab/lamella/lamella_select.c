/* Which polylines carry lamellas: every k-th, on nets of any topology. Called by lamella_grid.c.
 *
 * The two edges of one family in a face belong to neighboring polylines. Walking over faces,
 * every polyline of the family gets a level, one more or less than its neighbor's; those with
 * level = phase (mod k) are selected, so that along any polyline of the other family every k-th
 * is.
 *
 * Around irregular vertices and holes the levels may come back changed (usually reflected): the
 * phase with the fewest faces that disagree about the selection is taken. Among these, the one
 * whose selection lies nearest to all polylines of the boundary and to those that end at
 * irregular vertices: on a grid with n polylines both first and last are selected when k divides
 * n - 1, and otherwise the rest is shared between both ends. */
#include "fab/lamella/lamella_make.h"

/* The two neighboring polylines that a face lies between. */
typedef struct neighbors {
  int line[2];      /* of the two edges of the family in a face */
  int direction[2]; /* 1: the polyline travels with the face on its left */
} neighbors;

typedef struct levels {
  const lam_net *net;
  int *slot_line; /* per entry of net->ring: the polyline of that edge */
  int count;
  neighbors *faces;

  /* Per polyline. sign: 1 when levels increase to its left, -1 when to its right. component: of
   * polylines that reach each other over faces; -1: of the other family. */
  int *level, *sign, *component;
} levels;

/* The entry of net->ring that leads from v to its neighbor w. */
static int slot_of(const lam_net *net, int v, int w) {
  int i = net->ring_start[v];
  while (net->ring[i] != w) i++;
  return i;
}

/* The first and the last entry of a boundary vertex's ring are its edges along the boundary. */
static bool is_boundary_edge(const lam_net *net, int v, int w) {
  return net->boundary[v] &&
         (net->ring[net->ring_start[v]] == w || net->ring[net->ring_start[v + 1] - 1] == w);
}

/* Whether a polyline runs along the boundary all the way. */
static bool is_boundary_line(const lam_net *net, const lam_polyline *line) {
  for (int i = 0; i + 1 < line->count; i++)
    if (!is_boundary_edge(net, line->vertices[i], line->vertices[i + 1])) return false;
  return true;
}

/* Whether an open polyline ends inside the net: at an irregular vertex, then. */
static bool ends_at_irregular(const lam_net *net, const lam_polyline *line) {
  int first = line->vertices[0], last = line->vertices[line->count - 1];
  return !line->closed && (!net->boundary[first] || !net->boundary[last]);
}

/* The polyline of every edge, entered for both of its directions. */
static void find_lines(lam_arena *arena, levels *l) {
  const lam_net *net = l->net;
  l->slot_line = LAM_NEW(arena, int, net->ring_start[net->mesh.vertex_count]);
  for (int i = 0; i < net->polyline_count; i++) {
    const lam_polyline *line = &net->polylines[i];

    for (int k = 0; k < line->count - !line->closed; k++) {
      int v = line->vertices[k], w = line->vertices[(k + 1) % line->count];
      l->slot_line[slot_of(net, v, w)] = i;
      l->slot_line[slot_of(net, w, v)] = i;
    }
  }
}

/* 1 when the polyline travels from v to w, -1 when from w to v. */
static int travels(const lam_polyline *line, int v, int w) {
  for (int i = 0; i < line->count; i++)
    if (line->vertices[i] == v)
      return (i + 1 < line->count || line->closed) && line->vertices[(i + 1) % line->count] == w
                 ? 1
                 : -1;
  return -1;
}

/* For every face its two polylines of the family: sides c0 c1 and c2 c3, or c1 c2 and c3 c0. The
 * face lies on the left of its own sides. */
static void find_neighbors(lam_arena *arena, levels *l, int family) {
  const lam_net *net = l->net;
  l->faces = LAM_NEW(arena, neighbors, net->mesh.face_count);
  for (int f = 0; f < net->mesh.face_count; f++) {
    const int *c = net->mesh.faces[f];
    int side = net->polylines[l->slot_line[slot_of(net, c[0], c[1])]].family == family ? 0 : 1;

    neighbors *n = &l->faces[l->count++];
    for (int k = 0; k < 2; k++) {
      int v = c[side + 2 * k], w = c[(side + 2 * k + 1) % 4];
      n->line[k] = l->slot_line[slot_of(net, v, w)];
      n->direction[k] = travels(&net->polylines[n->line[k]], v, w);
    }
  }
}

/* The level of the polyline on the other side of a face, as seen from side k. */
static int expected(const levels *l, const neighbors *n, int k) {
  return l->level[n->line[k]] + l->sign[n->line[k]] * n->direction[k];
}

/* Levels spread from the first polyline of every component, nearest first. Returns the number of
 * components. */
static int spread_levels(lam_arena *arena, levels *l, int family) {
  int lines = l->net->polyline_count, components = 0, *queue = LAM_NEW(arena, int, lines);
  int *start = LAM_NEW(arena, int, lines + 1), *list = LAM_NEW(arena, int, 2 * l->count),
      *fill = LAM_NEW(arena, int, lines);

  /* The faces at every polyline in compressed form: entries start[line] .. start[line+1]-1 of
   * list, each twice the face plus the side. */
  for (int f = 0; f < 2 * l->count; f++) start[l->faces[f / 2].line[f % 2] + 1]++;
  for (int i = 0; i < lines; i++) start[i + 1] += start[i];
  for (int f = 0; f < 2 * l->count; f++) {
    int line = l->faces[f / 2].line[f % 2];
    list[start[line] + fill[line]++] = f;
  }

  for (int seed = 0; seed < lines; seed++) {
    if (l->component[seed] >= 0 || l->net->polylines[seed].family != family) continue;
    int head = 0, tail = 0;
    queue[tail++] = seed;
    l->sign[seed] = 1;
    l->component[seed] = components;

    while (head < tail) {
      int line = queue[head++];

      for (int i = start[line]; i < start[line + 1]; i++) {
        const neighbors *n = &l->faces[list[i] / 2];
        int k = list[i] % 2, other = n->line[1 - k];
        if (l->component[other] >= 0) continue;
        l->component[other] = components;
        l->level[other] = expected(l, n, k);
        l->sign[other] = -l->sign[line] * n->direction[k] * n->direction[1 - k];
        queue[tail++] = other;
      }
    }

    components++;
  }
  return components;
}

/* The remainder of a / k in 0 .. k - 1, for negative a too. */
static int modulo(int a, int k) { return (a % k + k) % k; }

/* How many sides of the faces of a component disagree about the selection with the phase: the
 * polyline as its neighbor expects it is selected and it is not, or the other way around. */
static int conflicts(const levels *l, int component, int every, int phase) {
  int count = 0;
  for (int f = 0; f < l->count; f++) {
    const neighbors *n = &l->faces[f];
    if (l->component[n->line[0]] != component) continue;
    for (int k = 0; k < 2; k++)
      count += (modulo(expected(l, n, k) - phase, every) == 0) !=
               (modulo(l->level[n->line[1 - k]] - phase, every) == 0);
  }
  return count;
}

/* The largest distance, in levels, from a polyline that should carry a lamella (on the boundary,
 * or with an end at an irregular vertex) to the nearest level that does. */
static int distance(const levels *l, int component, int every, int phase) {
  int most = 0;
  for (int i = 0; i < l->net->polyline_count; i++) {
    const lam_polyline *line = &l->net->polylines[i];
    if (l->component[i] != component ||
        !(is_boundary_line(l->net, line) || ends_at_irregular(l->net, line)))
      continue;

    int d = modulo(l->level[i] - phase, every);
    if (every - d < d) d = every - d;
    if (d > most) most = d;
  }
  return most;
}

/* Levels first; then for each component the phase with the fewest conflicts, and the nearest of
 * these. */
bool *lam_lamella_select(lam_arena *arena, const lam_net *net, int family, int every,
                         bool boundary) {
  int lines = net->polyline_count;
  bool *selected = LAM_NEW(arena, bool, lines);
  levels l = {.net = net,
              .level = LAM_NEW(arena, int, lines),
              .sign = LAM_NEW(arena, int, lines),
              .component = LAM_NEW(arena, int, lines)};
  for (int i = 0; i < lines; i++) l.component[i] = -1;

  find_lines(arena, &l);
  find_neighbors(arena, &l, family);
  int components = spread_levels(arena, &l, family);

  for (int c = 0; c < components; c++) {
    int best = 0, least = 0, nearest = 0;
    for (int phase = 0; phase < every; phase++) {
      int wrong = conflicts(&l, c, every, phase), far = distance(&l, c, every, phase);
      if (phase > 0 && (wrong > least || (wrong == least && far >= nearest))) continue;
      best = phase, least = wrong, nearest = far;
    }

    for (int i = 0; i < lines; i++)
      if (l.component[i] == c && modulo(l.level[i] - best, every) == 0)
        selected[i] = boundary || !is_boundary_line(net, &net->polylines[i]);
  }

  return selected;
}
