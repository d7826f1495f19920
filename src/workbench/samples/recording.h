/*
 * recording.h - recordings to what the board plays: a sound, or a piece of music.
 */
#ifndef WORKBENCH_RECORDING_H
#define WORKBENCH_RECORDING_H

#include "../../rom/manifest.h"
#include "pcm.h"

/* Reads a file's bytes by the ending of its name, for this loop; pcm_free what it gives. ID3 tags around the file are
 * skipped. False and one sentence without its name. */
bool recording_read(const char *file, const uint8_t *data, size_t n, const struct art_loop *loop, struct pcm *out,
                    char *err, size_t err_size);

/* Sets the loop that rom.lua says, if it says one, and makes p ready: pcm_prepare. False and one sentence. */
bool recording_prepare(struct pcm *p, const struct art_loop *loop, char *err, size_t err_size);

/* Bytes for free. */
struct recording_bytes {
    uint8_t *data;
    size_t n;
};

/* The sound that plays p, which was prepared: a tune (tune.h) with its samples. */
bool recording_sound(const struct pcm *p, const struct art_sound *s, struct recording_bytes *tune, char *err,
                     size_t err_size);

/* The piece of music that plays p: a tune, and the samples by themselves. markers: art.markers. */
bool recording_music(const struct pcm *p, const struct art_sound *s, const struct art_marker *markers,
                     struct recording_bytes *tune, struct recording_bytes *wave, char *err, size_t err_size);

#endif
