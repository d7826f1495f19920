/*
 * export.h - the command `export`: a game as one file that runs by itself.
 * floor: cab
 *
 * The file is a copy of this program, without what debuggers read and without the game that is built in, then, at a
 * multiple of ROM_ALIGN, the ROM. The copy's mark (mark.h) says where.
 */
#ifndef CAB_EXPORT_H
#define CAB_EXPORT_H

#include "../args.h"
#include "../host/result.h"

/* Exit code and sentence as everywhere. */
enum result export_run(const struct args *a);

#endif
