/*
 * verify_json.c - prints the results of `verify --json` (verify_json.h).
 */
#include "verify_json.h"

#include <stdio.h>
#include "../common/json.h"
#include "../demo/markers.h"

static struct json begin(const char *path, const char *verdict)
{
    struct json j = { .out = stdout };

    json_open(&j, NULL, '{');
    json_text(&j, "file", path);
    json_text(&j, "verdict", verdict);
    return j;
}

static void end(struct json *j)
{
    json_close(j, '}');
    putchar('\n');
}

static const char *verdict_word(const struct verdict *w)
{
    static const char *const words[] = {
        [VERDICT_HOLDS] = "holds",
        [VERDICT_DIFFERS] = "differs",
        [VERDICT_FAULT] = "fault",
        [VERDICT_NO_FAULT] = "no fault",
    };

    return words[w->kind];
}

/* The frames in which the difference began, and the parts that differ. */
static void add_difference(struct json *j, const struct verify_result *t)
{
    const struct verdict *w = t->verdict;

    if (w->kind == VERDICT_HOLDS)
        return;
    json_open(j, "difference", '{');
    json_number(j, "first", w->first);
    json_number(j, "frame", w->frame);
    json_open(j, "parts", '[');
    for (int i = 0; i < t->demo->n_parts; i++)
        if (w->parts >> i & 1)
            json_text(j, NULL, t->demo->part_name[i]);
    json_close(j, ']');
    json_close(j, '}');
}

/* Returns the last marker of a kind, not before `from` if that is not NULL; or NULL. */
static const struct demo_marker *last(const struct demo *d, enum board_marker_kind kind, const struct demo_marker *from)
{
    const struct demo_marker *m = d->n_markers ? d->markers + d->n_markers : NULL;

    while (m && m-- > (from ? from : d->markers))
        if (m->marker.kind == kind)
            return m;
    return NULL;
}

/* Facts about the demo's last game. */
static void add_game(struct json *j, const struct verify_result *t)
{
    const struct manifest *m = &t->cart->manifest;
    const struct demo_marker *game = last(t->again, MARKER_GAME, NULL);
    const struct demo_marker *over = game ? last(t->again, MARKER_OVER, game) : NULL;
    int difficulty = t->replay->difficulty;

    json_open(j, "score", '[');
    for (int p = 0; p < MAX_PLAYERS; p++)
        json_number(j, NULL, board_points(t->replay->guard.board, p));
    json_close(j, ']');
    json_text(j, "difficulty", difficulty < m->n_difficulties ? m->difficulties[difficulty] : NULL);
    json_text(j, "ship", game ? game->marker.name : NULL);
    json_number(j, "players", game ? game->marker.value : 0);
    json_text(j, "ended", over ? over->marker.name : NULL);
    json_number(j, "stages", over ? over->marker.value : 0);
}

static void add_moments(struct json *j, const struct demo *d)
{
    json_open(j, "moments", '[');
    for (uint32_t i = 0; i < d->n_markers; i++) {
        const struct board_marker *m = &d->markers[i].marker;
        if (!board_is_run_marker(m->kind))
            continue;
        json_open(j, NULL, '{');
        json_number(j, "frame", d->markers[i].frame);
        json_text(j, "kind", markers_kind_name(m->kind));
        json_text(j, "name", m->name);
        json_number(j, "value", m->value);
        json_close(j, '}');
    }
    json_close(j, ']');
}

static void add_start(struct json *j, const struct demo *d)
{
    json_open(j, "start", '{');
    json_digits(j, "seed", d->start.seed);
    json_number(j, "difficulty", d->start.difficulty);
    json_text(j, "practice", d->start.practice.section);
    json_text(j, "language", d->start.lang);
    json_bool(j, "large_hud", d->start.large_hud);
    json_bool(j, "at_title", d->start.at_title);
    json_open(j, "dip", '[');
    for (int i = 0; i < MAX_DIPS; i++)
        json_number(j, NULL, d->start.dip[i]);
    json_close(j, ']');
    json_number(j, "nvram", (int64_t)d->start.nvram_size);
    json_close(j, '}');
}

/* The build and game that recorded or replayed a demo. */
static void add_build(struct json *j, const char *key, uint32_t core, uint64_t game, uint64_t rom, const char *lua)
{
    json_open(j, key, '{');
    json_number(j, "core", core);
    json_hex(j, "game", game);
    json_hex(j, "rom", rom);
    json_text(j, "lua", lua);
    json_close(j, '}');
}

void verify_json_replayed(const struct verify_result *t)
{
    const struct demo *d = t->demo;
    const struct rom *rom = t->cart->rom;
    const struct board_fault *fault = replay_fault(t->replay);
    struct json j = begin(t->path, verdict_word(t->verdict));

    add_difference(&j, t);
    json_text(&j, "fault", fault ? fault->message : NULL);
    json_text(&j, "doubt", t->doubt);
    json_text(&j, "game", d->id);
    json_number(&j, "frames", d->frames);
    json_seconds(&j, "seconds", d->frames);
    json_names(&j, "flags", d->flags, demo_flag_name);
    if (t->verdict->kind == VERDICT_HOLDS) {
        add_game(&j, t);
        add_moments(&j, t->again);
    }
    add_start(&j, d);
    json_number(&j, "format", d->format);
    add_build(&j, "recorded", d->core_version, d->game_hash, d->rom_hash, d->lua_release);
    add_build(&j, "replayed", CORE_VERSION, rom_game_hash(rom), rom_hash(rom), board_lua_release());
    end(&j);
}

void verify_json_refused(const char *path, bool host_failed, const char *why)
{
    struct json j = begin(path, host_failed ? "failed" : "refused");

    json_text(&j, "error", why);
    end(&j);
}
