/* A stroke alphabet and its reading. Called by fab/flat/face.c and splice.c for strips, by
 * fab/parts for panels and sheets. */
#include "fab/flat/lettering.h"

#include <stddef.h>
#include <string.h>

/* The alphabet. A character is a list of strokes, separated by spaces; a stroke is a list of
 * points x y on a grid where capitals are 6 wide and 9 high.
 *   a, b, c as y: -1, -2, -3 (descenders)
 *   ~ after a point: it is not on the stroke but the middle control point of a parabola, as in
 *   outline fonts; between two of them in a row, the stroke passes through their midpoint */
typedef struct glyph {
  char character;
  char width; /* in grid units */
  const char *strokes;
} glyph;

static const glyph alphabet[] = {
    {' ', 3, ""},
    {'A', 6, "003960 1353"},
    {'B', 6, "00093959~55~3505 3565~60~3000"},
    {'C', 6, "6769~3909~060300~3060~62"},
    {'D', 6, "00092969~656460~2000"},
    {'E', 5, "59090050 0545"},
    {'F', 5, "590900 0545"},
    {'G', 6, "6769~3909~060300~3060~626434"},
    {'H', 6, "0009 6069 0565"},
    {'I', 2, "0020 0929 1019"},
    {'J', 5, "5953 5350~2000~02"},
    {'K', 6, "0009 6903 2560"},
    {'L', 5, "090050"},
    {'M', 7, "0009357970"},
    {'N', 6, "00096069"},
    {'O', 6, "3909~060300~3060~636669~39"},
    {'P', 6, "00093969~64~3404"},
    {'Q', 6, "3909~060300~3060~636669~39 4260"},
    {'R', 6, "00093969~64~3404 3460"},
    {'S', 6, "6769~3909~05~3565~60~3000~02"},
    {'T', 6, "0969 3930"},
    {'U', 6, "090300~3060~6369"},
    {'V', 6, "093069"},
    {'W', 8, "0920486089"},
    {'X', 6, "0069 0960"},
    {'Y', 6, "093569 3530"},
    {'Z', 6, "09690060"},
    {'a', 5, "5456~3606~00~3050~52 5650"},
    {'b', 5, "0900 0406~2656~50~2000~02"},
    {'c', 5, "5556~3606~00~3050~51"},
    {'d', 5, "5950 5456~3606~00~3050~52"},
    {'e', 5, "03535456~3606~00~3050~51"},
    {'f', 4, "4919~1710 0636"},
    {'g', 5, "565a5c~2c0c~0b 5456~3606~00~3050~52"},
    {'h', 5, "0900 0406~2656~5350"},
    {'i', 0, "0006 0809"},
    {'j', 2, "262a2c~0c 2829"},
    {'k', 5, "0900 4602 2450"},
    {'l', 2, "090200~20"},
    {'m', 8, "0600 0406~2646~4340 4446~6686~8380"},
    {'n', 5, "0600 0406~2656~5350"},
    {'o', 5, "0306~56~5350~00~03"},
    {'p', 5, "060c 0406~2656~50~2000~02"},
    {'q', 5, "565c 5456~3606~00~3050~52"},
    {'r', 4, "0600 0406~2646"},
    {'s', 5, "5556~2606~03~2353~50~2000~01"},
    {'t', 4, "191210~30 0636"},
    {'u', 5, "060300~3050~53 5650"},
    {'v', 4, "062046"},
    {'w', 6, "0620344066"},
    {'x', 5, "0056 0650"},
    {'y', 6, "0630 662b"},
    {'z', 5, "06560050"},
    {'0', 6, "3909~060300~3060~636669~39 2346"},
    {'1', 4, "072920 0040"},
    {'2', 6, "0709~3969~6664~0060"},
    {'3', 6, "0709~3969~65~3565~60~3000~02"},
    {'4', 6, "40490363"},
    {'5', 6, "690905~053565~60~3000~02"},
    {'6', 6, "5909~0300~3060~65~3505~03"},
    {'7', 6, "096920"},
    {'8', 6, "3505~09~3969~65~3565~60~3000~05~35"},
    {'9', 6, "1060~6669~3909~04~3464~66"},
    {'-', 4, "0444"},
    {'.', 1, "0001111000"},
    {'/', 4, "0049"},
    {'(', 2, "2907~050402~20"},
    {')', 2, "0927~252422~00"},
    {'+', 4, "0444 2226"},
    {':', 1, "0102121101 0506161505"},
};
static const glyph missing = {0, 6, "0009696000"};

/* Height of capitals in grid units, line segments per parabola, most points of a stroke. */
enum { HEIGHT = 9, PIECES = 5, MAX_POINTS = 128 };
/* Between characters, in grid units. */
static const double gap = 2.5;
/* Grid units are this much narrower than high: upright letters, about .53 times as wide as high. */
static const double narrow = 0.8;

static const glyph *find(char character) {
  for (size_t i = 0; i < sizeof alphabet / sizeof *alphabet; i++)
    if (alphabet[i].character == character) return &alphabet[i];
  return &missing;
}

const char *lam_lettering_characters(void) {
  return " ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-./()+:";
}

double lam_lettering_width(const char *text, double height) {
  double units = 0;
  for (const char *c = text; *c; c++) units += find(*c)->width + (c[1] ? gap : 0);
  return units * narrow * height / HEIGHT;
}

/* The grid point written in two characters: x as a digit, y as a digit or as a letter below 0. */
static lam_vec2 grid_point(const char *text) {
  int y = text[1] >= 'a' ? 'a' - 1 - text[1] : text[1] - '0';
  return lam_v2(text[0] - '0', y);
}

static lam_vec2 middle(lam_vec2 a, lam_vec2 b) { return lam_v2((a.x + b.x) / 2, (a.y + b.y) / 2); }

/* Reads one stroke into points (room for MAX_POINTS) and returns what follows it. A parabola a,
 * b, c is (1-t)^2 a + 2 t (1-t) b + t^2 c, drawn as PIECES segments. */
static const char *read_stroke(const char *text, lam_vec2 *points, int *count) {
  bool pending = false;
  lam_vec2 control = {0, 0};
  *count = 0;

  while (*text && *text != ' ') {
    lam_vec2 point = grid_point(text);
    bool off = text[2] == '~';
    text += off ? 3 : 2;
    /* The control point before this one waits for its end: this point, or the midpoint to the
     * next control point. */
    if (pending) {
      lam_vec2 from = points[*count - 1], to = off ? middle(control, point) : point;
      for (int i = 1; i <= PIECES; i++) {
        double t = (double)i / PIECES, u = 1 - t;
        points[(*count)++] = lam_v2(u * u * from.x + 2 * t * u * control.x + t * t * to.x,
                                    u * u * from.y + 2 * t * u * control.y + t * t * to.y);
      }
    } else if (!off)
      points[(*count)++] = point;

    control = point;
    pending = off;
  }

  return *text == ' ' ? text + 1 : text;
}

/* Strokes become open paths, all of one text joined; x runs along the base line, in grid units. */
void lam_lettering_add(lam_paths *paths, lam_layer layer, const char *text, lam_vec2 origin,
                       double angle, double height) {
  double unit = height / HEIGHT, x = 0;
  lam_motion motion = {cos(angle), sin(angle), origin};
  bool begun = false;

  for (; *text; text++) {
    const glyph *shape = find(*text);
    for (const char *rest = shape->strokes; *rest;) {
      lam_vec2 points[MAX_POINTS];
      int count;
      rest = read_stroke(rest, points, &count);
      for (int i = 0; i < count; i++)
        points[i] = lam_motion_apply(&motion,
                                     lam_v2((x + points[i].x) * narrow * unit, points[i].y * unit));
      lam_paths_add(paths, layer, false, count, points)->joined = begun;
      begun = true;
    }

    x += shape->width + gap;
  }
}
