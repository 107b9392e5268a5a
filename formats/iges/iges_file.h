/* The frame of an IGES 5.3 file that is being read: lines, directory, parameter lists, unit and
 * transformations. Used by iges_entities.c and iges_read.c. */
#ifndef LAM_FORMATS_IGES_IGES_FILE_H
#define LAM_FORMATS_IGES_IGES_FILE_H

#include "formats/scan.h"

typedef struct lam_iges_line {
  const char *text; /* at least 73 bytes */
  int number;       /* in the file */
} lam_iges_line;

typedef struct lam_iges_section {
  int count, capacity;
  lam_iges_line *lines;
} lam_iges_section;

/* A parameter list that is being read: the columns of its lines, one after another. */
typedef struct lam_iges_parameters {
  char *at; /* zero-terminated */
  bool ended;
} lam_iges_parameters;

/* What is being read. arena and scan (lam_scan_begin) are set by the caller, the rest by
 * lam_iges_begin. */
typedef struct lam_iges_reader {
  lam_arena *arena;
  lam_scan scan;
  lam_iges_section global, directory, parameter; /* lines of the sections G, D and P */
  char delimiter, terminator; /* between parameters; behind the last one of an entity */
  double unit;                /* in meters */
  int entity;                 /* type of the entity being read, for messages, */
  int directory_line;         /* and its first line in the directory, from 0 */
} lam_iges_reader;

/* x -> m x: a 3 x 3 matrix and, in the last column, a shift in the file's unit. */
typedef struct lam_iges_matrix {
  double m[3][4];
} lam_iges_matrix;

/* Add a message with a line of the file (0: none), or about the entity being read; return false. */
bool lam_iges_fail_at(lam_iges_reader *r, int number, const char *what);
bool lam_iges_fail(lam_iges_reader *r, const char *what);

/* Splits the file into sections and reads the unit. False with a message. */
bool lam_iges_begin(lam_iges_reader *r);
/* Field i (0 to 8) of directory line `at` (from 0), a whole number; blank, negative ones: 0. */
int lam_iges_field(const lam_iges_reader *r, int at, int i);
/* The parameters of the entity whose directory entry begins at line `at`, behind their type. Sets
 * entity and directory_line. False with a message. */
bool lam_iges_open(lam_iges_reader *r, int at, lam_iges_parameters *list);
/* The next parameters, count numbers or a whole number from least to most. What is left out is 0;
 * false with a message when the list has ended, or it is no such number. */
bool lam_iges_numbers(lam_iges_reader *r, lam_iges_parameters *list, double *numbers, size_t count);
bool lam_iges_integer(lam_iges_reader *r, lam_iges_parameters *list, int least, int most,
                      int *integer);
/* The transformation that the entry at line `at` names, followed by those that it names in turn;
 * the identity when it names none. False with a message. */
bool lam_iges_matrix_of(lam_iges_reader *r, int at, lam_iges_matrix *m);
/* The point p (three numbers), transformed; in the file's unit. */
lam_vec3 lam_iges_moved(const lam_iges_matrix *m, const double *p);

#endif
