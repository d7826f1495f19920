/*
 * pending.c - sections still to come.
 */
#include "lab.h"

void section_functions(void)
{
}

void section_border(void)
{
}
