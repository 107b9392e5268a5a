/* A lamella grid in the plane z = 0, for tests of flat patterns and sheets: n strips of family 0
 * along x and n of family 1 at an angle to them, `spacing` apart along the strips, single or
 * paired. Positions are exact, so that lengths, slots and areas are known in closed form. */
#ifndef LAM_TESTS_PLANE_GRID_H
#define LAM_TESTS_PLANE_GRID_H

#include "fab/lamella/lamella_flat.h"
#include "fab/lamella/lamella_make.h"
#include "tests/unit/asserts.h"

static inline lam_station plane_station(lam_vec3 origin, lam_vec3 t, double s) {
  return (lam_station){
      .x = lam_along(origin, s, t), .t = t, .m = {0, 0, 1}, .s = s, .partner = -1, .crossing = -1};
}

/* Strips begin `extend` before their first node. Sheets of a pair stand at -+pair/2 along b = m x
 * t. */
static inline lam_lamella_grid *plane_grid(lam_arena *arena, int n, double spacing, double angle,
                                           double height, double thickness, double pair,
                                           double clearance, double extend) {
  lam_lamella_grid *grid = LAM_NEW(arena, lam_lamella_grid, 1);
  int sheets = pair > 0 ? 2 : 1;
  *grid = (lam_lamella_grid){.height = height,
                             .thickness = thickness,
                             .pair = pair,
                             .clearance = clearance,
                             .strip_count = 2 * n * sheets,
                             .material = &lam_materials[0]};
  grid->strips = LAM_NEW(arena, lam_sheet_strip, grid->strip_count);
  lam_vec3 t[2] = {{1, 0, 0}, {cos(angle), sin(angle), 0}};
  for (int i = 0; i < grid->strip_count; i++) {
    int family = i / (n * sheets), lamella = i / sheets % n, sheet = i % sheets;
    double offset = sheets == 1 ? 0 : (sheet ? pair / 2 : -pair / 2);
    lam_vec3 b = lam_cross(lam_v3(0, 0, 1), t[family]);
    lam_vec3 first = lam_scale(t[1 - family], lamella * spacing);
    lam_sheet_strip *strip = &grid->strips[i];
    *strip =
        (lam_sheet_strip){.name = lam_arena_printf(arena, "%c%02d%s", 'A' + family, lamella + 1,
                                                   sheets == 1 ? ""
                                                   : sheet     ? "b"
                                                               : "a"),
                          .family = family,
                          .number = lamella + 1,
                          .group = family * n + lamella,
                          .offset = offset,
                          .part = i};
    strip->stations = LAM_NEW(arena, lam_station, n * sheets + 2);
    lam_vec3 origin = lam_along(lam_along(first, offset, b), -extend, t[family]);
    strip->stations[strip->station_count++] = plane_station(origin, t[family], 0);
    for (int k = 0; k < n * sheets; k++) {
      /* the partners of family 1 stand in the opposite order along a sheet of family 0 */
      int other = k / sheets, side = sheets == 2 && family == 0 ? 1 - k % 2 : k % sheets;
      double partner_offset = sheets == 1 ? 0 : (side ? pair / 2 : -pair / 2);
      double across = family == 0 ? (offset * cos(angle) - partner_offset) / sin(angle)
                                  : (partner_offset - offset * cos(angle)) / sin(angle);
      lam_station station = plane_station(origin, t[family], extend + other * spacing + across);
      station.partner = ((1 - family) * n + other) * sheets + side;
      station.angle = station.slot_angle = angle;
      strip->stations[strip->station_count++] = station;
    }
    strip->length = 2 * extend + (n - 1) * spacing;
    strip->stations[strip->station_count++] = plane_station(origin, t[family], strip->length);
  }
  return grid;
}

/* The parts of a grid with their flat patterns. */
static inline lam_part *plane_parts(lam_arena *arena, const lam_lamella_grid *grid) {
  lam_part *parts = LAM_NEW(arena, lam_part, grid->strip_count);
  for (int i = 0; i < grid->strip_count; i++)
    parts[i] = (lam_part){.name = grid->strips[i].name,
                          .kind = "lamella",
                          .family = grid->strips[i].family,
                          .group = grid->strips[i].group,
                          .material = grid->material,
                          .length = grid->strips[i].length,
                          .flat = lam_lamella_flat(arena, grid, &grid->strips[i])};
  return parts;
}

#endif
