/*
 * screen_replays.c - the runs that are kept: what each was, with its picture; to watch, to save under a name, to
 * delete.
 */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include "../../../platform/platform.h"
#include "../host/clean.h"
#include "../store/replays_print.h"
#include "cab_parts.h"

static struct {
    struct replays list;
    struct thumb thumb;
    int thumb_of; /* the replay whose picture that is; -1: none */
    char typed[CARD_NAME];
    bool typing, fresh; /* fresh: a letter takes the place of what is proposed */
    uint8_t held[PLAT_KEYS / 8];
    uint32_t switches;
} view;

/* ---- a replay in words ---- */

static void date_text(int64_t date, char *out, size_t size)
{
    const time_t t = (time_t)date;
    const struct tm *tm = localtime(&t);

    if (date == 0 || !tm || strftime(out, size, "%Y-%m-%d %H:%M", tm) == 0)
        snprintf(out, size, "?");
}

/* What it was, in a sentence for the foot. */
static void describe(const struct card *c, char *out, size_t size)
{
    const unsigned seconds = (c->last - c->first) / 60;
    int n = snprintf(out, size, "%u:%02u, %s", seconds / 60, seconds % 60, replays_end_word(c->end));

    if (c->players > 1)
        n += snprintf(out + n, size - (size_t)n, ", two players: %" PRId64 " and %" PRId64, c->points[0], c->points[1]);
    for (int i = 0; demo_flag_name(i); i++)
        if (c->flags >> i & 1)
            n += snprintf(out + n, size - (size_t)n, ", %s", demo_flag_name(i));
    if (c->rows)
        n += snprintf(out + n, size - (size_t)n, ", among the scores as %s", c->row[0].row.name);
    if (c->core != CORE_VERSION)
        snprintf(out + n, size - (size_t)n, ", of core version %u: it may not play as it was", (unsigned)c->core);
}

static const struct card *card(int i)
{
    return &view.list.list[i].card;
}

/* ---- what can be done with one ---- */

enum act { WATCH, NAME, DELETE, ACTS };

static int act_rows(void *of)
{
    (void)of;
    return ACTS;
}

static int chosen(void)
{
    return cab.screens.place[0].screen && cab.screens.deep ? view.thumb_of : -1;
}

static void act_row(void *of, int at, struct screen_row *row)
{
    static const char *const labels[] = { "watch", "save under a name", "delete" };
    static const char *const helps[] = { "from the run's start; T takes over, for practice from any moment",
                                         "what has a name is kept until you delete it", "" };

    (void)of;
    snprintf(row->label, sizeof row->label, "%s", at == NAME && card(chosen())->name[0] ? "another name" : labels[at]);
    snprintf(row->help, sizeof row->help, "%s", helps[at]);
}

static const char *act_text(void *of)
{
    static char text[SCREEN_HELP];

    (void)of;
    if (!view.typing)
        return card(chosen())->name;
    snprintf(text, sizeof text, "name: %s_\nEnter keeps it, Escape leaves it", view.typed);
    return text;
}

static void delete (void *of)
{
    char err[256];

    (void)of;
    if (!replays_delete(&view.list, view.thumb_of, err, sizeof err)) {
        screens_say(&cab.screens, "%s", err);
        return;
    }
    view.thumb_of = -1;
    replays_collect_roms(&view.list, rom_hash(cab_cart()->rom));
    screens_close(&cab.screens); /* what can be done with it */
}

/* The window takes text, or does so no more. */
static void want_text(bool on)
{
    view.typing = on;
    if (cab.want.text == on)
        return;
    cab.want.text = on;
    cab.quit = !cab_open_window() || cab.quit;
}

static void begin_name(void)
{
    const struct card *c = card(view.thumb_of);

    if (c->name[0])
        snprintf(view.typed, sizeof view.typed, "%s", c->name);
    else
        snprintf(view.typed, sizeof view.typed, "%s %" PRId64, c->ship[0] ? c->ship : c->id, c->points[0]);
    view.fresh = true;
    memset(view.held, 255, sizeof view.held);
    view.switches = UINT32_MAX;
    want_text(true);
}

static void act(void *of, int at)
{
    char path[REPLAY_PATH];
    const int i = chosen();

    (void)of;
    if (at == NAME) {
        begin_name();
    } else if (at == DELETE) {
        screens_ask(&cab.screens, "This replay is deleted for good.", "delete", delete, NULL);
    } else {
        replays_path(&view.list, i, path);
        const uint32_t first = card(i)->first;
        if (cab_watch(path, first))
            screens_close_all(&cab.screens);
    }
}

/* ---- its name ---- */

static void type(const char *text)
{
    if (!*text)
        return;
    if (view.fresh)
        view.typed[0] = 0;
    view.fresh = false;
    for (uint32_t c; *text;) {
        const int n = clean_character(text, &c);
        const size_t at = strlen(view.typed);
        if (c >= 32 && c != 127 && at + (size_t)n < sizeof view.typed) {
            memcpy(view.typed + at, text, (size_t)n);
            view.typed[at + (size_t)n] = 0;
        }
        text += n;
    }
    clean_line(view.typed);
}

static void erase(void)
{
    size_t n = strlen(view.typed);

    view.fresh = false;
    while (n && ((unsigned char)view.typed[--n] & 0xc0) == 0x80)
        ;
    view.typed[n] = 0;
}

static void keep_name(void)
{
    char err[256];

    if (!replays_name(&view.list, view.thumb_of, view.typed, err, sizeof err))
        screens_say(&cab.screens, "%s", err);
    else if (card(view.thumb_of)->name[0])
        screens_say(&cab.screens, "saved as \"%s\"", card(view.thumb_of)->name);
    else
        screens_say(&cab.screens, "it has no name any more");
}

/* Pressed now and not at the last look. */
static bool key(const struct plat_input *in, unsigned usage)
{
    return plat_key(in, usage) && !(view.held[usage >> 3 & 31] >> (usage & 7) & 1);
}

static bool listen(void *of, const struct plat_input *in)
{
    enum { ENTER = 40, ESCAPE = 41, BACKSPACE = 42, KEYPAD_ENTER = 88 };
    const uint32_t now = in->controllers[0] | in->controllers[1], fresh = now & ~view.switches;
    const bool yes = key(in, ENTER) || key(in, KEYPAD_ENTER) || fresh & (1u << PLAT_SOUTH | 1u << PLAT_START);

    (void)of;
    if (!view.typing)
        return false;
    type(in->text);
    if (key(in, BACKSPACE))
        erase();
    if (yes)
        keep_name();
    if (yes || key(in, ESCAPE) || fresh & 1u << PLAT_EAST)
        want_text(false);
    memcpy(view.held, in->keys, sizeof view.held);
    view.switches = now;
    return true;
}

static void act_closed(void *of)
{
    (void)of;
    want_text(false);
}

static const struct screen_def acts = { .title = "replay",
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
    (void)of;
    return view.list.n;
}

static void row(void *of, int at, struct screen_row *row)
{
    const struct card *c = card(at);
    char date[32];

    (void)of;
    date_text(c->date, date, sizeof date);
    snprintf(row->label, sizeof row->label, "%.47s", c->name[0] ? c->name : date);
    snprintf(row->value, sizeof row->value, "%s %" PRId64, c->ship,
             c->points[0] > c->points[1] ? c->points[0] : c->points[1]);
    describe(c, row->help, sizeof row->help);
}

static const char *text(void *of)
{
    (void)of;
    return view.list.n ? "" : "No run is kept yet. The last ones are, by themselves, when they are over.";
}

static void accept(void *of, int at)
{
    (void)of;
    view.thumb_of = at;
    screens_open(&cab.screens, &acts, NULL);
}

static void ask_delete(void *of, int at)
{
    accept(of, at);
    screens_ask(&cab.screens, "This replay is deleted for good.", "delete", delete, NULL);
}

static void closed(void *of)
{
    (void)of;
    replays_close(&view.list);
}

static int height(void *of, int w, int h)
{
    const struct manifest *m = &cab_cart()->m;
    const int high = (m->screen_w > m->screen_h ? THUMB_SIDE * m->screen_h / m->screen_w : THUMB_SIDE) + 4;

    (void)of;
    (void)w;
    return h - high >= 4 * CANVAS_LINE_H ? high : h / 3;
}

/* The screen covers the picture, so all entries of the palette are free but for the canvas's own. */
static void draw_thumb(const struct canvas *canvas, struct screen_area to)
{
    const struct thumb *t = &view.thumb;
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
static void draw_words(const struct card *c, const struct canvas *canvas, struct screen_area to)
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
    int side = 0;

    (void)of;
    if (view.thumb_of != at)
        replays_thumb(&view.list, at, &view.thumb);
    view.thumb_of = at;
    if (view.thumb.w > 0) {
        draw_thumb(canvas, to);
        side = view.thumb.w + 8;
    }
    draw_words(card(at), canvas, (struct screen_area){ to.x + side + 4, to.y, to.w - side - 4, to.h });
}

static const struct screen_def replays = { .title = "replays",
                                           .rows = rows,
                                           .row = row,
                                           .text = text,
                                           .accept = accept,
                                           .remove = ask_delete,
                                           .closed = closed,
                                           .height = height,
                                           .draw = draw };

void cab_open_replays(void)
{
    if (cab.attracting)
        cab_attract_end();
    replays_close(&view.list);
    view.thumb_of = -1;
    if (!replays_open(&view.list, cab_cart()->m.id))
        screens_say(&cab.screens, "not enough memory for all of them");
    screens_open(&cab.screens, &replays, NULL);
}
