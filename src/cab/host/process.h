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

/* When somebody breaks this program off (Ctrl+C, SIGTERM), standard error gets `last` before it ends so. NULL: no
 * more. */
void process_last_word(const char *last);

enum { PROCESS_JOBS = 64 };

/* Processors there are, 1 to PROCESS_JOBS. */
int process_cores(void);

/* A file that nobody else sees and that is gone with fclose; NULL: the host has none. */
FILE *process_scratch(void);

/* Work in pieces, from 0 to n - 1, up to `jobs` of them at a time: each in a process of its own where the host has
 * such, so that what it does to memory, and how it ends, is nobody else's. */
struct process_work {
    void *context;
    void (*work)(void *context, int i, FILE *out);
    void (*done)(void *context, int i, const char *text, size_t n,
                 int signal);     /* what it wrote; 0: it has ended well */
    void (*waits)(void *context); /* a few times a second */
};

/* Returns when all is done. done is called in any order. False: no process, or no memory; some pieces are not done. */
bool process_each(int n, int jobs, const struct process_work *w);

#endif
