/*
 * mml.h - music and sounds as their author writes them, compiled to a tune (tune.h). docs/measured/sound.md has the
 * language.
 */
#ifndef WORKBENCH_MML_H
#define WORKBENCH_MML_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { MML_FILE = 1 << 20 /* bytes */ };

/* What rom.lua says of it. */
struct mml_about {
    int volume, priority, limit; /* of 255 */
    const char *title;           /* "": what the text says */
    int duck;                    /* of 255 */
    /* Is told what is allowed and not meant, "music/tide.mml:12:7: ..."; NULL: nobody is. */
    void (*warn)(void *context, const char *sentence);
    void *context;
};

/* Compiles the n bytes; file is their name for messages. *out (free it) is a tune that tune_validate takes. False and
 * one sentence, "music/tide.mml:12:7: ..." */
bool mml_compile(const char *text, size_t n, const char *file, const struct mml_about *about, uint8_t **out,
                 size_t *size, char *err, size_t err_size);

#endif
