/*
 * main.c - the program curtain-player.
 */
#include "../../platform/platform.h"
#include "cli.h"

struct program *program_open(int argc, char **argv)
{
    return cli_open(argc, argv, NULL);
}

int main(int argc, char **argv)
{
    return cli_run(program_open(argc, argv));
}
