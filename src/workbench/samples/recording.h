/*
 * recording.h - makes a sound or music for the board from a sample file.
 */
#ifndef WORKBENCH_RECORDING_H
#define WORKBENCH_RECORDING_H

#include "../../rom/manifest.h"
#include "pcm.h"

/* Reads a file in the format of its suffix; free the result with pcm_free. Skips ID3 tags around the file. Errors don't
 * name the file. */
bool recording_read(const char *file, const uint8_t *data, size_t n, const struct art_loop *loop, struct pcm *out,
                    char *err, size_t err_size);

/* Sets the loop of rom.lua, if any, and calls pcm_prepare. */
bool recording_prepare(struct pcm *p, const struct art_loop *loop, char *err, size_t err_size);

/* data is malloc. */
struct recording_bytes {
    uint8_t *data;
    size_t n;
};

/* Makes a sound of p after recording_prepare: a tune (tune.h) with its samples. */
bool recording_sound(const struct pcm *p, const struct art_sound *s, struct recording_bytes *tune, char *err,
                     size_t err_size);

/* Makes music of p: a tune, and the samples separately. markers: art.markers. */
bool recording_music(const struct pcm *p, const struct art_sound *s, const struct art_marker *markers,
                     struct recording_bytes *tune, struct recording_bytes *wave, char *err, size_t err_size);

#endif
