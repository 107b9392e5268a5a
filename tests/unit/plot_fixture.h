/* What tests of plots share: colors and pieces of the drawings as they are expected. The colors are
 * those of core/ramp.h, computed apart from Ottosson's formulas and the curve of IEC 61966-2-1. */
#ifndef LAM_TESTS_PLOT_FIXTURE_H
#define LAM_TESTS_PLOT_FIXTURE_H

#include "formats/plot/plot.h"
#include "tests/unit/text_fixture.h"

/* The sequential scale at its ends, its quarters and its middle, and what is undefined. */
#define LOW "#321556"
#define QUARTER "#0b5493"
#define MIDDLE "#00929b"
#define THREE "#58cc84"
#define HIGH "#f5ea5c"
#define GRAY "#dadada"

/* Texts, lines, bars with the samples of their colors below; how a histogram begins. */
#define TEXT(x, y, size, anchor, text)                                                             \
  "<text x=\"" x "\" y=\"" y "\" font-size=\"" size "\" text-anchor=\"" anchor "\">" text          \
  "</text>\n"
#define LINE(class, x1, y1, x2, y2)                                                                \
  "<line class=\"" class "\" x1=\"" x1 "\" y1=\"" y1 "\" x2=\"" x2 "\" y2=\"" y2 "\"/>\n"
#define BAR(x, y, width, height, color, title)                                                     \
  "<rect class=\"bin\" x=\"" x "\" y=\"" y "\" width=\"" width "\" height=\"" height               \
  "\" fill=\"" color "\"><title>" title "</title></rect>\n"
#define SAMPLE(x, y, width, color)                                                                 \
  "<rect class=\"color\" x=\"" x "\" y=\"" y "\" width=\"" width "\" height=\"2\" fill=\"" color   \
  "\"/>\n"
#define BEGIN                                                                                      \
  "<g class=\"histogram\">\n<style>.axis { stroke: #202020; stroke-width: .2 } .grid { stroke: "   \
  "#d0d0d0; stroke-width: .12 } .mean { stroke: #202020; stroke-width: .3; stroke-dasharray: "     \
  "1 .7 } .bin { stroke: #202020; stroke-width: .1 } .color { shape-rendering: crispEdges "        \
  "}</style>\n"

#endif
