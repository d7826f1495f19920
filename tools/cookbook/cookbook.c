/*
 * cookbook.c - runs pages of the cookbook. `cookbook ROM FRAMES [-o DIR] PAGE[:FRAME[:STEP]]...` plays each page
 * from power-on and prints one line per page:
 *
 *     PAGE HASH BULLETS LASERS WORK MOST LEAST
 *
 * HASH is the state's hash after FRAMES frames; BULLETS and LASERS are the most alive at once; WORK, MOST and LEAST are
 * the mean, maximum and minimum work per frame (vm.h). The first two frames don't count: the book writes its text then.
 * With -o, pictures of the field at three frames, FRAME (300) and two more at intervals of STEP (40) frames, go to
 * DIR/PAGE.png. Exit code 1: a fault or a full pool, which standard error reports.
 *
 * The plain ship stands still. Other ships sway, hold fire, and press bomb now and then and after a hit.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../src/board/board.h"
#include "../../src/machine/machine.h"
#include "../../src/workbench/pack/pack.h"
#include "../../src/player/picture/png.h"

enum {
    FIRST = 2,        /* frames that don't count */
    SWAY = 40,        /* frames in one direction */
    BOMB_EVERY = 400, /* frames between bombs */
    BOMB_FIRST = 200,
    LATE = 5,     /* frames left for a deathbomb */
    PICTURES = 3, /* per page, side by side */
    GAP = 4,      /* px between pictures */
    GREY = 0x282828
};

struct cookbook {
    struct rom_image image;
    struct cart cart;
    size_t ram_size;
    void *ram;
    const char *dir; /* for pictures; NULL: no pictures */
    long frames;
};

/* Pictures of a page side by side. */
struct strip {
    struct fb fb;
    void *screen, *scratch;
    uint8_t *pix;
    int w, count, colours;
    uint32_t rgb[256]; /* colours of all pictures */
};

struct tally {
    uint32_t bullets, lasers;   /* most alive at once */
    uint64_t work, most, least; /* total; maximum and minimum per frame */
};

static void fail(const char *what)
{
    fprintf(stderr, "cookbook: %s\n", what);
    exit(2);
}

static uint16_t hands(const struct board *b, long f)
{
    uint16_t pads = PAD_FIRE;

    if (!b->player.in_game[0] || b->player.kind[0] == 0)
        return 0;
    if (f / SWAY % 4 != 1)
        pads |= f / SWAY % 4 == 2 ? PAD_RIGHT : f / SWAY % 4 == 0 ? PAD_LEFT : 0;
    if (f / (SWAY * 4) % 2)
        pads |= PAD_FOCUS;
    if (f % BOMB_EVERY == BOMB_FIRST || (b->player.deathbomb_left[0] == LATE && f % BOMB_EVERY < BOMB_FIRST))
        pads |= PAD_BOMB; /* also answers some hits */
    return pads;
}

static void strip_open(struct strip *s, const struct cookbook *c, const struct board *b)
{
    int w, h;

    board_screen_size(b, &w, &h);
    s->w = PICTURES * (c->cart.manifest.field_w + GAP) - GAP;
    s->pix = calloc((size_t)s->w, (size_t)c->cart.manifest.field_h);
    s->screen = malloc(fb_size(w, h));
    s->scratch = malloc(board_scratch_size(b));
    s->rgb[s->colours++] = GREY; /* the gaps */
    if (!s->pix || !s->screen || !s->scratch)
        fail("out of memory");
    fb_init(&s->fb, s->screen, w, h);
}

static int64_t distance(uint32_t a, uint32_t b)
{
    int64_t sum = 0;

    for (int shift = 0; shift < 24; shift += 8) {
        int64_t d = (int64_t)(a >> shift & 255) - (int64_t)(b >> shift & 255);
        sum += d * d;
    }
    return sum;
}

/* The strip's index for a colour; after 256 colours, that of the nearest one. */
static int strip_colour(struct strip *s, uint32_t rgb)
{
    int best = 0;

    for (int i = 1; i < s->colours; i++) {
        if (distance(s->rgb[i], rgb) < distance(s->rgb[best], rgb))
            best = i;
    }
    if (s->rgb[best] == rgb || s->colours == 256)
        return best;
    s->rgb[s->colours] = rgb;
    return s->colours++;
}

/* Adds the current field, without the text next to it. */
static void strip_add(struct strip *s, const struct cookbook *c, const struct board *b)
{
    const struct manifest *m = &c->cart.manifest;
    int known[256], x0 = s->count++ * (m->field_w + GAP);
    uint32_t rgb[256];

    memset(known, -1, sizeof known);
    board_draw(b, NULL, &s->fb, rgb, s->scratch);
    for (int y = 0; y < m->field_h; y++) {
        const uint8_t *from = s->fb.pix + (ptrdiff_t)(m->field_y + y) * s->fb.pitch + m->field_x;
        for (int x = 0; x < m->field_w; x++) {
            if (known[from[x]] < 0)
                known[from[x]] = strip_colour(s, rgb[from[x]]);
            s->pix[(ptrdiff_t)y * s->w + x0 + x] = (uint8_t)known[from[x]];
        }
    }
}

static void strip_close(struct strip *s, const struct cookbook *c, const char *page)
{
    uint8_t *bytes;
    size_t size;
    char path[1024];

    snprintf(path, sizeof path, "%s/%s.png", c->dir, page);
    if (!png_write(s->pix, s->w, s->w, c->cart.manifest.field_h, s->rgb, &bytes, &size))
        fail("out of memory");
    FILE *f = fopen(path, "wb");
    if (!f || fwrite(bytes, 1, size, f) != size || fclose(f))
        fail(path);
    free(bytes);
    free(s->pix);
    free(s->screen);
    free(s->scratch);
}

static void count(struct tally *t, const struct board *b)
{
    if (b->bullets.s.live > t->bullets)
        t->bullets = b->bullets.s.live;
    if (b->lasers.s.live > t->lasers)
        t->lasers = b->lasers.s.live;
    if (board_frame(b) <= FIRST)
        return;
    t->work += b->vm.work;
    if (b->vm.work < t->least)
        t->least = b->vm.work;
    if (b->vm.work > t->most)
        t->most = b->vm.work;
}

/* False after a fault or a log line, which reports a full pool. */
static bool sound(const char *page, const struct board *b)
{
    const struct board_out *out = board_last_output(b);

    if (out->log_size)
        fprintf(stderr, "%s: frame %u: %.*s", page, board_frame(b), (int)out->log_size, out->log);
    if (out->fault)
        fprintf(stderr, "%s: frame %u: %s\n", page, board_frame(b), out->fault->message);
    return !out->fault && !out->log_size;
}

static bool run(const struct cookbook *c, const char *page, long frame, long step)
{
    struct board_start start = { .difficulty = -1, .seed = 1 };
    struct tally t = { .least = UINT64_MAX };
    struct strip strip = { 0 };
    char err[512];

    snprintf(start.practice.section, sizeof start.practice.section, "%s", page);
    struct board *b = board_power_on(c->ram, c->ram_size, &c->image.rom, &start, err, sizeof err);
    if (!b)
        fail(err);
    bool fine = sound(page, b);
    if (c->dir)
        strip_open(&strip, c, b);
    for (long f = 1; f <= c->frames && fine; f++) {
        const uint16_t pads[MAX_PLAYERS] = { hands(b, f) };
        board_tick(b, pads);
        fine = sound(page, b);
        count(&t, b);
        if (c->dir && f == frame + strip.count * step && strip.count < PICTURES)
            strip_add(&strip, c, b);
    }
    if (c->dir)
        strip_close(&strip, c, page);
    printf("%s %016llx %u %u %llu %llu %llu\n", page, (unsigned long long)board_hash(b), t.bullets, t.lasers,
           (unsigned long long)(t.work / (uint64_t)(c->frames - FIRST)), (unsigned long long)t.most,
           (unsigned long long)t.least);
    return fine;
}

int main(int argc, char **argv)
{
    struct cookbook c = { 0 };
    bool fine = true;
    char err[512];
    int i = 3;

    if (argc < 4 || (c.frames = atol(argv[2])) <= FIRST)
        fail("usage: cookbook ROM FRAMES [-o DIR] PAGE[:FRAME[:STEP]]...");
    if (argc > 5 && !strcmp(argv[i], "-o")) {
        c.dir = argv[i + 1];
        i += 2;
    }
    if (!pack_load_game(argv[1], false, &c.image, err, sizeof err) ||
        !cart_open(&c.cart, &c.image.rom, err, sizeof err) || !board_size(&c.image.rom, &c.ram_size, err, sizeof err))
        fail(err);
    c.ram = malloc(c.ram_size);
    if (!c.ram)
        fail("out of memory");
    for (; i < argc; i++) {
        char page[64] = "";
        long frame = 300, step = 40;
        sscanf(argv[i], "%63[^:]:%ld:%ld", page, &frame, &step);
        fine &= run(&c, page, frame, step);
    }
    return fine ? 0 : 1;
}
