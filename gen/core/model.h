/* The types of the model with the operations on vectors. The types are public and stand in
 * include/lamella/model.h: this file only points to them. Used in every folder. */
#ifndef LAM_CORE_MODEL_H
#define LAM_CORE_MODEL_H

#include "core/vec3.h"
#include <lamella/model.h>

#endif
