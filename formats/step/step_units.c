/* Units of a STEP file (ISO 10303-41): SI units with prefixes, and units that are converted to
 * others. Called by step_read.c before the first geometry is read. */
#include "formats/step/step_reader.h"

enum { deepest_unit = 8 };

/* The size of an SI_UNIT with this name (".METRE.", ".RADIAN."), in meters or radians: that of
 * its prefix; 0 when the name is another one or the prefix is not known. Prefix and name are the
 * only items, or stand behind the dimensions where there are three. */
static double si_size(const lam_step_value *si, const char *si_name) {
  static const struct {
    const char *prefix;
    double size;
  } prefixes[] = {{".NANO.", 1e-9}, {".MICRO.", 1e-6}, {".MILLI.", 1e-3}, {".CENTI.", 1e-2},
                  {".DECI.", 1e-1}, {".DECA.", 1e1},   {".HECTO.", 1e2},  {".KILO.", 1e3}};
  int first = lam_step_has_items(si, 3) ? 1 : 0;
  const lam_step_value *prefix = lam_step_item(si, first), *name = lam_step_item(si, first + 1);
  if (!name || !lam_word_is(name->word, si_name)) return 0;

  if (prefix->type == LAM_STEP_NOTHING) return 1;
  for (size_t i = 0; i < sizeof prefixes / sizeof *prefixes; i++)
    if (lam_word_is(prefix->word, prefixes[i].prefix)) return prefixes[i].size;
  return 0;
}

/* The size of a unit in the SI unit of this name: of an SI unit, or of a CONVERSION_BASED_UNIT,
 * which is a number of another unit (an inch is 25.4 mm); 0 when it is none that is known. depth:
 * how many conversions led here. */
static double unit_size(const lam_step_reader *r, const lam_step_entity *entity,
                        const char *si_name, int depth) {
  const lam_step_value *si = lam_step_record(entity, "SI_UNIT");
  if (lam_step_item(si, 0)) return si_size(si, si_name);

  const lam_step_value *conversion = lam_step_record(entity, "CONVERSION_BASED_UNIT");
  const lam_step_value *measure = lam_step_typed(conversion, 1, LAM_STEP_REFERENCE);
  if (!measure || depth == deepest_unit) return 0;

  const lam_step_entity *with = lam_step_find(&r->tree, measure->entity);
  const lam_step_value *factor = lam_step_record(with, "LENGTH_MEASURE_WITH_UNIT");
  if (!factor) factor = lam_step_record(with, "PLANE_ANGLE_MEASURE_WITH_UNIT");
  if (!factor) factor = lam_step_record(with, "MEASURE_WITH_UNIT");

  const lam_step_value *number = lam_step_typed(lam_step_item(factor, 0), 0, LAM_STEP_NUMBER);
  const lam_step_value *base = lam_step_typed(factor, 1, LAM_STEP_REFERENCE);
  if (!number || !base) return 0;
  return number->number * unit_size(r, lam_step_find(&r->tree, base->entity), si_name, depth + 1);
}

/* Takes a unit that the geometry uses: the angle as it is, the length when it is known and the
 * only one. False with a message. */
static bool add_unit(lam_step_reader *r, const lam_step_entity *entity) {
  if (lam_step_record(entity, "PLANE_ANGLE_UNIT")) {
    double angle = unit_size(r, entity, ".RADIAN.", 0);
    if (angle > 0 && isfinite(angle)) r->angle = angle;
  }
  if (!lam_step_record(entity, "LENGTH_UNIT")) return true;

  double size = unit_size(r, entity, ".METRE.", 0);
  r->scan.location.line = entity->line;
  if (!(size > 0 && isfinite(size))) {
    lam_error_add(r->scan.errors, r->scan.location, NULL, "unit #%ld is no known unit of length",
                  entity->number);
    return false;
  }

  if (r->unit > 0 && r->unit != size) {
    lam_error_add(r->scan.errors, r->scan.location, NULL,
                  "two units of length, %g m and %g m; one expected", r->unit, size);
    return false;
  }

  r->unit = size;
  return true;
}

/* The units of all contexts together; an angle that is not given is in radians. */
bool lam_step_units(lam_step_reader *r) {
  r->angle = 1;
  for (int i = 0; i < r->tree.count; i++) {
    const lam_step_value *assigned =
        lam_step_record(&r->tree.entities[i], "GLOBAL_UNIT_ASSIGNED_CONTEXT");
    const lam_step_value *units = lam_step_item(assigned, 0);
    for (const lam_step_value *unit = units ? units->first : NULL; unit; unit = unit->next) {
      const lam_step_entity *entity = lam_step_find(&r->tree, unit->entity);
      if (entity && !add_unit(r, entity)) return false;
    }
  }

  if (r->unit > 0) return true;
  r->scan.location.line = 0;
  lam_error_add(r->scan.errors, r->scan.location, NULL, "names no unit of length");
  return false;
}
