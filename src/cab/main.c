/*
 * main.c - the program `curtain`. The only file that hands the host an exit code.
 */
#include "cli.h"

int main(int argc, char **argv)
{
    return cli_main(argc, argv);
}
