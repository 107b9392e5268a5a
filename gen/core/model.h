/* The model's types are public: this only points to them. */
#ifndef LAM_CORE_MODEL_H
#define LAM_CORE_MODEL_H

#include "core/vec3.h"
#include <lamella/model.h>

#endif
