/* Comparing numbers in cmocka tests, whose own comparison rounds to float. NaN fails everywhere. */
#ifndef LAM_ASSERTS_H
#define LAM_ASSERTS_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* Fails with both values when they differ by more than the tolerance. */
#define assert_near(value, expected, tolerance)                                                    \
  do {                                                                                             \
    double value_ = (value), expected_ = (expected);                                               \
    if (!(fabs(value_ - expected_) <= (tolerance)))                                                \
      fail_msg("%s is %.17g, expected %.17g within %g", #value, value_, expected_,                 \
               (double)(tolerance));                                                               \
  } while (0)

/* The same with a text that says what the value is. */
static inline void assert_near_named(double value, double expected, double tolerance,
                                     const char *what) {
  if (!(fabs(value - expected) <= tolerance))
    fail_msg("%s: %.17g, expected %.17g within %g", what, value, expected, tolerance);
}

/* Fails when the value is above the limit. */
#define assert_below(value, limit)                                                                 \
  do {                                                                                             \
    double value_ = (value), limit_ = (limit);                                                     \
    if (!(value_ <= limit_)) fail_msg("%s is %.17g, expected at most %g", #value, value_, limit_); \
  } while (0)

#define ASSERT_EXACT(a, b) assert_true((a) == (b))

#endif
