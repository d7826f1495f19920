/*
 * inspect.c - bodies, kinds, gauges, tasks, and the entity under a point; see inspect.h.
 */
#include "inspect.h"
#include "../../fb/blit.h"
#include <string.h>
#include "../base/int.h"
#include "../machine/machine.h"
#include "../script/tasks.h"
#include "../script/vm.h"
#include "../machine/collision/hit.h"
#include "../machine/lasers_run.h"
#include "../machine/machine.h"

static int32_t to_screen(fx v, int corner)
{
    return v + corner * 65536;
}

struct inspect_area inspect_field(const struct board *b)
{
    const struct manifest *m = &b->cart.m;

    return (struct inspect_area){ m->field_x, m->field_y, m->field_w, m->field_h };
}

struct inspect_ship_has inspect_plays(const struct board *b, int player)
{
    const bool flies = b->player.in[player] && b->core.frozen <= 0;
    const unsigned withheld = player_withheld(&b->player, (uint32_t)player);

    return (struct inspect_ship_has){ .steers = flies && !(withheld & PAD_FOCUS),
                                      .fires = flies && !(withheld & PAD_FIRE) };
}

/* ---- bodies ---- */

static struct inspect_body body_at(const struct board *b, enum inspect_kind kind, uint32_t slot, fx x, fx y)
{
    return (struct inspect_body){
        .kind = kind, .slot = slot, .x = to_screen(x, b->cart.m.field_x), .y = to_screen(y, b->cart.m.field_y)
    };
}

static const enum inspect_shape shape_words[] = { [SHAPE_NONE] = INSPECT_NONE,
                                                  [SHAPE_CIRCLE] = INSPECT_CIRCLE,
                                                  [SHAPE_BOX] = INSPECT_BOX,
                                                  [SHAPE_CAPSULE] = INSPECT_CAPSULE,
                                                  [SHAPE_CIRCLES] = INSPECT_CIRCLES };

static void set_circles(const struct board *b, struct inspect_body *body, const struct body *piece, uint32_t n)
{
    body->shape = INSPECT_CIRCLES;
    body->n = (int32_t)n;
    for (uint32_t i = 0; i < n; i++) {
        body->circle[i].x = to_screen(piece[i].x, b->cart.m.field_x);
        body->circle[i].y = to_screen(piece[i].y, b->cart.m.field_y);
        body->circle[i].r = piece[i].a;
        body->a = fx_max(body->a, fx_abs(body->circle[i].x - body->x) + piece[i].a);
        body->b = fx_max(body->b, fx_abs(body->circle[i].y - body->y) + piece[i].a);
    }
}

/* Sets the body's shape from the n shapes that the collision tests use. Only SHAPE_CIRCLES uses more than the first. */
static void set_shape(const struct board *b, struct inspect_body *body, uint8_t shape, const struct body *piece,
                      uint32_t n)
{
    if (shape == SHAPE_CIRCLES) {
        set_circles(b, body, piece, n);
        return;
    }
    body->shape = shape_words[shape];
    body->a = shape == SHAPE_NONE ? 0 : piece->a;
    body->b = shape == SHAPE_BOX || shape == SHAPE_CAPSULE ? piece->b : 0;
    body->c = piece->c;
}

static bool can_be_grazed(const struct board *b, uint32_t i)
{
    if (!(b->bullet_kinds.flags[b->bullets.kind[i]] & KIND_GRAZE) || b->bullets.flags[i] & BULLET_DELAYED)
        return false;
    for (uint32_t p = 0; p < PADS; p++)
        if (b->player.in[p] && !(b->bullets.flags[i] >> p & BULLET_GRAZED))
            return true;
    return false;
}

static struct inspect_body flying_body(const struct board *b, enum inspect_kind kind, uint32_t i)
{
    const struct bullets *s = kind == INSPECT_BULLET ? &b->bullets : &b->shots;
    const struct bullet_kinds *k = kind == INSPECT_BULLET ? &b->bullet_kinds : &b->shot_kinds;
    struct inspect_body body = body_at(b, kind, i, s->x[i], s->y[i]);

    struct body piece[SHAPE_PARTS];
    uint8_t shape = s->flags[i] & BULLET_DELAYED ? SHAPE_NONE : k->shape[s->kind[i]];

    set_shape(b, &body, shape, piece, hit_bullet_pieces(s, k, i, piece));
    body.spent = kind == INSPECT_BULLET && !can_be_grazed(b, i);
    return body;
}

static struct inspect_body enemy_body(const struct board *b, uint32_t i)
{
    const struct enemies *e = &b->enemies;
    const struct enemy_kinds *k = &b->enemy_kinds;
    struct inspect_body body = body_at(b, INSPECT_ENEMY, i, e->x[i], e->y[i]);

    struct body piece[SHAPE_PARTS];

    set_shape(b, &body, k->shape[e->kind[i]], piece, hit_enemy_pieces(b, i, piece));
    body.spent = !(k->flags[e->kind[i]] & ENEMY_TOUCH) || e->flags[i] & ENEMY_DYING;
    return body;
}

static struct inspect_body player_body(const struct board *b, uint32_t i)
{
    const struct player *p = &b->player;
    struct inspect_body body = body_at(b, INSPECT_PLAYER, i, p->x[i], p->y[i]);

    body.shape = INSPECT_CIRCLE;
    body.a = b->player_kinds.radius[p->kind[i]];
    body.graze = b->player_kinds.graze_radius[p->kind[i]];
    body.spent = p->safe[i] > 0 || b->start.practice.invincible;
    return body;
}

static bool laser_can_be_grazed(const struct board *b, uint32_t i)
{
    const uint16_t kind = b->laser_heads.kind[i];

    if (b->laser_kinds.flags[kind] & LASER_SHOOTS || !b->laser_kinds.graze[kind])
        return false;
    for (uint32_t p = 0; p < PADS; p++)
        if (b->player.in[p] && b->core.clock >= b->lasers.again[i * PADS + p])
            return true;
    return false;
}

/* Returns the body of laser i's segment that starts at corner k, with the reach used by the last frame's hit
 * detection. */
static struct inspect_body laser_body(const struct board *b, uint32_t i, uint32_t k)
{
    const fx reach = hit_laser_reach(b, i, lasers_age_seen(b, i));
    fx x, y, to_x, to_y;

    lasers_corner(b, i, k, &x, &y);
    lasers_corner(b, i, k + 1 < lasers_corners(b, i) ? k + 1 : k, &to_x, &to_y);
    const fx half_x = (fx)(((int64_t)to_x - x) / 2), half_y = (fx)(((int64_t)to_y - y) / 2);
    struct inspect_body body = body_at(b, INSPECT_LASER, i, x + half_x, y + half_y);
    if (reach >= 0) {
        body.shape = INSPECT_CAPSULE;
        body.a = reach;
        body.b = half_x;
        body.c = half_y;
    }
    body.spent = !laser_can_be_grazed(b, i);
    return body;
}

static void laser_bodies(const struct board *b, void (*each)(void *context, const struct inspect_body *body),
                         void *context)
{
    EACH_LIVE (i, &b->lasers.s) {
        const uint32_t n = lasers_corners(b, i);
        for (uint32_t k = 0; k + 1 < n || k == 0; k++) {
            struct inspect_body body = laser_body(b, i, k);
            each(context, &body);
        }
    }
}

void inspect_bodies(const struct board *b, void (*each)(void *context, const struct inspect_body *body), void *context)
{
    struct inspect_body body;

    EACH_LIVE (i, &b->enemies.s) {
        body = enemy_body(b, i);
        each(context, &body);
    }
    EACH_LIVE (i, &b->shots.s) {
        body = flying_body(b, INSPECT_SHOT, i);
        each(context, &body);
    }
    EACH_LIVE (i, &b->bullets.s) {
        body = flying_body(b, INSPECT_BULLET, i);
        each(context, &body);
    }
    laser_bodies(b, each, context);
    for (uint32_t i = 0; i < PADS; i++) {
        body = player_body(b, i);
        if (b->player.in[i])
            each(context, &body);
    }
}

bool inspect_ship(const struct board *b, int player, struct inspect_body *out)
{
    const struct player *p = &b->player;
    int dx, dy;

    if (!p->in[player] || p->flags[player] & PLAYER_HIDDEN)
        return false;
    screen_shake(&b->screen, b->core.clock, &dx, &dy);
    *out = player_body(b, (uint32_t)player);
    out->x += dx * 65536;
    out->y += dy * 65536;
    return true;
}

/* ---- kinds ---- */

static void measure(const struct shape_columns *k, uint32_t i, struct inspect_shape_of *out)
{
    fx a = k->a[i], w = a, h = k->shape[i] == SHAPE_BOX ? k->b[i] : a;

    if (k->shape[i] == SHAPE_CAPSULE) {
        w = a + k->b[i] + fx_abs(k->x[i]);
        h = a + fx_abs(k->y[i]);
    }
    *out = (struct inspect_shape_of){ .shape = shape_words[k->shape[i]], .x0 = -w, .y0 = -h, .x1 = w, .y1 = h };
    out->r = a;
    if (k->shape[i] == SHAPE_CAPSULE) {
        out->bar_x = k->b[i] + k->x[i];
        out->bar_y = k->y[i];
    }
    if (k->shape[i] != SHAPE_CIRCLES)
        return;
    out->x0 = out->y0 = FX_MAX;
    out->x1 = out->y1 = FX_MIN;
    for (uint32_t row = i; row <= i + (uint32_t)k->b[i]; row++) {
        out->x0 = fx_min(out->x0, k->x[row] - k->a[row]);
        out->x1 = fx_max(out->x1, k->x[row] + k->a[row]);
        out->y0 = fx_min(out->y0, k->y[row] - k->a[row]);
        out->y1 = fx_max(out->y1, k->y[row] + k->a[row]);
        out->circle[out->n].x = k->x[row];
        out->circle[out->n].y = k->y[row];
        out->circle[out->n++].r = k->a[row];
    }
}

/* Calls `each` for every kind of ship; a ship's hitbox is a circle. */
static void ship_kinds(const struct board *b, void (*each)(void *context, const struct inspect_shape_of *kind),
                       void *context)
{
    const struct player_kinds *k = &b->player_kinds;

    for (uint32_t i = 0; i < k->s.live; i++) {
        const char *name = board_name(b, N_PLAYER, (int)i);
        const fx r = k->radius[i];
        if (name)
            each(context, &(struct inspect_shape_of){ .of = "player",
                                                      .name = name,
                                                      .shape = INSPECT_CIRCLE,
                                                      .r = r,
                                                      .x0 = -r,
                                                      .y0 = -r,
                                                      .x1 = r,
                                                      .y1 = r,
                                                      .sprite = cart_sprite_name(&b->cart, k->sprite[i]) });
    }
}

/* Returns the name of the blend in a kind's flags if that is a ramp blend; otherwise NULL. */
static const char *ramp_of(const struct board *b, uint16_t flags)
{
    const int blend = (flags & KIND_BLEND) / KIND_BLEND_ONE;

    return blend && b->cart.main.mix[blend - 1] != BLIT_TABLE ? cart_blend_name(&b->cart, blend - 1) : NULL;
}

void inspect_kinds(const struct board *b, void (*each)(void *context, const struct inspect_shape_of *kind),
                   void *context)
{
    const struct bullet_kinds *k = &b->bullet_kinds, *ks = &b->shot_kinds;
    const struct enemy_kinds *ke = &b->enemy_kinds;
    const struct {
        const char *of;
        enum name_kind names;
        struct shape_columns shapes;
        uint32_t n;
        const uint16_t *sprite;
        const uint8_t *bank;
        const uint16_t *flags; /* KIND_ flags; NULL: no flags */
    } all[] = {
        { "bullet", N_BULLET, { k->shape, k->a, k->b, k->x, k->y }, k->s.live, k->sprite, k->bank, k->flags },
        { "shot", N_SHOT, { ks->shape, ks->a, ks->b, ks->x, ks->y }, ks->s.live, ks->sprite, ks->bank, ks->flags },
        { "enemy", N_ENEMY, { ke->shape, ke->a, ke->b, ke->x, ke->y }, ke->s.live, ke->sprite, ke->bank, NULL },
    };
    struct inspect_shape_of kind;

    for (int what = 0; what < 3; what++)
        for (uint32_t i = 0; i < all[what].n; i++) {
            const char *name = board_name(b, all[what].names, (int)i);
            if (!name || all[what].shapes.shape[i] == SHAPE_NONE) /* rows without a name are a kind's other circles */
                continue;
            measure(&all[what].shapes, i, &kind);
            kind.of = all[what].of;
            kind.name = name;
            kind.turns = all[what].flags && all[what].flags[i] & KIND_TURNS;
            kind.sprite = cart_sprite_name(&b->cart, all[what].sprite[i]);
            kind.bank = all[what].bank[i] & 15;
            kind.ramp = all[what].flags ? ramp_of(b, all[what].flags[i]) : NULL;
            each(context, &kind);
        }
    ship_kinds(b, each, context);
}

/* ---- gauges ---- */

static const struct slots *part_slots(const struct board *b, int i)
{
    return (const struct slots *)((const char *)b + machine_parts[i].at);
}

int inspect_gauges(const struct board *b, struct inspect_gauge out[MAX_PARTS])
{
    const void *fixed[] = { &b->input, &b->player, &b->fix, &b->pal, &b->nvram };

    for (int i = 0; i < PARTS; i++) {
        const struct slots *s = part_slots(b, i);
        bool list = !s->used;
        out[i] = (struct inspect_gauge){ machine_parts[i].chip->name,
                                         s->live,
                                         list ? s->live : s->top,
                                         list ? s->live : s->high,
                                         s->cap,
                                         s->refused,
                                         s->cap == 0 };
        for (size_t k = 0; k < sizeof fixed / sizeof *fixed; k++)
            out[i].fixed |= fixed[k] == (const void *)s;
    }
    return PARTS;
}

void inspect_memory(const struct board *b, size_t *used, size_t *size)
{
    *used = heap_used(b->vm.heap);
    *size = (size_t)b->cart.m.lua_kib * 1024;
}

uint64_t inspect_drawn(const struct board *b)
{
    return b->core.drawn;
}

void inspect_codes(const struct board *b, void (*each)(void *context, uint32_t code), void *context)
{
    const struct lines *l = &b->lines;

    for (uint32_t i = 0; i < b->fix.cols * b->fix.rows; i++)
        if (fix_code(&b->fix, i))
            each(context, fix_code(&b->fix, i));
    EACH_LIVE (i, &l->s)
        for (uint32_t k = 0; k < LINE_TEXT && !(l->flags[i] & LINE_HIDDEN) && l->code[i * LINE_TEXT + k]; k++)
            each(context, l->code[i * LINE_TEXT + k]);
}

/* ---- tasks ---- */

/* Stores the line at which the thread of task i waits; "" if the task has not run yet. */
static void find_line(const struct board *b, uint32_t i, char at[INSPECT_PLACE])
{
    at[0] = 0;
    if (!b->tasks.thread[i] || !(b->tasks.flags[i] & TASK_BEGUN))
        return;
    vm_where(b->tasks.thread[i], at, INSPECT_PLACE);
    size_t n = strlen(at);
    if (n >= 2) /* remove the final ": " */
        at[n - 2] = 0;
}

static void find_owner(const struct board *b, int64_t owner, struct inspect_task *out)
{
    static const enum inspect_owner owners[HANDLES] = {
        [H_BULLET] = OWNER_BULLET, [H_SHOT] = OWNER_SHOT, [H_ENEMY] = OWNER_ENEMY, [H_PLAYER] = OWNER_PLAYER,
        [H_SPRITE] = OWNER_SPRITE, [H_TASK] = OWNER_TASK, [H_LASER] = OWNER_LASER, [H_OPTION] = OWNER_OPTION
    };
    uint32_t slot = handle_slot(owner);

    if (!owner)
        return;
    out->owner = owners[handle_kind(owner)];
    out->owner_number = slot;
    if (out->owner == OWNER_PLAYER)
        out->owner_number++;
    if (out->owner == OWNER_TASK)
        out->owner_number = slots_has(&b->tasks.s, slot, handle_gen(owner)) ? b->tasks.serial[slot] : 0;
}

static void describe_task(const struct board *b, uint32_t i, struct inspect_task *out)
{
    const struct tasks *t = &b->tasks;

    *out = (struct inspect_task){ .serial = t->serial[i],
                                  .age = b->core.clock - t->born[i],
                                  .wait = t->wait[i] > 1 ? t->wait[i] : 1,
                                  .forever =
                                      t->wait[i] > LUA_MAXINTEGER / 2, /* a task that waits forever counts down too */
                                  .scope = t->flags[i] & TASK_SCOPE,
                                  .begun = t->flags[i] & TASK_BEGUN,
                                  .stopped = t->flags[i] & TASK_STOP || !tasks_owner_alive(b, t->owner[i]),
                                  .frozen = tasks_frozen(b, i) };
    find_owner(b, t->owner[i], out);
    find_line(b, i, out->at);
}

uint32_t inspect_tasks(const struct board *b, uint32_t first, struct inspect_task *out, uint32_t n)
{
    const struct tasks *t = &b->tasks;
    uint32_t k = 0;

    for (uint32_t i = t->first; i != UINT32_MAX && k < first + n; i = t->next[i], k++)
        if (k >= first)
            describe_task(b, i, &out[k - first]);
    return t->s.live;
}

bool inspect_task(const struct board *b, uint32_t serial, struct inspect_task *out)
{
    const struct tasks *t = &b->tasks;

    for (uint32_t i = t->first; i != UINT32_MAX && t->serial[i] <= serial; i = t->next[i])
        if (t->serial[i] == serial) {
            describe_task(b, i, out);
            return true;
        }
    return false;
}

/* ---- the entity under a point ---- */

/* How well a body matches the point searched for, Q15.16 px: distance from the hitbox (gap), size of the hitbox,
 * distance from its centre (far). Fits are compared field by field, in this order; the smallest wins. */
struct fit {
    fx gap, size, far;
};

struct search {
    fx x, y, within;
    struct fit best;
    struct inspect_body found;
};

static bool better(const struct fit *a, const struct fit *b)
{
    if (a->gap != b->gap)
        return a->gap < b->gap;
    if (a->size != b->size)
        return a->size < b->size;
    return a->far < b->far;
}

static void consider(void *context, const struct inspect_body *body)
{
    struct search *s = context;
    bool bar = body->shape == INSPECT_CAPSULE, box = body->shape == INSPECT_BOX || body->shape == INSPECT_CIRCLES;
    fx w = bar ? body->a + fx_abs(body->b) : body->a;
    fx h = bar ? body->a + fx_abs(body->c) : box ? body->b : body->a;
    int64_t dx = int64_abs((int64_t)body->x - s->x), dy = int64_abs((int64_t)body->y - s->y);

    if (dx > (int64_t)w + s->within || dy > (int64_t)h + s->within)
        return;
    fx far = fx_hypot((fx)dx, (fx)dy), gap = far - w;
    if (box || bar)
        gap = fx_hypot(fx_max((fx)dx - w, 0), fx_max((fx)dy - h, 0));
    struct fit fit = { fx_max(gap, 0), fx_max(w, h), far };
    if (fit.gap > s->within || (s->found.kind != INSPECT_NOTHING && !better(&fit, &s->best)))
        return;
    s->best = fit;
    s->found = *body;
}

static void describe_motion(const struct board *b, const struct bullets *s, uint32_t i, struct inspect_thing *out)
{
    out->moves = s->motion[i] != 0;
    if (!out->moves)
        return;
    out->program = s->motion[i] - 1u;
    out->motion = board_name(b, N_MOTION, (int)out->program);
    out->step = s->pc[i] + 1u;
    out->steps = b->motions.length[out->program];
    if (s->step_flags[i] & STEP_BEGUN)
        out->left = s->step_end[i] - b->core.clock;
}

static void describe_flying(const struct board *b, struct inspect_thing *out)
{
    bool bullet = out->body.kind == INSPECT_BULLET;
    const struct bullets *s = bullet ? &b->bullets : &b->shots;
    const struct bullet_kinds *k = bullet ? &b->bullet_kinds : &b->shot_kinds;
    uint32_t i = out->body.slot;

    out->name = board_name(b, bullet ? N_BULLET : N_SHOT, bullets_kind(s, k, i));
    out->tag = s->tag[i] ? board_name(b, N_TAG, s->tag[i]) : NULL;
    out->age = bullets_age(s, i, b->core.clock);
    out->speed = s->speed[i];
    out->dir = trig_to_degrees(s->dir[i]);
    out->by = s->owner_task[i];
    out->player = s->player[i];
    describe_motion(b, s, i, out);
}

static void describe_laser(const struct board *b, struct inspect_thing *out)
{
    const struct bullets *s = &b->laser_heads;
    uint32_t i = out->body.slot;

    out->name = board_name(b, N_LASER, s->kind[i]);
    out->tag = s->tag[i] ? board_name(b, N_TAG, s->tag[i]) : NULL;
    out->age = lasers_age(b, i);
    out->speed = s->speed[i];
    out->dir = trig_to_degrees(s->dir[i]);
    out->by = s->owner_task[i];
    out->player = s->player[i];
    describe_motion(b, s, i, out);
}

static void describe_enemy(const struct board *b, struct inspect_thing *out)
{
    const struct enemies *e = &b->enemies;
    uint32_t i = out->body.slot;

    out->name = board_name(b, N_ENEMY, e->kind[i]);
    out->tag = e->tag[i] ? board_name(b, N_TAG, e->tag[i]) : NULL;
    out->age = b->core.clock - e->born[i];
    out->by = e->owner_task[i];
    out->hp = e->hp[i];
    out->safe = e->safe[i];
}

static void describe_player(const struct board *b, struct inspect_thing *out)
{
    const struct player *p = &b->player;
    uint32_t i = out->body.slot;

    out->name = board_name(b, N_PLAYER, p->kind[i]);
    out->lives = p->lives[i];
    out->safe = p->safe[i] > INT32_MAX ? -1 : (int32_t)p->safe[i];
}

bool inspect_at(const struct board *b, int x, int y, int within, struct inspect_thing *out)
{
    struct search s = { .x = x * 65536 + 32768, .y = y * 65536 + 32768, .within = within * 65536 };

    *out = (struct inspect_thing){ 0 };
    inspect_bodies(b, consider, &s);
    out->body = s.found;
    out->x = to_screen(s.found.x, -b->cart.m.field_x);
    out->y = to_screen(s.found.y, -b->cart.m.field_y);
    if (s.found.kind == INSPECT_ENEMY)
        describe_enemy(b, out);
    else if (s.found.kind == INSPECT_PLAYER)
        describe_player(b, out);
    else if (s.found.kind == INSPECT_LASER)
        describe_laser(b, out);
    else if (s.found.kind != INSPECT_NOTHING)
        describe_flying(b, out);
    return s.found.kind != INSPECT_NOTHING;
}
