/* Names as identifiers, for the OpenSCAD and POV-Ray writers. */
#include "formats/identifier.h"

#include <stdbool.h>

/* Different names may give the same identifier: "a-b" and "a_b". */
void lam_identifier_add(lam_text *out, const char *name) {
  for (const char *c = name; *c; c++) {
    bool plain = (*c >= 'a' && *c <= 'z') || (*c >= 'A' && *c <= 'Z') || (*c >= '0' && *c <= '9');
    lam_text_bytes(out, plain ? c : "_", 1);
  }
}
