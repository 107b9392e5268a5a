/* Measures as color maps, and lists of measures that a person gives. Used by
 * design/pipeline_run.c, library/sources.c and cli/verb_measure.c. */
#ifndef LAM_NET_MEASURES_MEASURE_MAP_H
#define LAM_NET_MEASURES_MEASURE_MAP_H

#include "core/key.h"
#include "net/measures/measure.h"

/* Checks a name that was given at location under key. An unknown one is added to errors, and with
 * mapped a measure with one value for the whole net. Returns the measure, or NULL. */
const lam_measure_kind *lam_measure_named(const char *name, bool mapped, lam_location location,
                                          const char *key, lam_errors *errors);
/* The same for a list of const char *. */
void lam_measures_check(const lam_list *names, bool mapped, lam_location location, const char *key,
                        lam_errors *errors);

/* The map of a measure on vertices, edges or faces, in in->arena. Precondition: kind->on
 * is not LAM_ON_NET. */
lam_map lam_net_map(const lam_measuring *in, const lam_measure_kind *kind);
/* The maps of several measures, names->count of them, in in->arena; those with the same scale
 * (layout.h) get one range. Precondition: lam_measures_check finds nothing wrong with names. */
lam_map *lam_net_maps(const lam_measuring *in, const lam_list *names);

#endif
