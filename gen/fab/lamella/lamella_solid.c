/* The solid of a strip, without a boolean operation: sections, and cells between them. Called by
 * lamella.c.
 *
 * Sections follow the stations in order; a crossing has two, at the edges of its slot. Section k
 * has six points 6 k + 2 level + side:
 *   x + h m + y b
 *   level 0, 1, 2: h = -height/2, floor, +height/2
 *   side 0, 1: y = -+thickness/2
 * Between section k and k + 1 are two cells, lower and upper; in the two sections of a crossing,
 * family 0 leaves out the upper one and family 1 the lower one.
 *
 * The solid is the union of the cells, and its boundary consists of quads: per cell both sides;
 * its bottom, top, start and end, each unless another cell lies there. Every quad is split along
 * the diagonal through the corner with the smallest index. Quads share whole edges only, and two
 * cells never touch along an edge alone, so the boundary is closed and 2-manifold. Faces: cell by
 * cell (lower, then upper), in the order side 1, side 0, bottom, top, start, end. */
#include "fab/lamella/lamella_make.h"
#include "fab/mesh_fill.h"

typedef struct sections {
  int count;
  lam_vec3 *points; /* six per section */
  bool *slot;       /* whether the cell after the section is slotted */
} sections;

/* Appends the six points of a section at x + along t. */
static void add_section(sections *s, const lam_lamella_grid *grid, const lam_sheet_strip *strip,
                        const lam_station *q, double along) {
  double floor = strip->family == 0 ? -grid->clearance : grid->clearance;
  const double level[3] = {-grid->height / 2, floor, grid->height / 2};
  lam_vec3 x = lam_along(q->x, along, q->t), b = lam_cross(q->m, q->t);

  for (int l = 0; l < 3; l++)
    for (int side = 0; side < 2; side++)
      s->points[6 * s->count + 2 * l + side] =
          lam_along(lam_along(x, level[l], q->m), (side ? 0.5 : -0.5) * grid->thickness, b);
  s->count++;
}

/* One section per station, two at a crossing with a slot; the cell between them is slotted. */
static sections make_sections(lam_arena *arena, const lam_lamella_grid *grid,
                              const lam_sheet_strip *strip) {
  sections s = {0, LAM_NEW(arena, lam_vec3, 12 * strip->station_count),
                LAM_NEW(arena, bool, 2 * strip->station_count)};
  for (int i = 0; i < strip->station_count; i++) {
    const lam_station *q = &strip->stations[i];
    double low, high;
    lam_station_extent(grid, q, &low, &high);

    if (q->partner >= 0) {
      s.slot[s.count] = true;
      add_section(&s, grid, strip, q, low);
    }
    add_section(&s, grid, strip, q, high);
  }
  return s;
}

/* Whether there is a cell: row 0 below the floor, 1 above. open: the row that slots leave out. */
static bool is_solid(const sections *s, int cell, int row, int open) {
  return cell >= 0 && cell + 1 < s->count && row >= 0 && row < 2 && !(row == open && s->slot[cell]);
}

/* The quad of four corners counted from base, counterclockwise from outside, the smallest first. */
static void add_quad(lam_trimesh *mesh, int base, const int corner[4]) {
  lam_trimesh_quad(mesh, base + corner[0], base + corner[1], base + corner[2], base + corner[3]);
}

/* Adds the faces of a cell that no other cell covers. Corners relative to the first point of the
 * cell: 0 and 1 at its start below, 2 and 3 above them, 6 more at its end. With t ahead and m up,
 * b = m x t (side 1) is to the left. */
static void add_cell(lam_trimesh *mesh, const sections *s, int cell, int row, int open) {
  static const int left[4] = {1, 3, 9, 7}, right[4] = {0, 6, 8, 2}, bottom[4] = {0, 1, 7, 6},
                   top[4] = {2, 8, 9, 3}, start[4] = {0, 2, 3, 1}, end[4] = {6, 7, 9, 8};

  int base = 6 * cell + 2 * row;
  add_quad(mesh, base, left);
  add_quad(mesh, base, right);
  if (!is_solid(s, cell, row - 1, open)) add_quad(mesh, base, bottom);
  if (!is_solid(s, cell, row + 1, open)) add_quad(mesh, base, top);
  if (!is_solid(s, cell - 1, row, open)) add_quad(mesh, base, start);
  if (!is_solid(s, cell + 1, row, open)) add_quad(mesh, base, end);
}

/* A cell has six faces at most, so two rows of cells have at most 24 triangles per section. */
lam_trimesh lam_lamella_solid(lam_arena *arena, const lam_lamella_grid *grid,
                              const lam_sheet_strip *strip) {
  sections s = make_sections(arena, grid, strip);
  int open = strip->family == 0 ? 1 : 0, most = 24 * s.count;
  lam_trimesh mesh = {6 * s.count, s.points, 0, NULL};
  mesh.triangles = (int(*)[3])lam_arena_alloc(arena, (size_t)most, sizeof *mesh.triangles);

  for (int cell = 0; cell + 1 < s.count; cell++)
    for (int row = 0; row < 2; row++)
      if (is_solid(&s, cell, row, open)) add_cell(&mesh, &s, cell, row, open);
  return mesh;
}
