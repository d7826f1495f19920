/*
 * mml_tune.c - writes the bytes of a tune. Events are sorted by time, and at the same time by their order in the text.
 */
#include "mml_parts.h"

#include <stdlib.h>
#include <string.h>
#include "../../base/bytes.h"
#include "../../common/array.h"

struct output {
    struct mml *m;
    uint8_t *p; /* malloc */
    size_t n;
};

static void add_byte(struct output *b, uint8_t v)
{
    if (b->n == TUNE_MAX_BYTES || !array_append(&b->p, b->n, 1)) {
        free(b->p);
        mml_fail(b->m, 0, "longer than %d bytes (with loops expanded)", (int)TUNE_MAX_BYTES);
    }
    b->p[b->n++] = v;
}

static void add_bytes(struct output *b, const void *p, size_t n)
{
    for (size_t i = 0; i < n; i++)
        add_byte(b, ((const uint8_t *)p)[i]);
}

static void add_zeros(struct output *b, size_t n)
{
    while (n-- > 0)
        add_byte(b, 0);
}

static void add_ticks(struct output *b, uint32_t v)
{
    for (; v > 127; v >>= 7)
        add_byte(b, (uint8_t)(v | 128));
    add_byte(b, (uint8_t)v);
}

static int compare_events(const void *a, const void *b)
{
    const struct mml_event *x = a, *y = b;

    if (x->tick != y->tick)
        return x->tick < y->tick ? -1 : 1;
    return x->order < y->order ? -1 : x->order > y->order;
}

void mml_sort(struct mml_track *t)
{
    if (t->n > 0)
        qsort(t->events, t->n, sizeof *t->events, compare_events);
}

static void add_event(struct output *b, const struct mml_event *e)
{
    const uint8_t value[4] = { (uint8_t)e->value, (uint8_t)(e->value >> 8), (uint8_t)e->value2,
                               (uint8_t)(e->value2 >> 8) };
    const int n = e->event == TUNE_GLIDE                                                     ? 4
                  : e->event == TUNE_NOTE || e->event == TUNE_SLUR || e->event == TUNE_TEMPO ? 2
                  : e->event == TUNE_OFF || e->event == TUNE_END                             ? 0
                                                                                             : 1;
    add_byte(b, e->event);
    add_bytes(b, value, (size_t)n);
}

int mml_tempo_at(const struct mml_track *c, uint32_t tick)
{
    int tempo = 12000;

    for (uint32_t i = 0; i < c->n && c->events[i].tick <= tick; i++)
        if (c->events[i].event == TUNE_TEMPO)
            tempo = c->events[i].value;
    return tempo;
}

/* Returns the order of the loop's first event. A note that is released at the start of the loop is released before
 * it. */
static uint32_t first_loop_order(const struct mml_track *t)
{
    uint32_t order = UINT32_MAX;

    for (uint32_t i = 0; t->loop >= 0 && i < t->n; i++)
        if (t->events[i].tick >= (uint64_t)t->loop && t->events[i].event != TUNE_OFF && t->events[i].order < order)
            order = t->events[i].order;
    return order;
}

/* Starts the loop after an event that changes nothing, so that the times in the loop are relative to its start. */
static uint32_t start_loop(struct output *b, const struct mml_track *t, uint32_t now)
{
    const uint32_t tick = (uint32_t)t->loop;
    const struct mml_event off = { .event = TUNE_OFF },
                           tempo = { .event = TUNE_TEMPO, .value = (uint16_t)mml_tempo_at(&b->m->conductor, tick) };

    add_ticks(b, tick - now);
    add_event(b, t == &b->m->conductor ? &tempo : &off);
    return (uint32_t)b->n;
}

/* Writes a track; returns the offset of its loop, or 0. */
static uint32_t add_track(struct output *b, struct mml_track *t)
{
    const uint32_t first = first_loop_order(t);
    uint32_t now = 0, loop = 0;

    mml_sort(t);
    for (uint32_t i = 0; i < t->n && t->events[i].tick <= t->end; i++) {
        const struct mml_event *e = &t->events[i];
        const bool in_loop =
            t->loop >= 0 && (e->tick > (uint64_t)t->loop || (e->tick == (uint64_t)t->loop && e->order >= first));
        if (in_loop && !loop) {
            loop = start_loop(b, t, now);
            now = (uint32_t)t->loop;
        }
        add_ticks(b, e->tick - now);
        add_event(b, e);
        now = e->tick;
    }
    add_ticks(b, t->end - now);
    add_byte(b, TUNE_END);
    return loop;
}

/* Checks that all loops have the same length. The conductor gets the loop of the first track that has one. */
static void check_loops(struct mml *m)
{
    int first = -1;

    for (int i = 0; i < TUNE_MAX_TRACKS; i++) {
        const struct mml_track *t = &m->tracks[i];
        if (!t->used || t->loop < 0)
            continue;
        if (first < 0)
            first = i;
        const struct mml_track *f = &m->tracks[first];
        if (t->end - t->loop != f->end - f->loop)
            mml_fail(m, t->loop_from,
                     "track %c loops every %u ticks, track %c every %u (%d per quarter note): they would drift apart",
                     'A' + i, (unsigned)(t->end - t->loop), 'A' + first, (unsigned)(f->end - f->loop),
                     (int)TUNE_QUARTER);
    }
    if (first >= 0) {
        m->conductor.loop = m->tracks[first].loop;
        m->conductor.end = m->tracks[first].end;
        return;
    }
    for (int i = 0; i < TUNE_MAX_TRACKS; i++)
        if (m->tracks[i].used && m->tracks[i].end > m->conductor.end)
            m->conductor.end = m->tracks[i].end;
}

static void prepare_conductor(struct mml *m)
{
    struct mml_track *c = &m->conductor;

    mml_sort(c);
    for (uint32_t i = 0; i < c->n; i++)
        c->events[i].order = i;
    if (c->loop >= 0)
        mml_add(m, c, (uint32_t)c->loop, TUNE_TEMPO, mml_tempo_at(c, (uint32_t)c->loop), 0);
    else if (c->n == 0)
        mml_add(m, c, 0, TUNE_TEMPO, mml_tempo_at(c, 0), 0);
}

static void set_track_offset(struct output *b, int k, size_t at, uint32_t loop)
{
    bytes_put32(b->p + TUNE_HEADER_SIZE + TUNE_TITLE_SIZE + 8 * (size_t)k, (uint32_t)at);
    bytes_put32(b->p + TUNE_HEADER_SIZE + TUNE_TITLE_SIZE + 8 * (size_t)k + 4, loop);
}

/* Offsets of the table numbers in an instrument's bytes. */
static const uint8_t table_fields[] = { INST_WAVE_AT, INST_CURVES_AT, INST_CURVES_AT + 4, INST_CURVES_AT + 8 };

/* Writes the tables of the instruments, which are at `insts`, and replaces table numbers by offsets from the
 * instrument. */
static void add_tables(struct output *b, size_t insts)
{
    struct mml *m = b->m;

    for (int i = 0; i < m->n_insts; i++)
        for (size_t k = 0; k < sizeof table_fields; k++) {
            const size_t inst = insts + INST_BYTES * (size_t)i;
            const uint32_t number = bytes_get32(b->p + inst + table_fields[k]);
            if (number == 0)
                continue;
            struct mml_table *table = &m->tables[number - 1];
            if (table->at == 0) {
                table->at = (uint32_t)b->n;
                add_bytes(b, table->bytes, table->n);
            }
            bytes_put32(b->p + inst + table_fields[k], table->at - (uint32_t)inst);
        }
}

static void add_header(struct output *b, const struct mml_settings *settings, int tracks)
{
    struct mml *m = b->m;
    uint8_t header[TUNE_HEADER_SIZE] = {
        TUNE_FORMAT,     (uint8_t)settings->volume, (uint8_t)settings->priority, (uint8_t)settings->limit,
        (uint8_t)m->bar, (uint8_t)tracks,           (uint8_t)m->n_insts,         (uint8_t)m->n_markers
    };
    char title[TUNE_TITLE_SIZE] = "";

    header[TUNE_DUCK_AT] = (uint8_t)settings->duck;
    bytes_put32(header + 8, (uint32_t)mml_tempo_at(&m->conductor, 0));
    memcpy(title, settings->title && settings->title[0] ? settings->title : m->title,
           settings->title && settings->title[0] ? strlen(settings->title) : sizeof title);
    add_bytes(b, header, sizeof header);
    add_bytes(b, title, sizeof title);
    add_zeros(b, 8 * ((size_t)tracks + 1));
    add_bytes(b, m->insts, (size_t)m->n_insts * INST_BYTES);
    add_bytes(b, m->markers, (size_t)m->n_markers * TUNE_NAME_SIZE);
    add_tables(b, TUNE_HEADER_SIZE + TUNE_TITLE_SIZE + 8 * ((size_t)tracks + 1));
}

void mml_make(struct mml *m, const struct mml_settings *settings, uint8_t **out, size_t *size)
{
    struct output b = { m, NULL, 0 };
    int last = TUNE_MAX_TRACKS - 1;

    while (!m->tracks[last].used)
        last--;
    check_loops(m);
    prepare_conductor(m);
    add_header(&b, settings, last + 1);
    for (int k = 0; k <= last + 1; k++) {
        struct mml_track *t = k == 0 ? &m->conductor : &m->tracks[k - 1];
        const size_t at = b.n;
        const uint32_t loop = add_track(&b, t);
        set_track_offset(&b, k, at, loop);
    }
    add_zeros(&b, 8 + (0 - b.n) % 4);
    bytes_put32(b.p + 16, (uint32_t)b.n);
    *out = b.p;
    *size = b.n;
}
