/*
 * spoil.h - a small valid game to be spoilt, the checksums made good again, and what must come of it.
 *
 * A spoilt ROM is refused in one sentence, or runs SPOIL_FRAMES frames, or ends in a fault that says something. No
 * assertion, no crash, no rubbish in a message.
 */
#ifndef TESTS_SPOIL_H
#define TESTS_SPOIL_H

#include "machine/rig.h"
#include "repair.h"

enum { SPOIL_FRAMES = 120, SPOIL_RAM = 24 << 20 /* bytes; a spoilt manifest that asks for more is not powered */ };

enum spoil_outcome { SPOIL_REFUSED, SPOIL_TOO_LARGE, SPOIL_FAULTED, SPOIL_RAN, SPOIL_OUTCOMES };

/* Some of everything, so that a spoilt byte meets code that looks at it. */
static const char spoil_script[] =
    "bullet.def('dot', { sprite = 'dot', hit = { circle = 2 } })\n"
    "bullet.def('box', { sprite = 'wink', hit = { box = { 4, 6 } }, turns = true, bank = 2 })\n"
    "shot.def('shot', { sprite = 'arrow', hit = { circle = 4 }, damage = 3 })\n"
    "spark.def('spark', { sprite = 'dot', life = 20, gravity = 0.1, drag = 0.02 })\n"
    "local steps = motion.def { { wait = 5 }, { loop = 3, { turn = 40, over = 4 }, { accel = 0.1, over = 6 } },\n"
    "  { kind = 'box' }, { home = 3, over = 30 }, { aim = true }, { speed = 2.5, over = 9 } }\n"
    "local road = path.def { { x = 20, y = -10 }, { x = 60, y = 80, over = 30 }, { wait = 20 }, { x = 300, y = 90, "
    "over = 60 } }\n"
    "enemy.def('moth', { sprite = 'wink', hit = { box = { 16, 12 } }, hp = 4, score = 100, spark = 'spark', run = "
    "function(e)\n"
    "  while true do pattern.ring { kind = 'dot', from = e, n = 7, speed = 1.5, dir = rng.dir(), motion = steps } "
    "wait(17) end\n"
    "end })\n"
    "player.def('ship', { sprite = 'arrow', hit = { circle = 2 }, graze = 14, lives = 2, run = function(p)\n"
    "  while true do if pad.down('fire') then shot.fire { kind = 'shot', from = p, dir = 270, speed = 9 } end wait(3) "
    "end\n"
    "end })\n"
    "stage.def('one', function()\n"
    "  stage.wave { n = 5, every = 9, kind = 'moth', path = road }\n"
    "  stage.mark('later')\n"
    "  task.go(function() pattern.spiral { kind = 'box', x = 120, y = 60, n = 90, arms = 3, step = 11, every = 2, "
    "speed = 2 } end)\n"
    "  local s = sprite.put { sprite = 'arrow', x = 50, y = 50, bank = 3 }\n"
    "  for i = 1, 40 do s.x, s.flip_x = 3 * i, i % 2 == 0 text.put { col = 1, row = i % 20, text = ('%d %s'):format(i, "
    "rom.text 'words.txt') } wait(1) end\n"
    "  palette.fade { to = 0x203040, over = 30 }\n"
    "  save.set('best', (save.get('best', 0) + 7) % 100)\n"
    "  spark.burst { kind = 'spark', x = 99, y = 99, n = 12 }\n"
    "  stage.clear(60)\n"
    "end)\n"
    "on.graze(function(p, b) score.add(10, p) end)\n"
    "on.kill(function(e) bullet.clear { spark = 'spark' } end)\n"
    "boot.run { stages = { 'one' }, players = { 'ship' } }\n";

static inline void spoil_game(struct rig_game *g)
{
    struct manifest m = rig_manifest();

    m.lua_kib = 768;
    rig_script(g, &m, spoil_script);
}

/* Where lump i of a valid ROM stands. */
static inline void spoil_lump(const uint8_t *p, uint32_t i, size_t *at, size_t *n)
{
    const uint8_t *e = p + ROM_HEADER_SIZE + i * ROM_ENTRY_SIZE;

    *at = bytes_get32(e + 4);
    *n = bytes_get32(e + 8);
}

/* A sentence: something, on one line, without control characters, not cut in the middle by the buffer. */
static inline bool spoil_sentence(const char *s, size_t room)
{
    size_t n = strnlen(s, room);

    if (n == 0 || n + 1 >= room)
        return false;
    for (size_t i = 0; i < n; i++)
        if ((unsigned char)s[i] < 32 || s[i] == 127)
            return false;
    return true;
}

/* RAM and picture for one board after another. */
struct spoil_bench {
    void *ram, *pix, *scratch;
    size_t pix_size, scratch_size;
    uint32_t rgb[256];
    char said[512]; /* what a refusal or fault said */
};

static inline void spoil_open(struct spoil_bench *s)
{
    memset(s, 0, sizeof *s);
    s->ram = aligned_alloc(64, SPOIL_RAM);
}

static inline void spoil_close(struct spoil_bench *s)
{
    free(s->ram);
    free(s->pix);
    free(s->scratch);
}

static inline void spoil_draw(struct spoil_bench *s, const struct board *b)
{
    struct fb fb;
    int w, h;

    board_screen_size(b, &w, &h);
    if (fb_size(w, h) > s->pix_size)
        s->pix = realloc(s->pix, s->pix_size = fb_size(w, h));
    if (board_scratch_size(b) + 1 > s->scratch_size)
        s->scratch = realloc(s->scratch, s->scratch_size = board_scratch_size(b) + 1);
    fb_init(&fb, s->pix, w, h);
    board_draw(b, NULL, &fb, s->rgb, s->scratch);
}

/* The board, powered, runs; pads NULL: random ones of r. */
static inline enum spoil_outcome spoil_frames(struct spoil_bench *s, struct board *b, const struct demo *d,
                                              struct rng *r)
{
    uint16_t pads[MAX_PLAYERS] = { 0 };

    for (uint32_t f = 0; f < SPOIL_FRAMES && !board_last_output(b)->fault; f++) {
        if (d)
            demo_pads(d, f, pads);
        else
            rig_pads(r, pads);
        board_tick(b, pads);
        if (f % 40 == 7)
            spoil_draw(s, b);
    }
    const struct board_fault *fault = board_last_output(b)->fault;
    if (fault)
        snprintf(s->said, sizeof s->said, "%.*s", (int)strnlen(fault->message, sizeof s->said - 1), fault->message);
    return fault ? SPOIL_FAULTED : SPOIL_RAN;
}

/* Opens, powers and runs a ROM. bad: what must not be was. */
static inline enum spoil_outcome spoil_run(struct spoil_bench *s, const struct rom *rom,
                                           const struct board_start *start, const struct demo *d, uint64_t seed,
                                           bool *bad)
{
    char err[512] = "";
    enum spoil_outcome out;
    struct rng r;
    size_t size;

    rng_seed(&r, seed);
    *bad = false;
    s->said[0] = '\0';
    if (!board_size(rom, &size, err, sizeof err)) {
        out = SPOIL_REFUSED;
    } else if (size > SPOIL_RAM) {
        return SPOIL_TOO_LARGE;
    } else {
        memset(s->ram, 0x5a, size < 1 << 20 ? size : 1 << 20);
        struct board *b = board_power_on(s->ram, size, rom, start, err, sizeof err);
        out = b ? spoil_frames(s, b, d, &r) : SPOIL_REFUSED;
    }
    if (out == SPOIL_REFUSED)
        snprintf(s->said, sizeof s->said, "%s", err);
    /* A fault's words may be the script's own. */
    *bad = out == SPOIL_REFUSED ? !spoil_sentence(s->said, sizeof s->said) : out == SPOIL_FAULTED && s->said[0] == '\0';
    return out;
}

#endif
