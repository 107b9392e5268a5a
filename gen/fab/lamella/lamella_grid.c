/* From a net to the stations of lamellas: which polylines carry them, where they cross, and the
 * stations of every sheet. Called by lamella.c (lam_lamella_layout). */
#include "core/numbers.h"
#include "fab/lamella/lamella_make.h"
#include "fab/lamella/lamella_patch.h"
#include "fab/lamella/lamella_stations.h"

#include <string.h>

enum { smallest_crossing = 5 }; /* degrees */

/* A lamella: the polyline it follows and the vertices it uses. */
typedef struct lamella {
  const lam_polyline *line;
  int number, strip; /* strip: index of its first sheet */
  int first, last;   /* indices on the line: the first and the last vertex with stations */
  bool hub[2];       /* begins, ends short of a hub: a vertex where more than two lamellas meet */
} lamella;

/* What passes through a vertex. */
typedef struct site {
  const lam_polyline *line[2]; /* a polyline per family, or NULL */
  int index[2];                /* of the vertex in it */
  int lamella[2], carried[2];  /* the lamella (the last found), and how many there are */
  int node;                    /* -1: none */
} site;

/* The grid while it is laid out, with what it is made from. */
typedef struct layout {
  lam_workshop *shop;
  const lam_lamella_keys *keys;
  lam_location location;
  lam_lamella_grid *grid;
  int sheets; /* per lamella: 1 or 2 */
  int lamella_count;
  lamella *lamellas;
  site *sites; /* per vertex */
} layout;

static lam_vec3 at(const layout *l, int v) { return l->shop->net->mesh.vertices[v]; }

/* ---- lamellas and where they meet ---- */

/* A lamella for every polyline of the family that lamella_select.c chooses, numbered from 1. */
static void add_lamellas(layout *l, int family) {
  const lam_net *net = l->shop->net;
  const bool *selected =
      lam_lamella_select(l->shop->arena, net, family, l->keys->every, l->keys->boundary);
  for (int i = 0, number = 0; i < net->polyline_count; i++) {
    if (!selected[i]) continue;

    const lam_polyline *line = &net->polylines[i];
    l->lamellas[l->lamella_count] = (lamella){.line = line,
                                              .number = ++number,
                                              .strip = l->lamella_count * l->sheets,
                                              .last = line->count - 1};
    l->lamella_count++;
  }
}

/* The polylines through every vertex: any of the net at first, then those that carry lamellas,
 * which take precedence. */
static void fill_sites(layout *l) {
  const lam_net *net = l->shop->net;
  l->sites = LAM_NEW(l->shop->arena, site, net->mesh.vertex_count);
  for (int v = 0; v < net->mesh.vertex_count; v++) l->sites[v].node = -1;

  for (int i = 0; i < net->polyline_count; i++)
    for (int k = 0; k < net->polylines[i].count; k++) {
      site *s = &l->sites[net->polylines[i].vertices[k]];
      s->line[net->polylines[i].family] = &net->polylines[i];
      s->index[net->polylines[i].family] = k;
    }

  for (int i = 0; i < l->lamella_count; i++) {
    const lam_polyline *line = l->lamellas[i].line;
    for (int k = 0; k < line->count; k++) {
      site *s = &l->sites[line->vertices[k]];
      s->line[line->family] = line;
      s->index[line->family] = k;
      s->lamella[line->family] = i;
      s->carried[line->family]++;
    }
  }
}

/* More than one lamella of a family: no slots can be cut there. A crossing has one of each. */
static bool is_hub(const site *s) { return s->carried[0] > 1 || s->carried[1] > 1; }
static bool is_crossing(const site *s) { return s->carried[0] == 1 && s->carried[1] == 1; }

/* A lamella reaches from its first crossing to its last, or as far as its polyline where it has
 * none; at a hub it ends short of the vertex. Closed lines are used whole. */
static void trim(layout *l, lamella *a) {
  const int *v = a->line->vertices;
  if (a->line->closed) return;

  for (int end = 0; end < 2; end++) {
    int step = end ? -1 : 1, from = end ? a->last : a->first, k = from;
    a->hub[end] = is_hub(&l->sites[v[from]]);
    if (a->hub[end])
      k = from + step;
    else
      while (k >= 0 && k < a->line->count && !is_crossing(&l->sites[v[k]])) k += step;

    if (k < 0 || k >= a->line->count) k = from;
    *(end ? &a->last : &a->first) = k;
  }
}

/* ---- strips ---- */

static lam_patch site_patch(const layout *l, int v, int family) {
  const site *s = &l->sites[v];
  return lam_patch_make(l->shop->net, l->shop->normals, v, s->line, s->index, family);
}

/* The signed distance of a sheet (0 or 1) from its polyline, along b. */
static double offset_of(const layout *l, int sheet) {
  return l->sheets == 1 ? 0 : sheet == 0 ? l->keys->pair / 2 : -l->keys->pair / 2;
}

static void push(lam_places *p, lam_station q) { p->stations[p->count++] = q; }

/* Appends the stations of a strip at vertex v: one where nothing crosses, otherwise one per sheet
 * of the partner, in the order in which the strip meets them. */
static void push_vertex(const layout *l, const lam_sheet_strip *strip, int v, lam_places *all) {
  const site *s = &l->sites[v];
  lam_patch p = site_patch(l, v, strip->family);
  int family = strip->family;

  if (s->node < 0) {
    push(all, lam_patch_station(&p, family, strip->offset));
    all->stations[all->count - 1].vertex = v;
    return;
  }

  const lamella *partner = &l->lamellas[s->lamella[1 - family]];
  lam_station found[2];
  double along[2] = {0, 0};
  for (int k = 0; k < l->sheets; k++) {
    found[k] =
        lam_patch_crossing(&p, family, strip->offset, offset_of(l, k), l->keys->joint.scissor);
    found[k].crossing = s->node;
    found[k].vertex = v;
    if (l->keys->joint.kind == LAM_JOINT_HALF_LAP)
      found[k].partner = partner->strip + k;
    else
      found[k].slot_low = found[k].slot_high = found[k].slot_angle = 0;
    along[k] = lam_dot(lam_sub(found[k].x, p.x), p.t[family]);
  }

  bool swap = l->sheets == 2 && along[0] > along[1];
  for (int k = 0; k < l->sheets; k++) push(all, found[swap ? 1 - k : k]);
}

/* Appends the place beside a hub at which the curve of a strip begins or ends: own off the line
 * from the hub (from) to the next vertex, or the other way round when the strip comes to the
 * hub. */
static void push_hub(const layout *l, const lam_sheet_strip *strip, int hub, int next, bool end,
                     lam_places *all) {
  lam_station q = {.partner = -1, .crossing = -1, .vertex = hub, .m = l->shop->normals[hub]};
  lam_vec3 edge = lam_scale(lam_sub(at(l, next), at(l, hub)), end ? -1 : 1);
  q.t = lam_unit(lam_along(edge, -lam_dot(edge, q.m), q.m));
  q.x = lam_along(at(l, hub), strip->offset, lam_cross(q.m, q.t));
  push(all, q);
}

/* How far from a hub the lamella towards the vertex `toward` must end, in meters: strips of half
 * width w at an angle beta clear each other from w / tan(beta/2) on. beta is the smallest angle
 * to the first edge of any other lamella that ends there. */
static double setback(const layout *l, int hub, int toward) {
  lam_vec3 mine = lam_sub(at(l, toward), at(l, hub));
  double least = LAM_PI, w = (l->sheets - 1) * l->keys->pair / 2 + l->keys->thickness / 2 +
                             l->keys->joint.clearance;

  for (int i = 0; i < l->lamella_count; i++) {
    const lam_polyline *line = l->lamellas[i].line;
    for (int end = 0; end < 2 && !line->closed; end++) {
      int v = line->vertices[end ? line->count - 1 : 0],
          next = line->vertices[end ? line->count - 2 : 1];
      if (v == hub && next != toward)
        least = fmin(least, lam_angle(mine, lam_sub(at(l, next), at(l, hub))));
    }
  }

  return w / tan(least / 2) + l->keys->joint.clearance;
}

/* How far from its hub a lamella ends, in meters. Adds a message when the edge is too short for
 * that. */
static double setback_at(const layout *l, const lamella *a, int end) {
  const lam_polyline *line = a->line;
  int hub = line->vertices[end ? line->count - 1 : 0],
      next = line->vertices[end ? line->count - 2 : 1];
  double distance = setback(l, hub, next), length = lam_distance(at(l, hub), at(l, next));

  if (distance > 0.4 * length)
    lam_error_add(l->shop->errors, l->location, "pair",
                  "at net vertex %d lamellas have to end %.1f mm short to clear each other, and "
                  "the edge there is %.1f mm long: take a coarser net or thinner lamellas",
                  hub + 1, distance * 1e3, length * 1e3);
  return distance;
}

/* Vertices beyond the cut of a closed line that its curve goes on through at both ends: enough for
 * the ends of the curve to make no difference at the cut. */
enum { around = 6 };

/* The places that the curve of a strip goes through: those of its vertices, with a hub at an end
 * that stops short of it; of a closed line, whose vertices are all used, `around` more at both
 * ends. */
static lam_places places_of(const layout *l, const lamella *a, const lam_sheet_strip *strip) {
  const lam_polyline *line = a->line;
  int n = line->count, *v = line->vertices, more = line->closed ? around : 0;
  lam_places all = {.stations = LAM_NEW(l->shop->arena, lam_station, 2 * (n + 2 * around) + 2)};

  if (a->hub[0]) push_hub(l, strip, v[0], v[1], false, &all);
  for (int i = a->first - more; i <= a->last + more; i++) {
    int w = v[(i + around * n) % n];
    if (i == a->first) all.first = all.count;
    if (!is_hub(&l->sites[w])) push_vertex(l, strip, w, &all);
    if (i == a->last) all.last = all.count - 1;
  }
  if (a->hub[1]) push_hub(l, strip, v[n - 1], v[n - 2], true, &all);
  return all;
}

/* Whether every place lies apart from the next, as a curve needs it. Adds a message when not. */
static bool are_apart(const layout *l, const lam_sheet_strip *strip, const lam_places *all) {
  for (int i = 1; i < all->count; i++) {
    const lam_station *a = &all->stations[i - 1], *b = &all->stations[i];
    if (lam_distance(a->x, b->x) > 0) continue;
    lam_error_add(l->shop->errors, l->location, NULL,
                  "%s cannot be made: at net vertices %d and %d it stands in one place",
                  strip->name, a->vertex + 1, b->vertex + 1);
    return false;
  }
  return true;
}

/* A strip ends short of hubs, and runs on past its last crossings. A closed one is cut midway
 * between the last vertex and the first; the ends leave the clearance between them. */
static lam_span span_of(const layout *l, const lamella *a, const lam_places *all,
                        const lam_strip_curve *curve) {
  const double *s = curve->s, gap = l->keys->joint.clearance;
  if (a->line->closed)
    return (lam_span){.from = (s[all->first - 1] + s[all->first]) / 2 + gap / 2,
                      .to = (s[all->last] + s[all->last + 1]) / 2 - gap / 2};

  lam_span used = {0, s[all->count - 1], l->keys->extend, {!a->hub[0], !a->hub[1]}};
  if (a->hub[0]) used.from += setback_at(l, a, 0);
  if (a->hub[1]) used.to -= setback_at(l, a, 1);
  return used;
}

/* Fills the stations of one sheet along its curve. False, with a message, when it has no curve, or
 * a hub is too near. */
static bool fill_strip(layout *l, const lamella *a, lam_sheet_strip *strip) {
  lam_arena *arena = l->shop->arena;
  int before = l->shop->errors->count;
  lam_places all = places_of(l, a, strip);
  if (!are_apart(l, strip, &all)) return false;

  lam_vec3 *x = LAM_NEW(arena, lam_vec3, all.count), *m = LAM_NEW(arena, lam_vec3, all.count);
  for (int i = 0; i < all.count; i++) {
    x[i] = all.stations[i].x;
    m[i] = all.stations[i].m;
  }
  lam_strip_curve curve = lam_strip_curve_make(arena, all.count, x, m);

  lam_span used = span_of(l, a, &all, &curve);
  if (l->shop->errors->count > before) return false;
  lam_strip_lay(arena, l->grid, strip, &curve, &all, &used);
  return true;
}

/* A07, or A07a and A07b in a pair. */
static const char *strip_name(const layout *l, const lamella *a, int sheet) {
  static const char *const suffix[] = {"a", "b"};
  return lam_arena_printf(l->shop->arena, "%c%02d%s", 'A' + a->line->family, a->number,
                          l->sheets == 2 ? suffix[sheet] : "");
}

/* Slots must leave material between them and at the ends: at least the thickness. Reports the
 * narrowest rib of all strips that have too little. */
static void check_ribs(const layout *l) {
  const lam_lamella_grid *grid = l->grid;
  const lam_sheet_strip *worst = NULL;
  double least = grid->thickness, from = 0;

  for (int i = 0; i < grid->strip_count; i++) {
    const lam_sheet_strip *strip = &grid->strips[i];
    for (int k = 1; k < strip->station_count; k++) {
      double low, high, unused;
      lam_station_extent(grid, &strip->stations[k - 1], &unused, &high);
      lam_station_extent(grid, &strip->stations[k], &low, &unused);
      double rib = strip->stations[k].s + low - strip->stations[k - 1].s - high;
      if ((high == 0 && low == 0) || rib >= least - 1e-9) continue;
      least = rib, worst = strip, from = strip->stations[k - 1].s;
    }
  }

  if (worst)
    lam_error_add(l->shop->errors, l->location, "joint",
                  "%s would keep %.2f mm of material beside a slot, from %.1f mm after its start "
                  "on, and at least the thickness (%.2f mm) is needed: take a coarser net, a "
                  "larger pair or extend, less thickness or clearance, or a scissor angle nearer "
                  "to 90 deg",
                  worst->name, least * 1e3, from * 1e3, grid->thickness * 1e3);
}

/* A node at every vertex where one lamella of each family passes. False, with a message, when two
 * cross at less than smallest_crossing. */
static bool fill_nodes(layout *l) {
  lam_lamella_grid *grid = l->grid;
  int before = l->shop->errors->count;
  grid->nodes = LAM_NEW(l->shop->arena, lam_grid_node, l->shop->net->mesh.vertex_count);

  for (int i = 0; i < l->lamella_count; i++) {
    const lam_polyline *line = l->lamellas[i].line;
    for (int k = 0; k < line->count && line->family == 0; k++) {
      int v = line->vertices[k];
      site *s = &l->sites[v];
      if (!is_crossing(s)) continue;

      lam_patch p = site_patch(l, v, 0);
      if (sin(p.angle) < sin(smallest_crossing * LAM_DEGREE)) {
        lam_error_add(l->shop->errors, l->location, NULL,
                      "lamellas A%02d and B%02d cross at %.1f deg at net vertex %d: at least %d "
                      "deg are needed",
                      l->lamellas[i].number, l->lamellas[s->lamella[1]].number,
                      p.angle / LAM_DEGREE, v + 1, smallest_crossing);
        return false;
      }

      s->node = grid->node_count;
      grid->nodes[grid->node_count++] =
          (lam_grid_node){v, {i, s->lamella[1]}, p.x, p.n, {p.t[0], p.t[1]}, p.angle};
    }
  }
  return l->shop->errors->count == before;
}

/* Whether the key `families` names this family. */
static bool wants(const lam_lamella_keys *keys, int family) {
  for (int i = 0; i < keys->families.count; i++)
    if (((const int *)keys->families.items)[i] == family) return true;
  return false;
}

/* The part of a polyline that a lamella follows, with the vertices of the hubs that it ends short
 * of. Points into the net's polyline. */
static lam_polyline axis_of(const lamella *a) {
  int first = a->first - a->hub[0], last = a->last + a->hub[1];
  return (lam_polyline){a->line->family, a->line->closed, last - first + 1,
                        a->line->vertices + first};
}

/* Fills the strips of all lamellas; their parts are numbered from part on. False when one cannot be
 * made. */
static bool fill_strips(layout *l, int part) {
  lam_lamella_grid *grid = l->grid;
  grid->strip_count = l->lamella_count * l->sheets;
  grid->strips = LAM_NEW(l->shop->arena, lam_sheet_strip, grid->strip_count);

  for (int i = 0; i < l->lamella_count; i++)
    for (int k = 0; k < l->sheets; k++) {
      const lamella *a = &l->lamellas[i];
      lam_sheet_strip *strip = &grid->strips[a->strip + k];
      *strip = (lam_sheet_strip){.name = strip_name(l, a, k),
                                 .family = a->line->family,
                                 .number = a->number,
                                 .group = i,
                                 .offset = offset_of(l, k),
                                 .part = part + a->strip + k};
      if (!fill_strip(l, a, strip)) return false;
    }
  return true;
}

/* Lamellas, sites, nodes, strips: each step needs the one before it. Ribs are checked last, on
 * the finished stations. */
bool lam_lamella_layout(lam_workshop *shop, const lam_lamella_keys *keys, lam_location location,
                        int part, lam_lamella_grid *grid) {
  layout l = {shop, keys, location, grid, keys->pair > 0 ? 2 : 1, 0, NULL, NULL};
  int before = shop->errors->count;
  *grid = (lam_lamella_grid){.height = keys->height,
                             .thickness = keys->thickness,
                             .pair = keys->pair,
                             .clearance = keys->joint.clearance,
                             .material = &lam_materials[keys->material]};

  l.lamellas = LAM_NEW(shop->arena, lamella, shop->net->polyline_count);
  for (int f = 0; f < 2; f++)
    if (wants(keys, f)) add_lamellas(&l, f);
  fill_sites(&l);
  for (int i = 0; i < l.lamella_count; i++) trim(&l, &l.lamellas[i]);
  if (!fill_nodes(&l)) return false;

  grid->axes = LAM_NEW(shop->arena, lam_polyline, l.lamella_count);
  for (int i = 0; i < l.lamella_count; i++) grid->axes[i] = axis_of(&l.lamellas[i]);
  if (!fill_strips(&l, part)) return false;

  check_ribs(&l);
  return shop->errors->count == before;
}
