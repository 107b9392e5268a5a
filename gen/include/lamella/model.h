/* The model: what a design was turned into, as plain constant data. Writers of formats see nothing
 * else, and programs may read all of it. Meters, radians, z up. A model belongs to the session that
 * built it, with all that it points to; other threads may read it meanwhile. Where a comment says
 * nothing else, texts are not NULL, and an array is NULL only where its count is 0. */
#ifndef LAMELLA_MODEL_H
#define LAMELLA_MODEL_H

#include <lamella/types.h>

LAM_BEGIN_DECLS

/* ---- materials ---- */

typedef struct lam_material {
  const char *name, *doc;
  double density;             /* kg/m^3 */
  double max_strain;          /* elastic limit, dimensionless */
  double color[3];            /* linear RGB, for glTF */
  double metallic, roughness; /* 0 to 1, as glTF defines them */
} lam_material;

/* ---- flat patterns ---- */

/* What a line is for: layers of DXF files. */
typedef enum lam_layer {
  LAM_LAYER_CUT,
  LAM_LAYER_ENGRAVE,
  LAM_LAYER_LABEL,
  LAM_LAYER_SHEET, /* the outline of the stock */
  LAM_LAYER_COUNT  /* how many there are */
} lam_layer;

/* A polyline in the plane of a pattern or of a sheet. */
typedef struct lam_path {
  lam_layer layer;
  bool closed; /* the last point is joined to the first, and is not repeated */
  bool hole;   /* a closed cut inside the outline: offset inward by the kerf */
  bool joined; /* one object with the path before: the next stroke of a word */
  int count;
  lam_vec2 *points; /* count; meters */
  double radius;    /* of a circle round the mean of the points, a polygon for programs without
                       circles; 0: no circle. meters */
} lam_path;

/* Where a slot lies on a developed strip: along its axis and across it (0 on the axis), meters. */
typedef struct lam_flat_slot {
  double low, high, bottom, top; /* low to high along the axis, bottom to top across it */
  double at;                     /* along the axis, where the partner's middle line crosses */
} lam_flat_slot;

/* A developed part: outline, slots and holes on CUT, marks on ENGRAVE, lettering (as single
 * strokes) on LABEL. Meters. */
typedef struct lam_flat {
  int path_count;
  lam_path *paths;
  lam_vec2 min, max; /* bounds of the paths */
  double thickness;
  double height; /* of a strip, across its axis; 0: the part is no strip, and nothing below is
                     given */
  int axis_count;
  lam_vec2 *axis; /* axis_count points: the developed middle line, from end to end */
  bool reversed;  /* the axis runs against the part's direction of travel, so that the marked face
                     is the outer one */
  int slot_count;
  lam_flat_slot *slots; /* in order along the axis */
} lam_flat;

/* ---- records for programs that rebuild the part themselves (OpenSCAD) ---- */

/* A table of numbers about one part, whose columns its lam_record_kind names. */
typedef struct lam_record {
  const char *name; /* of the part */
  int family;       /* 0 or 1 */
  int columns, rows;
  const double *values; /* rows x columns, row-major; lengths in meters */
} lam_record;

/* What a column of a kind's records means. */
typedef struct lam_record_column {
  const char *name;
  bool is_length; /* written in millimeters */
  int decimals;   /* to write, of the number in the unit that is written */
} lam_record_column;

/* ---- parts ---- */

/* Where one instance of a part stands: x_world = origin + x axis[0] + y axis[1] + z axis[2]. */
typedef struct lam_pose {
  lam_vec3 origin;
  lam_vec3 axis[3];
} lam_pose;

/* One number about a part, for the bill of materials and glTF extras. */
typedef struct lam_fact {
  const char *name; /* for instance "length" */
  const char *unit; /* "m", "rad", "" ... */
  double value;
} lam_fact;

typedef struct lam_part {
  const char *name; /* unique and file-name safe, for instance "A07a" */
  const char *kind; /* row of the part registry that made it */
  int family;       /* 0, 1, or -1 */
  int group;        /* which physical element it belongs to (the two sheets of a pair share it); -1
                       when none */
  int congruence;   /* parts with the same number are copies of each other; counts from 1; 0: not
                       known */
  const lam_material *material;
  bool drawn;         /* to be looked at, not made: it may pass through other parts, and has no flat
                         pattern */
  lam_trimesh solid;  /* closed and oriented */
  int instance_count; /* 0: the solid stands where it is; n: it stands n times, placed by its
                         instances (and not where it is) */
  lam_pose *instances;
  double length;      /* developed length; 0 when it has none */
  double mass;        /* kg, of one instance */
  lam_flat *flat;     /* NULL: it is not cut from a sheet */
  lam_record *record; /* NULL: OpenSCAD gets the solid itself */
  int fact_count;
  lam_fact *facts;
} lam_part;

/* A connection of two lamellas. */
typedef struct lam_crossing {
  lam_vec3 position, normal; /* normal: of the net, unit */
  double angle;              /* between the families, as built */
  double flat_angle;         /* in the flat grid of developed lamellas; NaN: not computed */
  int parts[2];              /* index of one part per family */
  double along[2];           /* arc length on that part, from its start */
  double second[2];          /* that on the second sheet of a pair; single sheets have none */
} lam_crossing;

/* ---- sheets ---- */

/* What is cut from a sheet in one piece. */
typedef struct lam_sheet_piece {
  int part;            /* index of the part; -1: a splice plate, which belongs to no part */
  const char *label;   /* as lettered on it */
  double area, length; /* of the finished piece, m^2 and m: kerf not counted */
  int path_count;
  lam_path *paths; /* in sheet coordinates, kerf already applied */
} lam_sheet_piece;

/* A sheet of stock with the pieces that are cut from it; (0, 0) is its lower left corner. */
typedef struct lam_sheet {
  const char *name; /* unique and file-name safe */
  double width, height;
  const lam_material *material;
  double thickness;
  double kerf; /* 0: the outlines are not compensated */
  int piece_count;
  lam_sheet_piece *placed;
  double used; /* area of the pieces / area of the sheet */
  int warning_count;
  lam_path *warnings; /* lettering on the layer SHEET: why the sheet should not be cut */
} lam_sheet;

/* ---- report ---- */

/* What was measured on a number of elements (vertices, edges, faces, ...). NaN: undefined, or not
 * known (the minimum of a stage that keeps none). A count of things (parts that clash, sheets) has
 * the unit LAM_UNIT_COUNT, its value in min, max and mean, and 1 as count. */
#define LAM_UNIT_COUNT "count"
typedef struct lam_measure {
  const char *name, *unit; /* unit: "" when there is none */
  double min, max, mean;   /* in the unit */
  long count;              /* elements measured */
} lam_measure;

/* One step of a build. */
typedef struct lam_stage {
  const char *name;   /* such as "net: asymptotic" */
  bool converged;     /* without iterations: it did not fail */
  const char *reason; /* why it stopped, in words; "done" without iterations */
  int iterations;     /* -1: the stage does not iterate */
  double residual;    /* largest one at the end; meaningful when iterations >= 0 */
  int measure_count;
  lam_measure *measures;
  int note_count;
  const char **notes; /* sentences */
  double seconds;     /* wall time, shown only on request */
} lam_stage;

/* The stages in the order in which they ran. */
typedef struct lam_report {
  int stage_count;
  lam_stage *stages;
} lam_report;

/* ---- color maps ---- */

/* What the values of a map lie on. */
typedef enum lam_map_on { LAM_MAP_VERTICES, LAM_MAP_EDGES, LAM_MAP_FACES } lam_map_on;

/* A measure with its values on the elements of the model's net. */
typedef struct lam_map {
  lam_map_on on;
  const char *doc;     /* of the measure */
  lam_measure summary; /* its name and unit; smallest, largest and mean value */
  int count;
  const double *values;    /* count, one per element; not finite: undefined there */
  const int (*edges)[2];   /* vertices of the edges, when the values are on edges; else NULL */
  const lam_vec3 *normals; /* unit normals of the net's vertices */
  const lam_vec2 *layout; /* the net's vertices in the plane that it is compared with; NULL: none */
  double range[2]; /* of the colors, when several maps share them; 0, 0: that of the summary */
} lam_map;

/* ---- prints ---- */

/* A surface that a picture is printed on. */
typedef struct lam_printed {
  const char *name; /* unique */
  lam_trimesh mesh;
  const lam_vec2 *texture; /* per vertex: position in the picture, 0 to 1 from its lower left
                              corner */
  double max_stretch, mean_stretch; /* ratio of singular values of the map from the picture to the
                                       surface, >= 1 */
} lam_printed;

/* A picture and the surfaces it is printed on. */
typedef struct lam_print {
  int width, height;           /* pixels */
  const unsigned char *pixels; /* sRGB, 3 bytes each, rows from the top */
  int count;
  const lam_printed *sheets;
} lam_print;

/* ---- OpenSCAD ---- */

/* A number that OpenSCAD's Customizer shows and that a person may change. */
typedef struct lam_setting {
  const char *name;    /* OpenSCAD variable */
  const char *section; /* Customizer group */
  const char *range;   /* Customizer comment such as "[0:0.05:2]"; NULL: none */
  const char *doc;
  double value;   /* meters when it is a length */
  bool is_length; /* written in millimeters */
} lam_setting;

/* How the records of one kind of part are rebuilt: the template, its columns and its settings. */
typedef struct lam_record_kind {
  const char *kind; /* part kind */
  const char *scad; /* file in templates/scad */
  int column_count;
  const lam_record_column *columns;
  int setting_count;
  const lam_setting *settings;
} lam_record_kind;

/* ---- the model ---- */

/* The picture that is rendered of the scene. */
typedef struct lam_picture {
  const char *setting; /* a file of templates/pov without its ending */
  const char *view;    /* a view that the setting knows, or "auto" */
  int width, height;   /* pixels; 0: there is nothing to see, and the texts are NULL */
  const char *quality; /* an entry of render.ini */
} lam_picture;

typedef struct lam_model {
  const char *name;    /* of the design, and of its files */
  const char *title;   /* the name when the design has none */
  const char *source;  /* of the design; empty when it has none */
  const char *version; /* of the library that built it */

  /* Of all positions below, in the coordinates of what the design was built from, meters: (0, 0, 0)
   * unless that lies far away. */
  lam_vec3 origin;

  /* The net, and the lines and surfaces of the geometry. */
  const lam_mesh *net; /* NULL: the design has none */
  int polyline_count;
  const lam_polyline *polylines; /* lines of the net, of both families */
  int frame_count;               /* states of the net on its way to the result; 0: none were kept */
  const lam_vec3 *const *frames; /* frame_count x vertices: positions of the net's vertices */
  int surface_count;
  const lam_spline_surface *surfaces; /* smooth surfaces that are splines */
  int curve_count;
  const lam_named_curve *curves; /* axes of lamellas; without them, lines of the net */

  /* What is made. */
  int part_count;
  const lam_part *parts;
  int record_kind_count;
  const lam_record_kind *record_kinds; /* one per kind of part that has records */
  int crossing_count;
  const lam_crossing *crossings;
  int sheet_count;
  const lam_sheet *sheets;
  int support_count;
  const lam_vec3 *supports; /* net vertices on the ground */

  /* What is told and shown. */
  const lam_report *report;
  int map_count;
  const lam_map *maps;    /* of the net; none without a net */
  const lam_print *print; /* what is shown instead of the net; NULL: nothing */
  lam_picture picture;
} lam_model;

LAM_END_DECLS

#endif
