/* The table of materials, expanded into names and rows. Its figures go into masses, into notes
 * about the elastic limit and into the colors of glTF files. */
#include "fab/material.h"

/* Every material once: name, doc, density (kg/m^3), elastic limit (yield or bending strength
 * divided by Young's modulus), linear RGB, metallic, roughness. Above each row stand the sources of
 * strength, modulus and density; tests/unit/fab/test_material.c holds the row to them. */
#define MATERIALS(X)                                                                               \
  /* EN 10025-2: 235 MPa; EN 1993-1-1: 210 GPa; EN 1991-1-1: 77 to 78.5 kN/m^3 */                  \
  X("steel", "Structural steel S235: yield 235 MPa, modulus 210 GPa (EN 10025).", 7850, 0.0011,    \
    0.42, 0.43, 0.45, 1.0, 0.45)                                                                   \
  /* EN 10088-2: 210 (hot) to 230 MPa (cold rolled); EN 10088-1: 200 GPa, 7.9 kg/dm^3 */           \
  X("stainless", "Stainless steel 1.4301, 2B finish: yield 210 MPa, modulus 200 GPa (EN 10088).",  \
    7900, 0.00105, 0.62, 0.62, 0.61, 1.0, 0.30)                                                    \
  /* EN 10089: at least 1200 MPa; EN 13906-1: 206 GPa, 7.85 kg/dm^3 */                             \
  X("spring-steel", "Spring steel 51CrV4, tempered: yield 1200 MPa, modulus 206 GPa (EN 10132).",  \
    7850, 0.0058, 0.25, 0.26, 0.29, 1.0, 0.35)                                                     \
  /* EN 485-2: 125 MPa; EN 1999-1-1: 70 GPa; ASM Handbook, volume 2: 2.66 g/cm^3 */                \
  X("aluminum", "Aluminum EN AW-5083 H111: yield 125 MPa, modulus 70 GPa (EN 485).", 2660, 0.0018, \
    0.80, 0.81, 0.82, 1.0, 0.40)                                                                   \
  /* EN 1652: soft to 180 MPa, R350 170 MPa; data sheet of KME: 110 GPa, 8.44 g/cm^3 */            \
  X("brass", "Brass CuZn37, half hard: yield 180 MPa, modulus 110 GPa (EN 1652).", 8440, 0.0016,   \
    0.72, 0.52, 0.22, 1.0, 0.35)                                                                   \
  /* EN 636, F40 and E90: 60 MPa, 9 GPa; Handbook of Finnish Plywood: 640 to 700 kg/m^3 */         \
  X("plywood", "Birch plywood: bending strength 60 MPa, modulus 9 GPa along the outer grain.",     \
    680, 0.0066, 0.62, 0.45, 0.27, 0.0, 0.75)                                                      \
  /* DIN 68364, Wood Handbook (FPL): 90 to 93 MPa, 12 to 13.8 GPa, 550 to 600 kg/m^3 */            \
  X("larch",                                                                                       \
    "Larch lath: bending strength 90 MPa, modulus 12 GPa; half of the limit is kept for knots.",   \
    590, 0.0038, 0.50, 0.27, 0.13, 0.0, 0.70)                                                      \
  /* trade tables: 615 to 650 g/m^2 at 1 mm; Niskanen, Paper Physics: breaks from 1 % on */        \
  X("card", "Gray model card: creases at about 1 % strain.", 650, 0.0100, 0.66, 0.64, 0.58, 0.0,   \
    0.95)                                                                                          \
  /* ISO 7823-1: at least 70 MPa, 3 GPa; data sheets: to 3.3 GPa, 1.19 g/cm^3 */                   \
  X("acrylic",                                                                                     \
    "Cast acrylic sheet (PMMA): tensile strength 70 MPa, modulus 3.3 GPa; half of the limit.",     \
    1190, 0.0106, 0.85, 0.90, 0.92, 0.0, 0.10)                                                     \
  /* data sheets of PP-H: 30 to 33 MPa, 1.3 to 1.7 GPa, 0.90 to 0.92 g/cm^3 */                     \
  X("polypropylene", "Polypropylene sheet: yield 30 MPa, modulus 1.5 GPa.", 910, 0.0200, 0.88,     \
    0.88, 0.86, 0.0, 0.50)                                                                         \
  /* EN 572-1: 45 MPa, 70 GPa, 2500 kg/m^3 */                                                      \
  X("glass", "Float glass: bending strength 45 MPa, modulus 70 GPa (EN 572).", 2500, 0.00064,      \
    0.80, 0.88, 0.86, 0.0, 0.05)                                                                   \
  /* EN 14411, group BIa: 35 MPa; papers on stoneware: 58 to 72 GPa, 2.3 to 2.4 g/cm^3 */          \
  X("ceramic", "Glazed ceramic, white: bending strength 35 MPa, modulus 60 GPa (EN 14411).", 2300, \
    0.00058, 0.86, 0.85, 0.82, 0.0, 0.20)                                                          \
  /* GRCA, sprayed: 7 to 11 MPa, 10 to 20 GPa, 1.9 to 2.1 t/m^3 */                                 \
  X("concrete", "Glass-fiber concrete: limit of proportionality 7 MPa, modulus 15 GPa.", 2000,     \
    0.00047, 0.46, 0.45, 0.43, 0.0, 0.90)                                                          \
  /* as steel, for the coat is thin */                                                             \
  X("white-steel", "Structural steel S235, coated white: yield 235 MPa, modulus 210 GPa.", 7850,   \
    0.0011, 0.84, 0.84, 0.82, 0.0, 0.40)                                                           \
  /* EN 14080, GL24h: 24 MPa; in the mean 11.5 GPa, 420 kg/m^3 */                                  \
  X("spruce", "Glued spruce GL24: bending strength 24 MPa, modulus 11.5 GPa (EN 14080).", 420,     \
    0.0021, 0.66, 0.48, 0.29, 0.0, 0.70)                                                           \
  /* DIN 68364, Wood Handbook (FPL): 88 to 105 MPa, 10 to 13 GPa, 650 to 720 kg/m^3 */             \
  X("oak", "Oak: bending strength 90 MPa, modulus 12 GPa; half of the limit is kept for knots.",   \
    690, 0.0038, 0.36, 0.22, 0.11, 0.0, 0.60)                                                      \
  /* EN 1652, R240: 180 MPa; Copper Development Association: 117 to 132 GPa, 8.93 g/cm^3 */        \
  X("copper", "Copper Cu-DHP, half hard: yield 180 MPa, modulus 127 GPa (EN 1652).", 8930, 0.0014, \
    0.72, 0.34, 0.20, 1.0, 0.35)

#define NAME(name, doc, density, strain, r, g, b, metallic, roughness) name,
#define ROW(name, doc, density, strain, r, g, b, metallic, roughness)                              \
  {name, doc, density, strain, {r, g, b}, metallic, roughness},

const char *const lam_material_names[] = {MATERIALS(NAME) NULL};
const lam_material lam_materials[] = {MATERIALS(ROW)};
const int lam_material_count = sizeof lam_materials / sizeof lam_materials[0];
