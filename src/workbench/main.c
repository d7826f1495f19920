/*
 * main.c - the programs curtain and curtain-null; workbench.c has program_open.
 */
#include "../../platform/platform.h"
#include "../player/cli.h"

int main(int argc, char **argv)
{
    return cli_run(program_open(argc, argv));
}
