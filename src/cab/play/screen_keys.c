/*
 * screen_keys.c - every key and button, what it does, and another one in its place by pressing it.
 */
#include <stdio.h>
#include <string.h>
#include "cab_parts.h"

void cab_open_keys(void)
{
}
