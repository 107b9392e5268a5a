/* The model: what a design was turned into, as plain constant data. Writers see nothing else. Meters,
 * radians, z up. A model belongs to the session that built it. */
#ifndef LAMELLA_MODEL_H
#define LAMELLA_MODEL_H

#include <lamella/types.h>

LAM_BEGIN_DECLS

/* ---- materials ---- */
typedef struct lam_material {
  const char *name, *doc;
  double density;    /* kg/m^3 */
  double max_strain; /* elastic limit, dimensionless */
  double color[3];   /* linear RGB, for glTF */
  double metallic, roughness;
} lam_material;

/* ---- flat patterns ---- */
typedef enum lam_layer {
  LAM_LAYER_CUT,
  LAM_LAYER_ENGRAVE,
  LAM_LAYER_LABEL,
  LAM_LAYER_SHEET,
  LAM_LAYER_COUNT
} lam_layer;

typedef struct lam_path {
  lam_layer layer;
  bool closed;
  bool hole; /* a closed cut inside the outline: offset inward by the kerf */
  int count;
  lam_vec2 *points;
} lam_path;

/* Where a slot lies on a developed strip: along its axis and across it (0 on the axis). */
typedef struct lam_flat_slot {
  double low, high, bottom, top;
  double at; /* along the axis, where the partner's middle line crosses */
} lam_flat_slot;

/* A developed part: outline, slots and holes on CUT, marks on ENGRAVE, lettering (as single
 * strokes) on LABEL. */
typedef struct lam_flat {
  int path_count;
  lam_path *paths;
  lam_vec2 min, max; /* bounds of the paths */
  double thickness;
  double height;  /* of a strip, across its axis; 0 when the part is not a strip, and nothing below
                     is given */
  int axis_count; /* the developed middle line, from end to end */
  lam_vec2 *axis;
  bool reversed; /* the axis runs against the part's direction of travel, so that the marked face is
                    the outer one */
  int slot_count; /* in order along the axis */
  lam_flat_slot *slots;
} lam_flat;

/* ---- records for programs that rebuild the part themselves (OpenSCAD) ---- */
/* A table of numbers: rows x columns, row-major. Lengths in meters; decimals is the precision to
 * write after conversion: lengths (is_length[column]) are written in millimeters. */
typedef struct lam_record {
  const char *name; /* of the part */
  int family;
  int columns, rows;
  const double *values;
} lam_record;

/* What a record's columns mean. */
typedef struct lam_record_column {
  const char *name;
  bool is_length;
  int decimals;
} lam_record_column;

/* ---- parts ---- */
/* Position of one instance: x_world = origin + x axis[0] + y axis[1] + z axis[2]. */
typedef struct lam_pose {
  lam_vec3 origin;
  lam_vec3 axis[3];
} lam_pose;

typedef struct lam_fact {
  const char *name; /* for instance "length" */
  const char *unit; /* "m", "rad", "" ... */
  double value;
} lam_fact;

typedef struct lam_part {
  const char *name; /* unique and file-name safe, for instance "A07a" */
  const char *kind; /* row of the part registry that made it */
  int family;       /* 0, 1, or -1 */
  int group; /* which physical element it belongs to (the two sheets of a pair share it); -1 when
                none */
  int congruence; /* parts with the same number are copies of each other; counts from 1; 0 when not
                     known */
  const lam_material *material;
  bool drawn; /* to be looked at, not made: it may pass through other parts, and has no flat pattern
               */
  lam_trimesh solid;  /* closed and oriented */
  int instance_count; /* 0: the solid stands where it is; n: it is placed by frames (and not where
                         it is) */
  lam_pose *instances;
  double length;      /* developed length, 0 when it has none */
  double mass;        /* kg, of one instance */
  lam_flat *flat;     /* NULL when it is not cut from a sheet */
  lam_record *record; /* NULL when OpenSCAD gets the solid itself */
  int fact_count;
  lam_fact *facts; /* for the bill of materials and glTF extras */
} lam_part;

/* A connection of two lamellas. */
typedef struct lam_crossing {
  lam_vec3 position, normal;
  double angle;      /* between the families, as built */
  double flat_angle; /* in the flat grid of developed lamellas; NaN when not computed */
  int parts[2];      /* index of one part per family */
  double along[2];   /* arc length on that part */
} lam_crossing;

/* ---- sheets ---- */
typedef struct lam_sheet_piece {
  int part; /* index of the part; -1 for a splice plate, which belongs to no part */
  const char *label;
  double area, length; /* of the finished piece: kerf not counted */
  int path_count;
  lam_path *paths; /* in sheet coordinates, kerf already applied */
} lam_sheet_piece;

typedef struct lam_sheet {
  const char *name;
  double width, height;
  const lam_material *material;
  double thickness;
  double kerf; /* 0: the outlines are not compensated */
  int piece_count;
  lam_sheet_piece *placed;
  double used; /* area of the parts / area of the sheet */
} lam_sheet;

/* ---- report ---- */
/* What was measured on a number of elements. NaN: undefined, or not known (min of a stage that
 * keeps none). */
typedef struct lam_measure {
  const char *name, *unit;
  double min, max, mean;
  long count; /* elements measured */
} lam_measure;

typedef struct lam_stage {
  const char *name;
  bool converged; /* meaningful when iterations >= 0 */
  const char *reason;
  int iterations; /* -1: the stage does not iterate */
  double residual;
  int measure_count;
  lam_measure *measures;
  int note_count;
  const char **notes;
  double seconds; /* wall time, shown only on request */
} lam_stage;

typedef struct lam_report {
  int stage_count;
  lam_stage *stages;
} lam_report;

/* ---- color maps ---- */
typedef enum lam_map_on { LAM_MAP_VERTICES, LAM_MAP_EDGES, LAM_MAP_FACES } lam_map_on;

/* A measure with its values on the elements of the net. */
typedef struct lam_map {
  lam_map_on on;
  const char *doc;
  lam_measure summary;
  int count;
  const double *values;    /* not finite: undefined there */
  const int (*edges)[2];   /* vertices of the edges, when the values are on edges */
  const lam_vec3 *normals; /* unit normals of the net's vertices */
  const lam_vec2 *layout; /* the net's vertices in the plane that it is compared with; NULL: none */
  double range[2]; /* of the colors, when several maps share them; 0, 0: that of the summary */
} lam_map;

/* ---- prints ---- */
/* A surface with a place of the picture at every vertex. */
typedef struct lam_printed {
  const char *name; /* unique */
  lam_trimesh mesh;
  const lam_vec2 *texture; /* 0 to 1 from the picture's lower left corner, per vertex */
  double max_stretch,
      mean_stretch; /* ratio of singular values of the map from the picture to the surface, >= 1 */
} lam_printed;

/* A picture and the surfaces it is printed on. */
typedef struct lam_print {
  int width, height;
  const unsigned char *pixels; /* sRGB, 3 bytes each, rows from the top */
  int count;
  const lam_printed *sheets;
} lam_print;

/* ---- the picture ---- */
typedef struct lam_picture {
  const char *setting; /* a file of templates/pov without its ending */
  const char *view;    /* a view that the setting knows, or "auto" */
  int width, height;
  const char *quality; /* an entry of render.ini */
} lam_picture;

typedef struct lam_model {
  const char *name, *title, *source, *version;
  const lam_mesh *net; /* NULL when the design has none */
  int polyline_count;
  const lam_polyline *polylines;
  int frame_count;               /* states of the net on its way to the result; 0: none were kept */
  const lam_vec3 *const *frames; /* positions of the net's vertices */
  int surface_count;             /* smooth surfaces that are splines */
  const lam_spline_surface *surfaces;
  int curve_count; /* axes of lamellas; without them, lines of the net */
  const lam_named_curve *curves;
  int part_count;
  const lam_part *parts;
  int record_kind_count; /* per part kind with records: its columns and OpenSCAD settings */
  const struct lam_record_kind *record_kinds;
  int crossing_count;
  const lam_crossing *crossings;
  int sheet_count;
  const lam_sheet *sheets;
  int support_count; /* net vertices on the ground */
  const lam_vec3 *supports;
  const lam_report *report;
  int map_count; /* of the net; none without a net */
  const lam_map *maps;
  const lam_print *print; /* what is shown instead of the net; NULL: nothing */
  lam_picture picture;
} lam_model;

/* How a kind's records are rebuilt in OpenSCAD: the template, its columns and the literals of the
 * Customizer. */
typedef struct lam_setting {
  const char *name;    /* OpenSCAD variable */
  const char *section; /* Customizer group */
  const char *range;   /* Customizer comment such as "[0:0.05:2]"; NULL when none */
  const char *doc;
  double value; /* stored units; lengths are written in millimeters */
  bool is_length;
} lam_setting;

typedef struct lam_record_kind {
  const char *kind; /* part kind */
  const char *scad; /* file in templates/scad */
  int column_count;
  const lam_record_column *columns;
  int setting_count;
  const lam_setting *settings;
} lam_record_kind;

LAM_END_DECLS

#endif
