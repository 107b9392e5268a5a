/* Text between tags or in an attribute of XML. */
#ifndef LAM_FORMATS_XML_H
#define LAM_FORMATS_XML_H

#include "core/text.h"

/* Markup characters become entities, control characters are dropped. */
void lam_xml_escaped(lam_text *out, const char *string);

#endif
