/* From the text of a STEP file (ISO 10303-21) to its entities, by recursive descent, and finding
 * one's way among them. Called by step_read.c; looked into by all files of the reader. */
#include "formats/step/step_tree.h"
#include "core/grow.h"

#include <stdlib.h>
#include <string.h>

enum { deepest = 64, longest_entity = 15 };

typedef struct parser {
  lam_scan *scan;
  lam_arena *arena;
  int depth;    /* brackets that are open */
  int capacity; /* of the tree's entities */
  lam_step_tree *tree;
} parser;

static bool parse_value(parser *p, lam_step_value *value);

/* A message that says what stands here, when it can be shown, and what is expected; false. */
static bool fail(parser *p, const char *expected) {
  int shown = p->scan->at < p->scan->end;
  char given = shown ? *p->scan->at : ' ';
  if (shown && given > ' ' && given < 127)
    lam_error_add(p->scan->errors, p->scan->location, NULL, "\"%c\" given, %s expected", given,
                  expected);
  else
    lam_error_add(p->scan->errors, p->scan->location, NULL, "%s expected", expected);
  return false;
}

static bool at_end(const parser *p) { return p->scan->at == p->scan->end; }
static char peek(const parser *p) { return at_end(p) ? 0 : *p->scan->at; }

/* Goes on by a byte, counting lines. */
static void step(parser *p) {
  int end = lam_line_end(p->scan->at, p->scan->end);
  if (end == 1) p->scan->location.line++; /* of two bytes, the last one counts */
  p->scan->at++;
}

/* Whether the text goes on like this, upper or lower case. */
static bool starts(const parser *p, const char *text) {
  size_t length = strlen(text);
  return (size_t)(p->scan->end - p->scan->at) >= length &&
         strncasecmp(p->scan->at, text, length) == 0;
}

/* Passes over blanks and comments. */
static void skip(parser *p) {
  while (!at_end(p)) {
    if (starts(p, "/*")) {
      while (!at_end(p) && !starts(p, "*/")) step(p);
      for (int i = 0; i < 2 && !at_end(p); i++) step(p);
    } else if ((unsigned char)peek(p) <= ' ') {
      step(p);
    } else {
      return;
    }
  }
}

/* Passes over one character and blanks before it; false with a message when another one stands
 * there. */
static bool take(parser *p, char c, const char *expected) {
  skip(p);
  if (peek(p) != c || at_end(p)) return fail(p, expected);
  step(p);
  return true;
}

static bool is_digit(char c) { return c >= '0' && c <= '9'; }
static bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || c == '!';
}

/* ---- values ---- */

/* A # and at most 15 digits. */
static bool parse_entity_number(parser *p, long *number) {
  step(p); /* the # */
  *number = 0;
  int digits = 0;
  for (; is_digit(peek(p)) && digits <= longest_entity; digits++, step(p))
    *number = 10 * *number + (peek(p) - '0');
  return digits && digits <= longest_entity ? true : fail(p, "the number of an entity");
}

/* A text between quotes or dots, which it keeps; doubled quotes stand for one. */
static bool parse_text(parser *p, char quote, lam_step_value *value) {
  value->type = LAM_STEP_TEXT;
  value->word.text = p->scan->at;
  do {
    step(p);
    while (!at_end(p) && peek(p) != quote) step(p);
    if (at_end(p)) return fail(p, quote == '\'' ? "the end of a string" : "the end of a word");
    step(p);
  } while (quote == '\'' && peek(p) == quote);
  value->word.length = (int)(p->scan->at - value->word.text);
  return true;
}

/* All that can belong to a number; whether it is one is for lam_scan_number to say. */
static bool parse_number(parser *p, lam_step_value *value) {
  lam_word word = {p->scan->at, 0};
  while (!at_end(p) && (is_digit(peek(p)) || strchr("+-.eE", peek(p)))) step(p);
  word.length = (int)(p->scan->at - word.text);
  value->type = LAM_STEP_NUMBER;
  return lam_scan_number(p->scan, word, "number", &value->number);
}

/* The items of a list in brackets, linked in their order. Brackets may stand within brackets,
 * though not without end. */
static bool parse_items(parser *p, lam_step_value *list) {
  if (!take(p, '(', "(")) return false;
  if (++p->depth > deepest) return fail(p, "fewer brackets within brackets");

  const lam_step_value **link = &list->first;

  skip(p);
  while (peek(p) != ')') {
    lam_step_value *item = LAM_NEW(p->arena, lam_step_value, 1);
    if (!parse_value(p, item)) return false;
    *link = item;
    link = &item->next;
    list->count++;
    skip(p);
    if (peek(p) == ',') {
      step(p);
      skip(p);
      if (peek(p) == ')') return fail(p, "a value");
    } else if (peek(p) != ')') {
      return fail(p, ", or )");
    }
  }
  step(p);
  p->depth--;
  return true;
}

/* A keyword and its items. */
static bool parse_record(parser *p, lam_step_value *value) {
  skip(p);
  value->type = LAM_STEP_RECORD;
  value->word.text = p->scan->at;
  while (is_letter(peek(p)) || is_digit(peek(p))) step(p);
  value->word.length = (int)(p->scan->at - value->word.text);
  if (value->word.length == 0) return fail(p, "a keyword");
  return parse_items(p, value);
}

/* Any value, told from its first character; a dot begins a number or an enumeration. */
static bool parse_value(parser *p, lam_step_value *value) {
  skip(p);
  char c = peek(p), after = p->scan->end - p->scan->at > 1 ? p->scan->at[1] : 0;
  if (c == '$' || c == '*') {
    step(p);
    return true;
  }

  if (c == '\'' || c == '"' || (c == '.' && !is_digit(after))) return parse_text(p, c, value);
  if (c == '#') {
    value->type = LAM_STEP_REFERENCE;
    return parse_entity_number(p, &value->entity);
  }
  if (c == '(') {
    value->type = LAM_STEP_LIST;
    return parse_items(p, value);
  }

  if (is_letter(c)) return parse_record(p, value);
  if (is_digit(c) || c == '+' || c == '-' || c == '.') return parse_number(p, value);
  return fail(p, "a value");
}

/* ---- entities ---- */

/* Adds an empty entity to the tree; it moves when the next one is added. */
static lam_step_entity *append(parser *p) {
  lam_step_tree *tree = p->tree;
  LAM_APPEND(p->arena, tree->entities, tree->count, p->capacity, (lam_step_entity){0});
  return &tree->entities[tree->count - 1];
}

/* An entity, #12=RECORD(...); or the complex instance #12=(RECORD(...)RECORD(...)); */
static bool parse_entity(parser *p) {
  lam_step_entity *entity = append(p);
  entity->line = p->scan->location.line;
  if (!parse_entity_number(p, &entity->number) || !take(p, '=', "=")) return false;

  skip(p);
  bool complex = peek(p) == '(';
  if (complex) step(p);

  const lam_step_value **link = &entity->records;
  do {
    lam_step_value *record = LAM_NEW(p->arena, lam_step_value, 1);
    if (!parse_record(p, record)) return false;
    *link = record;
    link = &record->next;
    skip(p);
  } while (complex && peek(p) != ')');
  return (!complex || take(p, ')', ")")) && take(p, ';', ";");
}

/* Passes over a statement that is no entity: sections and the header. ended becomes true at the
 * last one of a file. */
static bool skip_statement(parser *p, bool *ended) {
  *ended |= starts(p, "END-ISO-10303-21");
  while (!at_end(p) && peek(p) != ';') {
    lam_step_value text = {0};
    if (peek(p) != '\'')
      step(p);
    else if (!parse_text(p, '\'', &text))
      return false;
    skip(p);
  }
  return take(p, ';', ";");
}

static int by_number(const void *a, const void *b) {
  long x = ((const lam_step_entity *)a)->number, y = ((const lam_step_entity *)b)->number;
  return (x > y) - (x < y);
}

/* Sorts the entities by number; a number that is given twice is an error. */
static bool sort_entities(lam_scan *scan, lam_step_tree *tree) {
  if (tree->count) qsort(tree->entities, (size_t)tree->count, sizeof *tree->entities, by_number);
  for (int i = 1; i < tree->count; i++)
    if (tree->entities[i].number == tree->entities[i - 1].number) {
      scan->location.line = tree->entities[i].line;
      lam_error_add(scan->errors, scan->location, NULL, "entity #%ld given twice",
                    tree->entities[i].number);
      return false;
    }
  return true;
}

/* Statement by statement, up to the one that ends the file. */
bool lam_step_tree_read(lam_arena *arena, lam_scan *scan, lam_step_tree *tree) {
  parser p = {.scan = scan, .arena = arena, .tree = tree};
  bool ended = false;
  *tree = (lam_step_tree){0};

  skip(&p);
  if (!starts(&p, "ISO-10303-21")) {
    scan->location.line = 0;
    lam_error_add(scan->errors, scan->location, NULL,
                  "is not a STEP file: it does not begin with ISO-10303-21");
    return false;
  }

  for (skip(&p); !at_end(&p) && !ended; skip(&p))
    if (!(peek(&p) == '#' ? parse_entity(&p) : skip_statement(&p, &ended))) return false;
  if (!ended) {
    lam_error_add(scan->errors, scan->location, NULL, "is cut off: END-ISO-10303-21 expected");
    return false;
  }
  return sort_entities(scan, tree);
}

/* ---- looking into it ---- */

const lam_step_entity *lam_step_find(const lam_step_tree *tree, long number) {
  lam_step_entity key = {.number = number};
  return tree->count ? bsearch(&key, tree->entities, (size_t)tree->count, sizeof key, by_number)
                     : NULL;
}

const lam_step_value *lam_step_record(const lam_step_entity *entity, const char *keyword) {
  for (const lam_step_value *r = entity ? entity->records : NULL; r; r = r->next)
    if (lam_word_is(r->word, keyword)) return r;
  return NULL;
}

const lam_step_value *lam_step_item(const lam_step_value *list, int i) {
  const lam_step_value *item = list ? list->first : NULL;
  while (item && i-- > 0) item = item->next;
  return item;
}

const lam_step_value *lam_step_typed(const lam_step_value *list, int i, lam_step_type type) {
  const lam_step_value *item = lam_step_item(list, i);
  return item && item->type == type ? item : NULL;
}
