/*
 * module.h - tracker modules (.xm .it .s3m .mod), rendered by libopenmpt: the only place that knows it.
 *
 * A pass is everything from where the module repeats to its end. With a loop, the first pass is followed by the one
 * that repeats exactly, where that is another one; without it, the first pass is all.
 */
#ifndef WORKBENCH_MODULE_H
#define WORKBENCH_MODULE_H

#include "pcm.h"

/* Reads a file's bytes, with the module's own loop if `loops`; pcm_free what it gives. False and one sentence without
 * the file's name. */
bool module_read(const uint8_t *data, size_t n, bool loops, struct pcm *out, char *err, size_t err_size);

#endif
