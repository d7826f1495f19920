/*
 * api_player.c - the Lua tables player, pad and score.
 */
#include <string.h>
#include "../events_run.h"
#include "api_parts.h"

extern const struct api_thing api_player_thing;

enum { D_NAME, D_SPRITE, D_HIT, D_REGISTERS = 8, D_MAGNET = 10, D_LINE, D_FULL, D_PULL, D_PICTURES, D_BOMB };
enum { D_BOMB_FOCUS = D_BOMB + 1, D_OPTIONS = 18, D_NEEDS };

static const struct api_param def_params[] = {
    REQUIRED("name", A_STR, "name of the ship, used in `players` of boot.run; must be new"),
    REQUIRED("sprite", A_SPRITE, "sprite to draw", STORED(player_kinds.sprite)),
    PARAM("hit", A_HIT_SHAPE, REQ, HIT_PLAYERS, 0, NULL, NULL, "hitbox, a circle around its position"),
    LENGTH("graze", OPT, "16", "radius of the circle in which bullets graze it", STORED(player_kinds.graze_radius)),
    PARAM("speed", A_FX, OPT, 0, MAX_SPEED, "px/frame", "4", "speed of flight", STORED(player_kinds.speed)),
    PARAM("focus", A_FX, OPT, 0, MAX_SPEED, "px/frame", "2", "speed of flight while the focus button is held",
          STORED(player_kinds.focus_speed)),
    PARAM("lives", A_INT, OPT, 1, MAX_LIVES, NULL, "3", "lives at the start of a game, counting the one in play",
          STORED(player_kinds.lives)),
    PARAM("safe", A_INT, OPT, 0, 100000, "frames", "120",
          "frames at the start and after a death during which nothing can hit the ship",
          STORED(player_kinds.safe_frames)),
    [D_REGISTERS] = OPTIONAL(
        "registers", A_TABLE,
        "up to 16 whole numbers that belong to the ship, { NAME = start } or { NAME = { .. } }; read and write them "
        "as p.NAME"),
    OPTIONAL("run", A_FUNC, "run(p): task that runs from when the ship joins the game until the player is out",
             PROPERTY("ship's run")),
    [D_MAGNET] =
        LENGTH("magnet", OPT, "24", "distance within which items fly to it", STORED(player_kinds.magnet_radius)),
    COORDINATE("collect_line", A_FX, OPT,
               "vertical position of a line; while the ship is above the line, it attracts all items; nil for no line"),
    LABEL("collect_full", OPT,
          "register of the ship or the run; while the register is at its max, all items fly to the ship"),
    PARAM("pull", A_FX, OPT, 0, MAX_SPEED, "px/frame", "6", "speed at which items fly to it",
          STORED(player_kinds.pull_speed)),
    [D_PICTURES] = OPTIONAL(
        "pictures", A_TABLE,
        "up to 15 more sprites, { NAME = sprite }, which `picture` selects by name; `left` and `right` are shown "
        "while the ship flies left or right"),
    LABEL("bomb", OPT, "bomb (bomb.def) that the bomb button starts"),
    LABEL("bomb_focus", OPT, "bomb used while focused; defaults to `bomb`"),
    PARAM("deathbomb", A_INT, OPT, 0, 600, "frames", "0",
          "frames after a hit during which a bomb can still save the ship; at 0, the ship dies immediately",
          STORED(player_kinds.deathbomb_frames)),
    [D_OPTIONS] =
        OPTIONAL("options", A_TABLE, "options (option.def) that fly with it and fire; needs `board = { options = n }`"),
    LABEL("needs", OPT, "unlock (unlock.def) that makes the ship available to players", PROPERTY("ship's needs")),
};

static const char *const first_picture_names[] = { "left", "right", NULL };

/* Returns the register that, when at its max, collects all items: the register's number + 1 in the ship,
 * PLAYER_RUN_REGISTER_OFFSET + its number in the run, or 0 for none. If both the ship and the run have a register of
 * that name, the ship's is used. */
static uint8_t find_full_register(lua_State *L, const struct board *b, int32_t kind,
                                  const struct api_value *collect_full)
{
    const char *name = collect_full->given ? lua_tostring(L, collect_full->at) : NULL;

    if (!name)
        return 0;
    const int run_register = api_find_ship_register(L, kind, name) < 0 ? api_find_run_register(L, name) : -1;
    const int i = run_register < 0 ? api_register_expect(L, "player.def", "collect_full", kind, name) : run_register;
    const uint32_t first_row = run_register < 0 ? b->player_kinds.first_register[kind] : b->registers.first_run_row;
    if (registers_rule(&b->registers, first_row + (uint32_t)i).max_value == REGISTER_NO_MAX)
        api_error(L, "player.def", "collect_full: register \"%s\" has no max (write registers = { %s = { max = n } })",
                  name, name);
    return (uint8_t)(run_register < 0 ? i + 1 : PLAYER_RUN_REGISTER_OFFSET + i);
}

/* Sets how the ship attracts items. */
static void define_item_attraction(lua_State *L, struct board *b, int32_t kind, const struct api_value *v)
{
    struct player_kinds *k = &b->player_kinds;
    const char *disabled_reason = api_disabled_reason(&b->cart.manifest, "item");

    for (int p = D_MAGNET; p <= D_PULL; p++)
        if (disabled_reason && v[p].given)
            api_error(L, "player.def", "%s: " API_DISABLED_FORMAT, def_params[p].name, disabled_reason);
    if (disabled_reason)
        return;
    k->collect_line[kind] = v[D_LINE].given ? v[D_LINE].f : FX_MIN;
    k->full_register[kind] = find_full_register(L, b, kind, &v[D_FULL]);
}

static int player_def(lua_State *L, struct board *b, struct api_value *v)
{
    struct player_kinds *k = &b->player_kinds;
    fx r = api_read_hit_shape(L, "player.def", v[D_HIT].at, HIT_PLAYERS).row[0].a;
    struct api_pictures pictures;

    api_pictures_read(L, "player.def", &v[D_PICTURES], (uint16_t)v[D_SPRITE].i, first_picture_names,
                      PLAYER_MAX_PICTURES, &pictures);
    vm_reserve(L, &k->s, MAX_KIND_ROWS);
    uint32_t row = k->s.live;
    api_pictures_append_rows(L, "player.def", &k->s, k->sprite, &pictures);
    for (; row < k->s.live; row++)
        k->radius[row] = PICTURE_ROW_RADIUS;
    const int32_t i = api_append_kind(L, "player.def", &k->s, N_PLAYER, v);
    k->radius[i] = r;
    k->first_register[i] = (uint16_t)b->registers.s.live;
    if (v[D_REGISTERS].given) {
        const int n = api_registers_define(L, "player.def", i, v[D_REGISTERS].at);
        k->n_registers[i] = (uint8_t)n;
    }
    define_item_attraction(L, b, i, v);
    k->bomb[i] = api_find_bomb(L, "bomb", i, &v[D_BOMB]);
    k->bomb_focus[i] = api_find_bomb(L, "bomb_focus", i, &v[D_BOMB_FOCUS]);
    api_options_read(L, b, i, &v[D_OPTIONS]);
    api_pictures_store_names(L, N_PLAYER, i, &pictures);
    if (v[D_NEEDS].given)
        api_record_location(L, "player.def", lua_tostring(L, v[D_NAME].at));
    return 0;
}

/* Implements sys.join; in C because it starts the kind's task. */
int api_player_enter(lua_State *L, struct board *b, uint32_t i, uint16_t kind)
{
    fx x, y;

    if (b->player.in_game[i])
        player_leave(&b->player, i);
    if (player_is_retired(&b->player, i))
        return vm_fault(L, FAULT_SCRIPT, "player %d has joined %d games; restart the board", (int)i + 1,
                        RETIRED_GENERATION - 1);
    b->player.in_game[i] = PLAYER_IN_GAME;
    for (uint32_t p = 0; p <= i; p++) { /* when player 2 joins, player 1 moves off centre too */
        events_get_start_position(b, p, &x, &y);
        if (b->player.in_game[p] && p != i)
            player_set_position(&b->player, p, x, y);
    }
    player_join(&b->player, &b->player_kinds, i, kind, x, y);
    registers_reset(&b->registers, b->player_kinds.first_register[kind], b->player_kinds.n_registers[kind], i);
    api_items_check(L, b);
    options_drop_from(&b->options, i, 0); /* left over from the previous game */
    b->core.extends_received[i] = 0;
    b->core.game_over = 0;
    input_drop_presses(&b->input, i, PRESS_GAME, PAD_ALL); /* earlier presses are not meant for the new ship */
    if (events_push_function(L, kind, "ship's run")) {
        lua_pushinteger(L, board_handle(b, H_PLAYER, (int32_t)i));
        tasks_start(b, L, board_handle(b, H_PLAYER, (int32_t)i), 1);
    }
    return 0;
}

enum { ARG_PLAYER = 0, ARG_X = 0, ARG_Y = 1, ARG_F = 0 };

static const struct api_param get_params[] = { REQUIRED("i", A_PLAYER, "player to return") };
static const struct api_param nearest_params[] = { COORDINATE("x", A_FX, REQ, "horizontal position to measure from"),
                                                   COORDINATE("y", A_FX, REQ, "vertical position to measure from") };
static const struct api_param each_params[] = { REQUIRED("f", A_FUNC,
                                                         "f(player): called with each player; it cannot wait") };

static int player_get(lua_State *L, struct board *b, struct api_value *v)
{
    lua_pushinteger(L, board_handle(b, H_PLAYER, (int32_t)v[ARG_PLAYER].i - 1));
    return 1;
}

static int player_nearest(lua_State *L, struct board *b, struct api_value *v)
{
    struct targets t = board_targets(b, false);

    lua_pushinteger(L, board_handle(b, H_PLAYER, targets_find_nearest(&t, v[ARG_X].f, v[ARG_Y].f)));
    return 1;
}

static int player_each(lua_State *L, struct board *b, struct api_value *v)
{
    for (int32_t i = 0; i < MAX_PLAYERS; i++) {
        if (!b->player.in_game[i])
            continue;
        lua_pushvalue(L, v[ARG_F].at);
        lua_pushinteger(L, board_handle(b, H_PLAYER, i));
        lua_call(L, 1, 0);
    }
    return 0;
}

enum { P_X, P_Y, P_FOCUS = 4, P_PICTURE = 9, P_STATE = 12, P_SCALE, PROPS };

static const struct api_param props[PROPS] = {
    COORDINATE("x", A_FX, REQ, "horizontal position in the field; a write teleports it, without collisions on the way",
               STORED(player.x), SETTER),
    COORDINATE("y", A_FX, REQ, "vertical position in the field; a write teleports it, without collisions on the way",
               STORED(player.y), SETTER),
    PARAM("lives", A_INT, REQ, 0, MAX_LIVES, NULL, NULL,
          "lives left after the one in play; reads as -1 in on.death when the last life is lost", STORED(player.lives),
          WRITABLE),
    PARAM("safe", A_INT, REQ, 0, INT32_MAX, "frames", NULL, "frames for which nothing can hit it",
          STORED(player.safe_left), WRITABLE),
    [P_FOCUS] = OPTIONAL("focus", A_BOOL,
                         "true while it flies at its focus speed; a write of true or false forces it, until the task "
                         "that wrote it ends, and nil leaves it to the button again",
                         BITS_OF(player.flags, PLAYER_FOCUS), SETTER),
    REQUIRED("grazes", A_INT, "number of bullets and lasers grazed in this game", STORED(player.grazes), PERSISTENT),
    REQUIRED("score", A_INT, "points in this game; score.add changes them", STORED(player.score), PERSISTENT),
    REQUIRED("index", A_INT, "number of the player, 1 or 2", PERSISTENT),
    REQUIRED("kind", A_PLAYER_KIND, "name of its kind", STORED(player.kind), PERSISTENT),
    [P_PICTURE] = OPTIONAL(
        "picture", A_STR,
        "picture to show, a name in `pictures` of its kind; nil shows the picture `left` or `right` while the ship "
        "flies left or right, otherwise its sprite",
        SETTER),
    REQUIRED("flip_x", A_BOOL, "true if mirrored left to right", BITS_OF(player.flags, PLAYER_FLIP), WRITABLE),
    REQUIRED("hidden", A_BOOL, "true if not drawn; it still flies, fires and is hit",
             BITS_OF(player.flags, PLAYER_HIDDEN), WRITABLE),
    [P_STATE] =
        REQUIRED("state", A_STR,
                 "\"fly\" or \"hit\"; in \"hit\", the player can't move or fire, but can still be saved by a bomb "
                 "(deathbomb)"),
    [P_SCALE] =
        PARAM("speed_scale", A_FX, REQ, 0, PLAYER_MAX_SCALE, NULL, NULL,
              "factor of its speed; back at 1 when the task that wrote it ends", STORED(player.speed_scale), SETTER),
};

static void get_player_prop(lua_State *L, struct board *b, uint32_t i, int p)
{
    const struct player *s = &b->player;

    if (p == P_PICTURE)
        api_picture_push(L, N_PLAYER, s->kind[i], s->flags[i] / PLAYER_PICTURE_ONE);
    else if (p == P_STATE)
        lua_pushstring(L, s->deathbomb_left[i] ? "hit" : "fly");
    else
        lua_pushinteger(L, i + 1); /* index */
}

static void set_player_prop(lua_State *L, struct board *b, uint32_t i, int p, const struct api_value *v)
{
    struct player *s = &b->player;

    if (p == P_X)
        player_set_position(s, i, v->f, s->y[i]);
    else if (p == P_Y)
        player_set_position(s, i, s->x[i], v->f);
    else if (p == P_SCALE)
        player_scale_speed(s, i, v->f, tasks_current_serial(b));
    else if (p == P_FOCUS)
        player_force_focus(s, i, !v->given ? FOCUS_BY_BUTTON : v->i ? FOCUS_ON : FOCUS_OFF, tasks_current_serial(b));
    else
        s->flags[i] = (uint8_t)((unsigned)(s->flags[i] & ~(PLAYER_PICTURE | PLAYER_PICTURE_LOCKED)) |
                                api_picture_find(L, N_PLAYER, s->kind[i], "player", v) * PLAYER_PICTURE_ONE |
                                (v->given ? PLAYER_PICTURE_LOCKED : 0));
}

const struct api_thing api_player_thing = { "player", props, PROPS, .get = get_player_prop, .set = set_player_prop };

enum { VERB_SELF, VERB_X, VERB_Y };

static const struct api_param push_params[] = { SELF_PARAM_OF(1 << H_PLAYER),
                                                SPEED("vx", A_FX, REQ, "distance to the right; negative: left"),
                                                SPEED("vy", A_FX, REQ, "distance down; negative: up") };
static const struct api_param shift_params[] = { SELF_PARAM_OF(1 << H_PLAYER), SHIFT_DX_PARAM, SHIFT_DY_PARAM };

static int push_player(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L;
    player_push(&b->player, handle_slot(v[VERB_SELF].i), v[VERB_X].f, v[VERB_Y].f);
    return 0;
}

static int shift_player(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L;
    player_shift(&b->player, handle_slot(v[VERB_SELF].i), v[VERB_X].f, v[VERB_Y].f, &b->player_area);
    return 0;
}

/* ---- pad ---- */

enum { BUTTON_NAME, BUTTON_PLAYER };

static const struct api_param button_params[] = { REQUIRED("button", A_BUTTON, "button to read"),
                                                  DEFAULT("p", A_PLAYER, "1", "player whose buttons to read") };

enum { TAKE_BUTTON, TAKE_AGE, TAKE_PLAYER };

static const struct api_param take_params[] = { REQUIRED("button", A_BUTTON, "button to read"),
                                                PARAM("n", A_INT, REQ, 0, MAX_PRESS_AGE, "frames", NULL,
                                                      "maximum age of the press; 0 accepts only a press in this frame"),
                                                DEFAULT("p", A_PLAYER, "1", "player whose buttons to read") };

unsigned api_get_pads(const struct board *b, const char *state, uint32_t p)
{
    return !strcmp(state, "pressed")    ? b->input.pressed[p]
           : !strcmp(state, "released") ? b->input.released[p]
           : !strcmp(state, "repeated") ? b->input.repeated[p]
                                        : input_held(&b->input, p);
}

static int read_button(lua_State *L, struct board *b, struct api_value *v)
{
    const char *state = api_current_binding(L)->entry->name + strlen("pad.");
    const uint32_t p = (uint32_t)v[BUTTON_PLAYER].i - 1;

    lua_pushboolean(L, v[BUTTON_PLAYER].i &&
                           (api_get_pads(b, state, p) & ~board_ignored_buttons(b, p)) >> v[BUTTON_NAME].i & 1);
    return 1;
}

static int take_press(lua_State *L, struct board *b, struct api_value *v)
{
    uint32_t p = (uint32_t)v[TAKE_PLAYER].i - 1, k = (uint32_t)v[TAKE_BUTTON].i;

    lua_pushboolean(L, v[TAKE_PLAYER].i && !(board_ignored_buttons(b, p) >> k & 1) &&
                           input_take(&b->input, p, k, (uint32_t)v[TAKE_AGE].i, board_press_side(b)));
    return 1;
}

/* ---- score ---- */

enum { ADD_POINTS, ADD_PLAYER };

static const struct api_param add_params[] = { PARAM("n", A_INT, REQ, -1e12, 1e12, "points", NULL,
                                                     "points to add; a negative number takes points away"),
                                               DEFAULT("p", A_PLAYER, "1", "player who gets the points") };

enum { ROWS_TABLE, ROWS_SHIP };

static const struct api_param rows_params[] = {
    PARAM("table", A_STR, REQ, 1, NV_MAX_KEY, NULL, NULL,
          "name of the score table; boot.run uses the names of the difficulties"),
    PARAM("ship", A_STR, OPT, 1, NV_MAX_KEY, NULL, NULL,
          "ship whose table to read; if omitted, the best rows of all ships are returned")
};

enum { ENTER_TABLE, ENTER_NAME, ENTER_SCORE, ENTER_SHIP, ENTER_STAGE, ENTER_CLEAR, ENTER_CONTINUES };

static const struct api_param enter_params[] = {
    PARAM("table", A_STR, REQ, 1, NV_MAX_KEY, NULL, NULL,
          "name of the score table; boot.run uses the names of the difficulties"),
    PARAM("name", A_STR, REQ, 1, NV_MAX_NAME, NULL, NULL, "name to show for the player"),
    PARAM("score", A_INT, REQ, -1e15, 1e15, "points", NULL, "points to enter"),
    PARAM("ship", A_STR, OPT, 1, NV_MAX_KEY, NULL, NULL,
          "ship that earned the score; the score is entered into the ship's table"),
    PARAM("stage", A_INT, OPT, 1, NV_STAGE_CLEARED - 1, NULL, NULL, "number of the stage reached"),
    DEFAULT("clear", A_BOOL, "false", "true if all stages were cleared; use it instead of `stage`"),
    PARAM("continues", A_INT, OPT, 0, NV_MAX_CONTINUES, NULL, "0", "number of continues used")
};

static int score_add(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L;
    if (v[ADD_PLAYER].i && b->player.in_game[v[ADD_PLAYER].i - 1])
        board_add_score(b, (uint32_t)v[ADD_PLAYER].i - 1, v[ADD_POINTS].i);
    return 0;
}

static void push_row(lua_State *L, const struct nv_row *row)
{
    lua_createtable(L, 0, 6);
    api_set_string(L, "name", row->name);
    api_set_integer(L, "score", row->score);
    if (row->ship[0])
        api_set_string(L, "ship", row->ship);
    if (row->stage && row->stage != NV_STAGE_CLEARED)
        api_set_integer(L, "stage", row->stage);
    lua_pushboolean(L, row->stage == NV_STAGE_CLEARED);
    lua_setfield(L, -2, "clear");
    api_set_integer(L, "continues", row->continues);
}

static int score_rows(lua_State *L, struct board *b, struct api_value *v)
{
    struct nv_row rows[NV_MAX_ROWS];
    const char *ship = v[ROWS_SHIP].given ? lua_tostring(L, v[ROWS_SHIP].at) : NULL;

    vm_charge(L, b->nvram.s.live / NVRAM_BYTES_PER_WORK);
    int n = nvram_get_rows(&b->nvram, lua_tostring(L, v[ROWS_TABLE].at), ship, rows);
    lua_createtable(L, n, 0);
    for (int r = 0; r < n; r++) {
        push_row(L, &rows[r]);
        lua_rawseti(L, -2, r + 1);
    }
    return 1;
}

static int score_enter(lua_State *L, struct board *b, struct api_value *v)
{
    const char *table = lua_tostring(L, v[ENTER_TABLE].at);
    struct nv_row row = { .score = v[ENTER_SCORE].i, .continues = (uint8_t)v[ENTER_CONTINUES].i };

    vm_charge(L, b->nvram.s.live / NVRAM_BYTES_PER_WORK);
    strcpy(row.name, lua_tostring(L, v[ENTER_NAME].at)); /* fits: the parameter limits the length of the name */
    if (v[ENTER_SHIP].given)
        strcpy(row.ship, lua_tostring(L, v[ENTER_SHIP].at));
    if (v[ENTER_STAGE].given)
        row.stage = (uint8_t)v[ENTER_STAGE].i;
    if (v[ENTER_CLEAR].i)
        row.stage = NV_STAGE_CLEARED;
    int r = nvram_enter_row(&b->nvram, table, &row);
    if (r == -2)
        return api_error(L, "score.enter", NVRAM_FULL_MESSAGE, b->cart.manifest.nvram_kib);
    if (r < 0)
        return lua_pushnil(L), 1;
    if (!board_is_listing(b) && !b->vm.loading) /* scores to beat are no part of a run */
        board_add_marker(b, MARKER_ROW, table, row.ship, "", r + 1);
    lua_pushinteger(L, r + 1);
    return 1;
}

static const struct api_entry entries[] = {
    { "player.def", player_def, PARAMS(def_params), 1, API_CHANGES | API_LOAD_ONLY, NULL,
      HELP("declares a ship: its sprite, its hitbox, its speed and its rules") },
    { "player.get", player_get, PARAMS(get_params), 1, 0, "player",
      HELP("returns player 1 or 2, even if that player isn't in the game") },
    { "player.nearest", player_nearest, PARAMS(nearest_params), 2, 0, "player",
      HELP("returns the living player nearest to a point, or a dead handle if there is none") },
    { "player.each", player_each, PARAMS(each_params), 1, API_CHANGES, NULL,
      HELP("calls a function for each player in the game") },
    API_EACH_VERB("player:push", push_player, push_params, 3,
                  "adds to the ship's next move: wind, a conveyor, pull; the ship stays in the field, and the whole "
                  "path is checked for hits"),
    API_EACH_VERB("player:shift", shift_player, shift_params, 3,
                  "teleports the ship by a distance, without collisions on the way; it stays in the field"),
    { "pad.down", read_button, PARAMS(button_params), 2, 0, "boolean", HELP("returns true while a button is held") },
    { "pad.pressed", read_button, PARAMS(button_params), 2, 0, "boolean",
      HELP("returns true in the frame in which a button goes down") },
    { "pad.take", take_press, PARAMS(take_params), 3, API_CHANGES, "boolean",
      HELP("takes a button's oldest press that hasn't been taken yet; returns false if there is none") },
    { "pad.released", read_button, PARAMS(button_params), 2, 0, "boolean",
      HELP("returns true in the frame in which a button is released") },
    { "pad.repeated", read_button, PARAMS(button_params), 2, 0, "boolean",
      HELP("returns true when a button goes down, then every 5 frames once it has been held for 20 frames") },
    { "score.add", score_add, PARAMS(add_params), 2, API_CHANGES, NULL,
      HELP("adds points to a player's score, which stays between 0 and 999,999,999,999; the points can earn extra "
           "lives (`extends` in rom.lua)") },
    { "score.rows", score_rows, PARAMS(rows_params), 2, API_CHANGES, "list",
      HELP("returns up to ten rows of a saved score table, best first; each is { name, score, ship, stage, clear, "
           "continues }") },
    { "score.enter", score_enter, PARAMS(enter_params), 1, API_CHANGES, "row",
      HELP("enters a score into a saved table of ten rows; returns the number of its row, or nil if the score is too "
           "low") },
    { "player.def register", NULL, api_register_settings, REGISTER_SETTING_COUNT, 0, API_LUA | API_SYS, NULL,
      HELP("one register of the ship; a plain number sets only `start`") },
    { "game.def register", NULL, api_register_settings, REGISTER_SETTING_COUNT, 0, API_LUA | API_SYS, NULL,
      HELP("one register of the run; a plain number sets only `start`") },
};
const struct api_module api_player = { entries, sizeof entries / sizeof *entries };
