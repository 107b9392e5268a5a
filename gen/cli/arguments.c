/* Reading options and files. What is wrong is said with the usage after it. Called by all
 * verb_*.c. */
#include "cli/arguments.h"
#include "cli/complain.h"

#include <stdio.h>
#include <string.h>

/* The row of the option that an argument names, or NULL; *value: what follows its equals sign, or
 * NULL. options may be NULL. */
static const lam_option *find(const lam_option *options, const char *argument, const char **value) {
  const char *equals = strchr(argument, '=');
  size_t length = equals ? (size_t)(equals - argument) : strlen(argument);
  *value = equals ? equals + 1 : NULL;

  for (const lam_option *o = options; o && o->name; o++)
    if (strlen(o->name) == length && strncmp(o->name, argument, length) == 0) return o;
  return NULL;
}

/* Stores an option with the value behind its equals sign (NULL: it has none, and the next argument
 * is taken). *i is at the option, and at its value afterwards. False: it lacks a value, has an
 * empty one, or has one too many. */
static bool store(const lam_option *option, const char *value, int argc, char **argv, int *i) {
  if (option->flag) {
    *option->flag = true;
    return !value;
  }

  if (!value) {
    if (*i + 1 == argc) return false;
    value = argv[++*i];
  }

  /* An empty name would stand for something that nobody has meant, such as the top folder. */
  if (!option->values && !*value) return false;

  if (option->values)
    option->values[(*option->count)++] = value;
  else
    *option->value = value;
  return true;
}

/* What is no option is a file; a single dash is one too. */
int lam_arguments_read(const lam_arguments *arguments, int argc, char **argv, const char **files,
                       int *count) {
  *count = 0;
  for (int i = 1; i < argc; i++) {
    const char *given = argv[i], *value;
    if (strcmp(given, "--help") == 0) return puts(arguments->usage) < 0;

    const lam_option *option = find(arguments->options, given, &value);
    if (option && !store(option, value, argc, argv, &i))
      return lam_complain_plain(2, "%s: %s %s\n%s", argv[0], option->name,
                                option->flag ? "takes no value" : "needs a value",
                                arguments->usage);
    if (option) continue;

    if ((given[0] == '-' && given[1]) || *count == arguments->most)
      return lam_complain_plain(2, "%s: %s is not expected here\n%s", argv[0], given,
                                arguments->usage);
    files[(*count)++] = given;
  }

  if (*count >= arguments->least) return -1;
  return lam_complain_plain(2, "%s: expected %s\n%s", argv[0], arguments->noun, arguments->usage);
}
