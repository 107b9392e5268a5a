/* Solving nets from arrays: the design of a net alone, with the arrays in place of its files.
 * Called through lamella/net.h. */
#include "design/pipeline.h"
#include "formats/in_place.h"
#include "library/sources.h"
#include <lamella/net.h>

#include <string.h>

/* A design of nothing but the net. It starts from a file, whose name nobody opens: the pipeline
 * takes the mesh of its inputs for it. False with messages. */
static bool parse_net(lam_session *session, const char *keys, lam_design *design) {
  const char *text = lam_arena_printf(session->arena, "{lamella: 1, name: net, net: %s}", keys);
  static const char *const overrides[] = {"net.from={file: arrays}"};
  lam_design_source source = {
      .text = text, .length = strlen(text), .override_count = 1, .overrides = overrides};
  return lam_source_parse(session, &source, design);
}

/* What the report says of the net, which is the only stage of such a design. */
static void take_result(const lam_model *model, lam_net_solution *solution) {
  const lam_stage *stage = &model->report->stages[0];
  *solution = (lam_net_solution){.converged = stage->converged,
                                 .reason = stage->reason,
                                 .iterations = stage->iterations,
                                 .residual = stage->residual,
                                 .mesh = *model->net,
                                 .polyline_count = model->polyline_count,
                                 .polylines = model->polylines,
                                 .measure_count = stage->measure_count,
                                 .measures = stage->measures};
}

/* The solution stays empty when the keys or the mesh are wrong. */
static lam_status solve(lam_session *session, const lam_net_task *task,
                        lam_net_solution *solution) {
  lam_design *design = LAM_NEW(session->arena, lam_design, 1);
  lam_model *model = LAM_NEW(session->arena, lam_model, 1);
  lam_inputs inputs = {.net = &task->start, .reference = task->reference};
  if (!parse_net(session, task->net, design)) return LAM_OK;

  if (lam_pipeline_run(session->arena, design, &inputs, &session->progress, &session->errors,
                       model))
    take_result(lam_model_in_place(session->arena, model), solution);
  return LAM_OK;
}

/* Declared in include/lamella/net.h. */
lam_status lam_net_solve(lam_session *session, const lam_net_task *task,
                         lam_net_solution *solution) {
  *solution = (lam_net_solution){0};
  LAM_ENTER(session);
  return lam_session_leave(session, solve(session, task, solution));
}
