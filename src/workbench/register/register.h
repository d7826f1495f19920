/*
 * register.h - `curtain register`: makes this program open .rom and .demo files on double click, for the current user.
 */
#ifndef WORKBENCH_REGISTER_H
#define WORKBENCH_REGISTER_H

#include "../../common/result.h"

/* Registers the program, or updates the registration; with remove, removes the registration. Prints the changes. */
enum result register_command(bool remove);

#endif
