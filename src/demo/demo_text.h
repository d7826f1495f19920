/*
 * demo_text.h - a demo as lines of text inside another text file, such as a report sent by mail.
 *
 * The lines between DEMO_TEXT_BEGIN and DEMO_TEXT_END are the demo's bytes in base64, 72 characters a line. Lines
 * before and after may contain anything.
 */
#ifndef DEMO_DEMO_TEXT_H
#define DEMO_DEMO_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define DEMO_TEXT_BEGIN "-----BEGIN CURTAIN DEMO-----"
#define DEMO_TEXT_END   "-----END CURTAIN DEMO-----"

enum { DEMO_TEXT_LINE_LENGTH = 72 };

/* A writer that takes bytes in chunks. It allocates no memory, so a crash handler can use it. */
struct demo_text {
    void (*write)(void *context, const void *bytes, size_t n);
    void *context;
    uint8_t pending[3];
    int n_pending;                        /* bytes in pending */
    char line[DEMO_TEXT_LINE_LENGTH + 1]; /* plus a \n */
    int line_length;                      /* characters in line */
};

void demo_text_begin(struct demo_text *t, void (*write)(void *context, const void *bytes, size_t n), void *context);
void demo_text_add(struct demo_text *t, const void *bytes, size_t n);
void demo_text_end(struct demo_text *t);

/* Finds a demo in the text in data, *size bytes, and decodes it in place: data and *size become the demo's. Returns
 * false, and changes nothing, when no line starts with DEMO_TEXT_BEGIN. Decoding stops at the end of the text or at the
 * first character that is not base64; the demo's CRCs detect damage. */
bool demo_text_decode(uint8_t *data, size_t *size);

#endif
