/* A table of a net's edges by their ends, which the tracing of lines (net_lines.c) and subdivision
 * (subdivide.c) look edges up in. */
#include "mesh/edge_table.h"

static int low_end(const lam_edge *e) {
  return e->vertex[0] < e->vertex[1] ? e->vertex[0] : e->vertex[1];
}

/* Counting sort of the edges by their lower end. */
lam_edge_table lam_edge_table_new(lam_arena *arena, const lam_net *net) {
  int n = net->mesh.vertex_count;
  lam_edge_table table = {net, LAM_NEW(arena, int, n + 1), LAM_NEW(arena, int, net->edge_count)};
  for (int e = 0; e < net->edge_count; e++) table.first[low_end(&net->edges[e]) + 1]++;
  for (int v = 0; v < n; v++) table.first[v + 1] += table.first[v];

  int *fill = LAM_NEW(arena, int, n);
  for (int e = 0; e < net->edge_count; e++) {
    int low = low_end(&net->edges[e]);
    table.list[table.first[low] + fill[low]++] = e;
  }
  return table;
}

/* Valences are small: the list of the lower end is searched. */
int lam_edge_table_find(const lam_edge_table *table, int a, int b) {
  int low = a < b ? a : b;
  for (int i = table->first[low]; i < table->first[low + 1]; i++)
    if (lam_edge_joins(&table->net->edges[table->list[i]], a, b)) return table->list[i];
  return -1;
}
