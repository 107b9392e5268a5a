/* Reading input files. */
#ifndef LAM_CLI_INPUT_H
#define LAM_CLI_INPUT_H

#include "core/error.h"
#include <stdbool.h>
#include <stddef.h>

/* The content of a file, followed by a zero that is not counted, owned by arena. False, with a message at place, when
 * it cannot be read. key: what the message is about; may be NULL. */
bool lam_input_read(lam_arena *arena, const char *path, lam_place place, const char *key, lam_errors *errors,
                    char **bytes, size_t *count);

#endif
