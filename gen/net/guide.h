/* The schedule that nets far from their start share: fairness and closeness lead for seven
 * iterations and are gone. */
#ifndef LAM_NET_GUIDE_H
#define LAM_NET_GUIDE_H

#define LAM_GUIDED_SCHEDULE                                                                        \
  {                                                                                                \
    .fairness = .02, .hold = 3, .decay = .473, .floor = 9e-4, .tolerance = 1e-12,                  \
    .max_iterations = 100                                                                          \
  }
#define LAM_GUIDED_GUIDE                                                                           \
  { LAM_FAIR_POSITION, .3, 0 }

#endif
