/* Files of surfaces as other programs write them. */
#ifndef LAM_TESTS_OTHERS_FIXTURE_H
#define LAM_TESTS_OTHERS_FIXTURE_H

#include "files_fixture.h"

/* A bilinear patch, written as OpenCASCADE and others do: lower-case words, comments, lines broken
 * anywhere, an inch.
 */
__attribute__((unused)) static const char step_inch[] =
    "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nENDSEC;\nDATA;\n"
    "#10=CARTESIAN_POINT('a;b''c',(0.,0.,0.));\n#11 = CARTESIAN_POINT ( '', ( 0., 1.,\n 0. ) ) ;\n"
    "#12=CARTESIAN_POINT($,(1.,0.,0.)); /* #12=( */ #13=CARTESIAN_POINT('',(1.,1.,2.5E-1));\n"
    "#20=B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#10,#11),(#12,#13)),.UNSPECIFIED.,.F.,.F.,.F.,(2,2),("
    "2,2),(0.,1.),"
    "(-1.,3.),.UNSPECIFIED.);\n"
    "#30=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#31,#34))"
    "REPRESENTATION_CONTEXT('',''));\n"
    "#31=(CONVERSION_BASED_UNIT('INCH',#32)LENGTH_UNIT()NAMED_UNIT(#35));\n"
    "#32=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#33);\n"
    "#33=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n"
    "#34=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));\n"
    "#35=DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);\n"
    "ENDSEC;\nEND-ISO-10303-21;\n";

/* Entity 128 in inches with other delimiters, exponents as in Fortran, left-out flags, moved by
 * entity 124: a turn by 90 degrees about z, then 10 inches along x. */
static inline lam_text iges_of_others(lam_arena *arena) {
  lam_text text = {.arena = arena};
  add_line(&text, "a comment", 'S', 1);
  add_line(&text, "1H//1H$/3Ha/b/4Ha.ig/1Hx/1Hy/32/38/6/38/15/1Hz/1./1/2HIN/1/.1/", 'G', 1);
  add_line(&text, "15H20000101.000000/1.D-3/10.$", 'G', 2);
  add_line(&text, "     124       1       0       0       0       0       0       000000000", 'D',
           1);
  add_line(&text, "     124       0       0       1       0", 'D', 2);
  add_line(&text, "     128       2       0       0       0       0       1       000000000", 'D',
           3);
  add_line(&text, "     128       0       0       3       0", 'D', 4);
  add_line(&text, "124/0./-1./0./10./1./0./0./0./0./0./1./0.$                            1", 'P',
           1);
  add_line(&text, "128/1/1/1/1///1///0.D0/0./1./1./0./0./2./2./                          3", 'P',
           2);
  add_line(&text, "1./1./1./1./0./0./0./ 1.0D+0 /0./0./0./1d0/0./                        3", 'P',
           3);
  add_line(&text, "1./1./.5/0./1./0./2.$                                                 3", 'P',
           4);
  add_line(&text, "S      1G      2D      4P      4", 'T', 1);
  return text;
}

#endif
