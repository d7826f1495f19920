/*
 * art_run.h - `curtain art` and `curtain palette`.
 * floor: cab
 */
#ifndef CAB_ART_RUN_H
#define CAB_ART_RUN_H

#include "../args.h"
#include "../host/result.h"

/* Lists a game's sprites, or puts them on a picture. What is not done has been told on plat_log. */
enum result art_run(const struct args *a);

/* Puts a list of colours into a bank of a palette, or takes one out of it. */
enum result palette_run(const struct args *a);

#endif
