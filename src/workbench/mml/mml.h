/*
 * mml.h - compiles MML, the music language, to a tune (tune.h). docs/measured/sound.md describes the language.
 */
#ifndef WORKBENCH_MML_H
#define WORKBENCH_MML_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { MML_MAX_FILE = 1 << 20 /* bytes */ };

/* The entry of rom.lua. */
struct mml_settings {
    int volume, priority, limit; /* volume: of 255 */
    const char *title;           /* "": the title in the text */
    int duck;                    /* of 255 */
    /* Receives warnings about probable mistakes, "music/tide.mml:12:7: ..."; may be NULL. */
    void (*warn)(void *context, const char *sentence);
    void *context;
};

/* Compiles n bytes to *out (malloc), a tune that tune_validate accepts. file: the name for messages, which start with
 * "music/tide.mml:12:7: ". */
bool mml_compile(const char *text, size_t n, const char *file, const struct mml_settings *settings, uint8_t **out,
                 size_t *size, char *err, size_t err_size);

#endif
