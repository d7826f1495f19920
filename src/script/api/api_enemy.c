/*
 * api_enemy.c - the Lua table enemy.
 */
#include "../../base/trig.h"
#include "../events_run.h"
#include "api_enemy.h"

enum {
    D_NAME,
    D_SPRITE,
    D_HIT,
    D_DROPS = 8,
    D_PICTURES = 15,
    D_RATE = 17,
    D_PARTS,
    D_TURNS = 20,
    D_SCALE,
    D_SCALE_HIT
};

static const struct api_param def_params[] = {
    REQUIRED("name", A_STR, "name of the kind, used as `kind = NAME`; must be new"),
    REQUIRED("sprite", A_SPRITE, "sprite to draw", STORED(enemy_kinds.sprite)),
    PARAM("hit", A_HIT_SHAPE, REQ, HIT_ENEMIES, 0, NULL, NULL,
          "hitbox, relative to the thing's position; \"none\" never hits"),
    PARAM("hp", A_INT, OPT, 1, INT32_MAX, NULL, "1", "damage it takes before it dies", STORED(enemy_kinds.hp)),
    PARAM("score", A_INT, OPT, 0, 1e12, "points", "0", "points for the player who kills it", STORED(enemy_kinds.score)),
    BANK(OPT, "0", "number added to the palette bank of its sprite", BITS_OF(enemy_kinds.bank, ENEMY_BANK)),
    DEFAULT("touch", A_BOOL, "true", "whether it hits players who touch it; if false, players can fly through it",
            BITS_OF(enemy_kinds.flags, ENEMY_TOUCH)),
    OPTIONAL("spark", A_SPARK_KIND, "kind of the twelve sparks it leaves when it dies; nil leaves none",
             STORED(enemy_kinds.spark)),
    [D_DROPS] = OPTIONAL("drops", A_TABLE, "items dropped when it dies, { NAME = count }"),
    OPTIONAL("run", A_FUNC, "run(e): task that starts when the enemy spawns and ends with the enemy", PROPERTY("run")),
    OPTIONAL(
        "on_hit", A_FUNC,
        "on_hit(e, p, damage): called when a shot or a laser of player p hits the enemy but doesn't kill it; p may "
        "be nil",
        PROPERTY("on_hit")),
    OPTIONAL("on_death", A_FUNC,
             "on_death(e, p): called when it dies, with the player who gets its score; p may be nil",
             PROPERTY("on_death")),
    DEFAULT(
        "swept", A_BOOL, "true",
        "check the entire path flown in each frame for players; if false, check only the position at the end of the "
        "frame",
        BITS_OF(enemy_kinds.flags, ENEMY_SWEPT)),
    BLEND_PARAM(enemy_kinds.flags, ENEMY_BLEND),
    DEFAULT("blocks", A_BOOL, "false", "whether it removes bullets that touch it",
            BITS_OF(enemy_kinds.flags, ENEMY_BLOCKS_BULLETS)),
    [D_PICTURES] = OPTIONAL(
        "pictures", A_TABLE,
        "up to 7 more sprites, { NAME = sprite }, which `picture` selects by name; `hurt` is shown while the enemy "
        "blinks, `left` and `right` while it moves left or right"),
    PARAM("blink", A_INT, OPT, 0, 15, "frames", "0", "frames it blinks after a hit; at 0 it never blinks",
          BITS_OF(enemy_kinds.bank, ENEMY_BLINK)),
    [D_RATE] = PARAM("rate", A_FX, OPT, 0, MAX_RATE, NULL, NULL,
                     "damage multiplier; at 0 it takes no damage; defaults to 1; needs `board = { bodies = true }`"),
    OPTIONAL("parts", A_TABLE, "list of 1 to 64 enemies attached to it; needs `board = { bodies = true }`"),
    DEFAULT("blink_soft", A_BOOL, "false", "blink only along the outline of the sprite",
            BITS_OF(enemy_kinds.flags, ENEMY_RIM_BLINK)),
    [D_TURNS] = DEFAULT("turns", A_BOOL, "false",
                        "rotate the sprite to the direction in which the enemy moves; the sprite needs `rotations` in "
                        "rom.lua; needs `board = { transforms = true }`",
                        BITS_OF(enemy_kinds.flags, ENEMY_TURNS)),
    SCALE(OPT, "1", "factor on the size of its sprite; needs `board = { transforms = true }`",
          STORED(enemy_kinds.scale)),
    DEFAULT("scale_hit", A_BOOL, "false",
            "apply each enemy's `scale` to its hitbox, too; needs `board = { transforms = true }`"),
    ALPHA(OPT, "8", "opacity of its sprite; needs `board = { transforms = true }`", STORED(enemy_kinds.alpha)),
};

static const char *const first_picture_names[] = { "hurt", NULL }, *const first_picture_names_sided[] = {
    "hurt", "left", "right", NULL
};

/* Returns whether the table of pictures has one for a side. */
static bool has_sides(lua_State *L, const struct api_value *pictures)
{
    if (!pictures->given)
        return false;
    const int top = lua_gettop(L);
    const bool found =
        lua_getfield(L, pictures->at, "left") != LUA_TNIL || lua_getfield(L, pictures->at, "right") != LUA_TNIL;
    lua_settop(L, top);
    return found;
}

static void define_body(lua_State *L, struct enemy_kinds *k, int32_t i, const struct api_value *v)
{
    if (v[D_RATE].given)
        api_check_bodies(L, "enemy.def", "rate");
    if (k->rate)
        k->rate[i] = v[D_RATE].given ? v[D_RATE].f : ENEMY_RATE_ONE;
    if (v[D_PARTS].given)
        api_body_define(L, i, v[D_PARTS].at);
}

static int enemy_def(lua_State *L, struct board *b, struct api_value *v)
{
    struct enemy_kinds *k = &b->enemy_kinds;
    struct api_shape shape = api_read_hit_shape(L, "enemy.def", v[D_HIT].at, HIT_ENEMIES);
    struct api_pictures pictures;

    api_check_transforms(L, v, D_TURNS, 4);
    if (v[D_TURNS].i)
        api_check_rotations(L, "enemy.def", "turns", &v[D_SPRITE]);
    if (v[D_SCALE_HIT].i && shape.shape != SHAPE_NONE) {
        struct api_shape largest = shape;
        api_scale_hit_shape(L, "enemy.def", &largest, SCALE_MAX);
        shape.shape |= SHAPE_SCALED;
    }
    const bool sides = has_sides(L, &v[D_PICTURES]);
    api_pictures_read(L, "enemy.def", &v[D_PICTURES], (uint16_t)v[D_SPRITE].i,
                      sides ? first_picture_names_sided : first_picture_names, ENEMY_MAX_PICTURES, &pictures);
    vm_reserve(L, &k->s, MAX_KIND_ROWS);
    const struct shape_columns columns = { k->shape, k->a, k->b, k->x, k->y };
    api_pictures_append_rows(L, "enemy.def", &k->s, k->sprite, &pictures);
    int32_t i = api_declare_kind(L, "enemy.def", &k->s, &columns, &shape);
    api_names_declare(L, N_ENEMY, "enemy.def", lua_tostring(L, v[D_NAME].at), i);
    api_store_arguments(L, b, i, v);
    if (pictures.n)
        k->flags[i] |= ENEMY_HURT_PICTURE;
    if (sides)
        k->flags[i - 1] = ENEMY_SIDES;
    api_pictures_store_names(L, N_ENEMY, i, &pictures);
    if (v[D_DROPS].given) {
        api_push_folded_drops(L, "enemy.def", v[D_DROPS].at);
        events_set_property(L, (uint16_t)i, "drops");
    }
    define_body(L, k, i, v);
    return 0;
}

enum {
    S_KIND,
    S_POSITION,
    S_PATH = S_POSITION + POSITION_PARAM_COUNT,
    S_MIRROR,
    S_HP,
    S_BANK,
    S_TAG,
    S_RUN,
    S_ON_DEATH,
    S_STAY,
    S_DROPS,
    S_FOLLOW,
    S_SHARE,
    S_RATE,
    S_DIR,
    S_SCALE,
    S_ALPHA,
    S_FIRST_VALUE
};

static const struct api_param spawn_params[] = {
    REQUIRED("kind", A_ENEMY_KIND, "declared kind to spawn"),
    POSITION_PARAMS,
    OPTIONAL("path", A_ROUTE,
             "route to fly; the enemy is removed at the end of the route; use it instead of `x` and `y`, or `from`"),
    DEFAULT("mirror", A_BOOL, "false", "mirror the path left to right"),
    PARAM("hp", A_INT, OPT, 1, INT32_MAX, NULL, NULL, "hit points; overrides its kind's"),
    BANK(OPT, NULL, "number added to the palette bank of its sprite; overrides its kind's"),
    LABEL("tag", OPT, "name of a group to put it in"),
    OPTIONAL("run", A_FUNC, "run(e): task that ends with the enemy; overrides its kind's"),
    OPTIONAL(
        "on_death", A_FUNC,
        "on_death(e, p): called when it dies, with the player who gets its score; p may be nil; overrides its kind's"),
    DEFAULT("stay", A_BOOL, "false", "keep the enemy when the boss phase that spawned it ends"),
    OPTIONAL("drops", A_TABLE, "items dropped when it dies, { NAME = count }; overrides its kind's"),
    THING("follow", OPT, 1 << H_ENEMY,
          "enemy to attach to as a part, at a distance of `dx` and `dy`; use it instead of a position; needs `board = "
          "{ bodies = true }`"),
    PARAM("share", A_FX, OPT, 0, 1, NULL, NULL,
          "fraction of the damage to the part that is also dealt to the body; defaults to 0; needs `follow`"),
    PARAM("rate", A_FX, OPT, 0, MAX_RATE, NULL, NULL,
          "damage multiplier; overrides its kind's; needs `board = { bodies = true }`"),
    DEFAULT("dir", A_DIR, "0", "direction to which its sprite is turned; needs `board = { transforms = true }`"),
    SCALE(OPT, NULL, "factor on the size of its sprite; overrides its kind's; needs `board = { transforms = true }`"),
    ALPHA(OPT, NULL, "opacity of its sprite; overrides its kind's; needs `board = { transforms = true }`"),
};

/* Starts a task owned by enemy h. Pops n values and the function below them; the function receives h, then the
 * values. */
static void start_task(lua_State *L, struct board *b, int64_t h, int n)
{
    lua_pushinteger(L, h);
    lua_insert(L, -n - 1);
    tasks_start(b, L, h, n + 1);
}

/* In a game without the module path, no value can be a route, so `message` is raised. */
void api_push_path_module(lua_State *L, const char *entry, int at, const char *message)
{
    lua_pushglobaltable(L);
    lua_pushliteral(L, "path");
    lua_rawget(L, -2);
    lua_remove(L, -2);
    if (!lua_istable(L, -1))
        api_error(L, entry, "%s", message);
    lua_getfield(L, -1, "known");
    lua_pushvalue(L, at);
    lua_call(L, 1, 1);
    if (!lua_toboolean(L, -1))
        api_error(L, entry, "%s", message);
    lua_pop(L, 1);
}

/* Stores the start position of an enemy's route. path.lua implements routes: path.place returns the position,
 * path.travel follows the route and removes the enemy. */
static void get_path_start(lua_State *L, const struct api_value *v, fx *x, fx *y)
{
    double px, py;

    api_push_path_module(L, "enemy.spawn", v[S_PATH].at, "path: expected a route (from path.def)");
    lua_getfield(L, -1, "place");
    lua_rawgeti(L, v[S_PATH].at, 1);
    lua_pushboolean(L, (int)v[S_MIRROR].i);
    lua_pushnumber(L, v[S_POSITION + POSITION_DX].n);
    lua_pushnumber(L, v[S_POSITION + POSITION_DY].n);
    lua_call(L, 4, 2);
    px = lua_tonumber(L, -2);
    py = lua_tonumber(L, -1);
    if (!fx_from_double(px, x) || !fx_from_double(py, y))
        api_error(L, "enemy.spawn", "path: the route starts outside the world");
    lua_pop(L, 3);
}

static void start_path_task(lua_State *L, struct board *b, int64_t h, const struct api_value *v)
{
    lua_getglobal(L, "path");
    lua_getfield(L, -1, "travel");
    lua_remove(L, -2);
    lua_pushvalue(L, v[S_PATH].at);
    lua_pushboolean(L, (int)v[S_MIRROR].i);
    lua_pushnumber(L, v[S_POSITION + POSITION_DX].n);
    lua_pushnumber(L, v[S_POSITION + POSITION_DY].n);
    start_task(L, b, h, 4);
}

/* Sets the drops of enemy i. Does nothing in a game without items, unless drops are given (an error). */
static void set_drops(lua_State *L, struct board *b, uint32_t i, const struct api_value *drops)
{
    if (drops && drops->given)
        api_push_folded_drops(L, "enemy.spawn", drops->at);
    else if (b->items.s.cap)
        lua_pushnil(L);
    else
        return;
    events_set_enemy_property(L, i, ENEMY_DROPS);
}

int32_t api_enemy_spawn(lua_State *L, struct board *b, uint16_t kind, fx x, fx y, int64_t owner)
{
    int32_t i = enemies_spawn(&b->enemies, &b->enemy_kinds, kind, x, y, b->core.clock);

    if (i == NO_SLOT) {
        board_report_full(b, &b->enemies.s);
        return i;
    }
    b->enemies.owner_task[i] = tasks_current_serial(b);
    b->enemies.owner[i] = owner;
    lua_pushnil(L);
    events_set_enemy_property(L, (uint32_t)i, ENEMY_ON_DEATH);
    set_drops(L, b, (uint32_t)i, NULL);
    return i;
}

void api_enemy_start_task(lua_State *L, struct board *b, uint32_t i)
{
    if (events_push_function(L, b->enemies.kind[i], "run"))
        start_task(L, b, board_handle(b, H_ENEMY, (int32_t)i), 0);
}

/* Reads the spawn position. Returns false if the thing `from` or `follow` is dead. */
static bool read_spawn_position(lua_State *L, struct board *b, const struct api_value *v, fx *x, fx *y)
{
    const struct api_value *at = v + S_POSITION;
    const bool has_position = at[POSITION_X].given || at[POSITION_Y].given || at[POSITION_FROM].given;

    if (v[S_FOLLOW].given || v[S_SHARE].given || v[S_RATE].given)
        api_check_bodies(L, "enemy.spawn", v[S_FOLLOW].given ? "follow" : v[S_SHARE].given ? "share" : "rate");
    if (v[S_FOLLOW].given) {
        if (has_position || v[S_PATH].given)
            api_error(L, "enemy.spawn", "`follow` cannot be combined with a position or a path");
        *x = *y = 0;
        return board_is_alive(b, v[S_FOLLOW].i);
    }
    if (v[S_SHARE].given)
        api_error(L, "enemy.spawn", "share: requires `follow`");
    if (!v[S_PATH].given)
        return api_read_position(L, b, "enemy.spawn", at, x, y);
    if (has_position)
        api_error(L, "enemy.spawn", "expected a position or a path, got both");
    get_path_start(L, v, x, y);
    return true;
}

/* Applies the arguments of enemy.spawn to a new enemy. */
static void apply_spawn_arguments(lua_State *L, struct board *b, uint32_t i, const struct api_value *v)
{
    struct enemies *e = &b->enemies;

    if (v[S_HP].given)
        e->hp[i] = (int32_t)v[S_HP].i;
    if (v[S_BANK].given)
        e->bank[i] = (uint8_t)v[S_BANK].i;
    if (v[S_TAG].given)
        e->tag[i] = api_intern_tag(L, "enemy.spawn", v[S_TAG].at);
    if (v[S_RATE].given)
        e->rate[i] = v[S_RATE].f;
    if (v[S_DIR].given)
        e->dir[i] = v[S_DIR].a;
    if (v[S_SCALE].given)
        e->scale[i] = (uint8_t)v[S_SCALE].i;
    if (v[S_ALPHA].given)
        e->alpha[i] = (uint8_t)v[S_ALPHA].i;
    if (v[S_FOLLOW].given)
        enemies_attach(e, i, handle_slot(v[S_FOLLOW].i), v[S_POSITION + POSITION_DX].f, v[S_POSITION + POSITION_DY].f,
                       v[S_SHARE].f);
    api_set_values(b, N_ENEMY_VALUE, i, v + S_FIRST_VALUE);
    lua_pushvalue(L, v[S_ON_DEATH].at);
    events_set_enemy_property(L, i, ENEMY_ON_DEATH);
    if (v[S_DROPS].given)
        set_drops(L, b, i, &v[S_DROPS]);
}

static void start_tasks(lua_State *L, struct board *b, uint32_t i, const struct api_value *v)
{
    const int64_t h = board_handle(b, H_ENEMY, (int32_t)i);

    if (v[S_RUN].given) {
        lua_pushvalue(L, v[S_RUN].at);
        start_task(L, b, h, 0);
    } else
        api_enemy_start_task(L, b, i);
    if (v[S_PATH].given)
        start_path_task(L, b, h, v);
}

static int enemy_spawn(lua_State *L, struct board *b, struct api_value *v)
{
    const uint16_t kind = (uint16_t)v[S_KIND].i;
    int32_t i = NO_SLOT;
    int64_t owner;
    fx x, y;

    api_check_transforms(L, v, S_DIR, 3);
    if (read_spawn_position(L, b, v, &x, &y) && tasks_get_spawn_owner(b, v[S_STAY].i, &owner)) {
        if (v[S_FOLLOW].given)
            api_body_check_depth(L, b, kind, v[S_FOLLOW].i);
        i = api_enemy_spawn(L, b, kind, x, y, owner);
    }
    const int64_t h = board_handle(b, H_ENEMY, i);
    if (i != NO_SLOT) {
        apply_spawn_arguments(L, b, (uint32_t)i, v);
        if (b->enemies.rate)
            api_body_spawn_parts(L, b, (uint32_t)i);
        start_tasks(L, b, (uint32_t)i, v);
        if (b->enemies.rate && b->enemies.n_parts[i])
            api_body_start_part_tasks(L, b, (uint32_t)i);
    }
    lua_pushinteger(L, h);
    return 1;
}

/* ---- properties ---- */

enum { P_X, P_Y, P_HP, P_PICTURE = 9, P_BODY = 15, PROPS = P_BODY + BODY_FOLLOW + 1 };

/* The last property exists only for groups. */
static const struct api_param props[PROPS + 1] = {
    COORDINATE("x", A_FX, REQ, "horizontal position in the field; a write teleports the enemy and ends its move",
               STORED(enemies.x), SETTER),
    COORDINATE("y", A_FX, REQ, "vertical position in the field; a write teleports the enemy and ends its move",
               STORED(enemies.y), SETTER),
    PARAM("hp", A_INT, REQ, 0, INT32_MAX, NULL, NULL, "hit points left, rounded up; writing 0 doesn't kill the enemy",
          STORED(enemies.hp), SETTER),
    BANK(REQ, NULL, "number added to the palette bank of its sprite", BITS_OF(enemies.bank, ENEMY_BANK), WRITABLE),
    LABEL("tag", OPT, "tag of its group, or nil", STORED(enemies.tag), WRITABLE),
    PARAM("safe", A_COUNT, REQ, 0, INT32_MAX, "frames", NULL,
          "frames for which it takes no damage, or forever; shots still hit it", STORED(enemies.safe_left), WRITABLE),
    REQUIRED("kind", A_ENEMY_KIND, "name of its kind", STORED(enemies.kind)),
    REQUIRED("age", A_INT, "frames since it spawned, not counting frozen frames", AGE_OF(enemies.born)),
    PARAM("frozen", A_COUNT, REQ, 0, INT32_MAX, "frames", NULL, "frames it stays frozen, or forever; 0 unfreezes it",
          STORED(enemies.frozen_left), WRITABLE),
    [P_PICTURE] = OPTIONAL("picture", A_STR,
                           "picture to show, a name in `pictures` of its kind; nil shows the kind's sprite", SETTER),
    REQUIRED("flip_x", A_BOOL, "true if mirrored left to right", BITS_OF(enemies.flags, ENEMY_FLIP), WRITABLE),
    REQUIRED("hidden", A_BOOL, "true if not drawn; it still moves, hits and is hit",
             BITS_OF(enemies.flags, ENEMY_HIDDEN), WRITABLE),
    REQUIRED("dir", A_DIR, "direction to which its sprite is turned, 0 to 360", STORED(enemies.dir), WRITABLE),
    SCALE(REQ, NULL, "factor on the size of its sprite", STORED(enemies.scale), WRITABLE),
    ALPHA(REQ, NULL, "opacity of its sprite", STORED(enemies.alpha), WRITABLE),
    [P_BODY] = PARAM("rate", A_FX, REQ, 0, MAX_RATE, NULL, NULL,
                     "damage multiplier; at 0 it takes no damage; needs `board = { bodies = true }`",
                     STORED(enemies.rate), WRITABLE),
    COORDINATE("dx", A_FX, REQ, "for a part, distance to the right of its body; a write ends the part's move", SETTER),
    COORDINATE("dy", A_FX, REQ, "for a part, distance below its body; a write ends the part's move", SETTER),
    PARAM("share", A_FX, REQ, 0, 1, NULL, NULL,
          "for a part, fraction of the damage it takes that is also dealt to its body", SETTER),
    THING("follow", OPT, 1 << H_ENEMY, "body it is attached to, or nil"),
    COUNT_PROP("enemies"),
};

static void get_enemy(lua_State *L, struct board *b, uint32_t i, int p)
{
    const struct enemies *e = &b->enemies;

    if (p == P_PICTURE)
        api_picture_push(L, N_ENEMY, e->kind[i], e->flags[i] / ENEMY_PICTURE_ONE);
    else
        api_body_get(L, b, i, (enum api_body_prop)(p - P_BODY));
}

static void set_enemy(lua_State *L, struct board *b, uint32_t i, int p, const struct api_value *v)
{
    struct enemies *e = &b->enemies;

    switch (p) {
    case P_X:
        enemies_set_position(e, i, v->f, e->y[i]);
        break;
    case P_Y:
        enemies_set_position(e, i, e->x[i], v->f);
        break;
    case P_HP:
        e->hp[i] = (int32_t)v->i;
        if (e->hp_deficit)
            e->hp_deficit[i] = 0;
        break;
    case P_PICTURE:
        e->flags[i] = (uint8_t)((unsigned)(e->flags[i] & ~ENEMY_PICTURE) |
                                api_picture_find(L, N_ENEMY, e->kind[i], "enemy", v) * ENEMY_PICTURE_ONE);
        break;
    default:
        api_body_set(L, b, i, (enum api_body_prop)(p - P_BODY), v->f);
    }
}

/* Returns whether a read or write of property p of a group includes enemy i: it must be alive, and a part if p is a
 * property of parts. */
static bool has_member(const struct board *b, uint32_t i, int p)
{
    const bool parts_only = p > P_BODY + BODY_RATE && p < PROPS;

    return !(b->enemies.flags[i] & ENEMY_NOT_ALIVE) && (!parts_only || b->enemies.body[i]);
}

const struct api_thing api_enemy_thing = { "enemy", props, PROPS, .get = get_enemy, .set = set_enemy, POOL(enemies) };
const struct api_thing api_enemies_thing = {
    "enemies", props, PROPS + 1, POOL(enemies), .member = H_ENEMY, .write_work = 1, .has_member = has_member
};

/* ---- verbs ---- */

enum {
    ARG_SELF,
    MOVE_X,
    MOVE_Y,
    MOVE_OVER,
    MOVE_EASE,
    MOVE_DX,
    MOVE_DY,
    SHIFT_X = 1,
    SHIFT_Y,
    HURT_HP = 1,
    HURT_PLAYER,
    KILL_PLAYER = 1
};

#define SELF_PARAM THING("self", REQ, 1 << H_ENEMY | 1 << H_ENEMIES, "the thing itself")
static const struct api_param move_params[] = {
    SELF_PARAM,
    COORDINATE("x", A_FX, OPT, "horizontal position to move to; give `x` and `y`, or `dx` and `dy`"),
    COORDINATE("y", A_FX, OPT, "vertical position to move to"),
    PARAM("over", A_INT, REQ, 1, 1e9, "frames", NULL, "duration of the move"),
    DEFAULT("ease", A_EASE, "linear",
            "how the speed changes on the way: `in` starts slowly, `out` ends slowly, `both` starts and ends slowly"),
    COORDINATE("dx", A_FX, OPT, "distance to the right; for a part, its new `dx`"),
    COORDINATE("dy", A_FX, OPT, "distance down; for a part, its new `dy`"),
};
static const struct api_param shift_params[] = { SELF_PARAM, SHIFT_DX_PARAM, SHIFT_DY_PARAM };
static const struct api_param hurt_params[] = {
    SELF_PARAM, PARAM("n", A_INT, REQ, 0, INT32_MAX, "hp", NULL, "damage to deal, before it is multiplied by `rate`"),
    OPTIONAL("p", A_PLAYER, "player who gets the score for a kill; defaults to the nearest player")
};
static const struct api_param kill_params[] = {
    SELF_PARAM, OPTIONAL("p", A_PLAYER, "player who gets its score; defaults to the nearest player")
};
static const struct api_param self_params[] = { SELF_PARAM };

const struct api_thing api_move_thing = { .name = "move" };

int api_start_movement(lua_State *L, struct board *b, struct api_value *v, api_function *start)
{
    const int64_t h = v[ARG_SELF].i;
    const uint32_t i = handle_slot(h);

    api_run_each(L, b, v, start);
    if (handle_kind(h) != H_ENEMY)
        return 0;
    lua_pushinteger(L, handle_make(H_MOVE, board_is_alive(b, h) ? b->enemies.move_serial[i] : 0, i));
    return 1;
}

static int move_one(lua_State *L, struct board *b, struct api_value *v)
{
    const uint32_t i = handle_slot(v[ARG_SELF].i), frames = (uint32_t)v[MOVE_OVER].i;

    (void)L;
    if (v[MOVE_X].given)
        enemies_move_to(&b->enemies, i, v[MOVE_X].f, v[MOVE_Y].f, frames, (enum ease)v[MOVE_EASE].i);
    else
        enemies_move_by(&b->enemies, i, v[MOVE_DX].f, v[MOVE_DY].f, frames, (enum ease)v[MOVE_EASE].i);
    return 0;
}

static int enemy_move(lua_State *L, struct board *b, struct api_value *v)
{
    const bool has_x = v[MOVE_X].given, has_y = v[MOVE_Y].given, has_dx = v[MOVE_DX].given, has_dy = v[MOVE_DY].given;

    if (has_x != has_y || has_dx != has_dy || has_x == has_dx)
        return api_error(L, api_current_binding(L)->entry->name, "expected either `x` and `y` or `dx` and `dy`");
    return api_start_movement(L, b, v, move_one);
}

static int enemy_shift(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L;
    enemies_shift(&b->enemies, handle_slot(v[ARG_SELF].i), v[SHIFT_X].f, v[SHIFT_Y].f);
    return 0;
}

/* Returns the player, 1 or 2, who is credited when a script damages or kills enemy i: `player` if given, otherwise the
 * nearest living player; 0: nobody. */
static uint32_t find_credited_player(const struct board *b, uint32_t i, const struct api_value *player)
{
    struct targets t = board_targets(b, false);

    return player->given ? (uint32_t)player->i
                         : (uint32_t)(targets_find_nearest(&t, b->enemies.x[i], b->enemies.y[i]) + 1);
}

static int enemy_hurt(lua_State *L, struct board *b, struct api_value *v)
{
    const uint32_t i = handle_slot(v[ARG_SELF].i);

    events_hurt_enemy(b, L, i, (int32_t)v[HURT_HP].i, find_credited_player(b, i, &v[HURT_PLAYER]));
    return 0;
}

static int enemy_kill(lua_State *L, struct board *b, struct api_value *v)
{
    const uint32_t i = handle_slot(v[ARG_SELF].i);

    events_kill_enemy(b, L, i, find_credited_player(b, i, &v[KILL_PLAYER]));
    return 0;
}

/* Also removes enemies that left the field in this frame but can still be read (board_is_readable), so that their
 * pending hits have no effect. */
static int enemy_remove(lua_State *L, struct board *b, struct api_value *v)
{
    int64_t h = v[ARG_SELF].i;
    struct enemies *e = &b->enemies;

    if (handle_kind(h) != H_ENEMIES) {
        if (board_is_readable(b, h) && !(e->flags[handle_slot(h)] & ENEMY_DYING))
            enemies_drop(e, handle_slot(h));
        return 0;
    }
    vm_charge(L, e->s.live);
    EACH_LIVE (i, &e->s)
        if (api_has_tag(e->tag, i, handle_slot(h)) && !(e->flags[i] & ENEMY_DYING))
            enemies_drop(e, i);
    return 0;
}

/* The verbs of a single enemy or of a group; the macro parameter `it` is how the help refers to the enemy or group. */
#define ENEMY_VERBS(thing, it, order, moves, waits)                                                                    \
    API_VERB(thing ":move", enemy_move, move_params, 1, moves,                                                         \
             "starts moving " it " to a position or by a distance, and returns immediately" waits),                    \
        API_EACH_VERB(thing ":shift", enemy_shift, shift_params, 3,                                                    \
                      "teleports " it " by a distance and shifts the rest of its move by the same distance"),          \
        API_EACH_VERB(thing ":hurt", enemy_hurt, hurt_params, 3, "damages " it " unless it is safe"),                  \
        API_EACH_VERB(thing ":kill", enemy_kill, kill_params, 2,                                                       \
                      "kills " it order "; score, sparks, drops and on_death work as usual"),                          \
        API_VERB(thing ":remove", enemy_remove, self_params, 1, NULL,                                                  \
                 "removes " it " without score, sparks, drops or on_death")

static const struct api_entry entries[] = {
    { "enemy.def", enemy_def, PARAMS(def_params), 1, API_CHANGES | API_LOAD_ONLY, NULL,
      HELP("declares a kind of enemy: its sprite, its hitbox and its rules") },
    { "enemy.spawn", enemy_spawn, PARAMS(spawn_params), 0, API_CHANGES | API_TAKES_VALUES, "enemy",
      HELP("spawns an enemy at a position, on a path or as a part of another enemy") },
    API_GROUPS("enemy"),
    { "enemy.count", api_push_count_of_kind, PARAMS(api_tag_params), 1, 0, "count",
      HELP("returns the number of live enemies with the given tag") },
    ENEMY_VERBS("enemy", "it", "", "move", API_MOVE_HELP),
    ENEMY_VERBS("enemies", "each enemy", " in slot order", NULL, ""),
};
const struct api_module api_enemy = { entries, sizeof entries / sizeof *entries };
