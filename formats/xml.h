/* Text between tags or in an attribute of XML; for the writers of SVG (formats/sheets,
 * formats/plot). */
#ifndef LAM_FORMATS_XML_H
#define LAM_FORMATS_XML_H

#include "core/text.h"

/* Adds string with &, <, > and " as entities. Control characters are dropped, what is no character
 * in UTF-8 becomes a question mark, everything else stays as it is. Fit for attributes in double
 * quotes. */
void lam_xml_escaped(lam_text *out, const char *string);

#endif
