/*
 * register.h - `curtain register`: a double click on a .rom or .demo file opens it with this program, for this user.
 */
#ifndef WORKBENCH_REGISTER_H
#define WORKBENCH_REGISTER_H

#include "../../common/result.h"

/* Sets it up, again if it was set up before; with remove, removes what it wrote. Prints what changed. */
enum result register_command(bool remove);

#endif
