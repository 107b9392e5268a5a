/* YAML into the document tree, through libyaml; nothing of libyaml outlives the call. Called by
 * parse.c for designs, by override.c for their values, by fill.c for defaults. */
#include "design/tree.h"
#include <string.h>
#include <yaml.h>

/* libyaml's memory; closed as soon as the tree stands, or with the arena when memory runs out on
 * the way. */
typedef struct yaml_source {
  yaml_parser_t parser;
  yaml_document_t document;
  bool parser_open, document_open;
} yaml_source;

/* One reading: what all steps need. */
typedef struct yaml_reader {
  lam_arena *arena;
  lam_errors *errors;
  lam_location origin;
  bool fixed;     /* every node has the location origin */
  int node_count; /* so far, aliases expanded */
  bool stopped;   /* a limit was reached: said once */
  yaml_document_t *document;
} yaml_reader;

/* Closes what is open, once: the arena calls it again when it is released. */
static void close_source(void *handle) {
  yaml_source *source = handle;
  if (source->document_open) yaml_document_delete(&source->document);
  if (source->parser_open) yaml_parser_delete(&source->parser);
  source->document_open = source->parser_open = false;
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
    {"found undefined alias", "an alias (*name) without its anchor (&name)"},
    {"found duplicate anchor", "an anchor (&name) is given twice"},
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
static void report_syntax(const yaml_reader *reader, const yaml_parser_t *parser, const char *bytes,
                          size_t count) {
  if (parser->error == YAML_MEMORY_ERROR) lam_arena_exhausted(reader->arena);

  yaml_mark_t mark = parser->problem_mark;
  if (parser->error == YAML_READER_ERROR) mark = mark_of_byte(bytes, count, parser->problem_offset);
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

/* ---- nodes ---- */

static lam_node *read_node(yaml_reader *reader, int id, int depth);

/* A limit is reached: says so once, and makes all steps return. */
static lam_node *stop(yaml_reader *reader, lam_location location, const char *text) {
  if (!reader->stopped) lam_error_add(reader->errors, location, NULL, "%s", text);
  reader->stopped = true;
  return NULL;
}

/* Fills a list with its items, until a limit is reached. */
static void read_list(yaml_reader *reader, const yaml_node_t *source, int depth, lam_node *node) {
  for (yaml_node_item_t *item = source->data.sequence.items.start;
       item < source->data.sequence.items.top; item++) {
    lam_node *value = read_node(reader, *item, depth + 1);
    if (reader->stopped) return;
    if (value) lam_node_append(reader->arena, node, NULL, value);
  }
}

/* Appends a key and its value to a map. A key must be a word. */
static void read_pair(yaml_reader *reader, const yaml_node_pair_t *pair, int depth,
                      lam_node *node) {
  lam_node *key = read_node(reader, pair->key, depth + 1);
  lam_node *value = reader->stopped ? NULL : read_node(reader, pair->value, depth + 1);
  if (!key || !value) return;
  if (key->type != LAM_NODE_SCALAR || key->text[0] == '\0') {
    lam_error_add(reader->errors, key->location, NULL,
                  "a key that is not a word; expected 'key: value'");
  } else {
    lam_node_append(reader->arena, node, key, value);
  }
}

/* Fills a map with its pairs, until a limit is reached. */
static void read_map(yaml_reader *reader, const yaml_node_t *source, int depth, lam_node *node) {
  for (yaml_node_pair_t *pair = source->data.mapping.pairs.start;
       pair < source->data.mapping.pairs.top; pair++) {
    if (node->count == LAM_DESIGN_MAX_KEYS) {
      stop(reader, node->location, "a map with more than 1000 keys");
      return;
    }
    read_pair(reader, pair, depth, node);
    if (reader->stopped) return;
  }
}

/* Fills a scalar. A zero byte would end its text early, and is a mistake. */
static void read_scalar(yaml_reader *reader, const yaml_node_t *source, lam_node *node) {
  const char *value = (const char *)source->data.scalar.value;
  node->plain = source->data.scalar.style == YAML_PLAIN_SCALAR_STYLE;
  node->text = lam_arena_copy(reader->arena, value);
  if (strlen(value) != source->data.scalar.length) {
    lam_error_add(reader->errors, node->location, NULL, "a zero byte in a text");
  }
}

/* The tag that libyaml gives to nodes without one. */
static const char *default_tag(yaml_node_type_t type) {
  if (type == YAML_SEQUENCE_NODE) return YAML_DEFAULT_SEQUENCE_TAG;
  return type == YAML_MAPPING_NODE ? YAML_DEFAULT_MAPPING_TAG : YAML_DEFAULT_SCALAR_TAG;
}

/* The node with this number in libyaml's document, with all below it. An alias is the number of its
 * anchor: the nodes are read again, and the limits end what an alias within itself would repeat
 * without end. NULL when a limit is reached, with a message. */
static lam_node *read_node(yaml_reader *reader, int id, int depth) {
  const yaml_node_t *source = yaml_document_get_node(reader->document, id);
  lam_location location = location_of(reader, source->start_mark);
  if (depth > LAM_DESIGN_MAX_DEPTH)
    return stop(reader, location, "maps and lists are nested more than 32 deep");
  if (++reader->node_count > LAM_DESIGN_MAX_NODES)
    return stop(reader, location, "more than 500000 values");

  if (source->tag && strcmp((const char *)source->tag, default_tag(source->type)) != 0) {
    lam_error_add(reader->errors, location, NULL,
                  "a YAML tag (!...); expected a value without a tag");
  }

  switch (source->type) {
  case YAML_SCALAR_NODE: {
    lam_node *node = lam_node_new(reader->arena, LAM_NODE_SCALAR, location);
    read_scalar(reader, source, node);
    return node;
  }
  case YAML_SEQUENCE_NODE: {
    lam_node *node = lam_node_new(reader->arena, LAM_NODE_LIST, location);
    read_list(reader, source, depth, node);
    return node;
  }
  case YAML_MAPPING_NODE: {
    lam_node *node = lam_node_new(reader->arena, LAM_NODE_MAP, location);
    read_map(reader, source, depth, node);
    return node;
  }
  default:
    return NULL;
  }
}

/* ---- documents ---- */

/* False, with a message, when anything but the end follows the first document: a second one, or
 * what is no YAML. */
static bool at_end(const yaml_reader *reader, yaml_source *source, const char *bytes,
                   size_t count) {
  yaml_document_t next;
  if (!yaml_parser_load(&source->parser, &next)) {
    report_syntax(reader, &source->parser, bytes, count);
    return false;
  }

  const yaml_node_t *root = yaml_document_get_root_node(&next);
  if (root) {
    lam_error_add(reader->errors, location_of(reader, next.start_mark), NULL,
                  "a second document (---); expected one design per file");
  }
  yaml_document_delete(&next);
  return !root;
}

/* The root of the first document of the source; NULL when it is empty or, with a message, wrong. */
static lam_node *read_document(yaml_reader *reader, yaml_source *source, const char *bytes,
                               size_t count) {
  if (!yaml_parser_load(&source->parser, &source->document)) {
    report_syntax(reader, &source->parser, bytes, count);
    return NULL;
  }

  source->document_open = true;
  reader->document = &source->document;
  if (!yaml_document_get_root_node(&source->document)) return NULL;
  if (!at_end(reader, source, bytes, count)) return NULL;
  return read_node(reader, 1, 0); /* libyaml's root is node 1 */
}

/* libyaml's memory is deferred to the arena, so that a jump does not lose it. */
lam_node *lam_tree_read(lam_arena *arena, const char *bytes, size_t count, lam_location origin,
                        bool fixed, lam_errors *errors) {
  yaml_reader reader = {.arena = arena, .errors = errors, .origin = origin, .fixed = fixed};
  if (count > LAM_DESIGN_MAX_BYTES) {
    lam_error_add(errors, origin, NULL, "%zu bytes; expected at most 4 MiB", count);
    return NULL;
  }

  yaml_source *source = LAM_NEW(arena, yaml_source, 1);
  lam_arena_defer(arena, close_source, source);
  if (!yaml_parser_initialize(&source->parser)) lam_arena_exhausted(arena);
  source->parser_open = true;
  yaml_parser_set_input_string(&source->parser, (const unsigned char *)(bytes ? bytes : ""), count);

  /* What was read before a limit was reached is of no use. */
  lam_node *root = read_document(&reader, source, bytes, count);
  close_source(source);
  return reader.stopped ? NULL : root;
}
