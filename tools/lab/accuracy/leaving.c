/*
 * leaving.c - see leaving.h.
 *
 * Bullets fly at a player who stands 8 px above the field's lower edge, and are gone after the frame that they end
 * outside of field and margin. The model knows a bullet's place, velocity and the edge: it walks the frames one by one,
 * asks touches.h of the way of each, and stops after the first that ends outside. So it says in which frame each bullet
 * touches first, if ever; the engine, on a board with all of them, must tell that frame, and within a frame the slots
 * in their order.
 */
#include "leaving.h"
#include <math.h>
#include "engine.h"
#include "lab.h"
#include "touches.h"

enum { TRIALS = 4096, MARGINS = 2, SPEEDS = 6, MOST_FRAMES = 64, NEVER = -1 };

static const int MARGIN[MARGINS] = { 0, 64 };
static const int SPEED[SPEEDS] = { 16, 64, 100, 300, 1000, 8191 };
static const fx PLAYER_X = 192 * 65536 + 24001, PLAYER_Y = 352 * 65536 + 51007, CONTACT = 4 * 65536;

struct flight {
    fx x, y, vx, vy;
    int touch; /* the frame, from 0, or NEVER: by the model */
    bool last; /* it is the frame in which the bullet leaves */
};

static struct flight flights[TRIALS];

struct tally {
    int touches, last, wrong_frame, out_of_order;
};
static struct tally tallies[MARGINS][SPEEDS];

static bool outside(const struct box *k, int64_t x, int64_t y)
{
    return x < k->x0 || x > k->x1 || y < k->y0 || y > k->y1;
}

static struct box keep_of(int margin)
{
    return (struct box){ PLAYER_X - PX(400), PLAYER_Y - PX(400), PLAYER_X + PX(400), PLAYER_Y + PX(8 + margin) };
}

static void walk(struct flight *f, const struct box *keep)
{
    int64_t x = f->x, y = f->y;

    f->touch = NEVER;
    for (int n = 0; n < MOST_FRAMES; n++) {
        bool leaves = outside(keep, x + f->vx, y + f->vy);
        if (touches_truly(x - PLAYER_X, y - PLAYER_Y, f->vx, f->vy, CONTACT)) {
            f->touch = n;
            f->last = leaves;
            return;
        }
        if (leaves)
            return;
        x += f->vx;
        y += f->vy;
    }
}

/* From anywhere above the edge, aimed at up to 6 px beside the player; at least half of a frame's way is behind it. */
static void set_flights(const struct box *keep, int speed)
{
    struct rng r;

    rng_seed(&r, (uint64_t)(keep->y1 >> 16) * 10000 + (uint64_t)speed);
    for (int i = 0; i < TRIALS; i++) {
        struct flight *f = &flights[i];
        double c, s, beside = lab_random(&r, -6, 6), back = lab_random(&r, 0, speed < 300 ? 1.5 * speed : 300);
        lab_direction(lab_random(&r, 0.05, 0.45), &c, &s);
        *f = (struct flight){ .vx = (fx)floor(speed * c * 65536), .vy = (fx)floor(speed * s * 65536) };
        f->x = PLAYER_X + (fx)floor((-back * c - beside * s) * 65536);
        f->y = PLAYER_Y + (fx)floor((-back * s + beside * c) * 65536);
        walk(f, keep);
    }
}

static void compare(struct tally *t, const struct box *keep)
{
    struct board *b = engine_power(TRIALS, 0, 0);
    uint16_t kind = engine_circle(&b->bullet_kinds, CONTACT - PX(1), true);
    static int told[TRIALS];

    engine_player(b, PX(1), PLAYER_X, PLAYER_Y, 0, 0);
    for (int i = 0; i < TRIALS; i++) {
        told[i] = NEVER;
        engine_bullet(&b->bullets, kind, flights[i].x, flights[i].y, flights[i].vx, flights[i].vy);
    }
    for (int n = 0; n < MOST_FRAMES && b->bullets.s.live; n++) {
        int32_t before = NEVER;
        engine_board_frame(b, keep);
        for (uint32_t k = 0; k < b->events.n; k++) {
            int32_t slot = (int32_t)handle_slot(b->events.b[k]);
            t->out_of_order += slot <= before;
            before = slot;
            told[slot] = told[slot] == NEVER ? n : told[slot];
        }
    }
    for (int i = 0; i < TRIALS; i++) {
        t->touches += flights[i].touch != NEVER;
        t->last += flights[i].touch != NEVER && flights[i].last;
        t->wrong_frame += told[i] != flights[i].touch;
    }
    engine_free(b);
}

void leaving_report(void)
{
    struct tally sum = { 0 };

    report_table("Bullets that fly towards a player 8 px above the field's lower edge and then leave the field",
                 "margin> | speed> | touches> | touches in the frame in which the bullet leaves the field> | touches "
                 "that the engine misses or reports in the wrong frame> | touches reported out of slot order>");
    for (int m = 0; m < MARGINS; m++)
        for (int s = 0; s < SPEEDS; s++) {
            struct tally *t = &tallies[m][s];
            struct box keep = keep_of(MARGIN[m]);
            set_flights(&keep, SPEED[s]);
            compare(t, &keep);
            sum.touches += t->touches;
            sum.last += t->last;
            sum.wrong_frame += t->wrong_frame;
            sum.out_of_order += t->out_of_order;
            report_row(false, report_string("%d px", MARGIN[m]), report_string("%d px/frame", SPEED[s]),
                       report_count(t->touches), report_percent((double)t->last / t->touches),
                       report_count(t->wrong_frame), report_count(t->out_of_order), NULL);
        }
    report_table_end();
    report_text("A bullet has left the field when it is outside the field and the *margin* around it at the end of a "
                "frame. In each\n"
                "frame, the engine moves everything, then finds touches, then despawns the bullets that have left the "
                "field. Of %s\n"
                "touches, %s happen in the frame in which the bullet leaves the field. An engine that despawned "
                "bullets first would\n"
                "miss these touches. The expected touches come from a reference model that steps each bullet "
                "separately with 128-bit\n"
                "products.",
                report_count(sum.touches), report_percent((double)sum.last / sum.touches));
    lab_claim(sum.wrong_frame + sum.out_of_order == 0, "what leaves the field touches what is on its way");
    lab_claim(sum.last > sum.touches / 5, "many touch as they leave");
}
