#include "cli/verb_run.h"
#include "cli/complain.h"

int lam_verb_run(int (*verb)(lam_arena *arena, int argc, char **argv), int argc, char **argv) {
  lam_arena *arena = lam_arena_new();
  volatile int status = 1;
  if (arena && LAM_ARENA_TRY(arena))
    status = verb(arena, argc, argv);
  else
    lam_complain_plain(1, "out of memory");
  lam_arena_free(arena);
  return status;
}
