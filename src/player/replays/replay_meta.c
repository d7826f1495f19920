/*
 * replay_meta.c - reads and writes a replay's metadata (replay_meta.h). One function walks over the fields for reading
 * and writing, so the two cannot disagree.
 */
#include "replay_meta.h"

#include <stdio.h>
#include <string.h>
#include "../../base/bytes.h"
#include "../../base/hash.h"
#include "../../common/clean.h"

enum { FORMAT = 2, HEADER_SIZE = 12 /* bytes before the fields */ };
static const char magic[] = "CCRD";

/* Writes the fields to `out`, or reads them from `in`. */
struct walk {
    uint8_t *out; /* NULL: read */
    const uint8_t *in;
    size_t at, size;
    uint32_t format;
    bool failed;
};

/* Writes or reads an integer field of 1, 4 or 8 bytes. */
static void walk_number(struct walk *w, void *field, size_t size)
{
    uint64_t v = size == 8 ? *(uint64_t *)field : size == 4 ? *(uint32_t *)field : *(uint8_t *)field;

    if (w->size - w->at < size) {
        w->failed = true;
        return;
    }
    if (!w->out)
        v = 0;
    for (size_t i = 0; i < size; i++, w->at++) {
        if (w->out)
            w->out[w->at] = (uint8_t)(v >> 8 * i);
        else
            v |= (uint64_t)w->in[w->at] << 8 * i;
    }
    if (size == 8)
        *(uint64_t *)field = v;
    else if (size == 4)
        *(uint32_t *)field = (uint32_t)v;
    else
        *(uint8_t *)field = (uint8_t)v;
}

#define WALK(w, field) walk_number(w, &(field), sizeof(field))

/* Writes or reads a text: its length and its bytes. Rejects NUL bytes and cleans control characters when reading. */
static void walk_text(struct walk *w, char *s, size_t capacity)
{
    uint8_t n = w->out ? (uint8_t)strlen(s) : 0;

    WALK(w, n);
    if (w->failed || n >= capacity || w->size - w->at < n) {
        w->failed = true;
        return;
    }
    if (w->out) {
        memcpy(w->out + w->at, s, n);
    } else {
        memcpy(s, w->in + w->at, n);
        s[n] = 0;
        w->failed = w->failed || strlen(s) != n;
        clean_line(s);
    }
    w->at += n;
}

static void walk_row(struct walk *w, struct replay_meta_row *r)
{
    walk_text(w, r->table, sizeof r->table);
    walk_text(w, r->row.ship, sizeof r->row.ship);
    walk_text(w, r->row.name, sizeof r->row.name);
    WALK(w, r->row.score);
    WALK(w, r->row.stage);
    WALK(w, r->row.continues);
}

static void walk(struct walk *w, struct replay_meta *c)
{
    uint8_t end = (uint8_t)c->end, rows = (uint8_t)c->rows;

    WALK(w, c->hash);
    WALK(w, c->bytes);
    WALK(w, c->date);
    WALK(w, c->rom);
    WALK(w, c->game);
    WALK(w, c->seed);
    WALK(w, c->core);
    WALK(w, c->flags);
    WALK(w, c->first);
    WALK(w, c->last);
    WALK(w, end);
    WALK(w, c->players);
    WALK(w, c->stages);
    walk_text(w, c->id, sizeof c->id);
    walk_text(w, c->ship, sizeof c->ship);
    walk_text(w, c->difficulty, sizeof c->difficulty);
    for (int p = 0; p < MAX_PLAYERS; p++)
        WALK(w, c->points[p]);
    walk_text(w, c->name, sizeof c->name);
    if (w->format > 1) {
        WALK(w, c->is_favourite);
        walk_text(w, c->stage, sizeof c->stage);
        walk_text(w, c->mission, sizeof c->mission);
    }
    WALK(w, rows);
    w->failed = w->failed || c->is_favourite > 1 || end >= REPLAY_ENDS || rows > REPLAY_MAX_ROWS || c->first > c->last;
    c->end = w->failed ? REPLAY_LEFT : (enum replay_meta_end)end;
    c->rows = w->failed ? 0 : rows;
    for (int i = 0; i < c->rows; i++)
        walk_row(w, &c->row[i]);
}

size_t replay_meta_write(const struct replay_meta *c, const struct thumb *t, uint8_t *out)
{
    struct replay_meta copy = *c;
    struct walk w = { .out = out, .at = HEADER_SIZE, .size = REPLAY_META_HEAD - 4, .format = FORMAT };
    const size_t pixels = (size_t)t->w * (size_t)t->h;

    walk(&w, &copy);
    memcpy(out, magic, 4);
    bytes_put32(out + 4, FORMAT);
    bytes_put32(out + 8, (uint32_t)(w.at - HEADER_SIZE));
    bytes_put32(out + w.at, hash_crc32(out, w.at));
    uint8_t *p = out + w.at + 4;
    p[0] = (uint8_t)t->w;
    p[1] = (uint8_t)t->h;
    memcpy(p + 2, t->pix, pixels);
    bytes_put32(p + 2 + pixels, hash_crc32(p, 2 + pixels));
    return w.at + 4 + 2 + pixels + 4;
}

/* Returns where the fields end; 0 if the file is not valid metadata. */
static size_t fields_end(const uint8_t *data, size_t size)
{
    if (size < HEADER_SIZE + 4 || memcmp(data, magic, 4) != 0 || bytes_get32(data + 4) < 1 ||
        bytes_get32(data + 4) > FORMAT)
        return 0;
    const size_t n = bytes_get32(data + 8);
    if (n > REPLAY_META_HEAD - HEADER_SIZE - 4 || n > size - HEADER_SIZE - 4)
        return 0;
    return bytes_get32(data + HEADER_SIZE + n) == hash_crc32(data, HEADER_SIZE + n) ? HEADER_SIZE + n : 0;
}

bool replay_meta_read(struct replay_meta *c, const uint8_t *data, size_t size)
{
    struct walk w = { .in = data, .at = HEADER_SIZE, .size = fields_end(data, size) };

    memset(c, 0, sizeof *c);
    if (w.size == 0)
        return false;
    w.format = bytes_get32(data + 4);
    walk(&w, c);
    if (!w.failed && w.at == w.size)
        return true;
    memset(c, 0, sizeof *c);
    return false;
}

bool replay_meta_read_thumb(struct thumb *t, const uint8_t *data, size_t size)
{
    const size_t at = fields_end(data, size) + 4;

    t->w = t->h = 0;
    if (at == 4 || size < at + 2)
        return false;
    const size_t pixels = (size_t)data[at] * data[at + 1];
    if (pixels == 0 || data[at] > THUMB_SIDE || data[at + 1] > THUMB_SIDE || size != at + 2 + pixels + 4 ||
        bytes_get32(data + at + 2 + pixels) != hash_crc32(data + at, 2 + pixels))
        return false;
    for (size_t i = 0; i < pixels; i++)
        if (data[at + 2 + i] >= THUMB_COLOURS)
            return false;
    t->w = data[at];
    t->h = data[at + 1];
    memcpy(t->pix, data + at + 2, pixels);
    return true;
}

static enum replay_meta_end end_of(const struct demo *d, const struct board_marker *over)
{
    if (!over)
        return d->fault ? REPLAY_FAULT : REPLAY_LEFT;
    return strcmp(over->name, "clear") == 0  ? REPLAY_CLEAR
           : strcmp(over->name, "quit") == 0 ? REPLAY_QUIT
                                             : REPLAY_OVER;
}

/* Copies what a marker within the run says. */
static void take_marker(struct replay_meta *c, const struct board_marker *m)
{
    if (m->kind == MARKER_STAGE)
        snprintf(c->stage, sizeof c->stage, "%s", m->name);
    else if (m->kind == MARKER_MISSION)
        snprintf(c->mission, sizeof c->mission, "%s", m->name);
    else if (m->kind == MARKER_DIFFICULTY)
        snprintf(c->difficulty, sizeof c->difficulty, "%.15s", m->name);
}

bool replay_meta_of_demo(struct replay_meta *c, const struct demo *d)
{
    const struct demo_marker *game = NULL, *over = NULL;

    memset(c, 0, sizeof *c);
    for (uint32_t i = 0; i < d->n_markers; i++) {
        if (d->markers[i].marker.kind == MARKER_GAME) {
            memset(c, 0, sizeof *c);
            game = &d->markers[i];
            over = NULL;
        } else if (d->markers[i].marker.kind == MARKER_OVER && game) {
            over = &d->markers[i];
        } else if (game && !over) {
            take_marker(c, &d->markers[i].marker);
        }
    }
    if (!game)
        return false;
    c->rom = d->rom_hash;
    c->game = d->game_hash;
    c->seed = d->start.seed;
    c->core = d->core_version;
    c->flags = d->flags;
    c->first = game->frame;
    c->last = d->frames;
    c->end = end_of(d, over ? &over->marker : NULL);
    c->players = (uint8_t)(game->marker.value < 0 || game->marker.value > MAX_PLAYERS ? 0 : game->marker.value);
    c->stages = (uint8_t)(over && over->marker.value > 0 && over->marker.value < 256 ? over->marker.value : 0);
    snprintf(c->id, sizeof c->id, "%s", d->id);
    snprintf(c->ship, sizeof c->ship, "%s", game->marker.name);
    for (int p = 0; p < MAX_PLAYERS; p++)
        demo_points(d, p, &c->points[p]);
    return true;
}

void replay_meta_take_name(struct replay_meta *c, const char *name)
{
    char clean[256];
    size_t n = 0;

    snprintf(clean, sizeof clean, "%s", name);
    clean_line(clean);
    const char *from = clean + strspn(clean, " \t");
    while (from[n]) {
        uint32_t code;
        const size_t bytes = (size_t)clean_decode_character(from + n, &code);
        if (n + bytes >= sizeof c->name)
            break;
        n += bytes;
    }
    while (n && strchr(" \t", from[n - 1]))
        n--;
    memcpy(c->name, from, n);
    c->name[n] = 0;
}
