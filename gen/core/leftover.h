/* What must not outlive the process: outside programs that run, temporary files that are being
 * written. Whoever begins one enters it here and takes it out again; when a signal ends the process
 * between the two, lam_leftovers_end removes it. Called by core/process.c, core/file.c, library/
 * and through lam_abandon (lamella/session.h). */
#ifndef LAM_CORE_LEFTOVER_H
#define LAM_CORE_LEFTOVER_H

#include <sys/types.h>

/* Enters a program by its process group, whose leader is a child of this process. Returns its
 * place, for lam_leftover_forget; -1: all places are taken, and nothing is entered. Any thread. */
int lam_leftover_program(pid_t group);
/* Enters a file by its name in an open folder (a descriptor, or AT_FDCWD); the name is copied. The
 * folder stays open until the file is forgotten. Returns as above; -1 for a name that is too long
 * too. */
int lam_leftover_file(int folder, const char *name);
/* Takes out what was entered; -1: nothing. */
void lam_leftover_forget(int place);

/* Kills all programs that are entered, waits for their end, and removes all files. May be called in
 * a signal handler, and by nobody but a process that is about to end. */
void lam_leftovers_end(void);

#endif
