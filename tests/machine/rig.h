/*
 * rig.h - what the tests of whole boards share: games packed from a folder or from script texts, boards with RAM of
 * their own, pads, pictures.
 *
 * A program that includes this runs in the repository's root.
 */
#ifndef TESTS_RIG_H
#define TESTS_RIG_H

#include "../test.h"
#include "../../src/base/bytes.h"
#include "../../src/base/hash.h"
#include "../../src/base/rng.h"
#include "../../fb/blit.h"
#include "../../src/script/api/api.h"
#include "../../src/machine/machine.h"
#include "../../src/machine/sound.h"
#include "../../src/workbench/bulletml/compile.h"
#include "../../src/demo/demo.h"
#include "../../src/workbench/mml/mml.h"
#include "../../src/workbench/pack/pack.h"
#include "../../src/workbench/samples/recording.h"
#include "../../src/sound/adpcm.h"
#include "../../src/sound/tables.h"

/* The most lumps a test's game has: the library's pieces are lumps too. */
enum { RIG_LUMPS = 512 };

/* A game in memory. */
struct rig_game {
    struct rom_image image;
    struct cart cart;
};

/* A board and all that is around one. */
struct rig {
    const struct rig_game *game;
    void *block, *ram;
    size_t ram_size;
    struct board *b;
    struct fb fb;
    void *pix, *scratch;
    uint8_t *snapshot; /* of rig_spoil; snapshot_room bytes */
    size_t snapshot_room;
};

struct rig_script {
    const char *name, *text; /* "main" */
};

/* Is there time for the long variants? */
static inline bool rig_long(void)
{
    const char *s = getenv("CURTAIN_LONG");

    return s && *s && strcmp(s, "0") != 0;
}

/* ---- games ---- */

/* The sprites of a game made here: 8x8; 16x16 in 16 turned copies; 4 frames of 8x8. Nothing about them is symmetric. */
static inline void rig_sprite(uint8_t *out, int side, int frames, int every, int rotations, int bank)
{
    const int fields[] = { side, side, side, side / 2, side / 2, frames, every, rotations, bank };

    memset(out, 0, CART_GFX_HEADER_SIZE);
    for (int i = 0; i < 9; i++) {
        out[2 * i] = (uint8_t)fields[i];
        out[2 * i + 1] = (uint8_t)(fields[i] >> 8);
    }
    for (int i = 0; i < frames * rotations * side * side; i++)
        out[CART_GFX_HEADER_SIZE + i] = (uint8_t)((i * 7 + i / side) % 5 ? bank * 16 + 1 + i % 15 : 0);
}

static inline int rig_by_name(const void *a, const void *b)
{
    return strcmp(((const struct lump *)a)->name, ((const struct lump *)b)->name);
}

/* Takes lumps in any order. */
static inline void rig_write(struct rig_game *g, struct lump *lumps, int n)
{
    char err[512];

    qsort(lumps, (size_t)n, sizeof *lumps, rig_by_name);
    g->image.size = rom_write_size(lumps, n);
    g->image.bytes = malloc(g->image.size);
    rom_write(g->image.bytes, lumps, n);
    if (!rom_open(&g->image.rom, g->image.bytes, g->image.size, err, sizeof err) ||
        !cart_open(&g->cart, &g->image.rom, err, sizeof err))
        fail_msg("%s", err);
}

/* Small capacities; sprites "dot", "arrow", "wink". */
static inline struct manifest rig_manifest(void)
{
    struct manifest m;

    manifest_set_defaults(&m);
    snprintf(m.id, sizeof m.id, "rig");
    m.bullets = 256;
    m.shots = 64;
    m.enemies = 32;
    m.sparks = 128;
    m.sprites = 16;
    m.motions = 32;
    m.tasks = 64;
    m.lua_kib = 1024;
    m.players = 2;
    return m;
}

/* A game of these scripts; m NULL: rig_manifest. One named "@std/NAME" takes the place of the library's. */
static inline void rig_scripts(struct rig_game *g, const struct manifest *m, const struct rig_script *s, int n)
{
    static uint8_t manifest[MANIFEST_BYTES], palette[CART_PALETTE_SIZE], font[96 * CART_GLYPH_SIZE];
    static uint8_t dot[CART_GFX_HEADER_SIZE + 64], arrow[CART_GFX_HEADER_SIZE + 16 * 256],
        wink[CART_GFX_HEADER_SIZE + 4 * 64];
    struct manifest own = m ? *m : rig_manifest();
    char names[RIG_LUMPS][80];
    struct lump lumps[RIG_LUMPS];
    int k = 0;

    /* "tiny": A, 3 x 4 px, and U+5F3E, 5 x 5 */
    static const uint8_t tiny[FACE_HEADER_SIZE + 2 * FACE_GLYPH_SIZE + 32 + 40] = {
        6, 0, 0,  0, 2, 0, 0, 0, 'A', 0,    0, 0, 40, 0, 0,  0, 3,  4, 0, 1, 4, 0, 0, 0, 0x3e, 0x5f,
        0, 0, 72, 0, 0, 0, 5, 5, 1,   0xff, 7, 0, 0,  0, 15, 0, 15, 0, 0, 0, 0, 0, 3, 3, 3,    [81] = 3,
    };

    const uint32_t manifest_size = manifest_pack(&own, manifest);
    for (int i = 0; i < CART_PALETTE_SIZE; i++)
        palette[i] = (uint8_t)(i * 37 + i / 3);
    for (int i = 0; i < 96 * CART_GLYPH_SIZE; i++)
        font[i] = (uint8_t)((i * 5 + i / 64 * 3) % 16);
    rig_sprite(dot, 8, 1, 1, 1, 0);
    rig_sprite(arrow, 16, 1, 1, 16, 0);
    rig_sprite(wink, 8, 4, 3, 1, 0);
    lumps[k++] = (struct lump){ "manifest", manifest, manifest_size };
    lumps[k++] = (struct lump){ "palette/main", palette, sizeof palette };
    lumps[k++] = (struct lump){ "palette/other", palette, sizeof palette };
    lumps[k++] = (struct lump){ "font", font, sizeof font };
    lumps[k++] = (struct lump){ "fonts/tiny", tiny, sizeof tiny };
    lumps[k++] = (struct lump){ "gfx/dot", dot, sizeof dot };
    lumps[k++] = (struct lump){ "gfx/arrow", arrow, sizeof arrow };
    lumps[k++] = (struct lump){ "gfx/wink", wink, sizeof wink };
    lumps[k++] = (struct lump){ "data/words.txt", (const uint8_t *)"words\n", 6 };
    for (int i = 0; i < n; i++, k++) {
        snprintf(names[k], sizeof names[k], "script/%s.lua", s[i].name);
        lumps[k] = (struct lump){ names[k], (const uint8_t *)s[i].text, (uint32_t)strlen(s[i].text) };
    }
    for (int i = 0; i < std_script_count; i++) {
        bool taken = false;
        snprintf(names[k], sizeof names[k], "script/@std/%s.lua", std_scripts[i].name);
        for (int j = 0; j < n; j++)
            taken |= !strncmp(s[j].name, "@std/", 5) && !strcmp(s[j].name + 5, std_scripts[i].name);
        if (taken)
            continue;
        lumps[k] = (struct lump){ names[k], std_scripts[i].data, (uint32_t)std_scripts[i].size };
        k++;
    }
    rig_write(g, lumps, k);
}

static inline void rig_script(struct rig_game *g, const struct manifest *m, const char *text)
{
    const struct rig_script s = { m ? m->entry : "main", text };

    rig_scripts(g, m, &s, 1);
}

/* The same, and string.sys is what only @std sees. */
static inline void rig_with_sys(struct rig_game *g, const struct manifest *m, const char *text)
{
    static char prelude[1 << 14];
    const struct rig_script scripts[] = { { m ? m->entry : "main", text }, { "@std/prelude", prelude } };

    for (int i = 0; i < std_script_count; i++)
        if (!strcmp(std_scripts[i].name, "prelude"))
            snprintf(prelude, sizeof prelude, "string.sys = ... %.*s", (int)std_scripts[i].size,
                     (const char *)std_scripts[i].data);
    rig_scripts(g, m, scripts, 2);
}

/* Puts two blends into a game, "ghost" and "glow", made by a rule for ramps; BLIT_TABLE: the table is nonsense. */
static inline void rig_ruled_blends(struct rig_game *g, enum blit_mix ghost, enum blit_mix glow)
{
    static uint8_t blend[2][CART_BLEND_SIZE];
    struct rig_game had = *g;
    struct lump lumps[RIG_LUMPS];
    int n = (int)had.image.rom.count;

    for (int i = 0; i < CART_BLEND_SIZE; i++) {
        const uint8_t under = (uint8_t)(i >> 8), over = (uint8_t)i;
        blend[0][i] = ghost == BLIT_TABLE ? (uint8_t)(i * 13 + under * 7 + 1) : blit_ramp_entry(ghost, under, over);
        blend[1][i] = glow == BLIT_TABLE ? (uint8_t)(i * 5 + under * 11 + 2) : blit_ramp_entry(glow, under, over);
    }
    for (int i = 0; i < n; i++)
        rom_lump(&had.image.rom, i, &lumps[i]);
    lumps[n++] = (struct lump){ "blend/ghost", blend[0], CART_BLEND_SIZE };
    lumps[n++] = (struct lump){ "blend/glow", blend[1], CART_BLEND_SIZE };
    rig_write(g, lumps, n);
    free(had.image.bytes);
}

static inline void rig_blends(struct rig_game *g)
{
    rig_ruled_blends(g, BLIT_TABLE, BLIT_TABLE);
}

/* Two maps: "sea" of 3 x 2 solid tiles of 8 px, and "reef" of 5 x 4 tiles of 16 px with holes. */
static inline void rig_maps(struct rig_game *g)
{
    enum { TILES = 4 };
    static uint8_t sea[CART_MAP_HEADER_SIZE + 2 * 6 + TILES * (1 + 64)],
        reef[CART_MAP_HEADER_SIZE + 2 * 20 + TILES * (1 + 256)];
    struct {
        uint8_t *at;
        int cols, rows, side, bank;
    } maps[] = { { sea, 3, 2, 8, 2 }, { reef, 5, 4, 16, 3 } };
    struct rig_game had = *g;
    struct lump lumps[RIG_LUMPS];
    int n = (int)had.image.rom.count;

    for (int k = 0; k < 2; k++) {
        uint8_t *p = maps[k].at, *solid = p + CART_MAP_HEADER_SIZE + 2 * maps[k].cols * maps[k].rows;
        const int tile = maps[k].side * maps[k].side, cells = maps[k].cols * maps[k].rows;
        bytes_put16(p, (uint16_t)maps[k].cols);
        bytes_put16(p + 2, (uint16_t)maps[k].rows);
        bytes_put16(p + 4, (uint16_t)maps[k].side);
        bytes_put16(p + 6, TILES);
        bytes_put16(p + 8, (uint16_t)maps[k].bank);
        bytes_put16(p + 10, k == 0);
        for (int i = 0; i < cells; i++)
            bytes_put16(p + CART_MAP_HEADER_SIZE + 2 * i, (uint16_t)(k == 0 ? 1 + i % 3 : i * 7 % TILES));
        for (int t = 1; t < TILES; t++) {
            solid[t] = k == 0 || t == 2;
            for (int i = 0; i < tile; i++)
                solid[TILES + t * tile + i] =
                    (uint8_t)(!solid[t] && i % 3 == 0 ? 0
                                                      : maps[k].bank * 16 + 1 + (i * 7 + i / maps[k].side + t) % 15);
        }
    }
    for (int i = 0; i < n; i++)
        rom_lump(&had.image.rom, i, &lumps[i]);
    lumps[n++] = (struct lump){ "map/reef", reef, sizeof reef };
    lumps[n++] = (struct lump){ "map/sea", sea, sizeof sea };
    rig_write(g, lumps, n);
    free(had.image.bytes);
}

/* Two sounds, "hit" and "boom" of two tracks, and two pieces of music, "tide" of endless tracks with markers and
 * changes of tempo, and "deep", which ends; and the recording "bell", which "deep" plays too. For a manifest with
 * sound. */
static inline void rig_sounds(struct rig_game *g)
{
    static const struct {
        const char *lump, *text;
    } texts[] = {
        { "tune/deep", "@b sample bell root=60\nA t90 @b o4 v12 c8e8 {c>g}4,8 r2\nB @noise l16 [c r]8" },
        { "tune/tide", "@lead fm ratio=2 depth=3 dull=200 decay=300 sustain=20 release=90 vibrato=30,5.5,100\n"
                       "A t133.25 @lead v12 o5 L l8 c8d8e8 \"drop\" t97 f8 & g4 e4 p20 c4 v9 {{cde}}4 t133.25 r8 \n"
                       "B @triangle o3 v14 L c2 g2 \"back\" a4 f4 e8\n"
                       "C @pulse V40 o4 L [c32r32]8 r1 r8" },
        { "sound/boom", "A t240 @noise E0,200,0,5 o4 v15 c4\nB @sine E0,200,0,5 v15 {o4c<<c}4" },
        { "sound/hit", "t200 @noise E0,60,0,10 o6 c8" },
        { "sound/siren", "t60 r1" },
    };
    struct mml_settings settings = { .volume = 255, .priority = 4, .limit = 2, .title = "" };
    struct rig_game had = *g;
    struct lump lumps[RIG_LUMPS];
    struct recording_bytes bell;
    uint8_t *made[8];
    int16_t wave[1500];
    char err[256];
    size_t size;
    int n = (int)had.image.rom.count, k = 0;

    for (int i = 0; i < n; i++)
        rom_lump(&had.image.rom, i, &lumps[i]);
    for (; k < 5; k++) {
        settings.duck = k == 4 ? 128 : 0;
        if (!mml_compile(texts[k].text, strlen(texts[k].text), texts[k].lump, &settings, &made[k], &size, err,
                         sizeof err))
            fail_msg("%s", err);
        lumps[n++] = (struct lump){ texts[k].lump, made[k], (uint32_t)size };
    }
    for (int i = 0; i < 1500; i++)
        wave[i] = (int16_t)((i * 577 % 1000 - 500) * (1500 - i) / 40);
    if (!recording_sound(&(struct pcm){ .frames = wave, .n = 1500, .rate = 22050, .channels = 1, .loop = -1 },
                         &(struct art_sound){ .volume = 255, .priority = 4, .limit = 2 }, &bell, err, sizeof err))
        fail_msg("%s", err);
    lumps[n++] = (struct lump){ "sound/bell", made[k++] = bell.data, (uint32_t)bell.n };
    rig_write(g, lumps, n);
    while (k-- > 0)
        free(made[k]);
    free(had.image.bytes);
}

/* Compiles a BulletML document; what is wrong with it is in err. */
static inline bool rig_compile(const char *xml, uint8_t **out, size_t *size, char *err, size_t err_size)
{
    struct document d;
    const bool good = document_read(&d, xml, strlen(xml), "test.xml", NULL, NULL, err, err_size) &&
                      bulletml_compile(&d, "test.xml", out, size, err, err_size);

    document_free(&d);
    return good;
}

/* Puts a lump into a game. */
static inline void rig_lump(struct rig_game *g, const char *name, const uint8_t *data, size_t size)
{
    struct rig_game had = *g;
    struct lump lumps[RIG_LUMPS];
    int n = (int)had.image.rom.count;

    for (int i = 0; i < n; i++)
        rom_lump(&had.image.rom, i, &lumps[i]);
    lumps[n++] = (struct lump){ name, data, (uint32_t)size };
    rig_write(g, lumps, n);
    free(had.image.bytes);
}

/* Puts a BulletML document into a game: bulletml/NAME. */
static inline void rig_document(struct rig_game *g, const char *name, const char *xml)
{
    char lump[80], err[256];
    uint8_t *out;
    size_t size;

    if (!rig_compile(xml, &out, &size, err, sizeof err))
        fail_msg("%s: %s", name, err);
    snprintf(lump, sizeof lump, "bulletml/%s", name);
    rig_lump(g, lump, out, size);
    free(out);
}

/* Packs roms/NAME. */
static inline void rig_folder(struct rig_game *g, const char *name)
{
    char path[256], err[512];

    snprintf(path, sizeof path, "%s%s", strchr(name, '/') ? "" : "roms/", name);
    if (!pack_load_game(path, false, &g->image, err, sizeof err) ||
        !cart_open(&g->cart, &g->image.rom, err, sizeof err))
        fail_msg("%s", err);
}

static inline void rig_game_free(struct rig_game *g)
{
    free(g->image.bytes);
    g->image.bytes = NULL;
}

/* The game's demo of that name; false: it has none. */
static inline bool rig_demo(const struct rig_game *g, const char *name, struct demo *d)
{
    char lump_name[80], err[512];
    struct lump lump;

    snprintf(lump_name, sizeof lump_name, "demo/%s", name);
    int i = rom_find(&g->image.rom, lump_name);
    if (i < 0)
        return false;
    rom_lump(&g->image.rom, i, &lump);
    if (!demo_read(d, lump.data, lump.size, err, sizeof err))
        fail_msg("demo %s: %s", name, err);
    return true;
}

/* ---- boards ---- */

/* Powers a board in RAM full of rubbish. A fault while loading is left to look at. start NULL: seed 1. */
static inline void rig_power_any(struct rig *r, const struct rig_game *g, const struct board_start *start)
{
    struct board_start plain = { .seed = 1, .difficulty = -1 };
    char err[512];
    int w, h;

    memset(r, 0, sizeof *r);
    r->game = g;
    if (!board_size(&g->image.rom, &r->ram_size, err, sizeof err))
        fail_msg("%s", err);
    r->block = malloc(r->ram_size + 16);
    r->ram = (uint8_t *)r->block + (16 - (uintptr_t)r->block % 16) % 16;
    memset(r->ram, 0x5a, r->ram_size);
    r->b = board_power_on(r->ram, r->ram_size, &g->image.rom, start ? start : &plain, err, sizeof err);
    if (!r->b)
        fail_msg("%s", err);
    board_screen_size(r->b, &w, &h);
    r->pix = malloc(fb_size(w, h));
    fb_init(&r->fb, r->pix, w, h);
    r->scratch = malloc(board_scratch_size(r->b));
}

/* Reserves space for all kinds, for tests that write their columns. */
static inline void rig_reserve_kinds(struct board *b)
{
    struct slots *lists[] = { &b->bullet_kinds.s, &b->shot_kinds.s, &b->enemy_kinds.s, &b->player_kinds.s };

    for (int i = 0; i < 4; i++)
        vm_reserve(b->vm.L, lists[i], lists[i]->cap);
}

/* Like motion_define, which leaves it to its caller to reserve space. */
static inline int32_t rig_motion(struct board *b, const struct motion_step *steps, uint32_t n, bool is_fine)
{
    vm_reserve(b->vm.L, &b->motions.s, 1);
    vm_reserve(b->vm.L, &b->steps.s, n);
    return motion_define(&b->motions, &b->steps, steps, n, is_fine);
}

static inline const struct board_fault *rig_fault(const struct rig *r)
{
    return board_last_output(r->b)->fault;
}

static inline void rig_sound(const struct rig *r)
{
    if (rig_fault(r))
        fail_msg("frame %u: %s\n%s", board_frame(r->b), rig_fault(r)->message, rig_fault(r)->trace);
}

static inline void rig_power(struct rig *r, const struct rig_game *g, const struct board_start *start)
{
    rig_power_any(r, g, start);
    rig_sound(r);
}

static inline void rig_free(struct rig *r)
{
    free(r->block);
    free(r->pix);
    free(r->scratch);
    free(r->snapshot);
    memset(r, 0, sizeof *r);
}

/* Frees a board and its game, which no other board may use. Does nothing to a rig without power. */
static inline void rig_close(struct rig *r)
{
    struct rig_game *game = (struct rig_game *)r->game;

    rig_free(r);
    if (game)
        rig_game_free(game);
}

/* One frame, which must not fault. */
static inline void rig_tick(struct rig *r, const uint16_t pads[MAX_PLAYERS])
{
    board_tick(r->b, pads);
    rig_sound(r);
}

static inline void rig_run(struct rig *r, int frames)
{
    const uint16_t none[MAX_PLAYERS] = { 0 };

    while (frames-- > 0)
        rig_tick(r, none);
}

/* What the game says in so many frames: what it prints, or the fault's message, without the place it happened at unless
 * that is asked for. Good until the next call. */
static inline const char *rig_said(const struct rig_game *g, int frames, bool place)
{
    static char said[8192];
    const uint16_t none[MAX_PLAYERS] = { 0 };
    struct rig r;
    size_t n = 0;

    rig_power_any(&r, g, NULL);
    for (int f = 0; f < frames && !rig_fault(&r); f++) {
        const struct board_out *out = board_tick(r.b, none);
        for (size_t i = 0; i < out->log_size && n + 1 < sizeof said; i++)
            said[n++] = out->log[i];
    }
    said[n] = 0;
    if (rig_fault(&r)) {
        const char *message = rig_fault(&r)->message, *at = place ? NULL : strstr(message, ": ");
        snprintf(said, sizeof said, "%s", at ? at + 2 : message);
    }
    rig_free(&r);
    return said;
}

/* What the game's string.told() returns. Good until the next call. */
static inline const char *rig_told(struct rig *r)
{
    lua_State *L = r->b->vm.L;

    lua_settop(L, 0);
    lua_getglobal(L, "string");
    lua_getfield(L, -1, "told");
    lua_call(L, 0, 1);
    return lua_tostring(L, -1);
}

/* Snapshot into r->snapshot; rig_spoil fills all of RAM with rubbish and puts the snapshot back. */
static inline void rig_save(struct rig *r)
{
    size_t n = board_snapshot_size(r->b);

    if (n > r->snapshot_room) {
        r->snapshot = realloc(r->snapshot, n);
        r->snapshot_room = n;
    }
    board_save(r->b, r->snapshot);
}

static inline void rig_restore(struct rig *r)
{
    memset(r->ram, 0xa5, r->ram_size);
    board_restore(r->b, r->snapshot);
}

static inline void rig_spoil(struct rig *r)
{
    rig_save(r);
    rig_restore(r);
}

/* Picture and colours as one number, by a view. */
static inline uint64_t rig_picture_by(struct rig *r, const struct view *view)
{
    uint32_t rgb[256];
    uint64_t h = HASH_START;

    board_draw(r->b, view, &r->fb, rgb, r->scratch);
    for (int y = 0; y < r->fb.h; y++)
        h = hash_bytes(h, r->fb.pix + (ptrdiff_t)y * r->fb.pitch, (size_t)r->fb.w);
    for (int i = 0; i < 256; i++)
        h = hash_fold(h, rgb[i]);
    return h;
}

static inline uint64_t rig_picture(struct rig *r)
{
    return rig_picture_by(r, NULL);
}

/* One of RIG_VIEWS, 0 the plain one. shades: for a ROM that has none. */
enum { RIG_VIEWS = VIEW_DIMS * COLOUR_BLIND_MODES * 2 };
static inline struct view rig_view(int i, const uint8_t *shades)
{
    return (struct view){ .dim = (enum view_dim)(i % VIEW_DIMS),
                          .colour_blind_mode = (enum colour_blind_mode)(i / VIEW_DIMS % COLOUR_BLIND_MODES),
                          .softens_flashes = i / VIEW_DIMS / COLOUR_BLIND_MODES,
                          .shades = shades };
}

/* What playing sounds needs: RUN_TESTS(rig_make_sound_tables, ...) fills it. */
static struct snd_tables rig_sound_tables;

static inline int rig_make_sound_tables(void **state)
{
    (void)state;
    board_sound_init_tables(&rig_sound_tables);
    return 0;
}

/* The loudest sample of the last frame's sound. */
static inline int rig_loudest(const struct board *b)
{
    int16_t sound[2 * BOARD_SOUND_FRAMES];
    int most = 0;

    board_mix_sound(b, &rig_sound_tables, sound);
    for (int i = 0; i < 2 * BOARD_SOUND_FRAMES; i++)
        most = abs(sound[i]) > most ? abs(sound[i]) : most;
    return most;
}

/* The first part whose hash differs, or NULL. */
static inline const char *rig_differs(const struct rig *a, const struct rig *b)
{
    uint64_t ha[MAX_PARTS], hb[MAX_PARTS];

    board_hashes(a->b, ha);
    board_hashes(b->b, hb);
    for (int i = 0; i < board_part_count(a->b); i++)
        if (ha[i] != hb[i])
            return board_part_name(a->b, i);
    return NULL;
}

/* ---- pads ---- */

/* Buttons held for some frames, as by hands. Start and select are pressed now and then only. */
static inline void rig_pads(struct rng *rng, uint16_t pads[MAX_PLAYERS])
{
    const uint64_t rare = PAD_START | PAD_SELECT;

    for (int i = 0; i < MAX_PLAYERS; i++) {
        if (rng_below(rng, 10) == 0)
            pads[i] = (uint16_t)((rng_below(rng, PAD_ALL + 1) & ~rare) | (rng_below(rng, 4) ? PAD_FIRE : 0));
        pads[i] &= (uint16_t)~rare;
        if (rng_below(rng, 150) == 0)
            pads[i] |= PAD_START;
        if (rng_below(rng, 900) == 0)
            pads[i] |= PAD_SELECT;
    }
}

#endif
