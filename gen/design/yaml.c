/* YAML into the document tree, through libyaml's events: limits hold while it is read, and no file
 * can make libyaml itself work for long. Nothing of libyaml outlives the call. Called by parse.c
 * for designs, by override.c for their values, by fill.c for defaults. */
#include "core/grow.h"
#include "design/tree.h"
#include <string.h>
#include <yaml.h>

/* libyaml's memory; closed as soon as the tree stands, or with the arena when memory runs out on
 * the way. */
typedef struct yaml_source {
  yaml_parser_t parser;
  yaml_event_t event; /* the one that is read */
  bool parser_open, event_open;
} yaml_source;

/* A name for a value. */
typedef struct anchor {
  const char *name;
  const lam_node *node;
  bool open; /* the value is being read */
} anchor;

/* One reading: what all steps need. */
typedef struct yaml_reader {
  lam_arena *arena;
  lam_errors *errors;
  lam_location origin;
  bool fixed;     /* every node has the location origin */
  int node_count; /* so far, aliases expanded */
  bool stopped;   /* a limit was reached, or the text is no YAML: said once */
  yaml_source *source;
  const char *bytes; /* of the text, for marks */
  size_t count;
  int anchor_count, anchor_capacity;
  anchor *anchors;
} yaml_reader;

/* Closes what is open, once: the arena calls it again when it is released. */
static void close_source(void *handle) {
  yaml_source *source = handle;
  if (source->event_open) yaml_event_delete(&source->event);
  if (source->parser_open) yaml_parser_delete(&source->parser);
  source->event_open = source->parser_open = false;
}

/* libyaml counts from 0, locations from 1. */
static lam_location location_of(const yaml_reader *reader, yaml_mark_t mark) {
  if (reader->fixed) return reader->origin;
  return (lam_location){reader->origin.file, (int)mark.line + 1, (int)mark.column + 1};
}

/* ---- syntax errors ---- */

/* What libyaml says, and what a message says for it. */
static const char *const plain_words[][2] = {
    {"mapping values are not allowed in this context",
     "a ':' stands where a value goes on; put a text with ': ' in quotes, or check the "
     "indentation"},
    {"found character that cannot start any token",
     "a tab, @, % or ` begins a value; indent with spaces, put such a text in quotes"},
    {"found a tab character that violates indentation",
     "a tab in the indentation; indent with spaces"},
    {"did not find expected ',' or ']'", "a list is not closed; expected ',' or ']'"},
    {"did not find expected ',' or '}'", "a map is not closed; expected ',' or '}'"},
    {"could not find expected ':'", "a key without a ':'; expected 'key: value'"},
    {"did not find expected key", "expected a key at this indentation"},
    {"did not find expected '-' indicator",
     "expected '- ' to go on with the list at this indentation"},
    {"did not find expected node content", "a value is missing"},
    {"found unexpected end of stream", "the file ends inside a text; the closing quote is missing"},
    {"control characters are not allowed", "a control character in the file"},
    {"invalid leading UTF-8 octet", "bytes that are not UTF-8"},
    {"invalid trailing UTF-8 octet", "bytes that are not UTF-8"},
    {"incomplete UTF-8 octet sequence", "bytes that are not UTF-8"},
    {"did not find expected <document start>", "expected a map of keys, 'key: value'"},
};

/* libyaml's own words where the table has none. NULL stands for a problem without words. */
static const char *own_words(const char *problem) {
  if (!problem) return "expected a map of keys, 'key: value'";
  for (size_t i = 0; i < sizeof plain_words / sizeof plain_words[0]; i++) {
    if (strcmp(problem, plain_words[i][0]) == 0) return plain_words[i][1];
  }
  return problem;
}

/* The mark of the byte at offset: libyaml gives none for bytes that it cannot read. Columns count
 * characters: bytes 80..BF continue one. */
static yaml_mark_t mark_of_byte(const char *bytes, size_t count, size_t offset) {
  yaml_mark_t mark = {0, 0, 0};
  for (size_t i = 0; i < offset && i < count; i++) {
    mark.column = bytes[i] == '\n' ? 0 : mark.column + ((bytes[i] & 0xC0) != 0x80);
    mark.line += bytes[i] == '\n';
  }
  return mark;
}

/* Adds a message about the problem that the parser stopped at; memory that ran out is none, and
 * jumps to the run's recovery point. */
static void report_syntax(const yaml_reader *reader) {
  const yaml_parser_t *parser = &reader->source->parser;
  if (parser->error == YAML_MEMORY_ERROR) lam_arena_exhausted(reader->arena);

  yaml_mark_t mark = parser->problem_mark;
  if (parser->error == YAML_READER_ERROR)
    mark = mark_of_byte(reader->bytes, reader->count, parser->problem_offset);
  const char *words = own_words(parser->problem);

  /* What is not closed shows far below: a list, map or quoted text is told with where it opens. */
  yaml_mark_t start = parser->context_mark;
  bool has_start =
      parser->context && (strstr(parser->context, "flow") || strstr(parser->context, "quoted"));
  if (has_start && !reader->fixed) {
    lam_error_add(reader->errors, location_of(reader, mark), NULL,
                  "not valid YAML: %s (began at line %zu, column %zu)", words, start.line + 1,
                  start.column + 1);
  } else {
    lam_error_add(reader->errors, location_of(reader, mark), NULL, "not valid YAML: %s", words);
  }
}

/* A limit is reached, or the text is wrong: says so once, and makes all steps return. */
static lam_node *stop(yaml_reader *reader, lam_location location, const char *text) {
  if (!reader->stopped) lam_error_add(reader->errors, location, NULL, "%s", text);
  reader->stopped = true;
  return NULL;
}

/* Goes to the next event. False, with a message, when there is none. */
static bool next_event(yaml_reader *reader) {
  yaml_source *source = reader->source;
  if (source->event_open) yaml_event_delete(&source->event);
  source->event_open = yaml_parser_parse(&source->parser, &source->event);
  if (source->event_open) return true;

  report_syntax(reader);
  reader->stopped = true;
  return false;
}

/* ---- nodes ---- */

/* Counts a node. False, with a message, when a limit is reached. */
static bool admit(yaml_reader *reader, lam_location location, int depth) {
  if (depth > LAM_DESIGN_MAX_DEPTH)
    stop(reader, location, "maps and lists are nested more than 32 deep");
  else if (++reader->node_count > LAM_DESIGN_MAX_NODES)
    stop(reader, location, "more than 500000 values");
  return !reader->stopped;
}

/* ---- anchors and aliases ---- */

/* The anchor of this name, or NULL. */
static anchor *find_anchor(const yaml_reader *reader, const char *name) {
  for (int i = 0; i < reader->anchor_count; i++)
    if (strcmp(reader->anchors[i].name, name) == 0) return &reader->anchors[i];
  return NULL;
}

/* Gives a node a name; does nothing without a name (NULL). Returns the number of the anchor, or
 * -1. */
static int add_anchor(yaml_reader *reader, const yaml_char_t *text, const lam_node *node) {
  const char *name = (const char *)text;
  if (!name) return -1;
  if (find_anchor(reader, name)) {
    stop(reader, node->location, "not valid YAML: an anchor (&name) is given twice");
  } else if (reader->anchor_count == LAM_DESIGN_MAX_ANCHORS) {
    stop(reader, node->location, "more than 1000 anchors (&name)");
  } else {
    const anchor added = {lam_arena_copy(reader->arena, name), node, true};
    LAM_APPEND(reader->arena, reader->anchors, reader->anchor_count, reader->anchor_capacity,
               added);
    return reader->anchor_count - 1;
  }
  return -1;
}

/* A copy of a node with all below it: every node has one parent. Limits hold for copies too. */
static lam_node *copy_node(yaml_reader *reader, const lam_node *from, int depth) {
  if (!admit(reader, from->location, depth)) return NULL;
  lam_node *node = lam_node_new(reader->arena, from->type, from->location);
  node->text = from->text;
  node->plain = from->plain;
  for (int i = 0; i < from->count && !reader->stopped; i++) {
    lam_node *key = from->type == LAM_NODE_MAP ? copy_node(reader, from->keys[i], depth + 1) : NULL;
    lam_node *item = reader->stopped ? NULL : copy_node(reader, from->items[i], depth + 1);
    if (item) lam_node_append(reader->arena, node, key, item);
  }
  return node;
}

/* What the alias of the current event stands for. */
static lam_node *read_alias(yaml_reader *reader, lam_location location, int depth) {
  const anchor *a = find_anchor(reader, (const char *)reader->source->event.data.alias.anchor);
  if (!a)
    return stop(reader, location, "not valid YAML: an alias (*name) without its anchor (&name)");
  if (a->open) return stop(reader, location, "an alias (*name) inside what it stands for");
  return copy_node(reader, a->node, depth);
}

/* ---- values ---- */

static lam_node *read_node(yaml_reader *reader, int depth);

/* Fills a list with its items up to its end event, or until a limit is reached. */
static void read_list(yaml_reader *reader, int depth, lam_node *node) {
  while (next_event(reader) && reader->source->event.type != YAML_SEQUENCE_END_EVENT) {
    lam_node *value = read_node(reader, depth + 1);
    if (reader->stopped) return;
    lam_node_append(reader->arena, node, NULL, value);
  }
}

/* Fills a map with its pairs up to its end event, or until a limit is reached. A key must be a
 * word. */
static void read_map(yaml_reader *reader, int depth, lam_node *node) {
  while (next_event(reader) && reader->source->event.type != YAML_MAPPING_END_EVENT) {
    if (node->count == LAM_DESIGN_MAX_KEYS) {
      stop(reader, node->location, "a map with more than 1000 keys");
      return;
    }

    lam_node *key = read_node(reader, depth + 1);
    lam_node *value = key && next_event(reader) ? read_node(reader, depth + 1) : NULL;
    if (!value) return;
    if (key->type != LAM_NODE_SCALAR || key->text[0] == '\0')
      lam_error_add(reader->errors, key->location, NULL,
                    "a key that is not a word; expected 'key: value'");
    else
      lam_node_append(reader->arena, node, key, value);
  }
}

/* Fills a scalar from the current event. A zero byte would end its text early, and is a mistake. */
static void read_scalar(yaml_reader *reader, lam_node *node) {
  const yaml_event_t *event = &reader->source->event;
  const char *value = (const char *)event->data.scalar.value;
  node->plain = event->data.scalar.style == YAML_PLAIN_SCALAR_STYLE;
  node->text = lam_arena_copy(reader->arena, value);
  if (strlen(value) != event->data.scalar.length)
    lam_error_add(reader->errors, node->location, NULL, "a zero byte in a text");
}

/* What an event says of the node that begins with it. */
typedef struct beginning {
  lam_node_type type;
  const yaml_char_t *anchor, *tag; /* NULL: none */
  const char *default_tag;         /* what a tag may say without changing anything */
} beginning;

static beginning begin_node(const yaml_event_t *e) {
  if (e->type == YAML_SEQUENCE_START_EVENT)
    return (beginning){LAM_NODE_LIST, e->data.sequence_start.anchor, e->data.sequence_start.tag,
                       YAML_DEFAULT_SEQUENCE_TAG};
  if (e->type == YAML_MAPPING_START_EVENT)
    return (beginning){LAM_NODE_MAP, e->data.mapping_start.anchor, e->data.mapping_start.tag,
                       YAML_DEFAULT_MAPPING_TAG};
  return (beginning){LAM_NODE_SCALAR, e->data.scalar.anchor, e->data.scalar.tag,
                     YAML_DEFAULT_SCALAR_TAG};
}

/* The node that begins with the current event, with all below it. NULL when a limit is reached or
 * the text is wrong, with a message. */
static lam_node *read_node(yaml_reader *reader, int depth) {
  const yaml_event_t *event = &reader->source->event;
  lam_location location = location_of(reader, event->start_mark);
  if (event->type == YAML_ALIAS_EVENT) return read_alias(reader, location, depth);
  if (!admit(reader, location, depth)) return NULL;

  beginning b = begin_node(event);
  const char *tag = (const char *)b.tag;
  if (tag && strcmp(tag, "!") != 0 && strcmp(tag, b.default_tag) != 0)
    lam_error_add(reader->errors, location, NULL,
                  "a YAML tag (!...); expected a value without a tag");

  /* The event is gone when the next one is read. */
  lam_node *node = lam_node_new(reader->arena, b.type, location);
  int named = add_anchor(reader, b.anchor, node);
  if (reader->stopped) return NULL;
  if (b.type == LAM_NODE_SCALAR) read_scalar(reader, node);
  if (b.type == LAM_NODE_LIST) read_list(reader, depth, node);
  if (b.type == LAM_NODE_MAP) read_map(reader, depth, node);
  if (named >= 0) reader->anchors[named].open = false;
  return reader->stopped ? NULL : node;
}

/* ---- documents ---- */

/* The root of the first document, with nothing behind it; NULL when the text is empty or, with a
 * message, wrong. The first event begins the text, the next one the document. */
static lam_node *read_document(yaml_reader *reader) {
  const yaml_event_t *event = &reader->source->event;
  if (!next_event(reader) || !next_event(reader)) return NULL;
  if (event->type == YAML_STREAM_END_EVENT || !next_event(reader)) return NULL;

  lam_node *root = read_node(reader, 0);
  if (!root || !next_event(reader) || !next_event(reader)) return NULL;
  if (event->type != YAML_STREAM_END_EVENT)
    return stop(reader, location_of(reader, event->start_mark),
                "a second document (---); expected one design per file");
  return root;
}

/* Whether there are more %TAG lines than anybody needs: libyaml compares each with all before. */
static bool has_many_directives(const char *bytes, size_t count) {
  int found = 0;
  const char *line = bytes, *end = bytes + count;
  while (line) {
    if (end - line > 4 && memcmp(line, "%TAG", 4) == 0) found++;
    line = memchr(line, '\n', (size_t)(end - line));
    if (line) line++;
  }
  return found > 16;
}

/* libyaml's memory is deferred to the arena, so that a jump does not lose it. */
lam_node *lam_tree_read(lam_arena *arena, const char *bytes, size_t count, lam_location origin,
                        bool fixed, lam_errors *errors) {
  if (count > LAM_DESIGN_MAX_BYTES) {
    lam_error_add(errors, origin, NULL, "%zu bytes; expected at most 4 MiB", count);
    return NULL;
  }
  if (!bytes) bytes = "";
  if (has_many_directives(bytes, count)) {
    lam_error_add(errors, origin, NULL, "more than 16 %%TAG lines");
    return NULL;
  }

  yaml_source *source = LAM_NEW(arena, yaml_source, 1);
  yaml_reader reader = {.arena = arena,
                        .errors = errors,
                        .origin = origin,
                        .fixed = fixed,
                        .source = source,
                        .bytes = bytes,
                        .count = count};
  lam_arena_defer(arena, close_source, source);
  if (!yaml_parser_initialize(&source->parser)) lam_arena_exhausted(arena);
  source->parser_open = true;
  yaml_parser_set_input_string(&source->parser, (const unsigned char *)bytes, count);

  /* What was read before a limit was reached is of no use. */
  lam_node *root = read_document(&reader);
  close_source(source);
  return reader.stopped ? NULL : root;
}
