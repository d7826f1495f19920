/*
 * motion.c - the store of motion programs. Equal programs are one, so a script may build them in a loop.
 */
#include "motion.h"

static const struct column step_columns[] = {
    COLUMN(steps, does), COLUMN(steps, over),  COLUMN(steps, kind),  COLUMN(steps, bank),  COLUMN(steps, dir),
    COLUMN(steps, turn), COLUMN(steps, home),  COLUMN(steps, speed), COLUMN(steps, accel), COLUMN(steps, count),
    COLUMN(steps, jump), COLUMN(steps, depth), COLUMN(steps, named),
};

static const struct column motion_columns[] = { COLUMN(motions, first), COLUMN(motions, length),
                                                COLUMN(motions, fine) };

const struct chip steps_chip = { "steps", step_columns, sizeof step_columns / sizeof *step_columns, true, false };
const struct chip motions_chip = { "motions", motion_columns, sizeof motion_columns / sizeof *motion_columns, true,
                                   false };

void motion_step_at(const struct steps *s, uint32_t i, struct motion_step *out)
{
    *out = (struct motion_step){ .does = s->does[i],
                                 .kind = s->kind[i],
                                 .count = s->count[i],
                                 .jump = s->jump[i],
                                 .over = s->over[i],
                                 .bank = s->bank[i],
                                 .depth = s->depth[i],
                                 .dir = s->dir[i],
                                 .home = s->home[i],
                                 .turn = s->turn[i],
                                 .speed = s->speed[i],
                                 .accel = s->accel[i],
                                 .named = s->named[i] };
}

/* A turn is 360 * 2^16 units of fx, so one is 2^13 / 45 units of ang. 45 is odd: there are no ties. */
ang motion_angle(fx degrees)
{
    const int64_t product = (int64_t)degrees * 8192;

    return (ang)((product + (product < 0 ? -22 : 22)) / 45);
}

static bool same(const struct steps *s, uint32_t i, const struct motion_step *p)
{
    return s->does[i] == p->does && s->over[i] == p->over && s->kind[i] == p->kind && s->bank[i] == p->bank &&
           s->dir[i] == p->dir && s->turn[i] == p->turn && s->home[i] == p->home && s->speed[i] == p->speed &&
           s->accel[i] == p->accel && s->count[i] == p->count && s->jump[i] == p->jump && s->depth[i] == p->depth &&
           s->named[i] == p->named;
}

static void store(struct steps *s, uint32_t i, const struct motion_step *p)
{
    s->does[i] = p->does;
    s->over[i] = p->over;
    s->kind[i] = p->kind;
    s->bank[i] = p->bank;
    s->dir[i] = p->dir;
    s->turn[i] = p->turn;
    s->home[i] = p->home;
    s->speed[i] = p->speed;
    s->accel[i] = p->accel;
    s->count[i] = p->count;
    s->jump[i] = p->jump;
    s->depth[i] = p->depth;
    s->named[i] = p->named;
}

int32_t motion_define(struct motions *m, struct steps *s, const struct motion_step *steps, uint32_t n, bool fine)
{
    for (uint32_t k = 0; k < m->s.live; k++) {
        uint32_t i = 0;
        if (m->length[k] != n || m->fine[k] != fine)
            continue;
        while (i < n && same(s, m->first[k] + i, &steps[i]))
            i++;
        if (i == n)
            return (int32_t)k;
    }
    if (s->s.cap - s->s.live < n) {
        s->s.refused++;
        return NO_SLOT;
    }
    int32_t made = slots_append(&m->s);
    if (made == NO_SLOT)
        return NO_SLOT;
    m->first[made] = s->s.live;
    m->length[made] = (uint16_t)n;
    m->fine[made] = fine;
    for (uint32_t i = 0; i < n; i++)
        store(s, (uint32_t)slots_append(&s->s), &steps[i]);
    return made;
}
