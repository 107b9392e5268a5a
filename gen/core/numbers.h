/* Constants that many files need, each once. Used in every folder. */
#ifndef LAM_CORE_NUMBERS_H
#define LAM_CORE_NUMBERS_H

#define LAM_PI 3.14159265358979323846
/* One degree in radians: 60 * LAM_DEGREE is an angle. */
#define LAM_DEGREE (LAM_PI / 180)
/* Degrees in a radian: angle * LAM_DEGREES_PER_RADIAN is a number for people. */
#define LAM_DEGREES_PER_RADIAN (180 / LAM_PI)

#endif
