/* Reads the keys `points`, `file`, `unit` and `weights` of surfaces over listed points. Called
 * by surf/kinds (interpolation, approximation, nurbs), by sides_keys.c and by
 * surf/area/least_area.c. */
#include "surf/spline/point_keys.h"

/* Three numbers a point, scaled to meters. */
lam_vec3 *lam_points_read(lam_arena *arena, const lam_list *list, int unit) {
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, list->count / 3);
  const double *x = list->items, meters = lam_point_unit(unit);
  for (int i = 0; i < list->count / 3; i++)
    points[i] = lam_scale(lam_v3(x[3 * i], x[3 * i + 1], x[3 * i + 2]), meters);
  return points;
}

/* Fits take seconds with so many points. */
enum { most_points = 100000 };

/* The points of the file, in meters; NULL with a message at `file`. */
static const lam_vec3 *from_file(lam_arena *arena, const lam_point_keys *keys, int least,
                                 lam_location location, lam_errors *errors, int *count) {
  const lam_point_file *cloud = &keys->cloud;
  if (!cloud->points) {
    lam_error_add(errors, location, "file", "%s cannot be read: this caller loads no files",
                  cloud->file);
    return NULL;
  }

  if (cloud->count < least) {
    lam_error_add(errors, location, "file", "%s has %d points; expected %d or more", cloud->file,
                  cloud->count, least);
    return NULL;
  }

  if (cloud->count > most_points) {
    lam_error_add(errors, location, "file",
                  "%s has %d points; expected at most %d: every %d-th of them will do", cloud->file,
                  cloud->count, most_points, (cloud->count - 1) / most_points + 1);
    return NULL;
  }

  lam_vec3 *points = LAM_NEW(arena, lam_vec3, cloud->count);
  for (int i = 0; i < cloud->count; i++)
    points[i] = lam_scale(cloud->points[i], lam_point_unit(keys->unit));
  *count = cloud->count;
  return points;
}

/* The file goes before the list: a design that names a file leaves the default list standing. */
const lam_vec3 *lam_points_given(lam_arena *arena, const lam_point_keys *keys, int least,
                                 lam_location location, lam_errors *errors, int *count) {
  int given = keys->list.count;
  if (keys->cloud.file) return from_file(arena, keys, least, location, errors, count);

  if (given % 3 || given < 3 * least) {
    lam_error_add(errors, location, "points",
                  "%d numbers given; expected x, y and z of %d points or more", given, least);
    return NULL;
  }

  *count = given / 3;
  return lam_points_read(arena, &keys->list, keys->unit);
}

/* Stops at the first weight that is not positive; NaN is none. */
bool lam_weights_check(const lam_list *weights, const char *key, lam_location location,
                       lam_errors *errors) {
  const double *w = weights->items;
  for (int i = 0; i < weights->count; i++)
    if (!(w[i] > 0)) {
      lam_error_add(errors, location, key, "weight %d is %g; expected a positive number", i + 1,
                    w[i]);
      return false;
    }
  return true;
}
