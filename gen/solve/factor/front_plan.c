/* Fronts planned: their rows, where children's rows go, where values go, where everything lies.
 * Called by solve/factor.c. */
#include "solve/factor/front_plan.h"

#include <stdlib.h>
#include <string.h>

/* The nodes that a front updates, by position in the order, ascending. */
typedef struct rows {
  int *node, count;
} rows;

typedef struct planner {
  lam_arena *arena, *scratch;
  const lam_pattern *pattern;
  lam_nodes nodes;
  lam_supernodes super;
  rows *rows;    /* of every front */
  int *unknowns; /* nodes + 1: unknowns before the node at a position */
  int *front_of; /* the front of the node at a position */
  lam_plan plan;
} planner;

static int compare_int(const void *a, const void *b) {
  int x = *(const int *)a, y = *(const int *)b;
  return (x > y) - (x < y);
}

static int padded(int count) { return (count + LANES - 1) / LANES * LANES; }

/* ---- rows ---- */

/* A set of nodes under construction. */
typedef struct collection {
  int *mark, *node, count, stamp;
} collection;

static void collect(collection *c, int node) {
  if (c->mark[node] == c->stamp) return;
  c->mark[node] = c->stamp;
  c->node[c->count++] = node;
}

/* What front i updates: the neighbors of its nodes that come later, and what its children update
 * beyond it. */
static rows find_rows(planner *p, int i, collection *c) {
  int begin = p->super.first[i], end = p->super.first[i + 1];
  c->count = 0;
  c->stamp = i + 1;
  for (int k = begin; k < end; k++) {
    int v = p->nodes.order[k];
    for (int e = p->nodes.start[v]; e < p->nodes.start[v + 1]; e++) {
      int other = p->nodes.position[p->nodes.neighbor[e]];
      if (other >= end) collect(c, other);
    }
  }
  for (int q = p->plan.fronts[i].child; q >= 0; q = p->plan.fronts[q].sibling)
    for (int e = 0; e < p->rows[q].count; e++)
      if (p->rows[q].node[e] >= end) collect(c, p->rows[q].node[e]);

  rows r = {LAM_NEW(p->scratch, int, c->count), c->count};
  qsort(c->node, (size_t)c->count, sizeof(int), compare_int);
  if (c->count) memcpy(r.node, c->node, sizeof(int) * (size_t)c->count);
  return r;
}

static int unknowns_at(const planner *p, int position) {
  return p->unknowns[position + 1] - p->unknowns[position];
}

/* Fronts with their sizes, in the tree of the supernodes. */
static void make_fronts(planner *p) {
  int count = p->plan.count = p->super.count, n = p->nodes.count;
  lam_front *fronts = p->plan.fronts = LAM_NEW(p->arena, lam_front, count);
  for (int i = 0; i < count; i++) fronts[i].child = fronts[i].sibling = -1;
  for (int i = count - 1; i >= 0; i--) {
    int parent = fronts[i].parent = p->super.parent[i];
    if (parent < 0) continue;
    fronts[i].sibling = fronts[parent].child;
    fronts[parent].child = i;
  }

  collection c = {.mark = LAM_NEW(p->scratch, int, n), .node = LAM_NEW(p->scratch, int, n)};
  p->rows = LAM_NEW(p->scratch, rows, count);
  for (int i = 0; i < count; i++) {
    lam_front *f = &fronts[i];
    p->rows[i] = find_rows(p, i, &c);
    for (int e = 0; e < p->rows[i].count; e++) f->m += unknowns_at(p, p->rows[i].node[e]);
    f->first = p->unknowns[p->super.first[i]];
    f->k = p->unknowns[p->super.first[i + 1]] - f->first;
    f->kp = padded(f->k);
    f->mp = padded(f->m);
  }
}

/* ---- where children's rows and values go ---- */

/* The row of the panel at which the node at a position begins, for the nodes of front i. */
static void find_places(const planner *p, int i, int *place) {
  int at = 0;
  for (int k = p->super.first[i]; k < p->super.first[i + 1]; k++) {
    place[k] = at;
    at += unknowns_at(p, k);
  }
  at = p->plan.fronts[i].kp;
  for (int e = 0; e < p->rows[i].count; e++) {
    place[p->rows[i].node[e]] = at;
    at += unknowns_at(p, p->rows[i].node[e]);
  }
}

/* The rows of front i in its parent, whose places are given, as few runs; runs end where pivots do.
 * Written from *count on; with runs NULL they are only counted. */
static void list_runs(const planner *p, int i, const int *place, lam_run *runs, int *count) {
  lam_front *f = &p->plan.fronts[i];
  int pivots = p->plan.fronts[f->parent].k, from = 0;
  lam_run run = {0};
  for (int e = 0; e < p->rows[i].count; e++) {
    int to = place[p->rows[i].node[e]], size = unknowns_at(p, p->rows[i].node[e]);
    bool continues = run.count && run.to + run.count == to && (run.to < pivots) == (to < pivots);
    if (!continues) {
      run = (lam_run){from, to, 0};
      ++*count;
    }
    run.count += size;
    from += size;
    if (runs) runs[*count - 1] = run;
    if (to < pivots) f->entering = from;
  }
}

/* Runs of all fronts: pass 0 counts, pass 1 writes. */
static void plan_runs(planner *p) {
  int *place = LAM_NEW(p->scratch, int, p->nodes.count);
  for (int pass = 0, count = 0; pass < 2; pass++) {
    if (pass) p->plan.runs = LAM_NEW(p->arena, lam_run, count);
    count = 0;
    for (int i = 0; i < p->plan.count; i++) {
      find_places(p, i, place);
      for (int q = p->plan.fronts[i].child; q >= 0; q = p->plan.fronts[q].sibling) {
        p->plan.fronts[q].run = count;
        list_runs(p, q, place, p->plan.runs, &count);
        p->plan.fronts[q].run_end = count;
      }
    }
  }
}

/* A piece of a column before its front has places: the unknowns of its first value. */
typedef struct raw_piece {
  int value, row, column, count, next;
} raw_piece;

/* Pieces as chains per front: those down columns, those along rows. */
typedef struct raw_pieces {
  raw_piece *list;
  int count, *chain[2];
} raw_pieces;

/* Cuts columns where the node of the row changes. Of two nodes the one eliminated first has the
 * piece in its front: as a column of it where the matrix' column is, along a row otherwise. Goes
 * backward, so that chains ascend. */
static raw_pieces cut_columns(const planner *p) {
  const lam_pattern *m = p->pattern;
  const lam_nodes *nodes = &p->nodes;
  raw_pieces raw = {.list = LAM_NEW(p->scratch, raw_piece, m->start[m->n])};
  for (int across = 0; across < 2; across++) {
    raw.chain[across] = LAM_NEW(p->scratch, int, p->plan.count);
    for (int i = 0; i < p->plan.count; i++) raw.chain[across][i] = -1;
  }
  for (int c = m->n - 1; c >= 0; c--)
    for (int end = m->start[c + 1]; end > m->start[c];) {
      int node = nodes->of[m->row[end - 1]], begin = end - 1;
      while (begin > m->start[c] && nodes->of[m->row[begin - 1]] == node) begin--;

      int row_at = nodes->position[node], column_at = nodes->position[nodes->of[c]];
      int across = row_at < column_at;
      int *head = &raw.chain[across][p->front_of[across ? row_at : column_at]];
      raw.list[raw.count] = (raw_piece){begin, m->row[begin], c, end - begin, *head};
      *head = raw.count++;
      end = begin;
    }
  return raw;
}

/* The row of the panel that an unknown has, with the places of its front. */
static int place_of(const planner *p, const int *place, int unknown) {
  int node = p->nodes.of[unknown];
  return place[p->nodes.position[node]] + unknown - p->nodes.first[node];
}

static void plan_pieces(planner *p) {
  raw_pieces raw = cut_columns(p);
  int *place = LAM_NEW(p->scratch, int, p->nodes.count), count = 0;
  p->plan.pieces = LAM_NEW(p->arena, lam_piece, raw.count);
  for (int i = 0; i < p->plan.count; i++) {
    lam_front *f = &p->plan.fronts[i];
    find_places(p, i, place);
    f->piece = count;
    for (int across = 0; across < 2; across++) {
      if (across) f->piece_across = count;
      for (int q = raw.chain[across][i]; q >= 0; q = raw.list[q].next) {
        const raw_piece *r = &raw.list[q];
        int row = place_of(p, place, r->row), column = place_of(p, place, r->column);
        p->plan.pieces[count++] = (lam_piece){r->value, across ? column : row,
                                              across ? row : column, r->count};
      }
    }
    f->piece_end = count;
  }
}

/* ---- memory ---- */

/* Update matrices that live at the same time: ascending ranges. */
typedef struct range {
  size_t begin, end;
  int front;
} range;

/* First fit: room for a matrix of this size among those that live. */
static size_t take(range *live, int *count, size_t size, int front) {
  size_t at = 0;
  int q = 0;
  for (; q < *count && live[q].begin < at + size; q++) at = live[q].end;
  memmove(live + q + 1, live + q, sizeof *live * (size_t)(*count - q));
  live[q] = (range){at, at + size, front};
  ++*count;
  return at;
}

static void give_back(range *live, int *count, int parent, const lam_front *fronts) {
  int kept = 0;
  for (int q = 0; q < *count; q++)
    if (fronts[live[q].front].parent != parent) live[kept++] = live[q];
  *count = kept;
}

/* Where factors and update matrices lie. A front's own is taken before its children's are given
 * back. */
static void plan_memory(planner *p) {
  lam_plan *plan = &p->plan;
  range *live = LAM_NEW(p->scratch, range, plan->count + 1);
  int count = 0;
  for (int i = 0; i < plan->count; i++) {
    lam_front *f = &plan->fronts[i];
    f->factor = plan->factor_size;
    plan->factor_size += (lam_factor_size(f) + LANES - 1) / LANES * LANES;
    size_t panel = lam_panel_rows(f) * (size_t)f->k;
    if (panel > plan->panel_size) plan->panel_size = panel;
    if (f->kp > plan->most_pivots) plan->most_pivots = f->kp;
    for (int c = 0; c < f->k; c++)
      plan->flops += (double)(f->k - c + f->m) * (double)(f->k - c + f->m);

    if (f->m) {
      size_t size = (lam_update_size(f) + LANES - 1) / LANES * LANES;
      f->update = take(live, &count, size, i);
      if (f->update + size > plan->update_size) plan->update_size = f->update + size;
    }
    if (f->child >= 0) give_back(live, &count, i, plan->fronts);
  }
}

/* Where the nodes of the order stand in the vectors, and in which front. */
static void number_unknowns(planner *p) {
  int n = p->nodes.count, count = 0;
  p->unknowns = LAM_NEW(p->scratch, int, n + 1);
  p->front_of = LAM_NEW(p->scratch, int, n);
  p->plan.unknown = LAM_NEW(p->arena, int, p->plan.n);
  for (int k = 0; k < n; k++) {
    int v = p->nodes.order[k];
    p->unknowns[k] = count;
    for (int c = p->nodes.first[v]; c < p->nodes.first[v + 1]; c++) p->plan.unknown[count++] = c;
  }
  p->unknowns[n] = count;
  for (int i = 0; i < p->super.count; i++)
    for (int k = p->super.first[i]; k < p->super.first[i + 1]; k++) p->front_of[k] = i;
}

lam_plan lam_plan_make(lam_arena *arena, lam_arena *scratch, const lam_pattern *pattern) {
  planner p = {.arena = arena, .scratch = scratch, .pattern = pattern, .plan.n = pattern->n};
  p.nodes = lam_nodes_find(scratch, pattern);
  lam_forest forest = lam_forest_grow(scratch, &p.nodes);
  p.super = lam_supernodes_merge(scratch, &p.nodes, &forest);

  number_unknowns(&p);
  make_fronts(&p);
  plan_runs(&p);
  plan_pieces(&p);
  plan_memory(&p);
  return p.plan;
}
