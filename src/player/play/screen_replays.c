/*
 * screen_replays.c - the runs that are kept: what each was, with its picture; to watch, to save under a name, to
 * delete.
 */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include "../../../platform/platform.h"
#include "../../common/clean.h"
#include "cab_parts.h"

/* ---- a replay in words ---- */

static void date_text(int64_t date, char *out, size_t size)
{
    const time_t t = (time_t)date;
    const struct tm *tm = localtime(&t);

    if (date == 0 || !tm || strftime(out, size, "%Y-%m-%d %H:%M", tm) == 0)
        snprintf(out, size, "?");
}

/* What it was, in a sentence for the foot. */
static void describe(const struct replay_meta *c, char *out, size_t size)
{
    static const char *const ends[REPLAY_ENDS] = { "unfinished", "all stages cleared", "game over", "quit",
                                                   "script error" };
    const unsigned seconds = (c->last - c->first) / 60;
    int n = snprintf(out, size, "%u:%02u, %s", seconds / 60, seconds % 60, ends[c->end]);

    if (c->players > 1)
        n += snprintf(out + n, size - (size_t)n, ", two players: %" PRId64 " and %" PRId64, c->points[0], c->points[1]);
    for (int i = 0; demo_flag_name(i); i++)
        if (c->flags >> i & 1)
            n += snprintf(out + n, size - (size_t)n, ", %s", demo_flag_name(i));
    if (c->rows)
        n += snprintf(out + n, size - (size_t)n, ", high score as %s", c->row[0].row.name);
    if (c->core != CORE_VERSION)
        snprintf(out + n, size - (size_t)n, ", core version %u: playback may diverge", (unsigned)c->core);
}

static const struct replay_meta *metadata(struct cab *cab, int i)
{
    return &cab->view.list.list[i].meta;
}

/* ---- what can be done with one ---- */

enum act { WATCH, NAME, DELETE, ACTS };

static int act_rows(void *of)
{
    (void)of;
    return ACTS;
}

static int chosen(struct cab *cab)
{
    return cab->screens.place[0].screen && cab->screens.deep ? cab->view.thumb_of : -1;
}

static void act_row(void *of, int at, struct screen_row *row)
{
    struct cab *cab = of;
    static const char *const labels[] = { "Watch", "Name Replay", "Delete" };
    static const char *const helps[] = { "Watch from the start. T: take over and practise.",
                                         "Named replays stay until you delete them.", "" };

    snprintf(row->label, sizeof row->label, "%s",
             at == NAME && metadata(cab, chosen(cab))->name[0] ? "Rename" : labels[at]);
    snprintf(row->help, sizeof row->help, "%s", helps[at]);
}

static const char *act_text(void *of)
{
    struct cab *cab = of;

    if (!cab->view.typing)
        return metadata(cab, chosen(cab))->name;
    snprintf(cab->view.text, sizeof cab->view.text, "Name: %s_\nEnter: save. Escape: cancel.", cab->view.typed);
    return cab->view.text;
}

static void delete (void *of)
{
    struct cab *cab = of;
    char err[256];

    if (!replays_delete(&cab->view.list, cab->view.thumb_of, err, sizeof err)) {
        screens_say(&cab->screens, "%s", err);
        return;
    }
    cab->view.thumb_of = -1;
    replays_collect_roms(&cab->view.list, rom_hash(cab_cart(cab)->rom));
    screens_close(&cab->screens); /* what can be done with it */
}

/* The window takes text, or does so no more. */
static void want_text(struct cab *cab, bool on)
{
    cab->view.typing = on;
    if (cab->want.text_input == on)
        return;
    cab->want.text_input = on;
    cab->quit = !cab_open_window(cab) || cab->quit;
}

static void begin_name(struct cab *cab)
{
    const struct replay_meta *c = metadata(cab, cab->view.thumb_of);

    if (c->name[0])
        snprintf(cab->view.typed, sizeof cab->view.typed, "%s", c->name);
    else
        snprintf(cab->view.typed, sizeof cab->view.typed, "%s %" PRId64, c->ship[0] ? c->ship : c->id, c->points[0]);
    cab->view.fresh = true;
    memset(cab->view.held, 255, sizeof cab->view.held);
    cab->view.switches = UINT32_MAX;
    want_text(cab, true);
}

static void act(void *of, int at)
{
    struct cab *cab = of;
    char path[REPLAY_PATH];
    const int i = chosen(cab);

    if (at == NAME) {
        begin_name(cab);
    } else if (at == DELETE) {
        screens_ask(&cab->screens, "Delete this replay? This cannot be undone.", "Delete", delete, cab);
    } else {
        replays_path(&cab->view.list, i, path);
        const uint32_t first = metadata(cab, i)->first;
        if (cab_watch(cab, path, first))
            screens_close_all(&cab->screens);
    }
}

/* ---- its name ---- */

static void type(struct cab *cab, const char *text)
{
    if (!*text)
        return;
    if (cab->view.fresh)
        cab->view.typed[0] = 0;
    cab->view.fresh = false;
    for (uint32_t c; *text;) {
        const int n = clean_decode_character(text, &c);
        const size_t at = strlen(cab->view.typed);
        if (c >= 32 && c != 127 && at + (size_t)n < sizeof cab->view.typed) {
            memcpy(cab->view.typed + at, text, (size_t)n);
            cab->view.typed[at + (size_t)n] = 0;
        }
        text += n;
    }
    clean_line(cab->view.typed);
}

static void erase(struct cab *cab)
{
    size_t n = strlen(cab->view.typed);

    cab->view.fresh = false;
    while (n && ((unsigned char)cab->view.typed[--n] & 0xc0) == 0x80)
        ;
    cab->view.typed[n] = 0;
}

static void keep_name(struct cab *cab)
{
    char err[256];

    if (!replays_name(&cab->view.list, cab->view.thumb_of, cab->view.typed, err, sizeof err))
        screens_say(&cab->screens, "%s", err);
    else if (metadata(cab, cab->view.thumb_of)->name[0])
        screens_say(&cab->screens, "Saved as \"%s\"", metadata(cab, cab->view.thumb_of)->name);
    else
        screens_say(&cab->screens, "Name removed");
}

/* Pressed now and not at the last look. */
static bool key(struct cab *cab, const struct plat_input *in, unsigned usage)
{
    return plat_is_key_held(in, usage) && !(cab->view.held[usage >> 3 & 31] >> (usage & 7) & 1);
}

static bool listen(void *of, const struct plat_input *in)
{
    struct cab *cab = of;
    const uint32_t now = in->controllers[0] | in->controllers[1], fresh = now & ~cab->view.switches;
    const bool yes =
        key(cab, in, KEY_ENTER) || key(cab, in, KEY_KEYPAD_ENTER) || fresh & (1u << PLAT_SOUTH | 1u << PLAT_START);

    if (!cab->view.typing)
        return false;
    type(cab, in->text);
    if (key(cab, in, KEY_BACKSPACE))
        erase(cab);
    if (yes)
        keep_name(cab);
    if (yes || key(cab, in, KEY_ESCAPE) || fresh & 1u << PLAT_EAST)
        want_text(cab, false);
    memcpy(cab->view.held, in->keys, sizeof cab->view.held);
    cab->view.switches = now;
    return true;
}

static void act_closed(void *of)
{
    struct cab *cab = of;

    want_text(cab, false);
}

static const struct screen_def acts = { .title = "Replay",
                                        .small = true,
                                        .rows = act_rows,
                                        .row = act_row,
                                        .text = act_text,
                                        .accept = act,
                                        .listen = listen,
                                        .closed = act_closed };

/* ---- the list ---- */

static int rows(void *of)
{
    struct cab *cab = of;

    return cab->view.list.n;
}

static void row(void *of, int at, struct screen_row *row)
{
    struct cab *cab = of;
    const struct replay_meta *c = metadata(cab, at);
    char date[32];

    date_text(c->date, date, sizeof date);
    snprintf(row->label, sizeof row->label, "%.47s", c->name[0] ? c->name : date);
    snprintf(row->value, sizeof row->value, "%s %" PRId64, c->ship,
             c->points[0] > c->points[1] ? c->points[0] : c->points[1]);
    describe(c, row->help, sizeof row->help);
}

static const char *text(void *of)
{
    struct cab *cab = of;

    return cab->view.list.n ? "" : "No replays yet. Runs are saved automatically when they end.";
}

static void accept(void *of, int at)
{
    struct cab *cab = of;

    cab->view.thumb_of = at;
    screens_open(&cab->screens, &acts, cab);
}

static void ask_delete(void *of, int at)
{
    struct cab *cab = of;

    accept(of, at);
    screens_ask(&cab->screens, "Delete this replay? This cannot be undone.", "Delete", delete, cab);
}

static void closed(void *of)
{
    struct cab *cab = of;

    replays_close(&cab->view.list);
}

static int height(void *of, int w, int h)
{
    struct cab *cab = of;
    const struct manifest *m = &cab_cart(cab)->manifest;
    const int high = (m->screen_w > m->screen_h ? THUMB_SIDE * m->screen_h / m->screen_w : THUMB_SIDE) + 4;

    (void)w;
    return h - high >= 4 * CANVAS_LINE_H ? high : h / 3;
}

/* The screen covers the picture, so all entries of the palette are free but for the canvas's own. */
static void draw_thumb(struct cab *cab, const struct canvas *canvas, struct screen_area to)
{
    const struct thumb *t = &cab->view.thumb;
    uint8_t entry[THUMB_COLOURS];
    int n = 0;

    for (int i = 0; i < 256 && n < THUMB_COLOURS; i++) {
        bool own = false;
        for (int c = 0; c < CANVAS_COLOURS; c++)
            own = own || canvas->colour[c] == i;
        if (own)
            continue;
        canvas->rgb[i] = thumb_colour(n);
        entry[n++] = (uint8_t)i;
    }
    const int x0 = to.x + 4, y0 = to.y + 1, h = t->h < to.h - 2 ? t->h : to.h - 2,
              w = t->w < to.w - 8 ? t->w : to.w - 8;
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++)
            canvas->fb->pix[(y0 + y) * canvas->fb->pitch + x0 + x] = entry[t->pix[y * t->w + x]];
    canvas_frame(canvas, x0 - 1, y0 - 1, w + 2, h + 2, CANVAS_GREY);
}

/* Beside the picture: what does not fit on the row. */
static void draw_words(const struct replay_meta *c, const struct canvas *canvas, struct screen_area to)
{
    char lines[6][64];
    int n = 0;

    date_text(c->date, lines[n++], sizeof lines[0]);
    snprintf(lines[n++], sizeof lines[0], "%s", c->ship);
    if (c->difficulty[0])
        snprintf(lines[n++], sizeof lines[0], "%s", c->difficulty);
    for (int p = 0; p < (c->players > 1 ? 2 : 1); p++)
        snprintf(lines[n++], sizeof lines[0], "%" PRId64 " points", c->points[p]);
    snprintf(lines[n++], sizeof lines[0], "%d stage%s", c->stages, c->stages == 1 ? "" : "s");
    for (int i = 0; i < n && (i + 1) * CANVAS_LINE_H <= to.h; i++)
        canvas_say_within(canvas, to.x, to.y + CANVAS_SAY_UP + i * CANVAS_LINE_H, i ? CANVAS_WHITE : CANVAS_YELLOW,
                          lines[i], to.w);
}

static void draw(void *of, int at, const struct canvas *canvas, struct screen_area to)
{
    struct cab *cab = of;
    int side = 0;

    if (cab->view.thumb_of != at)
        replays_thumb(&cab->view.list, at, &cab->view.thumb);
    cab->view.thumb_of = at;
    if (cab->view.thumb.w > 0) {
        draw_thumb(cab, canvas, to);
        side = cab->view.thumb.w + 8;
    }
    draw_words(metadata(cab, at), canvas, (struct screen_area){ to.x + side + 4, to.y, to.w - side - 4, to.h });
}

static const struct screen_def replays = { .title = "Replays",
                                           .rows = rows,
                                           .row = row,
                                           .text = text,
                                           .accept = accept,
                                           .remove = ask_delete,
                                           .closed = closed,
                                           .height = height,
                                           .draw = draw };

void cab_open_replays(struct cab *cab)
{
    if (cab->attracting)
        cab_attract_end(cab);
    replays_close(&cab->view.list);
    cab->view.thumb_of = -1;
    if (!replays_open(&cab->view.list, cab_cart(cab)->manifest.id))
        screens_say(&cab->screens, "Out of memory: some replays are not listed");
    screens_open(&cab->screens, &replays, cab);
}
