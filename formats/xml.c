/* Escaped text of XML, for the SVG writers in formats/sheets and formats/plot. */
#include "formats/xml.h"

/* A > needs no entity, in text or in an attribute. */
void lam_xml_escaped(lam_text *out, const char *string) {
  for (; *string; string++) {
    const char *entity = *string == '&'   ? "&amp;"
                         : *string == '<' ? "&lt;"
                         : *string == '"' ? "&quot;"
                                          : NULL;
    if (entity)
      lam_text_add(out, entity);
    else if ((unsigned char)*string >= ' ')
      lam_text_bytes(out, string, 1);
  }
}
