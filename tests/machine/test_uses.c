/*
 * test_uses.c - roms/torture uses all there is, for the tests that play it: its scripts name every API function, every
 * property and every key of a motion step, and under its demo every pool is full once and both players play.
 */
#include <ctype.h>
#include "rig.h"
#include "../../src/script/api/api_parts.h"

/* The frame in which the demo resets the board. */
enum { RESET = 3510 };

static struct rig_game g;
static char scripts[1 << 18], missing[4096];

static void read_scripts(void)
{
    struct lump lump;
    size_t n = 0;

    for (int i = 0; i < (int)g.image.rom.count; i++) {
        rom_lump(&g.image.rom, i, &lump);
        if (strncmp(lump.name, "script/", 7) || !strncmp(lump.name, "script/@std/", 12))
            continue;
        assert_true(n + lump.size < sizeof scripts);
        memcpy(scripts + n, lump.data, lump.size);
        n += lump.size;
    }
}

static bool is_word(char c)
{
    return isalnum((unsigned char)c) || c == '_';
}

/* Do the scripts have the word, after a character of `before` and, blanks left out, before one of `after`? */
static bool uses(const char *before, const char *word, const char *after)
{
    const size_t n = strlen(word);

    for (const char *at = scripts + 1; (at = strstr(at, word)) != NULL; at++) {
        const char *next = at + n + strspn(at + n, " ");
        if (!is_word(at[n]) && *next && strchr(before, at[-1]) && (!after || (strchr(after, *next) && next[1] != '=')))
            return true;
    }
    return false;
}

static void must_use(bool used, const char *name)
{
    if (!used)
        snprintf(missing + strlen(missing), sizeof missing - strlen(missing), " %s", name);
}

static void none_missing(void)
{
    if (missing[0])
        fail_msg("roms/torture does not use:%s", missing);
}

/* Missions are another way through the menus (test_missions.c), and the ROM has no documents (test_bulletml.c). */
TEST(functions)
{
    static const char *const others[] = { "mission.", "bullet.ml", "bullet.documents", "bulletml:" };

    missing[0] = 0;
    for (int i = 0; i < api_count_entries(&api_table); i++) {
        const struct api_entry *e = api_get_entry(&api_table, i);
        const char *verb = strchr(e->name, ':');
        bool other = e->flags & API_SYS;
        for (size_t k = 0; k < sizeof others / sizeof *others; k++)
            other |= strncmp(e->name, others[k], strlen(others[k])) == 0;
        if (!other && !strchr(e->name, ' '))
            must_use(verb ? uses(":", verb + 1, "({") : uses(" \n\t(,=#", e->name, NULL), e->name);
    }
    none_missing();
}

TEST(properties)
{
    missing[0] = 0;
    for (int k = 1; k < HANDLE_KINDS; k++)
        for (int i = 0; i < api_table.things[k]->n; i++) {
            const struct api_param *p = &api_table.things[k]->props[i];
            if (k != H_BULLETML)
                must_use(uses(".", p->name, NULL), p->name);
            if (k != H_BULLETML && p->access & PROP_WRITE)
                must_use(uses(".", p->name, "=,"), p->name);
        }
    none_missing();
}

TEST(steps)
{
    static const char *const step_keys[] = { "wait",   "kind",  "bank",  "dir",  "aim",    "turn",     "home",
                                             "speed",  "accel", "die",   "loop", "go_to",  "polar",    "wave",
                                             "orbit",  "ease",  "spin",  "at",   "every",  "phase",    "radius_to",
                                             "bounce", "walls", "emit",  "path", "mirror", "wait_for", "over",
                                             "ax",     "ay",    "limit", "vx",   "vy",     "turn_to" };

    missing[0] = 0;
    for (size_t i = 0; i < sizeof step_keys / sizeof *step_keys; i++)
        must_use(uses(" {\n(", step_keys[i], "="), step_keys[i]);
    none_missing();
}

/* ---- under the demo ---- */

struct reached {
    uint32_t most[PART_COUNT], actions;
    bool in[MAX_PLAYERS], grazed[MAX_PLAYERS], scored[MAX_PLAYERS], hurt[MAX_PLAYERS], focused[MAX_PLAYERS];
};

static const struct slots *pool(const struct board *b, int part)
{
    return (const struct slots *)((const uint8_t *)b + machine_parts[part].offset);
}

static void look(const struct board *b, struct reached *at)
{
    for (int i = 0; i < PART_COUNT; i++)
        at->most[i] = pool(b, i)->live > at->most[i] ? pool(b, i)->live : at->most[i];
    for (uint32_t i = 0; i < b->steps.s.live; i++)
        at->actions |= b->steps.actions[i];
    for (int p = 0; p < MAX_PLAYERS; p++) {
        at->in[p] |= b->player.in_game[p];
        at->grazed[p] |= b->player.grazes[p] > 0;
        at->scored[p] |= b->player.score[p] > 0;
        at->hurt[p] |= b->player.in_game[p] && b->player.lives[p] < 2;
        at->focused[p] |= b->player.flags[p] & PLAYER_FOCUS;
    }
}

TEST(demo)
{
    static struct reached at;
    uint16_t pads[MAX_PLAYERS];
    struct demo d;
    struct rig r;

    assert_true(rig_demo(&g, "torture", &d));
    rig_power(&r, &g, &d.start);
    for (uint32_t f = 0; f < RESET; f++) {
        demo_pads(&d, f, pads);
        rig_tick(&r, pads);
        look(r.b, &at);
    }
    for (int i = 0; i < PART_COUNT; i++) {
        const char *name = machine_parts[i].chip->name;
        const struct slots *s = pool(r.b, i);
        if (!s->cap || strstr(name, "_kinds") || !strcmp(name, "steps") || !strcmp(name, "laser_heads"))
            continue;                              /* there are as many laser_heads as lasers */
        const bool bytes = !strcmp(name, "nvram"); /* a script for which there is no room ends */
        if (bytes ? at.most[i] < 256 : 10 * at.most[i] < 9 * s->cap)
            fail_msg("%s: at most %u of %u live", name, at.most[i], s->cap);
        if ((!machine_parts[i].chip->is_list || !strcmp(name, "motions")) && !s->refused)
            fail_msg("%s: never full", name);
    }
    assert_int_equal(at.actions, DOES_ALL);
    for (int p = 0; p < MAX_PLAYERS; p++)
        assert_true(at.in[p] && at.grazed[p] && at.scored[p] && at.hurt[p] && at.focused[p]);
    rig_free(&r);
    demo_free(&d);
}

static int setup(void **state)
{
    (void)state;
    rig_folder(&g, "torture");
    read_scripts();
    return 0;
}

static int teardown(void **state)
{
    (void)state;
    rig_game_free(&g);
    return 0;
}

RUN_TESTS(setup, teardown)
