/*
 * speaker.c - see speaker.h.
 *
 * Our clock makes 48000 frames in what we think is a second, the speaker's uses them up in what it thinks is one. The
 * queue shows the difference; each block is stretched by at most 4 frames in 800 against it, far below what an ear can
 * tell. A queue that ran dry is primed with silence again.
 */
#include "speaker.h"

#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../board/board.h"

void speaker_stretch(const int16_t last[2], const int16_t *in, int16_t *out, int n)
{
    for (int i = 0; i < n; i++) {
        int at = (i + 1) * SPEAKER_BLOCK, k = at / n, rest = at % n;
        for (int c = 0; c < 2; c++) {
            int b = rest ? in[2 * k + c] : 0, a = k ? in[2 * (k - 1) + c] : last[c];
            out[2 * i + c] = (int16_t)(a + (rest ? (b - a) * rest / n : 0));
        }
    }
}

static int block_length(int waiting)
{
    int n = (SPEAKER_AHEAD - waiting) / 128;
    n = n > SPEAKER_STRETCH ? SPEAKER_STRETCH : n < -SPEAKER_STRETCH ? -SPEAKER_STRETCH : n;
    return SPEAKER_BLOCK + n;
}

/* The tables are made when they are first needed. */
static bool ready(struct speaker *s, const struct board *b)
{
    if (s->muted || !board_has_sound(b))
        return false;
    if (!s->tables && (s->tables = malloc(board_sound_tables())) != NULL)
        board_sound_open(s->tables);
    return s->tables != NULL;
}

void speaker_close(struct speaker *s)
{
    free(s->tables);
    s->tables = NULL;
}

void speaker_play(struct speaker *s, const struct board *b)
{
    static const int16_t silence[2 * SPEAKER_BLOCK];
    int16_t loud[2 * SPEAKER_BLOCK], out[2 * (SPEAKER_BLOCK + SPEAKER_STRETCH)];
    if (!ready(s, b))
        return;
    int waiting = plat_sound(silence, 0);
    if (waiting < 0)
        return;
    if (waiting == 0)
        for (int i = 1; i < SPEAKER_AHEAD / SPEAKER_BLOCK; i++)
            plat_sound(silence, SPEAKER_BLOCK);
    board_sound(b, s->tables, loud);
    for (int i = 0; i < 2 * SPEAKER_BLOCK; i++)
        loud[i] = (int16_t)(loud[i] * s->volume / 100);
    int n = waiting ? block_length(waiting) : SPEAKER_BLOCK;
    speaker_stretch(s->last, loud, out, n);
    memcpy(s->last, loud + 2 * (SPEAKER_BLOCK - 1), sizeof s->last);
    plat_sound(out, n);
}
