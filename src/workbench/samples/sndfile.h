/*
 * sndfile.h - recordings in OGG (Vorbis, Opus) and FLAC files, which libsndfile reads: the only place that knows it.
 *
 * The loop of the tags LOOPSTART and LOOPLENGTH (or LOOPEND, the frame behind it) is kept; those of Opus count at
 * 48 kHz.
 */
#ifndef WORKBENCH_SNDFILE_H
#define WORKBENCH_SNDFILE_H

#include "pcm.h"

/* Reads a file's bytes; pcm_free what it gives. False and one sentence without the file's name. */
bool sndfile_read(const uint8_t *data, size_t n, struct pcm *out, char *err, size_t err_size);

#endif
