/*
 * cli.h - runs the program's commands.
 */
#ifndef PLAYER_CLI_H
#define PLAYER_CLI_H

enum {
    EXIT_DONE = 0,
    EXIT_DIFFERS = 1, /* a check failed */
    EXIT_INPUT = 2,   /* bad input or a script fault; plat_log has the error */
    EXIT_HOST = 3     /* the host failed or stopped the program; plat_log has the error */
};

struct program;
struct workbench;

/* Starts the command in argv (platform.h, program_open); argv may be rearranged. workbench may be NULL. Returns NULL
 * when out of memory. */
struct program *cli_open(int argc, char **argv, const struct workbench *workbench);

/* Runs the program to its end and closes it. Returns the exit code. p may be NULL. */
int cli_run(struct program *p);

#endif
