/*
 * bot.c - plays a game by looking ahead, and records a demo of it: `bot ROM DEMO [option...]`.
 *
 *     --frames N      stop after N frames (default 20000)
 *     --stage S       practice start instead of the title
 *     --seed N        seed
 *     --deaths N      let the first N bullets that come hit (a run with deaths in it)
 *     --bombs N       press bomb where no way out is seen, N times at most
 *     --finish        stop two seconds after a score was entered into a table
 *     --quiet         no report
 *
 * While no player is in the game it presses what gets through menus. In the game it saves the board, tries each
 * direction for some frames, restores, and takes the way on which it lives longest and stands best. So it sees what
 * will happen, but knows nothing of any particular game.
 * floor: tools
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../platform/platform.h"
#include "../src/board/machine.h"
#include "../src/cab/demo/demo.h"
#include "../src/cab/pack/pack.h"
#include "tally.h"

enum {
    HOLD = 5,   /* frames a decision lasts */
    AHEAD = 42, /* frames it looks ahead */
    WAYS = 17,  /* standing, eight directions, and those with focus */
};

struct bot {
    struct board *b;
    void *snapshot;
    size_t room;
    bool finish;
    int deaths; /* it still has to die so often */
    int bombs;  /* it may still press bomb so often */
    uint16_t pads[PADS];
    uint32_t until; /* frame of the next decision */
    struct tally tally;
};

static const uint16_t compass[9] = { 0,
                                     PAD_LEFT,
                                     PAD_RIGHT,
                                     PAD_UP,
                                     PAD_DOWN,
                                     PAD_LEFT | PAD_UP,
                                     PAD_RIGHT | PAD_UP,
                                     PAD_LEFT | PAD_DOWN,
                                     PAD_RIGHT | PAD_DOWN };

static uint16_t way(int i)
{
    return i < 9 ? compass[i] : (uint16_t)(compass[i - 8] | PAD_FOCUS);
}

static void save(struct bot *bot)
{
    size_t need = board_snapshot_size(bot->b);

    if (need > bot->room) {
        free(bot->snapshot);
        bot->room = need * 2;
        bot->snapshot = malloc(bot->room);
        if (!bot->snapshot)
            exit(3);
    }
    board_save(bot->b, bot->snapshot);
}

static double px(fx v)
{
    return v / 65536.0;
}

/* How well a player stands: under the nearest enemy, low on the field, away from the edges. */
static double standing(const struct board *b)
{
    double x = px(b->player.x[0]), y = px(b->player.y[0]), w = b->cart.m.field_w, h = b->cart.m.field_h;
    double want = w / 2, best = 1e9;

    EACH_LIVE (i, &b->enemies.s) {
        double ex = px(b->enemies.x[i]), ey = px(b->enemies.y[i]), d = (ex > x ? ex - x : x - ex);
        if (ey > 0 && ey < y && ex > 0 && ex < w && d < best) {
            best = d;
            want = ex;
        }
    }
    double off = x > want ? x - want : want - x, low = y > h * 0.82 ? y - h * 0.82 : h * 0.82 - y;
    return -0.02 * off - 0.02 * low - (x < 24 || x > w - 24 ? 1 : 0);
}

/* Crowding: bullets near the player that come nearer. */
static double danger(const struct board *b)
{
    double x = px(b->player.x[0]), y = px(b->player.y[0]), sum = 0;

    EACH_LIVE (i, &b->bullets.s) {
        double dx = px(b->bullets.x[i]) - x, dy = px(b->bullets.y[i]) - y, d2 = dx * dx + dy * dy;
        if (d2 < 900)
            sum += 1 / (d2 + 60);
    }
    return sum;
}

static bool hit(const struct board *b, int32_t lives)
{
    return !b->player.in[0] || b->player.lives[0] < lives || board_last(b)->fault;
}

/* What it would have taken on the way: items and kills, as points. */
static double gained(const struct board *b, int64_t score)
{
    int64_t more = b->player.score[0] - score;

    return 0.002 * (double)(more < 2000 ? more : 2000);
}

/* Frames lived when the first decision is `first`, the second `second`; *value: how good the end is. */
static int try_way(struct bot *bot, uint16_t first, uint16_t second, double *value)
{
    int32_t lives = bot->b->player.lives[0];
    int64_t score = bot->b->player.score[0];

    *value = 0;
    for (int f = 0; f < AHEAD; f++) {
        uint16_t move = f < HOLD ? first : f < 3 * HOLD ? second : 0;
        uint16_t pads[PADS] = { (uint16_t)(move | PAD_FIRE), 0 };
        board_tick(bot->b, pads);
        if (hit(bot->b, lives))
            return f;
        if (f == HOLD || f == 3 * HOLD)
            *value -= 6 * danger(bot->b);
    }
    *value += standing(bot->b) + gained(bot->b, score);
    return AHEAD;
}

/* The best of all first decisions, each followed by the k-th kind of second one. */
static void search(struct bot *bot, int k, double *best, uint16_t *chosen)
{
    for (int i = 0; i < WAYS; i++) {
        double value;
        uint16_t second = k == 0 ? 0 : k == 1 ? way(i) : way(i < 9 ? (i * 5 + 3) % 9 : 9 + (i * 5) % 8);
        int lived = try_way(bot, way(i), second, &value);
        board_restore(bot->b, bot->snapshot);
        value += 1000.0 * lived;
        if (value > *best) {
            *best = value;
            *chosen = way(i);
        }
    }
}

/* Looks further only when the simple ways all end badly; where all do, there is the bomb. */
static uint16_t decide(struct bot *bot)
{
    double best = -1e18;
    uint16_t chosen = 0;

    save(bot);
    for (int k = 0; k < 3 && best < 1000.0 * AHEAD - 100; k++)
        search(bot, k, &best, &chosen);
    if (best >= 1000.0 * AHEAD - 100 || bot->bombs <= 0)
        return chosen;
    bot->bombs--;
    return chosen | PAD_BOMB;
}

/* Through menus: fire now and then, so that each screen can be seen. */
static uint16_t press(uint32_t frame)
{
    return frame % 75 == 60 ? PAD_FIRE : frame % 75 == 20 ? PAD_START : 0;
}

static void think(struct bot *bot)
{
    const struct board *b = bot->b;
    uint32_t frame = board_frame(b);

    if (!b->player.in[0] || b->core.frozen) {
        bot->pads[0] = press(frame);
        bot->until = 0;
        return;
    }
    if (player_withheld(&b->player, 0)) { /* it is talked; start would pause that */
        bot->pads[0] = press(frame) & PAD_FIRE;
        bot->until = 0;
        return;
    }
    bool busy = b->enemies.s.live || b->bullets.s.live;
    if (bot->deaths > 0 && b->bullets.s.live > 30) { /* it goes to meet them */
        bot->pads[0] = PAD_FIRE | (frame % 8 < 4 ? PAD_UP : 0);
        return;
    }
    if (frame >= bot->until) {
        bot->pads[0] = busy ? decide(bot) : 0;
        bot->until = frame + HOLD;
    }
    bot->pads[0] |= PAD_FIRE;
}

static void fail(const char *what)
{
    fprintf(stderr, "bot: %s\n", what);
    exit(2);
}

/* Was a score entered in this frame? */
static bool entered(const struct board_out *out)
{
    for (int i = 0; i < out->markers; i++)
        if (out->marker[i].kind == MARKER_ROW)
            return true;
    return false;
}

static void play(struct bot *bot, struct demo_writer *w, uint32_t frames, bool quiet)
{
    struct board *b = bot->b;

    while (board_frame(b) < frames) {
        uint64_t deaths = bot->tally.deaths;
        think(bot);
        tally_before(&bot->tally, b);
        const struct board_out *out = board_tick(b, bot->pads);
        demo_frame(w, b, bot->pads);
        if (out->log_size && !quiet)
            printf("%6u  %.*s", board_frame(b), (int)out->log_size, out->log);
        if (out->fault)
            fail(out->fault->message);
        tally_after(&bot->tally, b);
        if (bot->finish && entered(out) && frames > board_frame(b) + 120)
            frames = board_frame(b) + 120;
        bot->deaths -= (int)(bot->tally.deaths - deaths);
    }
}

int main(int argc, char **argv)
{
    struct bot bot = { 0 };
    struct board_start start = { .difficulty = -1, .seed = 1 };
    struct rom_image image;
    struct demo_writer w = { 0 };
    struct cart cart;
    uint32_t frames = 20000;
    bool quiet = false;
    char err[256];
    size_t size;

    if (argc < 3)
        fail("usage: bot ROM DEMO [option...]");
    for (int i = 3; i < argc; i++) {
        const char *more = i + 1 < argc ? argv[i + 1] : "0";
        if (!strcmp(argv[i], "--frames"))
            frames = (uint32_t)atoi(more), i++;
        else if (!strcmp(argv[i], "--stage"))
            snprintf(start.practice.section, sizeof start.practice.section, "%s", more), i++;
        else if (!strcmp(argv[i], "--seed"))
            start.seed = (uint64_t)atoll(more), i++;
        else if (!strcmp(argv[i], "--deaths"))
            bot.deaths = atoi(more), i++;
        else if (!strcmp(argv[i], "--bombs"))
            bot.bombs = atoi(more), i++;
        else if (!strcmp(argv[i], "--finish"))
            bot.finish = true;
        else if (!strcmp(argv[i], "--quiet"))
            quiet = true;
        else
            fail(argv[i]);
    }
    if (!rom_image_load(argv[1], false, &image, err, sizeof err) || !cart_open(&cart, &image.rom, err, sizeof err) ||
        !board_size(&image.rom, &size, err, sizeof err))
        fail(err);
    for (int i = 0; i < cart.m.n_dips; i++)
        start.dip[i] = cart.m.dips[i].value;
    void *ram = malloc(size);
    if (!ram || !(bot.b = board_power(ram, size, &image.rom, &start, true, err, sizeof err)))
        fail(ram ? err : "out of memory");
    board_count(bot.b, false);
    if (!demo_begin(&w, argv[2], &cart, bot.b, &start, 0))
        fail(w.err);
    play(&bot, &w, frames, quiet);
    if (!demo_end(&w, bot.b))
        fail(w.err);
    const struct tally *t = &bot.tally;
    printf("%u frames, %llu bullets fired, at most %u at once, %llu kills, %llu grazes, %llu deaths\n",
           board_frame(bot.b), (unsigned long long)t->fired, t->most, (unsigned long long)t->kills,
           (unsigned long long)t->grazes, (unsigned long long)t->deaths);
    return 0;
}
