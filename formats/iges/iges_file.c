/* The frame of an IGES 5.3 file: fixed lines of 80 columns, with the letter of the section in
 * column 73. Directory entries are two lines of ten fields of eight columns; parameters are a
 * list with a delimiter of its own. Called by iges_entities.c and iges_read.c. */
#include "formats/iges/iges_file.h"
#include "core/grow.h"

#include <stdlib.h>
#include <string.h>

enum { section_column = 72, parameter_columns = 64, field = 8, deepest_matrix = 8 };

typedef lam_iges_line line;
typedef lam_iges_section section;
typedef lam_iges_parameters parameters;
typedef lam_iges_matrix matrix;
typedef lam_iges_reader reader;

/* A message about the file: its line alone tells where. */
bool lam_iges_fail_at(reader *r, int number, const char *what) {
  r->scan.location.line = number;
  lam_error_add(r->scan.errors, r->scan.location, NULL, "%s", what);
  return false;
}

/* A message about the entity being read, which is named as IGES does, by D and its directory
 * line. */
bool lam_iges_fail(reader *r, const char *what) {
  r->scan.location.line = r->directory.lines[r->directory_line].number;
  lam_error_add(r->scan.errors, r->scan.location, NULL, "entity %d at D%d: %s", r->entity,
                r->directory_line + 1, what);
  return false;
}

/* ---- lines ---- */

/* Appends a line of the file to the section that its letter names. False with a message when
 * there is no such section; ended becomes true at the terminate section. The start section is not
 * kept. */
static bool take_line(reader *r, line l, bool *ended) {
  section *s = NULL;
  switch (l.text[section_column]) {
  case 'S':
    return true;
  case 'G':
    s = &r->global;
    break;
  case 'D':
    s = &r->directory;
    break;
  case 'P':
    s = &r->parameter;
    break;
  case 'T':
    *ended = true;
    return true;
  default:
    return lam_iges_fail_at(r, l.number == 1 ? 0 : l.number,
                            l.number == 1 ? "is not an IGES file: column 73 names no section"
                                          : "column 73 names no section; expected S, G, D, P or T");
  }

  LAM_APPEND(r->arena, s->lines, s->count, s->capacity, l);
  return true;
}

/* Sorts the lines up to the terminate section into sections. A first line that is none of IGES
 * means that the file is none. */
static bool split(reader *r) {
  const char *at = r->scan.at, *end = r->scan.end;
  bool ended = false;
  for (int number = 1; at < end && !ended; number++) {
    const char *stop = at;
    while (stop < end && !lam_line_end(stop, end)) stop++;
    if (stop - at <= section_column)
      return lam_iges_fail_at(r, number == 1 ? 0 : number,
                              number == 1 ? "is not an IGES file: its lines are not of 80 columns"
                                          : "a line of 80 columns expected");
    if (!take_line(r, (line){at, number}, &ended)) return false;
    at = stop + lam_line_end(stop, end);
  }

  if (!ended) return lam_iges_fail_at(r, 0, "is cut off: it has no terminate section");
  return r->global.count ? true : lam_iges_fail_at(r, 0, "has no global section");
}

/* The eight columns are copied, because fields follow one another without a separator. */
int lam_iges_field(const reader *r, int at, int i) {
  char digits[field + 1] = {0};
  memcpy(digits, r->directory.lines[at].text + field * i, field);
  long value = strtol(digits, NULL, 10);
  return value < 0 ? 0 : (int)value;
}

/* The first columns of count lines of a section as one terminated text; the arena's. */
static char *joined(lam_arena *arena, const section *s, int first, int count, int columns) {
  char *text = lam_arena_alloc(arena, (size_t)count * (size_t)columns + 1, 1);
  for (int i = 0; i < count; i++)
    memcpy(text + i * columns, s->lines[first + i].text, (size_t)columns);
  return text;
}

/* ---- parameters ---- */

/* The next parameter without blanks around it, up to its delimiter. A string is nH and n letters,
 * among which the delimiter may be. */
static lam_word next(const reader *r, parameters *list) {
  while (*list->at == ' ') list->at++;
  lam_word word = {list->at, 0};
  char *end = list->at;
  while (*end >= '0' && *end <= '9') end++;
  if (*end == 'H' && end > list->at) {
    long length = strtol(list->at, NULL, 10);
    end++;
    for (; length > 0 && *end; length--) end++;
  }

  while (*end && *end != r->delimiter && *end != r->terminator) end++;
  word.length = (int)(end - list->at);
  list->ended = *end != r->delimiter;
  list->at = list->ended ? end : end + 1;
  while (word.length && word.text[word.length - 1] == ' ') word.length--;
  return word;
}

/* A number; D stands for E, as in Fortran. What is left out is 0. False with a message. */
static bool next_number(reader *r, parameters *list, double *number) {
  *number = 0;
  if (list->ended) return lam_iges_fail(r, "parameters are missing");
  lam_word word = next(r, list);
  for (int i = 0; i < word.length; i++) /* the text is a copy of the reader's own */
    if (word.text[i] == 'D' || word.text[i] == 'd') ((char *)word.text)[i] = 'E';
  if (word.length == 0) return true;

  int before = r->scan.errors->count;
  r->scan.location.line = r->directory.lines[r->directory_line].number;
  lam_scan_number(&r->scan, word, lam_arena_printf(r->arena, "entity %d", r->entity), number);
  return r->scan.errors->count == before;
}

bool lam_iges_numbers(reader *r, parameters *list, double *numbers, size_t count) {
  for (size_t i = 0; i < count; i++)
    if (!next_number(r, list, &numbers[i])) return false;
  return true;
}

/* Numbers of all kinds are read as real ones first: some programs write 3. for 3. */
bool lam_iges_integer(reader *r, parameters *list, int least, int most, int *integer) {
  double number;
  if (!next_number(r, list, &number)) return false;
  if (!(number >= least && number <= most))
    return lam_iges_fail(r, "a number of points, degree or flag is out of range");
  *integer = (int)number;
  return *integer == number ? true : lam_iges_fail(r, "a whole number expected");
}

/* The list begins with the type of its entity, which is compared with the directory's and passed
 * over. */
bool lam_iges_open(reader *r, int at, parameters *list) {
  int first = lam_iges_field(r, at, 1), count = lam_iges_field(r, at + 1, 3);
  r->entity = lam_iges_field(r, at, 0);
  r->directory_line = at;
  if (first < 1 || count < 1 || first - 1 + count > r->parameter.count)
    return lam_iges_fail(r, "its directory entry points outside the parameter section");

  *list = (parameters){.at = joined(r->arena, &r->parameter, first - 1, count, parameter_columns)};
  double type;
  return next_number(r, list, &type) &&
         (type == r->entity || lam_iges_fail(r, "its parameters belong to another entity"));
}

/* ---- global section ---- */

/* The first two global parameters, strings of one letter such as 1H, name the characters that
 * part and end lists; left out, the defaults stay. Moves behind the delimiter that follows. */
static void read_delimiter(const reader *r, parameters *list, char *delimiter) {
  if (strncmp(list->at, "1H", 2) == 0 && list->at[2]) {
    *delimiter = list->at[2];
    list->at += 3;
  }
  if (*list->at == r->delimiter) list->at++;
}

/* The unit of length from the global section: the model's scale (parameter 13, which must be 1)
 * and the unit flag (14). Sizes of units by their flags; 3 stands for a unit named by text, which
 * is not read. */
static bool read_global(reader *r) {
  static const double units[] = {
      [1] = 0.0254, [2] = 1e-3,    [4] = 0.3048, [5] = 1609.344, [6] = 1,
      [7] = 1e3,    [8] = 2.54e-5, [9] = 1e-6,   [10] = 1e-2,    [11] = 2.54e-8};
  enum { scale_parameter = 13, unit_parameter };
  parameters list = {.at = joined(r->arena, &r->global, 0, r->global.count, section_column)};

  r->delimiter = ',', r->terminator = ';';
  read_delimiter(r, &list, &r->delimiter);
  read_delimiter(r, &list, &r->terminator);

  double scale = 1, flag = 1;
  r->scan.location.line = r->global.lines[0].number;
  for (int i = 3; i <= unit_parameter && !list.ended; i++) {
    lam_word word = next(r, &list);
    if (i < scale_parameter || word.length == 0) continue;
    if (!lam_scan_number(&r->scan, word, "scale or unit", i == unit_parameter ? &flag : &scale))
      return false;
  }

  int count = (int)(sizeof units / sizeof *units), line_number = r->global.lines[0].number;
  r->unit = flag >= 1 && flag < count ? units[(int)flag] : 0;
  if (!(r->unit > 0))
    return lam_iges_fail_at(r, line_number,
                            "the unit of length is unknown; expected a flag of 1, 2 or 4 to 11");
  return scale == 1 || lam_iges_fail_at(r, line_number,
                                        "the scale of the model is not 1: such files are not read");
}

/* The transformation that a directory entry names, with those that it names in turn: a point goes
 * through the inner one (entity 124) first, m = outer * inner. */
static bool read_matrix(reader *r, int at, int depth, matrix *m) {
  int pointer = lam_iges_field(r, at, 6);
  *m = (matrix){{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  if (pointer == 0) return true;

  parameters list;
  matrix inner, outer;
  if (pointer + 1 > r->directory.count || pointer % 2 == 0 ||
      lam_iges_field(r, pointer - 1, 0) != 124 || depth == deepest_matrix)
    return lam_iges_fail(r, "it names a transformation that is none");
  if (!lam_iges_open(r, pointer - 1, &list) || !lam_iges_numbers(r, &list, &inner.m[0][0], 12))
    return false;
  if (!read_matrix(r, pointer - 1, depth + 1, &outer)) return false;

  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 4; j++) {
      m->m[i][j] = j == 3 ? outer.m[i][3] : 0;
      for (int k = 0; k < 3; k++) m->m[i][j] += outer.m[i][k] * inner.m[k][j];
    }
  return true;
}

/* Row i of the matrix times (p, 1). */
lam_vec3 lam_iges_moved(const matrix *m, const double *p) {
  double x[3];
  for (int i = 0; i < 3; i++)
    x[i] = m->m[i][0] * p[0] + m->m[i][1] * p[1] + m->m[i][2] * p[2] + m->m[i][3];
  return lam_v3(x[0], x[1], x[2]);
}

bool lam_iges_matrix_of(lam_iges_reader *r, int at, lam_iges_matrix *m) {
  return read_matrix(r, at, 0, m);
}

/* Units are needed from here on; directory entries are pairs of lines. */
bool lam_iges_begin(lam_iges_reader *r) {
  if (!split(r) || !read_global(r)) return false;
  return r->directory.count % 2 == 0 ||
         lam_iges_fail_at(r, 0, "has an odd number of directory lines");
}
