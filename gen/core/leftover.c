/* A table of fixed places, filled and emptied without a lock, so that a signal handler can read it
 * at any moment. Called by core/process.c, core/file.c and library/. */
#include "core/leftover.h"

#include <errno.h>
#include <limits.h>
#include <signal.h>
#include <stdatomic.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { places = 64 };

/* A place is taken before it is filled, and is seen by a handler when it is filled. */
typedef enum state { empty, taken, program, file } state;

typedef struct leftover {
  atomic_int state;
  pid_t group;         /* program */
  int folder;          /* file: name is in it */
  char name[PATH_MAX]; /* file */
} leftover;

static leftover table[places];

/* The first empty place, which is taken; -1: there is none. */
static int take_place(void) {
  for (int i = 0; i < places; i++) {
    int expected = empty;
    if (atomic_compare_exchange_strong(&table[i].state, &expected, taken)) return i;
  }
  return -1;
}

int lam_leftover_program(pid_t group) {
  int place = take_place();
  if (place < 0) return -1;
  table[place].group = group;
  atomic_store(&table[place].state, program);
  return place;
}

int lam_leftover_file(int folder, const char *name) {
  size_t length = strlen(name) + 1;
  int place = length <= PATH_MAX ? take_place() : -1;
  if (place < 0) return -1;

  table[place].folder = folder;
  memcpy(table[place].name, name, length);
  atomic_store(&table[place].state, file);
  return place;
}

void lam_leftover_forget(int place) {
  if (place >= 0) atomic_store(&table[place].state, empty);
}

/* Programs first: one that still runs could write its file anew. */
void lam_leftovers_end(void) {
  for (int i = 0; i < places; i++) {
    if (atomic_load(&table[i].state) != program) continue;
    kill(-table[i].group, SIGKILL);
    while (waitpid(table[i].group, NULL, 0) < 0 && errno == EINTR) continue;
  }

  for (int i = 0; i < places; i++)
    if (atomic_load(&table[i].state) == file) unlinkat(table[i].folder, table[i].name, 0);
}
