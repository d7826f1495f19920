/*
 * engine.c - see engine.h. Lists of events have room for whatever a frame can raise.
 */
#include "engine.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../src/script/api/api.h"

const struct box ENGINE_EVERYWHERE = { FX_MIN, FX_MIN, FX_MAX, FX_MAX };

struct place {
    const struct chip *chip;
    void *self;
    uint32_t cap;
};

static void *room_for(size_t n)
{
    void *p = aligned_alloc(64, (n + 63) / 64 * 64);

    if (!p) {
        fprintf(stderr, "lab: out of memory\n");
        exit(2);
    }
    return memset(p, 0, n);
}

struct board *engine_power(uint32_t bullets, uint32_t shots, uint32_t enemies)
{
    struct board *b = room_for(sizeof *b);
    const struct place places[] = {
        { &bullets_chip, &b->bullets, bullets },
        { &bullet_kinds_chip, &b->bullet_kinds, MAX_KINDS },
        { &shots_chip, &b->shots, shots },
        { &shot_kinds_chip, &b->shot_kinds, MAX_KINDS },
        { &enemies_chip, &b->enemies, enemies },
        { &enemy_kinds_chip, &b->enemy_kinds, MAX_KINDS },
        { &input_chip, &b->input, MAX_PLAYERS },
        { &player_chip, &b->player, MAX_PLAYERS },
        { &player_kinds_chip, &b->player_kinds, 64 },
        { &motions_chip, &b->motions, 64 },
        { &steps_chip, &b->steps, 64 * MOTION_STEPS_PER_PROGRAM },
    };
    enum { COUNT = sizeof places / sizeof *places };
    uint64_t size = 0;

    for (int i = 0; i < COUNT; i++)
        size += slots_size(places[i].chip, places[i].cap, 0);
    b->ram = room_for(size);
    uint8_t *next = b->ram;
    for (int i = 0; i < COUNT; i++)
        slots_layout(places[i].chip, places[i].self, places[i].cap, 0, &next);
    const uint32_t events = 2 * bullets + shots + 16;
    events_init(&b->events, events, room_for(events_size(events)));
    b->hit_grid = room_for(hit_grid_size(enemies));
    b->output = room_for(sizeof *b->output);
    return b;
}

void engine_free(struct board *b)
{
    free(b->output);
    free(b->events.a);
    free(b->hit_grid);
    free(b->ram);
    free(b);
}

static uint16_t kind_of(struct bullet_kinds *k, uint8_t shape, fx a, fx b, bool swept)
{
    int32_t i = slots_append(&k->s);

    k->shape[i] = shape;
    k->a[i] = a;
    k->b[i] = b;
    k->flags[i] = swept ? KIND_SWEPT : 0;
    return (uint16_t)i;
}

uint16_t engine_circle(struct bullet_kinds *k, fx radius, bool swept)
{
    return kind_of(k, SHAPE_CIRCLE, radius, 0, swept);
}

uint16_t engine_box(struct bullet_kinds *k, fx half_w, fx half_h, bool swept)
{
    return kind_of(k, SHAPE_BOX, half_w, half_h, swept);
}

uint16_t engine_enemy(struct board *b, fx half_w, fx half_h)
{
    int32_t i = slots_append(&b->enemy_kinds.s);

    b->enemy_kinds.shape[i] = SHAPE_BOX;
    b->enemy_kinds.a[i] = half_w;
    b->enemy_kinds.b[i] = half_h;
    b->enemy_kinds.hp[i] = 1;
    return (uint16_t)i;
}

uint16_t engine_motion(struct board *b, const struct motion_step *steps, uint32_t n, bool fine)
{
    return (uint16_t)(motion_define(&b->motions, &b->steps, steps, n, fine) + 1);
}

uint32_t engine_bullet(struct bullets *s, uint16_t kind, fx x, fx y, fx vx, fx vy)
{
    const struct bullet_spec shape = { .x = x, .y = y, .kind = kind };
    uint32_t i = (uint32_t)bullets_fire(s, &shape, 0);

    s->vx[i] = vx;
    s->vy[i] = vy;
    s->speed_bound = fx_max(s->speed_bound, fx_max(fx_abs(vx), fx_abs(vy)));
    return i;
}

void engine_player(struct board *b, fx radius, fx x, fx y, fx mx, fx my)
{
    b->player_kinds.radius[0] = radius;
    b->player_kinds.graze_radius[0] = radius;
    b->player.in_game[0] = 1;
    b->player.gen[0] = 1;
    b->player.kind[0] = 0;
    b->player.x[0] = x;
    b->player.y[0] = y;
    b->player.prev_x[0] = x - mx;
    b->player.prev_y[0] = y - my;
}

void engine_move(struct board *b, const struct box *keep)
{
    struct motion_world w = {
        .motions = &b->motions, .steps = &b->steps, .kinds = &b->bullet_kinds, .clock = b->core.clock
    };

    bullets_move(&b->bullets, &w, keep, NULL, false);
    b->core.clock++;
}

/* No tick sets the limit of work here. */
static void begin_frame(struct board *b)
{
    b->events.n = 0;
    b->vm.limit = UINT64_MAX;
}

uint32_t engine_board_frame(struct board *b, const struct box *keep)
{
    begin_frame(b);
    b->keep_box = *keep;
    b->player_area = ENGINE_EVERYWHERE;
    board_move_entities(b);
    hit_run(b);
    b->core.clock++;
    bullets_release_all(&b->bullets); /* their events stay to be read */
    return b->events.n;
}

uint32_t engine_hits(struct board *b)
{
    struct bullets_query query[MAX_PLAYERS];

    begin_frame(b);
    hit_get_queries(b, query);
    for (uint32_t k = 0; k < b->bullets.s.top / SLOTS_BLOCK * MAX_PLAYERS; k++) /* all are asked */
        b->bullets.near_player[k] = query[k % MAX_PLAYERS].reach < 0 ? 0 : b->bullets.s.live_bits[k / MAX_PLAYERS];
    b->bullets.holds_all = true;
    hit_run(b);
    return b->events.n;
}

const char *engine_default(const char *entry, const char *argument)
{
    for (int i = 0; i < api_count_entries(&api_table); i++) {
        const struct api_entry *e = api_get_entry(&api_table, i);
        for (int k = 0; k < e->count && !strcmp(e->name, entry); k++)
            if (!strcmp(e->params[k].name, argument) && e->params[k].def)
                return e->params[k].def;
    }
    return "";
}
