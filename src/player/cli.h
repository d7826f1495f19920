/*
 * cli.h - the command line: every command of `curtain help`.
 */
#ifndef PLAYER_CLI_H
#define PLAYER_CLI_H

enum {
    EXIT_DONE = 0,
    EXIT_DIFFERS = 1, /* the thing checked does not hold */
    EXIT_INPUT = 2,   /* bad input or a script fault: one line has gone to plat_log */
    EXIT_HOST = 3     /* the host failed or stopped it: the same */
};

struct program;
struct workbench;

/* Starts what argv says (platform.h, program_open); argv may be rearranged. workbench: NULL: there is none. Returns
 * NULL when out of memory. */
struct program *cli_open(int argc, char **argv, const struct workbench *workbench);

/* Runs the program to its end and closes it. Returns the exit code. p may be NULL. */
int cli_run(struct program *p);

#endif
