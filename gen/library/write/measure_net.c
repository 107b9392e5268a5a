/* Measuring nets from arrays, and drawing a measure as a color map. Called through lamella/net.h,
 * by cli/verb_measure.c. */
#include "core/file.h"
#include "core/numbers.h"
#include "library/session_state.h"
#include "library/write/write_map.h"
#include "net/measures/measure.h"
#include "net/measures/measure_map.h"
#include "net/net_kind.h"
#include <lamella/net.h>

#include <string.h>

static const lam_location nowhere;

/* The kind of net whose measures are asked for; NULL: none is, or there is no such kind, with a
 * message. */
static const lam_net_kind *kind_of(lam_session *session, const char *as) {
  const lam_row_head *head = as ? lam_registry_find(&lam_nets, as) : NULL;
  if (as && !head)
    lam_error_add(&session->errors, nowhere, "--as", "%s; expected a net of `lamella list nets`",
                  as);
  return (const lam_net_kind *)head;
}

/* Messages name the options of `lamella measure`, which are what a person gave. */
static lam_status check(lam_session *session, const lam_measure_task *task) {
  kind_of(session, task->as);
  if (!task->map || !lam_measure_named(task->map, true, nowhere, "--map", &session->errors))
    return LAM_OK;

  if (!lam_measure_map_check(task->map_path, &session->errors)) return LAM_OK;
  const char *const inputs[] = {task->name, task->reference_name};
  for (int i = 0; i < 2; i++)
    if (inputs[i] && lam_path_same(inputs[i], task->map_path))
      lam_error_add(&session->errors, nowhere, "-o",
                    "given %s, which is measured; expected another file for the map",
                    task->map_path);
  return LAM_OK;
}

/* Declared, as all functions of the face here, in include/lamella/net.h. */
lam_status lam_measure_task_check(lam_session *session, const lam_measure_task *task) {
  LAM_ENTER(session);
  return lam_session_leave(session, check(session, task));
}

/* What measures need beside the net, put into in. The reference's search tree is closed with the
 * session's memory. False with a message. */
static bool prepare(lam_session *session, const lam_measure_task *task, lam_measuring *in) {
  in->target_angle = task->angle > 0 ? task->angle : LAM_PI / 2;
  in->axis = task->axis;
  if (!task->reference) return true;

  lam_status status;
  lam_tree *tree = lam_tree_new(task->reference, &status);
  if (status == LAM_NO_MEMORY) lam_arena_exhausted(session->arena);
  if (!tree) {
    lam_error_add(&session->errors, nowhere, "--reference",
                  "the mesh cannot be searched; it has no valid triangle");
    return false;
  }
  lam_arena_defer(session->arena, lam_tree_free, tree);
  in->reference = tree;
  in->reference_mesh = task->reference;
  return true;
}

/* Draws the measure as the only map of a model, which has the name of the mesh without folder and
 * ending. */
static lam_status write_map(lam_session *session, const lam_measure_task *task,
                            const lam_measuring *in) {
  const char *path = task->name ? task->name : "net", *slash = strrchr(path, '/');
  const char *file = slash ? slash + 1 : path, *dot = strrchr(file, '.');
  int length = (int)(dot ? dot - file : (long)strlen(file));

  lam_map map = lam_net_map(in, lam_measure_find(task->map));
  lam_model model = {.name = lam_arena_printf(session->arena, "%.*s", length, file),
                     .net = &in->net->mesh,
                     .map_count = 1,
                     .maps = &map};
  return lam_measure_map_write(&model, task->map_path, &session->errors);
}

/* The map is drawn first: when it fails nothing is measured. */
static lam_status measure(lam_session *session, const lam_measure_task *task, lam_measured *out) {
  lam_arena *arena = session->arena;
  const lam_net_kind *kind = kind_of(session, task->as);
  lam_net *net = LAM_NEW(arena, lam_net, 1);

  check(session, task);
  if (session->errors.count ||
      !lam_net_build(arena, task->mesh, (lam_location){.file = task->name}, &session->errors, net))
    return LAM_OK;

  lam_measuring measuring = lam_measuring_of(arena, net, net->mesh.vertices);
  if (!prepare(session, task, &measuring)) return LAM_OK;
  if (task->map) {
    lam_status status = write_map(session, task, &measuring);
    if (status != LAM_OK) return status;
  }

  out->boundary_loops = net->loop_count;
  out->irregular_vertices = net->irregular_count;
  out->measures = lam_net_measure(&measuring, kind ? kind->measures : NULL, &out->measure_count);
  return LAM_OK;
}

/* All zero when something is wrong. */
lam_status lam_measure_net(lam_session *session, const lam_measure_task *task,
                           lam_measured *measured) {
  *measured = (lam_measured){0};
  LAM_ENTER(session);
  return lam_session_leave(session, measure(session, task, measured));
}
