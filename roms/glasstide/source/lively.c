/*
 * lively.c - where a demo is liveliest, and where it is calm: `lively ROM DEMO`. A line for each part of it, from a
 * stage, a mark or a phase to the next: KIND NAME FRAME BULLETS FRAMES STORY CALM LONGEST. FRAME is the frame with the
 * most bullets and lasers, BULLETS; FRAMES is the length of the part, STORY the frames of dialogues and pages in it,
 * CALM the other frames without bullets and lasers, LONGEST the most of them in a row, counted from before the part. A
 * boss's name stands before that of its phase: crab/pincers.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../../src/machine/machine.h"
#include "../../../src/demo/demo.h"
#include "../../../src/workbench/pack/pack.h"
#include "../../../src/workbench/survive/simulation.h"

enum {
    LASER = 6,  /* bullets that a laser counts as */
    TYPED = 120 /* frames that a line takes to appear, at most */
};

struct piece {
    char kind[8], name[80], boss[40];
    uint32_t frame, most;
    uint32_t frames, story, calm, longest;
    uint32_t row;   /* frames without bullets up to now, also of the part before */
    uint32_t typed; /* the last of them, since a frame of story: a line appears letter by letter, without a hint */
};

static void fail(const char *what)
{
    fprintf(stderr, "lively: %s\n", what);
    exit(2);
}

static void tell(struct piece *p)
{
    if (p->kind[0])
        printf("%s %s %u %u %u %u %u %u\n", p->kind, p->name, p->frame, p->most, p->frames, p->story, p->calm,
               p->longest);
    p->kind[0] = 0;
}

static void begin(struct piece *p, const char *kind, const char *name)
{
    tell(p);
    snprintf(p->kind, sizeof p->kind, "%s", kind);
    snprintf(p->name, sizeof p->name, "%s", name);
    p->frame = p->most = p->frames = p->story = p->calm = p->longest = 0;
}

/* A moment begins or ends a part. */
static void take(struct piece *p, const struct board_marker *m)
{
    char name[80];

    switch (m->kind) {
    case MARKER_STAGE:
        begin(p, "stage", m->name);
        break;
    case MARKER_MARK:
        begin(p, "mark", m->name);
        break;
    case MARKER_BOSS:
        snprintf(p->boss, sizeof p->boss, "%s", m->name);
        break;
    case MARKER_PHASE:
        snprintf(name, sizeof name, "%s/%s", p->boss, m->name);
        begin(p, "phase", name);
        break;
    case MARKER_WON:
    case MARKER_LOST:
    case MARKER_CLEAR:
    case MARKER_OVER:
        tell(p);
        break;
    default:
        break;
    }
}

static void look(struct piece *p, const struct board *b)
{
    const uint32_t now = b->bullets.s.live + LASER * b->lasers.s.live;
    const bool is_story = board_last_output(b)->key_hint_count > 0;

    p->frames++;
    if (is_story && p->typed && p->typed <= TYPED && p->calm >= p->typed && p->row >= p->typed) {
        p->calm -= p->typed;
        p->row -= p->typed;
        p->story += p->typed;
    }
    p->typed = is_story || now || !p->story ? 0 : p->typed + 1;
    p->story += is_story;
    p->calm += !is_story && !now;
    p->row = is_story ? p->row : now ? 0 : p->row + 1;
    p->longest = p->row > p->longest ? p->row : p->longest;
    if (p->kind[0] && (now > p->most || !p->frame)) {
        p->most = now;
        p->frame = board_frame(b);
    }
}

int main(int argc, char **argv)
{
    struct piece part = { .frame = 0 };
    struct rom_image image;
    struct cart cart;
    struct simulation t;
    struct demo d;
    char err[512];

    if (argc != 3)
        fail("usage: lively ROM DEMO");
    if (!pack_load_game(argv[1], false, &image, err, sizeof err) || !cart_open(&cart, &image.rom, err, sizeof err) ||
        !demo_load(&d, argv[2], err, sizeof err) || !demo_check_cart(&d, &cart, err, sizeof err) ||
        !simulation_open(&t, &image.rom, &d.start, err, sizeof err))
        fail(err);
    for (uint32_t f = 0; f < d.frames && !board_last_output(t.b)->fault; f++) {
        const struct board_out *out = board_tick(t.b, d.pads[f]);
        for (int i = 0; i < out->marker_count; i++)
            take(&part, &out->marker[i]);
        look(&part, t.b);
    }
    tell(&part);
    return 0;
}
