/*
 * cli.h - the command line: every command of `curtain help`.
 */
#ifndef CAB_CLI_H
#define CAB_CLI_H

enum {
    EXIT_DONE = 0,
    EXIT_DIFFERS = 1, /* the thing checked does not hold */
    EXIT_INPUT = 2,   /* bad input or a script fault: one line has gone to plat_log */
    EXIT_HOST = 3     /* the host failed or stopped it: the same */
};

/* Does what argv says, with a loop of its own; argv may be rearranged. Returns the exit code. */
int cli_main(int argc, char **argv);

#endif
