/* The only file that includes Clipper. It works on integers: coordinates are rounded to
 * nanometers. Called by fab/flat/sheet.c through fab/flat/path_offset.h. */
#include "fab/flat/path_offset.h"

#include <cmath>
#include <new>
#include <polyclipping/clipper.hpp>

namespace {
const double units_per_meter = 1e9;
const double miter_limit = 4; /* corners down to 29 degrees stay sharp */

/* The polygon in nanometers, counterclockwise. */
ClipperLib::Path to_clipper(const lam_vec2 *points, int count) {
  ClipperLib::Path path;
  for (int i = 0; i < count; i++)
    path.emplace_back(std::llround(points[i].x * units_per_meter),
                      std::llround(points[i].y * units_per_meter));
  if (!ClipperLib::Orientation(path)) ClipperLib::ReversePath(path);
  return path;
}

/* The outlines of the polygon moved outward by distance (meters), with sharp corners; none or
 * several when it vanishes or falls apart. */
ClipperLib::Paths moved(const ClipperLib::Path &path, double distance) {
  ClipperLib::ClipperOffset offset(miter_limit);
  offset.AddPath(path, ClipperLib::jtMiter, ClipperLib::etClosedPolygon);
  ClipperLib::Paths result;
  offset.Execute(result, distance * units_per_meter);
  return result;
}

/* Moving back gives the polygon again, unless a slot closed up or a tongue vanished. Rounding
 * moves an edge by units, so areas may differ by a few units times the perimeter. */
bool can_be_undone(const ClipperLib::Path &path, const ClipperLib::Path &result, double distance) {
  ClipperLib::Paths back = moved(result, -distance);
  double length = 0;
  for (size_t i = 0; i < path.size(); i++) {
    const ClipperLib::IntPoint &a = path[i], &b = path[(i + 1) % path.size()];
    length += std::hypot(static_cast<double>(a.X - b.X), static_cast<double>(a.Y - b.Y));
  }

  return back.size() == 1 &&
         std::fabs(ClipperLib::Area(back[0]) - ClipperLib::Area(path)) <= 4 * length;
}
} // namespace

extern "C" lam_status lam_offset_polygon(const lam_vec2 *points, int count, double distance,
                                         lam_vec2 *result, int *result_count) {
  *result_count = 0;
  try {
    ClipperLib::Path original = to_clipper(points, count);
    ClipperLib::Paths paths = moved(original, distance);
    if (paths.size() != 1 || !can_be_undone(original, paths[0], distance)) return LAM_BAD_INPUT;

    const ClipperLib::Path &path = paths[0];
    if (path.size() > static_cast<size_t>(LAM_OFFSET_ROOM(count))) return LAM_FAILED;

    for (size_t i = 0; i < path.size(); i++)
      result[i] = {static_cast<double>(path[i].X) / units_per_meter,
                   static_cast<double>(path[i].Y) / units_per_meter};

    *result_count = static_cast<int>(path.size());
    return LAM_OK;
  } catch (const std::bad_alloc &) {
    return LAM_NO_MEMORY;
  } catch (...) {
    return LAM_FAILED;
  }
}
