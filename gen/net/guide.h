/* Schedules and guides that several kinds of nets share, as initializers of lam_schedule and
 * lam_guide. Used by the files of net/kinds. */
#ifndef LAM_NET_GUIDE_H
#define LAM_NET_GUIDE_H

/* For nets that begin far from a solution: fairness and the guide lead for seven iterations (the
 * weight stays .02 for three and falls below .0009 in four more), then they are gone. */
#define LAM_GUIDED_SCHEDULE                                                                        \
  {                                                                                                \
    .fairness = .02, .hold = 3, .decay = .473, .floor = 9e-4, .tolerance = 1e-12,                  \
    .max_iterations = 100                                                                          \
  }

/* For nets that begin near a solution: no fairness, unless the design asks for it; it is halved
 * in every iteration then. */
#define LAM_UNGUIDED_SCHEDULE                                                                      \
  {                                                                                                \
    .fairness = 0, .hold = 0, .decay = .5, .floor = 1e-3, .tolerance = 1e-12,                      \
    .max_iterations = 100                                                                          \
  }

/* Fairness of positions, and closeness to the start that keeps it from flattening the net. */
#define LAM_GUIDED_GUIDE                                                                           \
  { LAM_FAIR_POSITION, .3, 0 }

#endif
