/* Limits of memory as Linux tells them. Called by design/net_stage.c. */
#include "core/memory.h"

#include <fcntl.h>
#include <math.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <unistd.h>

/* The limit of the container; infinite when there is none ("max") or no such file. */
static double container_limit(void) {
  char text[32] = "";
  int file = open("/sys/fs/cgroup/memory.max", O_RDONLY | O_CLOEXEC);
  if (file < 0) return INFINITY;
  ssize_t count = read(file, text, sizeof text - 1);
  close(file);

  double bytes = count > 0 ? strtod(text, NULL) : 0;
  return bytes > 0 ? bytes : INFINITY;
}

double lam_memory_most(void) {
  double most = container_limit();
  long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
  if (pages > 0 && size > 0) most = fmin(most, (double)pages * (double)size);

  struct rlimit limit;
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    most = fmin(most, (double)limit.rlim_cur);
  return most;
}
