/* The net of a plot in the colors of a map, in parallel projection. Called by plot_svg.c. */
#include "core/numbers.h"
#include "formats/plot/plot.h"

#include <math.h>
#include <stdlib.h>

static const double azimuth = -55 * LAM_PI / 180, elevation = 32 * LAM_PI / 180; /* of the viewer */

/* What is drawn, and where: set up by lam_plot_view. */
typedef struct view {
  lam_text *out;
  const lam_mesh *net;
  const lam_map *map;
  const lam_color_scale *scale;
  lam_vec3 *points; /* on the page, x right, y down, z towards the viewer */
  double line;      /* width of the thin lines, millimeters */
  /* Edges of a map on edges by their smaller vertex v: first[v], then by next[e]; -1 ends. */
  int *first, *next;
} view;

/* A face by the sum of the depths of its corners. */
typedef struct sorted_face {
  double depth;
  int face;
} sorted_face;

/* For qsort: farther faces first; those as far away in their order. */
static int nearer(const void *a, const void *b) {
  const sorted_face *p = a, *q = b;
  return p->depth != q->depth ? (p->depth > q->depth) - (p->depth < q->depth) : p->face - q->face;
}

/* The net on the picture plane, in meters: x right, y down, z towards the viewer. */
static void look(view *v) {
  lam_vec3 right = lam_v3(-sin(azimuth), cos(azimuth), 0);
  lam_vec3 to =
      lam_v3(cos(elevation) * cos(azimuth), cos(elevation) * sin(azimuth), sin(elevation));
  lam_vec3 up = lam_cross(to, right);
  for (int i = 0; i < v->net->vertex_count; i++) {
    lam_vec3 x = v->net->vertices[i];
    v->points[i] = lam_v3(lam_dot(x, right), -lam_dot(x, up), lam_dot(x, to));
  }
}

/* The layout on the picture plane, seen from above. */
static void look_flat(view *v) {
  for (int i = 0; i < v->net->vertex_count; i++)
    v->points[i] = lam_v3(v->map->layout[i].x, -v->map->layout[i].y, 0);
}

/* The bounding rectangle of the points; z is 0. */
static void bounds(const view *v, lam_vec3 *low, lam_vec3 *high) {
  *low = lam_v3(INFINITY, INFINITY, 0), *high = lam_v3(-INFINITY, -INFINITY, 0);
  for (int i = 0; i < v->net->vertex_count; i++) {
    lam_vec3 p = v->points[i];
    *low = lam_v3(fmin(low->x, p.x), fmin(low->y, p.y), 0),
    *high = lam_v3(fmax(high->x, p.x), fmax(high->y, p.y), 0);
  }
}

/* Millimeters per meter that fit the points into the box; 0 when they have no extent. */
static double fitting(const view *v, lam_box box) {
  lam_vec3 low, high;
  bounds(v, &low, &high);
  double scale = fmin(box.width / (high.x - low.x), box.height / (high.y - low.y));
  return isfinite(scale) ? scale : 0;
}

/* Moves the points from meters on the picture plane into the middle of the box, at so many
 * millimeters per meter. Lines are thinner where the faces are small. */
static void move_into(view *v, lam_box box, double scale) {
  lam_vec3 low, high;
  bounds(v, &low, &high);
  for (int i = 0; i < v->net->vertex_count; i++) {
    lam_vec3 *p = &v->points[i];
    p->x = box.x + box.width / 2 + (p->x - (low.x + high.x) / 2) * scale;
    p->y = box.y + box.height / 2 + (p->y - (low.y + high.y) / 2) * scale;
    p->z *= scale;
  }

  double edge = sqrt(box.width * box.height / fmax(v->net->face_count, 1));
  v->line = fmin(.12, .03 * edge);
}

/* Begins a path through the points, closed from three on. Points that are not finite stand at 0. */
static void add_path(const view *v, const lam_vec3 *points, int count) {
  lam_text_add(v->out, "<path d=\"M");
  for (int i = 0; i < count; i++) {
    lam_text_add(v->out, i == 0 ? "" : i == 1 ? " L" : " ");
    lam_text_number(v->out, isfinite(points[i].x) ? points[i].x : 0, 2);
    lam_text_add(v->out, ",");
    lam_text_number(v->out, isfinite(points[i].y) ? points[i].y : 0, 2);
  }
  lam_text_add(v->out, count > 2 ? " Z\"" : "\"");
}

/* Filled and stroked in one color, so that no gap shows between neighbors. */
static void fill(const view *v, const lam_vec3 *points, int count, double value) {
  add_path(v, points, count);
  lam_text_add(v->out, " fill=\"");
  lam_rgb_write(v->out, lam_color_of(v->scale, value));
  lam_text_add(v->out, "\" stroke=\"");
  lam_rgb_write(v->out, lam_color_of(v->scale, value));
  lam_text_add(v->out, "\"/>\n");
}

/* A face in the colors of its vertices: each has the quarter between the midpoints of its edges
 * and the middle of the face. */
static void fill_quarters(const view *v, const lam_vec3 corners[4], const int *face) {
  lam_vec3 center =
      lam_scale(lam_add(lam_add(corners[0], corners[1]), lam_add(corners[2], corners[3])), .25);
  for (int k = 0; k < 4; k++) {
    lam_vec3 next = lam_mix(corners[k], corners[(k + 1) % 4], .5),
             before = lam_mix(corners[k], corners[(k + 3) % 4], .5);
    fill(v, (lam_vec3[4]){corners[k], next, center, before}, 4, v->map->values[face[k]]);
  }
}

/* Lists the edges of the map by their smaller vertex. */
static void find_edges(lam_arena *arena, view *v) {
  v->first = LAM_NEW(arena, int, v->net->vertex_count);
  v->next = LAM_NEW(arena, int, v->map->count);
  for (int i = 0; i < v->net->vertex_count; i++) v->first[i] = -1;
  for (int e = 0; e < v->map->count; e++) {
    const int *ends = v->map->edges[e];
    int low = ends[0] < ends[1] ? ends[0] : ends[1];
    v->next[e] = v->first[low];
    v->first[low] = e;
  }
}

/* The value of the edge between vertices a and b; not a number when the map does not have it. */
static double edge_value(const view *v, int a, int b) {
  int low = a < b ? a : b, high = a < b ? b : a;
  for (int e = v->first[low]; e >= 0; e = v->next[e])
    if (v->map->edges[e][0] == high || v->map->edges[e][1] == high) return v->map->values[e];
  return NAN;
}

/* A white face and its edges in their colors. */
static void draw_edges(const view *v, const lam_vec3 corners[4], const int *face) {
  add_path(v, corners, 4);
  lam_text_add(v->out, " fill=\"#ffffff\" stroke=\"none\"/>\n");
  for (int k = 0; k < 4; k++) {
    add_path(v, (lam_vec3[2]){corners[k], corners[(k + 1) % 4]}, 2);
    lam_text_add(v->out, " class=\"edge\" stroke=\"");
    lam_rgb_write(v->out, lam_color_of(v->scale, edge_value(v, face[k], face[(k + 1) % 4])));
    lam_text_add(v->out, "\"/>\n");
  }
}

/* A face as its map wants it, with a thin line around it where the values are not on edges. */
static void draw_face(const view *v, int f) {
  const int *face = v->net->faces[f];
  lam_vec3 corners[4];
  for (int k = 0; k < 4; k++) corners[k] = v->points[face[k]];
  if (v->map->on == LAM_MAP_EDGES) {
    draw_edges(v, corners, face);
    return;
  }

  if (v->map->on == LAM_MAP_FACES)
    fill(v, corners, 4, v->map->values[f]);
  else
    fill_quarters(v, corners, face);

  add_path(v, corners, 4);
  lam_text_add(v->out, " class=\"line\"/>\n");
}

/* All faces in a group of this class, farther ones first, so that nearer ones cover them. */
static void draw(view *v, const char *class) {
  lam_text *out = v->out;
  sorted_face *order = LAM_NEW(out->arena, sorted_face, v->net->face_count);
  for (int f = 0; f < v->net->face_count; f++) {
    order[f].face = f;
    for (int k = 0; k < 4; k++) order[f].depth += v->points[v->net->faces[f][k]].z;
  }
  qsort(order, (size_t)v->net->face_count, sizeof *order, nearer);

  lam_text_printf(out, "<g class=\"%s\" stroke-linejoin=\"round\" stroke-width=\"", class);
  lam_text_number(out, v->line, 3);
  lam_text_add(
      out,
      "\">\n<style>.line { fill: none; stroke: #202020; stroke-opacity: .55 } .edge { fill: none; "
      "stroke-linecap: round; stroke-width: ");
  lam_text_number(out, 4 * v->line, 3);
  lam_text_add(out, " }</style>\n");

  for (int i = 0; i < v->net->face_count; i++) draw_face(v, order[i].face);
  lam_text_add(out, "</g>\n");
}

/* A layout and the net get half of the box each, and the smaller of the two scales that fit. */
void lam_plot_view(lam_text *out, const lam_mesh *net, const lam_map *map,
                   const lam_color_scale *scale, lam_box box) {
  static const double gap = 6; /* between net and layout, mm */
  lam_arena *arena = out->arena;
  view v = {.out = out,
            .net = net,
            .map = map,
            .scale = scale,
            .points = LAM_NEW(arena, lam_vec3, net->vertex_count)};

  if (map->on == LAM_MAP_EDGES) find_edges(arena, &v);
  look(&v);
  if (!map->layout) {
    move_into(&v, box, fitting(&v, box));
    draw(&v, "view");
    return;
  }

  lam_box half = {box.x, box.y, (box.width - gap) / 2, box.height}, other = half;
  other.x += half.width + gap;
  double shared = fitting(&v, half);
  look_flat(&v);
  shared = fmin(shared, fitting(&v, other));
  move_into(&v, other, shared);
  draw(&v, "layout");

  look(&v);
  move_into(&v, half, shared);
  draw(&v, "view");
}
