/*
 * screen_replays.c - the saved runs, with a thumbnail and details of each: sorting and importing them.
 * screen_replay.c has the actions on one of them.
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "../../../platform/platform.h"
#include "../../common/array.h"
#include "../replays/roms.h"
#include "../screens/screen_picture.h"
#include "play_state.h"
#include "../../base/int.h"

/* ---- the list ---- */

static int64_t best_score(const struct replay_meta *c)
{
    return c->points[0] > c->points[1] ? c->points[0] : c->points[1];
}

static int compare(const void *left, const void *right)
{
    const struct replay_order *a = left, *b = right;

    return a->key != b->key ? (a->key < b->key ? 1 : -1) : a->i - b->i;
}

/* Sorts an index of the list, which itself stays sorted by date. */
static void sort(struct replay_list *l)
{
    free(l->order);
    l->order = calloc((size_t)l->list.n + 1, sizeof *l->order);
    for (int i = 0; l->order && i < l->list.n; i++) {
        const struct replay_meta *c = &l->list.list[i].meta;
        l->order[i].i = i;
        l->order[i].key = l->sort == REPLAYS_BY_SCORE       ? best_score(c)
                          : l->sort == REPLAYS_BY_FAVOURITE ? c->is_favourite
                                                            : 0;
    }
    if (l->order)
        qsort(l->order, (size_t)l->list.n, sizeof *l->order, compare);
}

void replay_list_changed(struct play *play)
{
    play->replay_list.chosen = -1;
    sort(&play->replay_list);
}

static bool is_older(const struct replay_list *l, const struct replay_meta *c)
{
    return c->rom != l->rom && c->game != l->game;
}

/* Loads what is shown of replay i and not in its metadata. */
static void choose(struct replay_list *l, int i)
{
    const struct replay_meta *c = &l->list.list[i].meta;

    if (l->chosen == i)
        return;
    l->chosen = i;
    l->thumb.w = 0;
    replays_thumb(&l->list, i, &l->thumb);
    l->version = !is_older(l, c) ? REPLAY_CURRENT : roms_has(c->id, c->rom) ? REPLAY_OLDER : REPLAY_LOST;
}

/* ---- descriptions ---- */

static void date_text(int64_t date, char *out, size_t size)
{
    const time_t t = (time_t)date;
    const struct tm *tm = localtime(&t);

    if (date == 0 || !tm || strftime(out, size, "%Y-%m-%d %H:%M", tm) == 0)
        snprintf(out, size, "?");
}

/* Writes a score in groups of three digits. */
static void score_text(int64_t score, char *out, size_t size)
{
    char digits[24];
    size_t n = (size_t)snprintf(digits, sizeof digits, "%" PRId64, score), to = 0;

    for (size_t i = 0; i < n && to + 2 < size; i++) {
        if (i > 0 && (n - i) % 3 == 0 && digits[i - 1] != '-')
            out[to++] = ',';
        out[to++] = digits[i];
    }
    out[to] = 0;
}

/* Returns the title of the mission, or of the last stage that was played; "": unknown. */
static const char *place_title(struct play *play, const struct replay_meta *c)
{
    const struct sections *s = practice_sections(&play->practice);

    return c->mission[0] ? sections_title(s, MARKER_MISSION, c->mission) : sections_title(s, MARKER_STAGE, c->stage);
}

static const char *ship_title(struct play *play, const struct replay_meta *c)
{
    return sections_title(practice_sections(&play->practice), MARKER_SHIP, c->ship);
}

void replay_list_title(struct play *play, const struct replay_meta *c, char *out, size_t size)
{
    const char *place = place_title(play, c), *ship = ship_title(play, c);

    if (c->name[0])
        snprintf(out, size, "%s", c->name);
    else
        snprintf(out, size, "%s%s%s", place, place[0] && ship[0] ? ", " : "", ship);
}

/* Writes how the run ended. */
static void end_text(const struct replay_meta *c, char *out, size_t size)
{
    static const char *const ends[REPLAY_ENDS] = { "Unfinished", "Cleared", "Game over", "Quit", "Script error" };

    snprintf(out, size, "%s",
             c->mission[0] && c->end == REPLAY_CLEAR  ? "Mission clear"
             : c->mission[0] && c->end == REPLAY_OVER ? "Mission failed"
                                                      : ends[c->end]);
}

/* Adds a sentence, translated. */
static void add_sentence(const struct play *play, char *out, size_t size, const char *sentence)
{
    char words[SCREEN_HELP];
    const size_t n = strlen(out);

    screen_translate(&play->screens.words, sentence, words, sizeof words);
    snprintf(out + n, size - n, "%s%s", n ? " " : "", words);
}

/* The help of a replay's row: what a player should know before watching it. */
static void describe(const struct play *play, const struct replay_meta *c, char *out, size_t size)
{
    char sentence[SCREEN_HELP];

    if (is_older(&play->replay_list, c))
        add_sentence(play, out, size, "Recorded in an older version of the game.");
    snprintf(sentence, sizeof sentence, "Recorded with core version %u: playback may diverge.", (unsigned)c->core);
    if (c->core != CORE_VERSION)
        add_sentence(play, out, size, sentence);
    for (int i = 0; demo_flag_name(i); i++)
        if (c->flags >> i & 1) {
            screen_sentence(sentence, sizeof sentence, demo_flag_name(i));
            add_sentence(play, out, size, sentence);
        }
    screens_format(&play->screens, sentence, sizeof sentence, "High score as %s.", c->row[0].row.name);
    if (c->rows)
        add_sentence(play, out, size, sentence);
    if (!out[0])
        snprintf(out, size, "Select to watch, name or export it.");
}

/* ---- rows ---- */

/* The rows above the replays: sorting, unless there is nothing to sort, and importing. */
static int rows_above(const struct replay_list *l)
{
    return l->list.n > 1 ? 2 : 1;
}

static int rows(void *context)
{
    const struct replay_list *l = &((struct play *)context)->replay_list;

    return rows_above(l) + (l->order ? l->list.n : 0);
}

/* Returns the replay of a row, or -1. */
static int replay_at(const struct replay_list *l, int at)
{
    return at < rows_above(l) ? -1 : l->order[at - rows_above(l)].i;
}

static bool is_sort_row(const struct replay_list *l, int at)
{
    return at == 0 && rows_above(l) == 2;
}

static void describe_row_above(const struct replay_list *l, int at, struct screen_row *row)
{
    static const char *const orders[] = { "Newest", "Best Score", "Favourites" };

    if (is_sort_row(l, at)) {
        snprintf(row->label, sizeof row->label, "Sort");
        snprintf(row->value, sizeof row->value, "%s", orders[l->sort]);
        snprintf(row->help, sizeof row->help, "The order of the list.");
        row->changes = true;
    } else {
        snprintf(row->label, sizeof row->label, "Import...");
        snprintf(row->help, sizeof row->help, "Add a replay from a file, or drop the file on the window.");
    }
}

/* The value is the score and the day. */
static void row(void *context, int at, struct screen_row *row)
{
    struct play *play = context;
    const struct replay_list *l = &play->replay_list;
    const int i = replay_at(l, at);
    char title[SCREEN_LABEL - 4], date[32], score[32];

    if (i < 0) {
        describe_row_above(l, at, row);
        return;
    }
    const struct replay_meta *c = &l->list.list[i].meta;
    snprintf(title, sizeof title, "%s", c->name[0] ? c->name : place_title(play, c));
    if (!title[0])
        replay_list_title(play, c, title, sizeof title);
    snprintf(row->label, sizeof row->label, "%s%s", c->is_favourite ? "* " : "", title);
    row->removable = true;
    date_text(c->date, date, sizeof date);
    score_text(best_score(c), score, sizeof score);
    snprintf(row->value, sizeof row->value, "%s  %.5s", score, c->date ? date + 5 : date); /* month and day */
    if (is_older(l, c))
        row->colour = CANVAS_GREY;
    describe(play, c, row->help, sizeof row->help);
}

static const char *text(void *context)
{
    struct play *play = context;

    return play->replay_list.list.n ? "" : "No replays yet. Runs are saved automatically when they end.";
}

static void change(void *context, int at, int by)
{
    struct replay_list *l = &((struct play *)context)->replay_list;

    (void)at;
    l->sort = (enum replay_sort)((l->sort + (by < 0 ? REPLAY_SORTS - 1 : 1)) % REPLAY_SORTS);
    sort(l);
}

static void open_imports(struct play *play);

static void accept(void *context, int at)
{
    struct play *play = context;
    const int i = replay_at(&play->replay_list, at);

    if (i < 0) {
        open_imports(play);
        return;
    }
    choose(&play->replay_list, i);
    screens_open(&play->screens, &replay_screen, play);
}

static void remove_replay(void *context, int at)
{
    struct play *play = context;
    choose(&play->replay_list, replay_at(&play->replay_list, at));
    play_ask_to_delete_replay(play);
}

static void closed(void *context)
{
    struct replay_list *l = &((struct play *)context)->replay_list;

    replays_close(&l->list);
    free(l->order);
    free(l->file);
    l->order = NULL;
    l->file = NULL;
    l->files = 0;
}

/* ---- the picture: thumbnail and details ---- */

static int height(void *context, int w, int h)
{
    struct play *play = context;
    const struct manifest *m = &play_cart(play)->manifest;
    const int high = (m->screen_w > m->screen_h ? THUMB_SIDE * m->screen_h / m->screen_w : THUMB_SIDE) + 12;

    (void)w;
    if (!play->replay_list.order || play->replay_list.list.n == 0)
        return 0;
    return h - high >= 4 * CANVAS_LARGE_LINE_HEIGHT ? high : int_max(h / 3, 4 * CANVAS_LARGE_LINE_HEIGHT);
}

static int draw_thumb(const struct thumb *t, const struct canvas *canvas, struct screen_area to)
{
    struct screen_picture p = { .w = t->w, .h = t->h, .pitch = t->w, .pix = t->pix };

    for (int i = 0; i < THUMB_COLOURS; i++)
        p.rgb[i] = thumb_colour(i);
    return screen_picture_draw(&p, canvas, to);
}

/* Adds a line to the details: a label and a value, or a value that needs no label (NULL). */
static void add_line(const struct play *play, char *text, size_t size, const char *label, const char *value)
{
    char words[64], *end = text + strlen(text);
    const size_t room = size - (size_t)(end - text);

    screen_translate(&play->screens.words, label ? label : value, words, sizeof words);
    if (words[0])
        snprintf(end, room, label ? "%s %s\n" : "%s\n", words, value);
}

static void list_details(struct play *play, const struct replay_meta *c, char *text, size_t size)
{
    static const char *const versions[] = { [REPLAY_OLDER] = "Older version", [REPLAY_LOST] = "Not playable" };
    const unsigned seconds = (c->last - c->first) / 60;
    char value[64];

    text[0] = '\0';
    add_line(play, text, size, NULL, place_title(play, c));
    add_line(play, text, size, NULL, ship_title(play, c));
    add_line(play, text, size, NULL,
             sections_title(practice_sections(&play->practice), MARKER_DIFFICULTY, c->difficulty));
    for (int p = 0; p < (c->players > 1 ? 2 : 1); p++) {
        score_text(c->points[p], value, sizeof value);
        add_line(play, text, size, p ? "Score 2P" : "Score", value);
    }
    snprintf(value, sizeof value, "%u:%02u", seconds / 60, seconds % 60);
    add_line(play, text, size, "Length", value);
    end_text(c, value, sizeof value);
    add_line(play, text, size, NULL, value);
    date_text(c->date, value, sizeof value);
    add_line(play, text, size, NULL, value);
    if (play->replay_list.version != REPLAY_CURRENT)
        add_line(play, text, size, NULL, versions[play->replay_list.version]);
}

/* Joins lines by two spaces, as far as they fit `width` px. */
static void join_lines(const struct canvas *canvas, char *text, int width)
{
    char *start = text;

    for (char *end; (end = strchr(start, '\n')) != NULL && end[1]; start = end + 1) {
        char joined[SCREEN_TEXT], *next = strchr(end + 1, '\n');
        snprintf(joined, sizeof joined, "%.*s  %.*s", (int)(end - start), start, (int)(next - end - 1), end + 1);
        if (canvas_large_text_width(canvas, joined) > width)
            continue;
        memmove(end + 2, end + 1, strlen(end + 1) + 1);
        memcpy(end, "  ", 2);
        end = start - 1; /* the longer line may take another one */
    }
}

static void draw_details(struct play *play, const struct replay_meta *c, const struct canvas *canvas,
                         struct screen_area to)
{
    const int line = canvas_line_height(canvas);
    char text[SCREEN_TEXT];
    const char *from = text;

    list_details(play, c, text, sizeof text);
    if (canvas_large_text_lines(canvas, text, to.w) * line > to.h)
        join_lines(canvas, text, to.w);
    for (int y = to.y; *from && y + line <= to.y + to.h; y += line) {
        const int n = canvas_large_text_fit(canvas, from, to.w);
        canvas_large_text_n(canvas, to.x, y + canvas->ascent, CANVAS_WHITE, from, (size_t)n);
        from += n;
        from += *from == '\n';
    }
}

static void draw(void *context, int at, const struct canvas *canvas, struct screen_area to)
{
    struct play *play = context;
    struct replay_list *l = &play->replay_list;
    const int here = replay_at(l, at), i = here < 0 ? l->order[0].i : here; /* above the replays: the first one */
    int side = 0;

    choose(l, i);
    if (l->thumb.w > 0)
        side = draw_thumb(&l->thumb, canvas, (struct screen_area){ to.x + 5, to.y, THUMB_SIDE, to.h - 12 }) + 8;
    draw_details(play, &l->list.list[i].meta, canvas,
                 (struct screen_area){ to.x + 5 + side, to.y - 2, to.w - 10 - side, to.h });
}

static const struct screen_def replays = { .title = "Replays",
                                           .rows = rows,
                                           .row = row,
                                           .text = text,
                                           .change = change,
                                           .accept = accept,
                                           .remove = remove_replay,
                                           .removal = "Delete",
                                           .closed = closed,
                                           .height = height,
                                           .draw = draw };

static void list(struct play *play)
{
    struct replay_list *l = &play->replay_list;

    replays_close(&l->list);
    if (!replays_open(&l->list, play_home_cart(play)->manifest.id))
        screens_show_message(&play->screens, "Out of memory: some replays are not listed");
    replay_list_changed(play);
}

/* Returns the row of the replay that was watched last, or of the first one. */
static int first_chosen(const struct replay_list *l)
{
    for (int i = 0; l->order && i < l->list.n; i++)
        if (strcmp(l->list.list[l->order[i].i].stem, l->watched) == 0)
            return rows_above(l) + i;
    return rows_above(l);
}

void play_open_replays(struct play *play)
{
    const struct rom *rom = play_home_cart(play)->rom;

    attract_end(&play->attract);
    play->replay_list.rom = rom_hash(rom);
    play->replay_list.game = rom_game_hash(rom);
    list(play);
    screens_open(&play->screens, &replays, play);
    screens_choose(&play->screens, first_chosen(&play->replay_list));
}

/* ---- importing ---- */

static void find_file(void *context, const struct plat_folder_entry *file)
{
    struct replay_list *l = context;

    if (file->is_folder || !files_has_suffix(file->name, ".demo") || strlen(file->name) >= sizeof l->file[0])
        return;
    char *name = array_append(&l->file, (size_t)l->files, sizeof l->file[0]);
    if (!name)
        return;
    strcpy(name, file->name);
    l->files++;
}

static int import_rows(void *context)
{
    return ((struct play *)context)->replay_list.files;
}

static void import_row(void *context, int at, struct screen_row *row)
{
    snprintf(row->label, sizeof row->label, "%.90s", ((struct play *)context)->replay_list.file[at]);
}

static const char *import_text(void *context)
{
    struct play *play = context;
    struct replay_list *l = &play->replay_list;

    screens_format(&play->screens, l->text, sizeof l->text, "%s",
                   l->files ? "Exported replays and other files in their folder. Select one to copy it to your replays."
                            : "No exported replays. To import a .demo file, drop it on the window.");
    return l->text;
}

static bool import(struct play *play, const char *path, char *err, size_t err_size)
{
    struct replay_list *l = &play->replay_list;
    const bool good = replays_import(&l->list, path, play_home_cart(play)->rom, err, err_size);

    replay_list_changed(play);
    return good;
}

static void accept_import(void *context, int at)
{
    struct play *play = context;
    char path[sizeof REPLAY_EXPORTS + sizeof play->replay_list.file[0]], err[FILES_ERR_SIZE];

    snprintf(path, sizeof path, REPLAY_EXPORTS "/%s", play->replay_list.file[at]);
    if (import(play, path, err, sizeof err))
        screens_show_message(&play->screens, "Imported. It is in your replays, as a favourite.");
    else
        screens_show_message(&play->screens, "Cannot import this file: %s.", err);
}

static const struct screen_def imports = {
    .title = "Import Replay", .rows = import_rows, .row = import_row, .text = import_text, .accept = accept_import
};

static void open_imports(struct play *play)
{
    struct replay_list *l = &play->replay_list;

    free(l->file);
    l->file = NULL;
    l->files = 0;
    plat_list(REPLAY_EXPORTS, find_file, l);
    screens_open(&play->screens, &imports, play);
}

void play_import_replay(struct play *play, const char *path)
{
    const bool open = screens_contain(&play->screens, &replays);
    char err[FILES_ERR_SIZE];

    if (!open)
        list(play);
    if (import(play, path, err, sizeof err))
        play_show_message(play, MESSAGE_FRAMES, "Replay imported");
    else
        play_warn(play, "Cannot import %s: %s", path, err);
    if (open)
        screens_show_message(&play->screens, "%s", play->message.text);
    else
        closed(play);
}
