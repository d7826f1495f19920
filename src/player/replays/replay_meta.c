/*
 * replay_meta.c - see replay_meta.h. One walk over the fields writes or reads them, so the two cannot disagree.
 */
#include "replay_meta.h"

#include <stdio.h>
#include <string.h>
#include "../../base/bytes.h"
#include "../../base/hash.h"
#include "../../common/clean.h"

enum { FORMAT = 1, BEFORE = 12 /* bytes before the fields */ };
static const char magic[] = "CCRD";

/* Where the fields are written to, or read from. */
struct walk {
    uint8_t *out; /* NULL: reads */
    const uint8_t *in;
    size_t at, size;
    bool bad;
};

static void number(struct walk *w, uint64_t *v, int bytes)
{
    if (w->size - w->at < (size_t)bytes) {
        w->bad = true;
        return;
    }
    uint64_t read = 0;
    for (int i = 0; i < bytes; i++) {
        if (w->out)
            w->out[w->at + (size_t)i] = (uint8_t)(*v >> 8 * i);
        else
            read |= (uint64_t)w->in[w->at + (size_t)i] << 8 * i;
    }
    w->at += (size_t)bytes;
    if (!w->out)
        *v = read;
}

static void walk64(struct walk *w, uint64_t *v)
{
    number(w, v, 8);
}

static void walk_signed(struct walk *w, int64_t *v)
{
    uint64_t u = (uint64_t)*v;

    number(w, &u, 8);
    *v = (int64_t)u;
}

static void walk32(struct walk *w, uint32_t *v)
{
    uint64_t u = *v;

    number(w, &u, 4);
    *v = (uint32_t)u;
}

static void walk8(struct walk *w, uint8_t *v)
{
    uint64_t u = *v;

    number(w, &u, 1);
    *v = (uint8_t)u;
}

/* A text, as its length and its bytes; read, it has no NUL but its end, and no byte that a terminal obeys. */
static void text(struct walk *w, char *s, size_t room)
{
    uint8_t n = w->out ? (uint8_t)strlen(s) : 0;

    walk8(w, &n);
    if (w->bad || n >= room || w->size - w->at < n) {
        w->bad = true;
        return;
    }
    if (w->out) {
        memcpy(w->out + w->at, s, n);
    } else {
        memcpy(s, w->in + w->at, n);
        s[n] = 0;
        w->bad = w->bad || strlen(s) != n;
        clean_line(s);
    }
    w->at += n;
}

static void walk_row(struct walk *w, struct replay_meta_row *r)
{
    text(w, r->table, sizeof r->table);
    text(w, r->row.ship, sizeof r->row.ship);
    text(w, r->row.name, sizeof r->row.name);
    walk_signed(w, &r->row.score);
    walk8(w, &r->row.stage);
    walk8(w, &r->row.continues);
}

static void walk(struct walk *w, struct replay_meta *c)
{
    uint8_t end = (uint8_t)c->end, rows = (uint8_t)c->rows;

    walk64(w, &c->hash);
    walk64(w, &c->bytes);
    walk_signed(w, &c->date);
    walk64(w, &c->rom);
    walk64(w, &c->game);
    walk64(w, &c->seed);
    walk32(w, &c->core);
    walk32(w, &c->flags);
    walk32(w, &c->first);
    walk32(w, &c->last);
    walk8(w, &end);
    walk8(w, &c->players);
    walk8(w, &c->stages);
    text(w, c->id, sizeof c->id);
    text(w, c->ship, sizeof c->ship);
    text(w, c->difficulty, sizeof c->difficulty);
    for (int p = 0; p < MAX_PLAYERS; p++)
        walk_signed(w, &c->points[p]);
    text(w, c->name, sizeof c->name);
    walk8(w, &rows);
    w->bad = w->bad || end >= CARD_ENDS || rows > CARD_ROWS || c->first > c->last;
    c->end = w->bad ? CARD_LEFT : (enum replay_meta_end)end;
    c->rows = w->bad ? 0 : rows;
    for (int i = 0; i < c->rows; i++)
        walk_row(w, &c->row[i]);
}

size_t replay_meta_write(const struct replay_meta *c, const struct thumb *t, uint8_t *out)
{
    struct replay_meta copy = *c;
    struct walk w = { .out = out, .at = BEFORE, .size = CARD_HEAD - 4 };
    const size_t pixels = (size_t)t->w * (size_t)t->h;

    walk(&w, &copy);
    memcpy(out, magic, 4);
    bytes_put32(out + 4, FORMAT);
    bytes_put32(out + 8, (uint32_t)(w.at - BEFORE));
    bytes_put32(out + w.at, hash_crc32(out, w.at));
    uint8_t *p = out + w.at + 4;
    p[0] = (uint8_t)t->w;
    p[1] = (uint8_t)t->h;
    memcpy(p + 2, t->pix, pixels);
    bytes_put32(p + 2 + pixels, hash_crc32(p, 2 + pixels));
    return w.at + 4 + 2 + pixels + 4;
}

/* Where the fields end; 0: these bytes are no card. */
static size_t end_of_head(const uint8_t *data, size_t size)
{
    if (size < BEFORE + 4 || memcmp(data, magic, 4) != 0 || bytes_get32(data + 4) != FORMAT)
        return 0;
    const size_t n = bytes_get32(data + 8);
    if (n > CARD_HEAD - BEFORE - 4 || n > size - BEFORE - 4)
        return 0;
    return bytes_get32(data + BEFORE + n) == hash_crc32(data, BEFORE + n) ? BEFORE + n : 0;
}

bool replay_meta_read(struct replay_meta *c, const uint8_t *data, size_t size)
{
    struct walk w = { .in = data, .at = BEFORE, .size = end_of_head(data, size) };

    memset(c, 0, sizeof *c);
    if (w.size == 0)
        return false;
    walk(&w, c);
    if (!w.bad && w.at == w.size)
        return true;
    memset(c, 0, sizeof *c);
    return false;
}

bool replay_meta_read_thumb(struct thumb *t, const uint8_t *data, size_t size)
{
    const size_t at = end_of_head(data, size) + 4;

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
        return d->fault ? CARD_FAULT : CARD_LEFT;
    return strcmp(over->name, "clear") == 0 ? CARD_CLEAR : strcmp(over->name, "quit") == 0 ? CARD_QUIT : CARD_OVER;
}

bool replay_meta_of_demo(struct replay_meta *c, const struct demo *d)
{
    const struct demo_marker *game = NULL, *over = NULL;

    for (uint32_t i = 0; i < d->n_markers; i++) {
        if (d->markers[i].marker.kind == MARKER_GAME) {
            game = &d->markers[i];
            over = NULL;
        } else if (d->markers[i].marker.kind == MARKER_OVER && game) {
            over = &d->markers[i];
        }
    }
    memset(c, 0, sizeof *c);
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
