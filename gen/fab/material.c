/* The table of materials, expanded into names and rows. Its figures go into masses, into notes
 * about the elastic limit and into the colors of glTF files. */
#include "fab/material.h"

/* Every material once: name, doc, density (kg/m^3), elastic limit (yield or bending strength
 * divided by Young's modulus), linear RGB, metallic, roughness. */
#define MATERIALS(X)                                                                               \
  X("steel", "Structural steel S235: yield 235 MPa, modulus 210 GPa (EN 10025).", 7850, 0.0011,    \
    0.42, 0.43, 0.45, 1.0, 0.45)                                                                   \
  X("stainless", "Stainless steel 1.4301, 2B finish: yield 210 MPa, modulus 200 GPa (EN 10088).",  \
    7900, 0.00105, 0.62, 0.62, 0.61, 1.0, 0.30)                                                    \
  X("spring-steel", "Spring steel 51CrV4, tempered: yield 1200 MPa, modulus 206 GPa (EN 10132).",  \
    7850, 0.0058, 0.25, 0.26, 0.29, 1.0, 0.35)                                                     \
  X("aluminum", "Aluminum EN AW-5083 H111: yield 125 MPa, modulus 70 GPa (EN 485).", 2660, 0.0018, \
    0.80, 0.81, 0.82, 1.0, 0.40)                                                                   \
  X("brass", "Brass CuZn37, half hard: yield 180 MPa, modulus 110 GPa (EN 1652).", 8440, 0.0016,   \
    0.72, 0.52, 0.22, 1.0, 0.35)                                                                   \
  X("plywood", "Birch plywood: bending strength 60 MPa, modulus 9 GPa along the outer grain.",     \
    680, 0.0066, 0.62, 0.45, 0.27, 0.0, 0.75)                                                      \
  X("larch",                                                                                       \
    "Larch lath: bending strength 90 MPa, modulus 12 GPa; half of the limit is kept for knots.",   \
    590, 0.0038, 0.50, 0.27, 0.13, 0.0, 0.70)                                                      \
  X("card", "Gray model card: creases at about 1 % strain.", 650, 0.0100, 0.66, 0.64, 0.58, 0.0,   \
    0.95)                                                                                          \
  X("acrylic",                                                                                     \
    "Cast acrylic sheet (PMMA): tensile strength 70 MPa, modulus 3.3 GPa; half of the limit.",     \
    1190, 0.0106, 0.85, 0.90, 0.92, 0.0, 0.10)                                                     \
  X("polypropylene", "Polypropylene sheet: yield 30 MPa, modulus 1.5 GPa.", 910, 0.0200, 0.88,     \
    0.88, 0.86, 0.0, 0.50)                                                                         \
  X("glass", "Float glass: bending strength 45 MPa, modulus 70 GPa (EN 572).", 2500, 0.00064,      \
    0.80, 0.88, 0.86, 0.0, 0.05)                                                                   \
  X("ceramic", "Glazed ceramic, white: bending strength 35 MPa, modulus 60 GPa (EN 14411).", 2300, \
    0.00058, 0.86, 0.85, 0.82, 0.0, 0.20)                                                          \
  X("concrete", "Glass-fiber concrete: limit of proportionality 7 MPa, modulus 15 GPa.", 2000,     \
    0.00047, 0.46, 0.45, 0.43, 0.0, 0.90)                                                          \
  X("white-steel", "Structural steel S235, coated white: yield 235 MPa, modulus 210 GPa.", 7850,   \
    0.0011, 0.84, 0.84, 0.82, 0.0, 0.40)                                                           \
  X("spruce", "Glued spruce GL24: bending strength 24 MPa, modulus 11.5 GPa (EN 14080).", 420,     \
    0.0021, 0.66, 0.48, 0.29, 0.0, 0.70)                                                           \
  X("oak", "Oak: bending strength 90 MPa, modulus 12 GPa; half of the limit is kept for knots.",   \
    690, 0.0038, 0.36, 0.22, 0.11, 0.0, 0.60)                                                      \
  X("copper", "Copper Cu-DHP, half hard: yield 180 MPa, modulus 127 GPa (EN 1652).", 8930, 0.0014, \
    0.72, 0.34, 0.20, 1.0, 0.35)

#define NAME(name, doc, density, strain, r, g, b, metallic, roughness) name,
#define ROW(name, doc, density, strain, r, g, b, metallic, roughness)                              \
  {name, doc, density, strain, {r, g, b}, metallic, roughness},

const char *const lam_material_names[] = {MATERIALS(NAME) NULL};
const lam_material lam_materials[] = {MATERIALS(ROW)};
const int lam_material_count = sizeof lam_materials / sizeof lam_materials[0];
