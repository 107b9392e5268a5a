/* Escaped text of XML, for the SVG writers in formats/sheets and formats/plot. */
#include "formats/xml.h"

/* A > needs its entity behind ]]. */
static const char *entity_of(char c) {
  switch (c) {
  case '&':
    return "&amp;";
  case '<':
    return "&lt;";
  case '>':
    return "&gt;";
  case '"':
    return "&quot;";
  default:
    return NULL;
  }
}

void lam_xml_escaped(lam_text *out, const char *string) {
  for (int size; *string; string += size ? size : 1) {
    size = lam_utf8_size(string);
    const char *entity = entity_of(*string);
    if (entity)
      lam_text_add(out, entity);
    else if ((unsigned char)*string >= ' ')
      lam_text_bytes(out, size ? string : "?", size ? (size_t)size : 1);
  }
}
