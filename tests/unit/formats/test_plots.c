/* Color maps as drawings, from nets that stand in front of the viewer: what is expected on the page
 * follows by hand. */
#include "tests/unit/plot_fixture.h"

static const lam_color_scale unit_scale = {0, 1, false, false};

/* ---- points in front of the viewer ---- */

/* The viewer stands at an azimuth of -55 and an elevation of 32 degrees: sin 55 = .819..., cos 55 =
 * .573..., sin 32 = .529..., cos 32 = .848.... Right is (sin 55, cos 55, 0); up and towards the
 * viewer are the products of these. A point so far to the right, down, and nearer. */
static lam_vec3 seen(double x, double y, double nearer) {
  const lam_vec3 right = {0.8191520442889918, 0.5735764363510462, 0},
                 up = {-0.3039492031326501, 0.4340844486047482, 0.848048096156426},
                 to = {0.4864204048476921, -0.6946803316219238, 0.5299192642332049};
  return lam_along(lam_along(lam_scale(right, x), -y, up), nearer, to);
}

/* ---- the view ---- */

#define GROUP(class, line, edge)                                                                   \
  "<g class=\"" class "\" stroke-linejoin=\"round\" stroke-width=\"" line "\">\n"                  \
                      "<style>.line { fill: none; stroke: #202020; stroke-opacity: .55 } .edge { " \
                      "fill: none; "                                                               \
                      "stroke-linecap: round; stroke-width: " edge " }</style>\n"
#define FILL(data, color) "<path d=\"" data " Z\" fill=\"" color "\" stroke=\"" color "\"/>\n"
#define OUTLINE(data) "<path d=\"" data " Z\" class=\"line\"/>\n"
#define FACE(data, color) FILL(data, color) OUTLINE(data)
#define WHITE(data) "<path d=\"" data " Z\" fill=\"#ffffff\" stroke=\"none\"/>\n"
#define EDGE(data, color) "<path d=\"" data "\" class=\"edge\" stroke=\"" color "\"/>\n"

static const char *view_of(lam_arena *arena, const lam_mesh *net, const lam_map *map, lam_box box) {
  lam_text out = {.arena = arena};
  lam_plot_view(&out, net, map, &unit_scale, box);
  return out.data;
}

/* Three faces of 1 m beside each other, 4 m x 1 m with a gap: 25 mm a meter in a box of 100 mm x 80
 * mm, its middle at (60, 60). The middle face is nearest and the last one farthest. */
static void nearer_faces_cover_farther_ones(void **state) {
  lam_vec3 vertices[12];
  static const double left[] = {0, 1, 3}, depth[] = {0, 2, -1};
  int faces[3][4];
  for (int f = 0; f < 3; f++)
    for (int k = 0; k < 4; k++) {
      static const double x[] = {0, 1, 1, 0}, y[] = {1, 1, 0, 0};
      vertices[4 * f + k] = seen(5 + left[f] + x[k], 3 + y[k], depth[f]);
      faces[f][k] = 4 * f + k;
    }
  const lam_mesh net = {12, vertices, 3, faces};
  const double values[] = {0, .5, 1};
  const lam_map map = {.on = LAM_MAP_FACES, .count = 3, .values = values};
  const char *const expected[] = {
      GROUP("view", "0.12", "0.48"),
      FACE("M85,72.5 L110,72.5 110,47.5 85,47.5", HIGH),
      FACE("M10,72.5 L35,72.5 35,47.5 10,47.5", LOW),
      FACE("M35,72.5 L60,72.5 60,47.5 35,47.5", MIDDLE),
      "</g>\n",
      NULL,
  };
  assert_pieces(*state, "view", view_of(*state, &net, &map, (lam_box){10, 20, 100, 80}), expected);
}

/* Faces at one distance, here four times the same, are drawn in their order. The height fits: 2 m
 * in 4 mm. Thin lines are .03 of the root of the area per face, 16 mm2 / 4: .06 mm. */
static void equal_faces_keep_their_order(void **state) {
  lam_vec3 vertices[] = {seen(0, 2, 0), seen(1, 2, 0), seen(1, 0, 0), seen(0, 0, 0)};
  int faces[][4] = {{0, 1, 2, 3}, {0, 1, 2, 3}, {0, 1, 2, 3}, {0, 1, 2, 3}};
  const lam_mesh net = {4, vertices, 4, faces};
  const double values[] = {.25, 0, NAN, .75};
  const lam_map map = {.on = LAM_MAP_FACES, .count = 4, .values = values};
#define SQUARE "M1,4 L3,4 3,0 1,0"
  const char *const expected[] = {
      GROUP("view", "0.06", "0.24"),
      FACE(SQUARE, QUARTER),
      FACE(SQUARE, LOW),
      FACE(SQUARE, GRAY),
      FACE(SQUARE, THREE),
      "</g>\n",
      NULL,
  };
  assert_pieces(*state, "view", view_of(*state, &net, &map, (lam_box){0, 0, 4, 4}), expected);
}

/* A face of four unlike sides, 10 mm a meter: each vertex colors the quarter between the middles of
 * its edges and the middle of the face. */
static void a_vertex_colors_its_quarter(void **state) {
  lam_vec3 vertices[] = {seen(0, 3, 0), seen(4, 2, 0), seen(3, 0, 0), seen(1, 1, 0)};
  int faces[][4] = {{0, 1, 2, 3}};
  const lam_mesh net = {4, vertices, 1, faces};
  const double values[] = {0, .25, .5, 1};
  const lam_map map = {.on = LAM_MAP_VERTICES, .count = 4, .values = values};
  const char *const expected[] = {
      GROUP("view", "0.12", "0.48"),
      FILL("M0,30 L20,25 20,15 5,20", LOW),
      FILL("M40,20 L35,10 20,15 20,25", QUARTER),
      FILL("M30,0 L20,5 20,15 35,10", MIDDLE),
      FILL("M10,10 L5,20 20,15 20,5", HIGH),
      OUTLINE("M0,30 L40,20 30,0 10,10"),
      "</g>\n",
      NULL,
  };
  assert_pieces(*state, "view", view_of(*state, &net, &map, (lam_box){0, 0, 40, 30}), expected);
}

/* Edges in any direction and order; edges 0 and 3 begin at one vertex. Edge 2-3 is not in the map:
 * gray. */
static void an_edge_has_its_own_line(void **state) {
  lam_vec3 vertices[] = {seen(0, 2, 0), seen(2, 2, 0), seen(2, 0, 0), seen(0, 0, 0)};
  int faces[][4] = {{0, 1, 2, 3}};
  const lam_mesh net = {4, vertices, 1, faces};
  const double values[] = {1, 0, .5};
  const int edges[][2] = {{1, 0}, {2, 1}, {0, 3}};
  const lam_map map = {.on = LAM_MAP_EDGES, .count = 3, .values = values, .edges = edges};
  const char *const expected[] = {
      GROUP("view", "0.12", "0.48"),
      WHITE("M10,30 L30,30 30,10 10,10"),
      EDGE("M10,30 L30,30", HIGH),
      EDGE("M30,30 L30,10", LOW),
      EDGE("M30,10 L10,10", GRAY),
      EDGE("M10,10 L10,30", MIDDLE),
      "</g>\n",
      NULL,
  };
  assert_pieces(*state, "view", view_of(*state, &net, &map, (lam_box){10, 10, 20, 20}), expected);
}

/* Net and layout have half of the width each, 6 mm between them, here 47 mm: 10 to 57 and 63 to
 * 110. The layout, 4.7 m wide, fits at 10 mm a meter, the net of 1 m would at 47: both are drawn at
 * 10, in the middle of their halves. Seen from above, y is up. */
static void a_layout_stands_beside_the_net(void **state) {
  lam_vec3 vertices[] = {seen(0, 1, 0), seen(1, 1, 0), seen(1, 0, 0), seen(0, 0, 0)};
  int faces[][4] = {{0, 1, 2, 3}};
  const lam_mesh net = {4, vertices, 1, faces};
  const double values[] = {.5};
  const lam_vec2 layout[] = {{0, 0}, {4.7, 0}, {4.7, 1}, {0, 2}};
  const lam_map map = {.on = LAM_MAP_FACES, .count = 1, .values = values, .layout = layout};
  const char *const expected[] = {
      GROUP("layout", "0.12", "0.48"),
      FACE("M63,70 L110,70 110,60 63,50", MIDDLE),
      "</g>\n",
      GROUP("view", "0.12", "0.48"),
      FACE("M28.5,65 L38.5,65 38.5,55 28.5,55", MIDDLE),
      "</g>\n",
      NULL,
  };
  assert_pieces(*state, "view", view_of(*state, &net, &map, (lam_box){10, 20, 100, 80}), expected);
}

/* The net is the larger one: 4.7 m wide at 10 mm a meter, the layout of 1 m as well. */
static void a_small_layout_is_not_enlarged(void **state) {
  lam_vec3 vertices[] = {seen(0, 1, 0), seen(4.7, 1, 0), seen(4.7, 0, 0), seen(0, 0, 0)};
  int faces[][4] = {{0, 1, 2, 3}};
  const lam_mesh net = {4, vertices, 1, faces};
  const double values[] = {.5};
  const lam_vec2 layout[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const lam_map map = {.on = LAM_MAP_FACES, .count = 1, .values = values, .layout = layout};
  const char *text = view_of(*state, &net, &map, (lam_box){10, 20, 100, 80});
  assert_holds(text, FACE("M81.5,65 L91.5,65 91.5,55 81.5,55", MIDDLE));
  assert_holds(text, FACE("M10,65 L57,65 57,55 10,55", MIDDLE));
}

/* A coordinate that is not a number stands at 0, and does not move the others: the layout's half of
 * 47 mm x 80 mm is in the middle of 1 m, at 47 mm a meter. */
static void what_is_no_number_stands_at_zero(void **state) {
  lam_vec3 vertices[] = {seen(0, 1, 0), seen(1, 1, 0), seen(1, 0, 0), seen(0, 0, 0)};
  int faces[][4] = {{0, 1, 2, 3}};
  const lam_mesh net = {4, vertices, 1, faces};
  const double values[] = {.5};
  const lam_vec2 layout[] = {{NAN, 0}, {1, NAN}, {1, 1}, {0, 1}};
  const lam_map map = {.on = LAM_MAP_FACES, .count = 1, .values = values, .layout = layout};
  assert_holds(view_of(*state, &net, &map, (lam_box){10, 20, 100, 80}),
               FACE("M0,83.5 L110,0 110,36.5 63,36.5", MIDDLE));
}

/* A net without extent, and one without faces: all is in the middle of the box, no division by 0;
 * .03 of 2 mm for the lines. */
static void a_point_stands_in_the_middle(void **state) {
  lam_vec3 vertices[4] = {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
  int faces[][4] = {{0, 1, 2, 3}};
  const double values[] = {.5};
  const lam_map map = {.on = LAM_MAP_FACES, .count = 1, .values = values};
  lam_mesh net = {4, vertices, 1, faces};
  assert_lines("a point", view_of(*state, &net, &map, (lam_box){1, 3, 2, 2}),
               GROUP("view", "0.06", "0.24") FACE("M2,4 L2,4 2,4 2,4", MIDDLE) "</g>\n");
  net.face_count = 0;
  assert_lines("no face", view_of(*state, &net, &map, (lam_box){1, 3, 2, 2}),
               GROUP("view", "0.06", "0.24") "</g>\n");
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEXT_TEST(nearer_faces_cover_farther_ones),  TEXT_TEST(equal_faces_keep_their_order),
      TEXT_TEST(a_vertex_colors_its_quarter),      TEXT_TEST(an_edge_has_its_own_line),
      TEXT_TEST(a_layout_stands_beside_the_net),   TEXT_TEST(a_small_layout_is_not_enlarged),
      TEXT_TEST(what_is_no_number_stands_at_zero), TEXT_TEST(a_point_stands_in_the_middle),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
