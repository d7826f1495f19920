/*
 * module.h - tracker modules (.xm .it .s3m .mod), rendered by libopenmpt: the only place that knows it.
 * floor: cab
 *
 * What is kept is the first pass and, where it differs, the one that follows itself: the loop is exact to the sample. A
 * pass is all from where the module repeats to its end.
 */
#ifndef CAB_MODULE_H
#define CAB_MODULE_H

#include "pcm.h"

/* Reads a file's bytes; pcm_free what it gives. False and one sentence without the file's name. */
bool module_read(const uint8_t *data, size_t n, struct pcm *out, char *err, size_t err_size);

#endif
