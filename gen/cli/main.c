/* The program `lamella`: finds the verb and hands it its arguments. */
#include "cli/complain.h"
#include "cli/solid_facts.h"
#include "cli/verbs.h"
#include <lamella/lamella.h>

#include <errno.h>
#include <locale.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* A line of the help. */
typedef struct verb {
  const char *name;
  int (*run)(int argc, char **argv);
  const char *doc; /* arguments, two blanks or more, a few words */
} verb;

static const verb verbs[] = {
    {"build", lam_verb_build, "DESIGN [-o DIR]      make everything that a design says"},
    {"check", lam_verb_check,
     "DESIGN               find mistakes in a design and say what it would make"},
    {"list", lam_verb_list,
     "[WHAT]                surfaces, nets, constraints, parts, formats, designs"},
    {"show", lam_verb_show, "NAME                  the reference page of anything listed"},
    {"new", lam_verb_new, "DESIGN [-o FILE]       copy a shipped design to start from"},
    {"measure", lam_verb_measure, "MESH.obj [--as NET]  independent measures of a quad mesh"},
    {"diff", lam_verb_diff, "A B [--tolerance T]   compare two meshes or two pictures"},
    {"inspect", lam_verb_inspect,
     "FILE.stl           closed? oriented? self-intersections, volume, inertia"},
    {"bench", lam_verb_bench, "[--json] [FOLDER]    how fast the solver is on this machine"},
};
enum { verb_count = sizeof verbs / sizeof *verbs };

/* All verbs in two columns: how each is called, and what it does. Returns the exit status 0. */
static int help(FILE *out) {
  fputs("lamella makes surfaces, discrete nets and the parts they are built from.\n\nusage: "
        "lamella VERB ...\n",
        out);

  for (int i = 0; i < verb_count; i++) {
    const char *gap = strstr(verbs[i].doc, "  ");
    int width = gap ? (int)(gap - verbs[i].doc) : 0;
    while (gap && *gap == ' ') gap++;

    char call[64];
    snprintf(call, sizeof call, "%s %.*s", verbs[i].name, width, verbs[i].doc);
    fprintf(out, "  %-28s %s\n", call, gap ? gap : "");
  }

  fputs("\nlamella VERB --help explains a verb. Start with: lamella list designs\n", out);
  return 0;
}

/* The version, and the instruction set that it uses. Returns the exit status 0. */
static int version(void) {
  printf("lamella %s\nlinear algebra: %s\n", LAM_VERSION, lam_kernels());
  return 0;
}

/* Says that there is no such verb, and which one may have been meant. Returns the exit status. */
static int complain_unknown(const char *given) {
  const char *names[verb_count + 1];
  for (int i = 0; i < verb_count; i++) names[i] = verbs[i].name;
  names[verb_count] = NULL;

  const char *near = lam_did_you_mean(given, names);
  return lam_complain_plain(2, "%s is not a verb%s%s%s; see lamella --help", given,
                            near ? " (did you mean " : "", near ? near : "", near ? "?)" : "");
}

/* The first argument is a verb, or asks for help or the version. Returns the exit status. */
static int run(int argc, char **argv) {
  if (argc < 2) {
    help(stderr);
    return 2;
  }
  const char *given = argv[1];
  if (strcmp(given, "--help") == 0 || strcmp(given, "-h") == 0 || strcmp(given, "help") == 0)
    return help(stdout);
  if (strcmp(given, "--version") == 0) return version();

  for (int i = 0; i < verb_count; i++)
    if (strcmp(given, verbs[i].name) == 0) return verbs[i].run(argc - 1, argv + 1);
  return complain_unknown(given);
}

/* Programs that were started and temporary files go with the program; then the signal does what it
 * does to any program. */
static void end_with(int signal_number) {
  lam_abandon();
  signal(signal_number, SIG_DFL);
  raise(signal_number);
}

/* Signals by which a person or the system ends a program. One that is ignored, as under nohup,
 * stays so. */
static void handle_signals(void) {
  static const int ending[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE};
  for (size_t i = 0; i < sizeof ending / sizeof *ending; i++)
    if (signal(ending[i], end_with) == SIG_IGN) signal(ending[i], SIG_IGN);
}

/* What a verb says must arrive: a full disk behind stdout is a failure of every verb. */
int main(int argc, char **argv) {
  setlocale(LC_ALL, "C");
  handle_signals();
  lam_json_begin();

  int status = run(argc, argv);
  bool lost = fflush(stdout) != 0;
  if (!lost && !ferror(stdout)) return status;
  lam_complain_plain(1, "stdout cannot be written%s%s", lost ? ": " : "",
                     lost ? strerror(errno) : "");
  return status ? status : 1;
}
