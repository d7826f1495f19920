/*
 * process.h - another program that is fed through a pipe, and a terminal that somebody looks at. Hosts that have
 * neither say so.
 * floor: cab
 */
#ifndef CAB_PROCESS_H
#define CAB_PROCESS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* Is there a program of that name to be run? name: letters and digits. */
bool process_is_there(const char *name);

/* Starts a line of shell, which reads what is written. From then on a pipe that nobody reads is an error and no signal.
 * NULL: it cannot be. */
FILE *process_open(const char *command);

/* True: all was taken, and the program ended as if all went well. */
bool process_close(FILE *f);

/* A word as shell takes it, whatever is in it. False: no room. */
bool process_word(char *out, size_t size, const char *word);

/* Is standard error a terminal? */
bool process_terminal(void);

#endif
