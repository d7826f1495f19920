/*
 * screen_replays.c - the saved runs, with a thumbnail of each; watching, naming and deleting them.
 */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include "../../../platform/platform.h"
#include "../../common/clean.h"
#include "play_state.h"

/* ---- descriptions ---- */

static void date_text(int64_t date, char *out, size_t size)
{
    const time_t t = (time_t)date;
    const struct tm *tm = localtime(&t);

    if (date == 0 || !tm || strftime(out, size, "%Y-%m-%d %H:%M", tm) == 0)
        snprintf(out, size, "?");
}

/* The help of its row. */
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

static const struct replay_meta *meta_of(const struct play *play, int i)
{
    return &play->replay_list.list.list[i].meta;
}

/* ---- the actions on a replay ---- */

enum { WATCH, NAME, DELETE, ACTIONS };

static int action_rows(void *context)
{
    (void)context;
    return ACTIONS;
}

static void action_row(void *context, int at, struct screen_row *row)
{
    struct play *play = context;
    static const struct {
        const char *label, *help;
    } texts[ACTIONS] = {
        [WATCH] = { "Watch", "Watch from the start. T: take over and practise." },
        [NAME] = { "Name Replay", "Named replays stay until you delete them." },
        [DELETE] = { "Delete", "" },
    };
    const bool named = meta_of(play, play->replay_list.thumb_of)->name[0];

    snprintf(row->label, sizeof row->label, "%s", at == NAME && named ? "Rename" : texts[at].label);
    snprintf(row->help, sizeof row->help, "%s", texts[at].help);
}

static const char *action_text(void *context)
{
    struct play *play = context;

    if (!play->replay_list.typing)
        return meta_of(play, play->replay_list.thumb_of)->name;
    screens_format(&play->screens, play->replay_list.text, sizeof play->replay_list.text,
                   "Name: %s_\nEnter: save. Escape: cancel.", play->replay_list.typed);
    return play->replay_list.text;
}

static void delete (void *context)
{
    struct play *play = context;
    char err[256];

    if (!replays_delete(&play->replay_list.list, play->replay_list.thumb_of, err, sizeof err)) {
        screens_show_message(&play->screens, "%s", err);
        return;
    }
    play->replay_list.thumb_of = -1;
    replays_collect_roms(&play->replay_list.list, rom_hash(play_cart(play)->rom));
    screens_close(&play->screens); /* its actions */
}

static void set_typing(struct play *play, bool on)
{
    play->replay_list.typing = on;
    play_set_text_input(play, on);
}

static void start_typing(struct play *play)
{
    struct replay_list *l = &play->replay_list;
    const struct replay_meta *c = meta_of(play, l->thumb_of);

    if (c->name[0])
        snprintf(l->typed, sizeof l->typed, "%s", c->name);
    else
        snprintf(l->typed, sizeof l->typed, "%s %" PRId64, c->ship[0] ? c->ship : c->id, c->points[0]);
    l->fresh = true;
    memset(l->held, 255, sizeof l->held);
    l->buttons = UINT32_MAX;
    set_typing(play, true);
}

static void ask_to_delete(struct play *play)
{
    screens_ask(&play->screens, "Delete this replay? This cannot be undone.", "Delete", delete, play);
}

static void do_action(void *context, int at)
{
    struct play *play = context;
    struct replay_list *l = &play->replay_list;
    char path[REPLAY_PATH];

    if (at == NAME) {
        start_typing(play);
    } else if (at == DELETE) {
        ask_to_delete(play);
    } else {
        replays_path(&l->list, l->thumb_of, path);
        if (play_watch(play, path, meta_of(play, l->thumb_of)->first))
            screens_close_all(&play->screens);
    }
}

/* ---- typing a name ---- */

static void type(struct replay_list *l, const char *text)
{
    if (!*text)
        return;
    if (l->fresh)
        l->typed[0] = 0;
    l->fresh = false;
    for (uint32_t c; *text;) {
        const int n = clean_decode_character(text, &c);
        const size_t at = strlen(l->typed);
        if (c >= 32 && c != 127 && at + (size_t)n < sizeof l->typed) {
            memcpy(l->typed + at, text, (size_t)n);
            l->typed[at + (size_t)n] = 0;
        }
        text += n;
    }
    clean_line(l->typed);
}

static void erase(struct replay_list *l)
{
    size_t n = strlen(l->typed);

    l->fresh = false;
    while (n && ((unsigned char)l->typed[--n] & 0xc0) == 0x80)
        ;
    l->typed[n] = 0;
}

static void save_name(struct play *play)
{
    char err[256];

    if (!replays_name(&play->replay_list.list, play->replay_list.thumb_of, play->replay_list.typed, err, sizeof err))
        screens_show_message(&play->screens, "%s", err);
    else if (meta_of(play, play->replay_list.thumb_of)->name[0])
        screens_show_message(&play->screens, "Saved as \"%s\"", meta_of(play, play->replay_list.thumb_of)->name);
    else
        screens_show_message(&play->screens, "Name removed");
}

/* Pressed now and not at the last poll. */
static bool key(const struct replay_list *l, const struct plat_input *in, unsigned usage)
{
    return plat_is_key_held(in, usage) && !(l->held[usage >> 3 & 31] >> (usage & 7) & 1);
}

static bool listen(void *context, const struct plat_input *in)
{
    struct play *play = context;
    struct replay_list *l = &play->replay_list;
    enum { ENTER = 40, ESCAPE = 41, BACKSPACE = 42, KEYPAD_ENTER = 88 };
    const uint32_t now = in->controllers[0] | in->controllers[1], fresh = now & ~l->buttons;
    const bool yes = key(l, in, ENTER) || key(l, in, KEYPAD_ENTER) || fresh & (1u << PLAT_SOUTH | 1u << PLAT_START);

    if (!l->typing)
        return false;
    type(l, in->text);
    if (key(l, in, BACKSPACE))
        erase(l);
    if (yes)
        save_name(play);
    if (yes || key(l, in, ESCAPE) || fresh & 1u << PLAT_EAST)
        set_typing(play, false);
    memcpy(l->held, in->keys, sizeof l->held);
    l->buttons = now;
    return true;
}

static void actions_closed(void *context)
{
    struct play *play = context;

    set_typing(play, false);
}

static const struct screen_def actions = { .title = "Replay",
                                           .small = true,
                                           .rows = action_rows,
                                           .row = action_row,
                                           .text = action_text,
                                           .accept = do_action,
                                           .listen = listen,
                                           .closed = actions_closed };

/* ---- the list ---- */

static int rows(void *context)
{
    struct play *play = context;

    return play->replay_list.list.n;
}

static void row(void *context, int at, struct screen_row *row)
{
    struct play *play = context;
    const struct replay_meta *c = meta_of(play, at);
    char date[32];

    date_text(c->date, date, sizeof date);
    snprintf(row->label, sizeof row->label, "%.47s", c->name[0] ? c->name : date);
    snprintf(row->value, sizeof row->value, "%s %" PRId64, c->ship,
             c->points[0] > c->points[1] ? c->points[0] : c->points[1]);
    describe(c, row->help, sizeof row->help);
}

static const char *text(void *context)
{
    struct play *play = context;

    return play->replay_list.list.n ? "" : "No replays yet. Runs are saved automatically when they end.";
}

static void accept(void *context, int at)
{
    struct play *play = context;

    play->replay_list.thumb_of = at;
    screens_open(&play->screens, &actions, play);
}

static void remove_replay(void *context, int at)
{
    accept(context, at);
    ask_to_delete(context);
}

static void closed(void *context)
{
    struct play *play = context;

    replays_close(&play->replay_list.list);
}

static int height(void *context, int w, int h)
{
    struct play *play = context;
    const struct manifest *m = &play_cart(play)->manifest;
    const int high = (m->screen_w > m->screen_h ? THUMB_SIDE * m->screen_h / m->screen_w : THUMB_SIDE) + 4;

    (void)w;
    return h - high >= 4 * CANVAS_LARGE_LINE_HEIGHT ? high : h / 3;
}

static void draw_thumb(const struct thumb *t, const struct canvas *canvas, struct screen_area to)
{
    uint32_t colours[THUMB_COLOURS];
    uint8_t used[THUMB_COLOURS], entry[THUMB_COLOURS];
    bool seen[THUMB_COLOURS] = { false };
    int n = 0;

    for (int i = 0; i < t->w * t->h; i++) {
        const uint8_t c = t->pix[i];
        if (!seen[c])
            colours[n++] = thumb_colour(c);
        used[c] = seen[c] ? used[c] : (uint8_t)(n - 1);
        seen[c] = true;
    }
    canvas_add_colours(canvas, colours, n, entry);
    const int x0 = to.x + 4, y0 = to.y + 1, h = t->h < to.h - 2 ? t->h : to.h - 2,
              w = t->w < to.w - 8 ? t->w : to.w - 8;
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++)
            canvas->fb->pix[(y0 + y) * canvas->fb->pitch + x0 + x] = entry[used[t->pix[y * t->w + x]]];
    canvas_outline(canvas, x0 - 1, y0 - 1, w + 2, h + 2, CANVAS_GREY);
}

/* Beside the thumbnail: the details that don't fit in the row. */
static void draw_details(const struct words *words, const struct replay_meta *c, const struct canvas *canvas,
                         struct screen_area to)
{
    char lines[6][64], shown[64];
    int n = 0;

    date_text(c->date, lines[n++], sizeof lines[0]);
    snprintf(lines[n++], sizeof lines[0], "%s", c->ship);
    if (c->difficulty[0])
        snprintf(lines[n++], sizeof lines[0], "%s", c->difficulty);
    for (int p = 0; p < (c->players > 1 ? 2 : 1); p++)
        snprintf(lines[n++], sizeof lines[0], "%" PRId64 " points", c->points[p]);
    snprintf(lines[n++], sizeof lines[0], c->stages == 1 ? "%d stage" : "%d stages", c->stages);
    for (int i = 0; i < n && (i + 1) * canvas_line_height(canvas) <= to.h; i++) {
        screen_translate(words, lines[i], shown, sizeof shown);
        canvas_large_text_truncated(canvas, to.x, to.y + canvas->ascent + i * canvas_line_height(canvas),
                                    i ? CANVAS_WHITE : CANVAS_YELLOW, shown, to.w);
    }
}

static void draw(void *context, int at, const struct canvas *canvas, struct screen_area to)
{
    struct play *play = context;
    struct replay_list *l = &play->replay_list;
    int side = 0;

    if (l->thumb_of != at)
        replays_thumb(&l->list, at, &l->thumb);
    l->thumb_of = at;
    if (l->thumb.w > 0) {
        draw_thumb(&l->thumb, canvas, to);
        side = l->thumb.w + 8;
    }
    draw_details(&play->screens.words, meta_of(play, at), canvas,
                 (struct screen_area){ to.x + side + 4, to.y, to.w - side - 4, to.h });
}

static const struct screen_def replays = { .title = "Replays",
                                           .rows = rows,
                                           .row = row,
                                           .text = text,
                                           .accept = accept,
                                           .remove = remove_replay,
                                           .closed = closed,
                                           .height = height,
                                           .draw = draw };

void play_open_replays(struct play *play)
{
    attract_end(&play->attract);
    replays_close(&play->replay_list.list);
    play->replay_list.thumb_of = -1;
    if (!replays_open(&play->replay_list.list, play_cart(play)->manifest.id))
        screens_show_message(&play->screens, "Out of memory: some replays are not listed");
    screens_open(&play->screens, &replays, play);
}
