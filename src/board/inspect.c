/*
 * inspect.c - bodies, kinds, gauges, tasks, and the entity under a point; see inspect.h.
 */
#include "inspect.h"
#include "../../fb/blit.h"
#include <string.h>
#include "../base/int.h"
#include "../script/tasks.h"
#include "../script/vm.h"
#include "../machine/collision/hit.h"
#include "../machine/lasers_run.h"
#include "../machine/machine.h"
#include "../machine/window.h"

struct inspect_area inspect_field(const struct board *b)
{
    const struct window w = window_of(b);

    return (struct inspect_area){ .x = w.x,
                                  .y = w.y,
                                  .w = w.w,
                                  .h = w.h,
                                  .left = w.left,
                                  .top = w.top,
                                  .zoom = w.zoom,
                                  .field_w = b->cart.manifest.field_w,
                                  .field_h = b->cart.manifest.field_h };
}

void inspect_to_field(const struct board *b, int32_t *x, int32_t *y)
{
    const struct window w = window_of(b);

    *x = window_field_x(&w, *x);
    *y = window_field_y(&w, *y);
}

struct inspect_controls inspect_player_controls(const struct board *b, int player)
{
    const bool in_play = b->player.in_game[player] && b->core.frozen <= 0;
    const unsigned ignored_buttons = player_ignored_buttons(&b->player, (uint32_t)player);

    return (struct inspect_controls){ .can_steer = in_play && !(ignored_buttons & PAD_FOCUS),
                                      .can_fire = in_play && !(ignored_buttons & PAD_FIRE) };
}

struct inspect_pause inspect_pause(const struct board *b)
{
    const struct channel *c = &b->channel;
    struct inspect_pause out = { .is_listening = c->is_listening, .entry_count = c->entry_count };

    for (int p = 0; p < MAX_PLAYERS; p++)
        out.in_play[p] = b->player.in_game[p] != 0;
    for (int i = 0; i < out.entry_count; i++)
        out.entries[i] = (const char *)c->labels + i * PAUSE_LABEL_SIZE;
    return out;
}

/* ---- bodies, first in the field, then on the screen ---- */

static struct inspect_body body_at(enum inspect_kind kind, uint32_t slot, fx x, fx y)
{
    return (struct inspect_body){ .kind = kind, .slot = slot, .x = x, .y = y };
}

static const enum inspect_shape inspect_shapes[] = { [SHAPE_NONE] = INSPECT_NO_SHAPE,
                                                     [SHAPE_CIRCLE] = INSPECT_CIRCLE,
                                                     [SHAPE_BOX] = INSPECT_BOX,
                                                     [SHAPE_CAPSULE] = INSPECT_CAPSULE,
                                                     [SHAPE_CIRCLES] = INSPECT_CIRCLES };

static void set_circles(struct inspect_body *body, const struct body *circles, uint32_t n)
{
    body->shape = INSPECT_CIRCLES;
    body->n = (int32_t)n;
    for (uint32_t i = 0; i < n; i++) {
        body->circle[i].x = circles[i].x;
        body->circle[i].y = circles[i].y;
        body->circle[i].r = circles[i].a;
        body->a = fx_max(body->a, fx_abs(circles[i].x - body->x) + circles[i].a);
        body->b = fx_max(body->b, fx_abs(circles[i].y - body->y) + circles[i].a);
    }
}

/* Sets the body's shape from the n shapes that the collision tests use. Only SHAPE_CIRCLES uses more than the first. */
static void set_shape(struct inspect_body *body, uint8_t shape, const struct body *shapes, uint32_t n)
{
    if (shape == SHAPE_CIRCLES) {
        set_circles(body, shapes, n);
        return;
    }
    body->shape = inspect_shapes[shape];
    body->a = shape == SHAPE_NONE ? 0 : shapes->a;
    body->b = shape == SHAPE_BOX || shape == SHAPE_CAPSULE ? shapes->b : 0;
    body->c = shapes->c;
}

static bool can_be_grazed(const struct board *b, uint32_t i)
{
    if (!(b->bullet_kinds.flags[b->bullets.kind[i]] & KIND_GRAZE) || b->bullets.flags[i] & BULLET_DELAYED)
        return false;
    for (uint32_t p = 0; p < MAX_PLAYERS; p++)
        if (b->player.in_game[p] && !(b->bullets.flags[i] >> p & BULLET_GRAZED))
            return true;
    return false;
}

static struct inspect_body bullet_or_shot_body(const struct board *b, enum inspect_kind kind, uint32_t i)
{
    const struct bullets *s = kind == INSPECT_BULLET ? &b->bullets : &b->shots;
    const struct bullet_kinds *k = kind == INSPECT_BULLET ? &b->bullet_kinds : &b->shot_kinds;
    struct inspect_body body = body_at(kind, i, s->x[i], s->y[i]);

    struct body shapes[SHAPE_MAX_CIRCLES];
    uint8_t shape = s->flags[i] & BULLET_DELAYED ? SHAPE_NONE : k->shape[s->kind[i]];

    set_shape(&body, shape, shapes, hit_split_bullet(s, k, i, shapes));
    body.is_dimmed = kind == INSPECT_BULLET && !can_be_grazed(b, i);
    return body;
}

static struct inspect_body enemy_body(const struct board *b, uint32_t i)
{
    const struct enemies *e = &b->enemies;
    const struct enemy_kinds *k = &b->enemy_kinds;
    struct inspect_body body = body_at(INSPECT_ENEMY, i, e->x[i], e->y[i]);

    struct body shapes[SHAPE_MAX_CIRCLES];

    set_shape(&body, k->shape[e->kind[i]] & (uint8_t)~SHAPE_SCALED, shapes, hit_split_enemy(b, i, shapes));
    body.is_dimmed = !(k->flags[e->kind[i]] & ENEMY_TOUCH) || e->flags[i] & ENEMY_DYING;
    return body;
}

static struct inspect_body player_body(const struct board *b, uint32_t i)
{
    const struct player *p = &b->player;
    struct inspect_body body = body_at(INSPECT_PLAYER, i, p->x[i], p->y[i]);

    body.shape = INSPECT_CIRCLE;
    body.a = b->player_kinds.radius[p->kind[i]];
    body.graze = b->player_kinds.graze_radius[p->kind[i]];
    body.is_dimmed = p->safe_left[i] > 0 || b->start.practice.invincible;
    return body;
}

static bool laser_can_be_grazed(const struct board *b, uint32_t i)
{
    const uint16_t kind = b->laser_heads.kind[i];

    if (b->laser_kinds.flags[kind] & LASER_HITS_ENEMIES || !b->laser_kinds.graze_interval[kind])
        return false;
    for (uint32_t p = 0; p < MAX_PLAYERS; p++)
        if (b->player.in_game[p] && b->core.clock >= b->lasers.rehit_clock[i * MAX_PLAYERS + p])
            return true;
    return false;
}

/* Returns the body of segment k of laser i, with the reach used by the last frame's hit detection. */
static struct inspect_body laser_body(const struct board *b, uint32_t i, uint32_t k)
{
    const fx reach = hit_laser_reach(b, i, lasers_shown_age(b, i));
    const struct lasers_segment s = lasers_get_segment(b, i, k);
    const fx half_x = (fx)(((int64_t)s.to_x - s.x) / 2), half_y = (fx)(((int64_t)s.to_y - s.y) / 2);
    struct inspect_body body = body_at(INSPECT_LASER, i, s.x + half_x, s.y + half_y);

    if (reach >= 0) {
        body.shape = INSPECT_CAPSULE;
        body.a = reach;
        body.b = half_x;
        body.c = half_y;
    }
    body.is_dimmed = !laser_can_be_grazed(b, i);
    return body;
}

/* Multiplies a length by the zoom. */
static void zoom_length(const struct window *w, int32_t *length)
{
    *length = fx_sat((int64_t)*length * w->zoom);
}

static void move_to_screen(const struct window *w, struct inspect_body *body)
{
    body->x = window_screen_x(w, body->x);
    body->y = window_screen_y(w, body->y);
    zoom_length(w, &body->a);
    zoom_length(w, &body->b);
    zoom_length(w, &body->c);
    zoom_length(w, &body->graze);
    for (int i = 0; i < body->n; i++) {
        body->circle[i].x = window_screen_x(w, body->circle[i].x);
        body->circle[i].y = window_screen_y(w, body->circle[i].y);
        zoom_length(w, &body->circle[i].r);
    }
}

void inspect_bodies(const struct board *b, void (*visit)(void *context, const struct inspect_body *body), void *context)
{
    const struct window w = window_of(b);
    struct inspect_body body;

    EACH_LIVE (i, &b->enemies.s) {
        body = enemy_body(b, i);
        move_to_screen(&w, &body);
        visit(context, &body);
    }
    EACH_LIVE (i, &b->shots.s) {
        body = bullet_or_shot_body(b, INSPECT_SHOT, i);
        move_to_screen(&w, &body);
        visit(context, &body);
    }
    EACH_LIVE (i, &b->bullets.s) {
        body = bullet_or_shot_body(b, INSPECT_BULLET, i);
        move_to_screen(&w, &body);
        visit(context, &body);
    }
    EACH_LIVE (i, &b->lasers.s)
        for (uint32_t k = 0; k < lasers_segment_count(b, i); k++) {
            body = laser_body(b, i, k);
            move_to_screen(&w, &body);
            visit(context, &body);
        }
    for (uint32_t i = 0; i < MAX_PLAYERS; i++) {
        body = player_body(b, i);
        move_to_screen(&w, &body);
        if (b->player.in_game[i])
            visit(context, &body);
    }
}

bool inspect_ship(const struct board *b, int player, struct inspect_body *out)
{
    const struct player *p = &b->player;
    const struct window w = window_of(b);
    int dx, dy;

    if (!p->in_game[player] || p->flags[player] & PLAYER_HIDDEN)
        return false;
    screen_get_shake(&b->screen, b->core.clock, &dx, &dy);
    *out = player_body(b, (uint32_t)player);
    out->x += dx * FX_ONE;
    out->y += dy * FX_ONE;
    move_to_screen(&w, out);
    return true;
}

/* ---- kinds ---- */

static void measure_kind(const struct shape_columns *k, uint32_t i, struct inspect_kind_shape *out)
{
    const uint8_t shape = k->shape[i] & (uint8_t)~SHAPE_SCALED;
    fx a = k->a[i], w = a, h = shape == SHAPE_BOX ? k->b[i] : a;

    if (shape == SHAPE_CAPSULE) {
        w = a + k->b[i] + fx_abs(k->x[i]);
        h = a + fx_abs(k->y[i]);
    }
    *out = (struct inspect_kind_shape){ .shape = inspect_shapes[shape], .x0 = -w, .y0 = -h, .x1 = w, .y1 = h };
    out->r = a;
    if (shape == SHAPE_CAPSULE) {
        out->bar_x = k->b[i] + k->x[i];
        out->bar_y = k->y[i];
    }
    if (shape != SHAPE_CIRCLES)
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

/* Calls `visit` for every kind of ship; a ship's hitbox is a circle. */
static void visit_ship_kinds(const struct board *b, void (*visit)(void *context, const struct inspect_kind_shape *kind),
                             void *context)
{
    const struct player_kinds *k = &b->player_kinds;

    for (uint32_t i = 0; i < k->s.live; i++) {
        const char *name = board_name(b, N_PLAYER, (int)i);
        const fx r = k->radius[i];
        if (name)
            visit(context, &(struct inspect_kind_shape){ .entity = "player",
                                                         .name = name,
                                                         .shape = INSPECT_CIRCLE,
                                                         .r = r,
                                                         .x0 = -r,
                                                         .y0 = -r,
                                                         .x1 = r,
                                                         .y1 = r,
                                                         .scale = SCALE_ONE,
                                                         .sprite = cart_name(&b->cart, CART_SPRITES, k->sprite[i]) });
    }
}

/* Returns the name of the blend in a kind's flags if that is a ramp blend; otherwise NULL. */
static const char *ramp_name(const struct board *b, uint16_t flags)
{
    const int blend = (flags & KIND_BLEND) / KIND_BLEND_ONE;

    return blend && b->cart.main_tables.mix[blend - 1] != BLIT_TABLE ? cart_name(&b->cart, CART_BLENDS, blend - 1)
                                                                     : NULL;
}

void inspect_kinds(const struct board *b, void (*visit)(void *context, const struct inspect_kind_shape *kind),
                   void *context)
{
    const struct bullet_kinds *k = &b->bullet_kinds, *ks = &b->shot_kinds;
    const struct enemy_kinds *ke = &b->enemy_kinds;
    const struct {
        const char *entity;
        enum name_kind name_kind;
        struct shape_columns shapes;
        uint32_t n;
        const uint16_t *sprite;
        const uint8_t *bank;
        const uint16_t *flags; /* KIND_ flags; NULL: no flags */
        const uint8_t *scale;  /* NULL: not enabled */
    } types[] = {
        { "bullet", N_BULLET, { k->shape, k->a, k->b, k->x, k->y }, k->s.live, k->sprite, k->bank, k->flags, k->scale },
        { "shot",
          N_SHOT,
          { ks->shape, ks->a, ks->b, ks->x, ks->y },
          ks->s.live,
          ks->sprite,
          ks->bank,
          ks->flags,
          ks->scale },
        { "enemy",
          N_ENEMY,
          { ke->shape, ke->a, ke->b, ke->x, ke->y },
          ke->s.live,
          ke->sprite,
          ke->bank,
          NULL,
          ke->scale },
    };
    struct inspect_kind_shape kind;

    for (int type = 0; type < 3; type++)
        for (uint32_t i = 0; i < types[type].n; i++) {
            const char *name = board_name(b, types[type].name_kind, (int)i);
            if (!name || types[type].shapes.shape[i] == SHAPE_NONE) /* rows without a name: a cloud or other circles */
                continue;
            measure_kind(&types[type].shapes, i, &kind);
            kind.entity = types[type].entity;
            kind.name = name;
            kind.is_rotated = types[type].flags && types[type].flags[i] & KIND_TURNS;
            kind.sprite = cart_name(&b->cart, CART_SPRITES, types[type].sprite[i]);
            kind.scale =
                types[type].scale && !(types[type].shapes.shape[i] & SHAPE_SCALED) ? types[type].scale[i] : SCALE_ONE;
            kind.bank = types[type].bank[i] & 15;
            kind.ramp = types[type].flags ? ramp_name(b, types[type].flags[i]) : NULL;
            visit(context, &kind);
        }
    visit_ship_kinds(b, visit, context);
}

/* ---- gauges ---- */

int inspect_gauges(const struct board *b, struct inspect_gauge out[MAX_PARTS])
{
    const void *fixed[] = { &b->input, &b->player, &b->fix, &b->pal, &b->nvram };

    for (int i = 0; i < PART_COUNT; i++) {
        const struct slots *s = part_of(b, i);
        bool is_list = !s->live_bits;
        out[i] = (struct inspect_gauge){ machine_parts[i].chip->name,
                                         s->live,
                                         is_list ? s->live : s->top,
                                         is_list ? s->live : s->high_water,
                                         s->cap,
                                         s->refused,
                                         s->cap == 0 };
        for (size_t k = 0; k < sizeof fixed / sizeof *fixed; k++)
            out[i].is_fixed |= fixed[k] == (const void *)s;
    }
    return PART_COUNT;
}

void inspect_memory(const struct board *b, size_t *used, size_t *size)
{
    *used = heap_used(b->vm.heap);
    *size = (size_t)b->cart.manifest.lua_kib * 1024;
}

uint64_t inspect_random_draws(const struct board *b)
{
    return b->core.drawn;
}

void inspect_codes(const struct board *b, void (*visit)(void *context, uint32_t code), void *context)
{
    const struct lines *l = &b->lines;

    for (uint32_t i = 0; i < b->fix.cols * b->fix.rows; i++)
        if (fix_code(&b->fix, i))
            visit(context, fix_code(&b->fix, i));
    EACH_LIVE (i, &l->s)
        for (uint32_t k = 0; k < LINE_MAX_TEXT && !(l->flags[i] & LINE_HIDDEN) && l->code[i * LINE_MAX_TEXT + k]; k++)
            visit(context, l->code[i * LINE_MAX_TEXT + k]);
}

/* ---- tasks ---- */

/* Stores the line at which the thread of task i waits; "" if the task has not run yet. */
static void find_line(const struct board *b, uint32_t i, char location[INSPECT_LOCATION_SIZE])
{
    location[0] = 0;
    if (!b->tasks.thread[i] || !(b->tasks.flags[i] & TASK_BEGUN))
        return;
    vm_get_location(b->tasks.thread[i], location, INSPECT_LOCATION_SIZE);
    size_t n = strlen(location);
    if (n >= 2) /* remove the final ": " */
        location[n - 2] = 0;
}

static void find_owner(const struct board *b, int64_t owner, struct inspect_task *out)
{
    static const enum inspect_owner owners[HANDLE_KINDS] = {
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
                                  .waits_forever =
                                      t->wait[i] > LUA_MAXINTEGER / 2, /* a task that waits forever counts down too */
                                  .is_scope = t->flags[i] & TASK_SCOPE,
                                  .has_begun = t->flags[i] & TASK_BEGUN,
                                  .is_stopped = t->flags[i] & TASK_STOP || !tasks_is_owner_alive(b, t->owner[i]),
                                  .is_frozen = tasks_is_frozen(b, i) };
    find_owner(b, t->owner[i], out);
    find_line(b, i, out->location);
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
 * distance from its centre (distance). Fits are compared field by field, in this order; the smallest wins. */
struct fit {
    fx gap, size, distance;
};

struct search {
    fx x, y, radius;
    struct fit best;
    struct inspect_body found;
};

static bool is_better(const struct fit *a, const struct fit *b)
{
    if (a->gap != b->gap)
        return a->gap < b->gap;
    if (a->size != b->size)
        return a->size < b->size;
    return a->distance < b->distance;
}

static void update_best_fit(void *context, const struct inspect_body *body)
{
    struct search *s = context;
    bool is_capsule = body->shape == INSPECT_CAPSULE,
         is_box = body->shape == INSPECT_BOX || body->shape == INSPECT_CIRCLES;
    fx w = is_capsule ? body->a + fx_abs(body->b) : body->a;
    fx h = is_capsule ? body->a + fx_abs(body->c) : is_box ? body->b : body->a;
    int64_t dx = int64_abs((int64_t)body->x - s->x), dy = int64_abs((int64_t)body->y - s->y);

    if (dx > (int64_t)w + s->radius || dy > (int64_t)h + s->radius)
        return;
    fx distance = fx_hypot((fx)dx, (fx)dy), gap = distance - w;
    if (is_box || is_capsule)
        gap = fx_hypot(fx_max((fx)dx - w, 0), fx_max((fx)dy - h, 0));
    struct fit fit = { fx_max(gap, 0), fx_max(w, h), distance };
    if (fit.gap > s->radius || (s->found.kind != INSPECT_NOTHING && !is_better(&fit, &s->best)))
        return;
    s->best = fit;
    s->found = *body;
}

static void describe_motion(const struct board *b, const struct bullets *s, uint32_t i, struct inspect_entity *out)
{
    out->has_motion = s->motion[i] != 0;
    if (!out->has_motion)
        return;
    out->program = s->motion[i] - 1u;
    out->motion = board_name(b, N_MOTION, (int)out->program);
    out->step = s->pc[i] + 1u;
    out->step_count = b->motions.length[out->program];
    if (s->step_flags[i] & STEP_BEGUN)
        out->frames_left = s->step_end[i] - b->core.clock;
}

/* Describes a bullet, shot or laser. */
static void describe_flyer(const struct board *b, const struct bullets *s, enum name_kind names, uint16_t kind,
                           uint32_t age, struct inspect_entity *out)
{
    const uint32_t i = out->body.slot;

    out->name = board_name(b, names, kind);
    out->tag = s->tag[i] ? board_name(b, N_TAG, s->tag[i]) : NULL;
    out->age = age;
    out->speed = s->speed[i];
    out->dir = trig_to_degrees(s->dir[i]);
    out->owner_task = s->owner_task[i];
    out->player = s->player[i];
    describe_motion(b, s, i, out);
}

static void describe_enemy(const struct board *b, struct inspect_entity *out)
{
    const struct enemies *e = &b->enemies;
    uint32_t i = out->body.slot;

    out->name = board_name(b, N_ENEMY, e->kind[i]);
    out->tag = e->tag[i] ? board_name(b, N_TAG, e->tag[i]) : NULL;
    out->age = b->core.clock - e->born[i];
    out->owner_task = e->owner_task[i];
    out->hp = e->hp[i];
    out->safe_left = e->safe_left[i];
}

static void describe_player(const struct board *b, struct inspect_entity *out)
{
    const struct player *p = &b->player;
    uint32_t i = out->body.slot;

    out->name = board_name(b, N_PLAYER, p->kind[i]);
    out->lives = p->lives[i];
    out->safe_left = p->safe_left[i] > INT32_MAX ? -1 : (int32_t)p->safe_left[i];
}

bool inspect_entity_at(const struct board *b, int x, int y, int radius, struct inspect_entity *out)
{
    struct search s = { .x = x * 65536 + 32768, .y = y * 65536 + 32768, .radius = radius * 65536 };

    *out = (struct inspect_entity){ 0 };
    inspect_bodies(b, update_best_fit, &s);
    out->body = s.found;
    out->x = s.found.x;
    out->y = s.found.y;
    inspect_to_field(b, &out->x, &out->y);
    if (s.found.kind == INSPECT_ENEMY)
        describe_enemy(b, out);
    else if (s.found.kind == INSPECT_PLAYER)
        describe_player(b, out);
    else if (s.found.kind == INSPECT_LASER)
        describe_flyer(b, &b->laser_heads, N_LASER, b->laser_heads.kind[s.found.slot], lasers_age(b, s.found.slot),
                       out);
    else if (s.found.kind == INSPECT_BULLET)
        describe_flyer(b, &b->bullets, N_BULLET, bullets_kind(&b->bullets, &b->bullet_kinds, s.found.slot),
                       bullets_age(&b->bullets, s.found.slot, b->core.clock), out);
    else if (s.found.kind == INSPECT_SHOT)
        describe_flyer(b, &b->shots, N_SHOT, bullets_kind(&b->shots, &b->shot_kinds, s.found.slot),
                       bullets_age(&b->shots, s.found.slot, b->core.clock), out);
    return s.found.kind != INSPECT_NOTHING;
}
