/* How much memory there is: for what estimates its need before it begins (design/net_stage.c). */
#ifndef LAM_CORE_MEMORY_H
#define LAM_CORE_MEMORY_H

/* The bytes that this process may have at most: the memory of the machine, of the container, or the
 * limit of the shell (ulimit -v), whichever is least. Infinite when the system does not tell. */
double lam_memory_most(void);

#endif
