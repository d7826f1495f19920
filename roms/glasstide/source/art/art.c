/*
 * art.c - writes the pictures of the games in roms/: `art OUTDIR` Glass Tide's, `art OUTDIR card` the test card's, `art
 * OUTDIR bench` the bench's, `art OUTDIR cookbook` the cookbook's; `art OUTDIR glow` what the sandbox has of its own;
 * `art OUTDIR night` those of examples/shooter; and `art OUTDIR icon` the program's icons.
 *
 * The same bytes on every host. `make art` writes them all.
 */
#include "art.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

struct picture {
    const char *name;
    struct sheet (*make)(void);
    enum art_stage stage; /* whose palette it is drawn in */
};

static const struct picture GAME[] = {
    { "bullets", art_bullets, ART_MAIN },
    { "shots", art_shots, ART_MAIN },
    { "sparks", art_sparks, ART_MAIN },
    { "finds", art_finds, ART_MAIN },
    { "fires", art_fires, ART_MAIN },
    { "lights", art_lights, ART_MAIN },
    { "sherds", art_sherds, ART_MAIN },
    { "logo_light", art_logo_light, ART_MAIN },
    { "marker", art_marker, ART_MAIN },
    { "gems", art_gems, ART_MAIN },
    { "font", art_font, ART_MAIN },
    { "logo", art_logo, ART_MAIN },
    /* crafts, and who flies them */
    { "heron", art_heron, ART_MAIN },
    { "petrel", art_petrel, ART_MAIN },
    { "iri", art_iri, ART_MAIN },
    { "sen", art_sen, ART_MAIN },
    { "tern", art_tern, ART_MAIN },
    { "ono", art_ono, ART_MAIN },
    { "arms", art_arms, ART_MAIN },
    /* stage one */
    { "enemies", art_enemies, ART_MAIN },
    { "enemies_poses", art_enemies_poses, ART_MAIN },
    { "floor", art_floor, ART_MAIN },
    { "reef", art_reef, ART_MAIN },
    { "border", art_border, ART_MAIN },
    { "shoal", art_shoal, ART_ONE },
    { "shoal_poses", art_shoal_poses, ART_ONE },
    { "lantern_nautilus", art_lantern_nautilus, ART_ONE },
    { "crab", art_crab, ART_ONE },
    { "crab_face", art_crab_face, ART_ONE },
    { "wreck", art_wreck, ART_ONE },
    { "kelp", art_kelp, ART_ONE },
    { "whale", art_whale, ART_ONE },
    { "bones", art_bones, ART_ONE },
    { "shafts", art_shafts, ART_ONE },
    /* stage two */
    { "creatures_two", art_two_creatures, ART_TWO },
    { "creatures_two_poses", art_two_creatures_poses, ART_TWO },
    { "bellows", art_two_bellows, ART_TWO },
    { "cinder", art_two_cinder, ART_TWO },
    { "quench", art_two_quench, ART_TWO },
    { "cinder_face", art_two_cinder_face, ART_TWO },
    { "quench_face", art_two_quench_face, ART_TWO },
    { "bullets_two", art_two_bullets, ART_TWO },
    { "works", art_two_works, ART_TWO },
    { "stacks", art_two_stacks, ART_TWO },
    { "street", art_two_street, ART_TWO },
    { "skyline", art_two_skyline, ART_TWO },
    { "yard", art_two_yard, ART_TWO },
    { "train", art_two_train, ART_TWO },
    /* stage three */
    { "queen", art_queen, ART_MAIN },
    { "queen_face", art_queen_face, ART_THREE },
    { "queen_abyss", art_queen_abyss, ART_THREE },
    { "abyss_life", art_abyss_life, ART_THREE },
    { "abyss_life_poses", art_abyss_life_poses, ART_THREE },
    { "gulper", art_gulper, ART_THREE },
    { "gulper_poses", art_gulper_poses, ART_THREE },
    { "angler", art_angler, ART_THREE },
    { "lamplight", art_lamplight, ART_THREE },
    { "trench", art_trench, ART_THREE },
    { "quay", art_quay, ART_THREE },
    { "quay_lamps", art_quay_lamps, ART_THREE },
    { "abyss_tiles", art_abyss_tiles, ART_THREE },
    /* the moon */
    { "heron_gilt", art_heron_gilt, ART_MAIN },
    { "petrel_gilt", art_petrel_gilt, ART_MAIN },
    { "tern_gilt", art_tern_gilt, ART_MAIN },
    { "heron_ember", art_heron_ember, ART_MAIN },
    { "petrel_ember", art_petrel_ember, ART_MAIN },
    { "tern_ember", art_tern_ember, ART_MAIN },
    { "last", art_last, ART_MOON },
    { "last_face", art_last_face, ART_MOON },
    { "water", art_water, ART_MOON },
    { "dry", art_dry, ART_STORY },
    { "brink", art_brink, ART_STORY },
    { "wave", art_wave, ART_STORY },
    { "dive", art_dive, ART_STORY },
    { "flood", art_flood, ART_STORY },
    { "home", art_home, ART_STORY },

    { NULL, NULL, ART_MAIN },
};
static const struct picture BENCH[] = {
    { "discs", art_bench, ART_MAIN }, { "font", art_font }, { "tiles", art_tiles }, { NULL, NULL }
};
static const struct picture CARD[] = { { "card", art_card }, { "font", art_font }, { NULL, NULL } };

static const struct picture LIGHT[] = {
    { "glow", art_glow }, { "items", art_items }, { "tiles", art_tiles }, { NULL, NULL }
};

static const struct picture BOOK[] = {
    { "bullets", art_bullets }, { "shots", art_shots }, { "sparks", art_sparks }, { "heron", art_heron },
    { "enemies", art_enemies }, { "queen", art_queen }, { "glow", art_glow },     { "items", art_items },
    { "tiles", art_tiles },     { "font", art_font },   { NULL, NULL },
};

static const struct picture NIGHT[] = {
    { "bullets", art_bullets },   { "shots", art_shots },   { "sparks", art_sparks }, { "kite", art_kite },
    { "lanterns", art_lanterns }, { "keeper", art_keeper }, { "night", art_night },   { "moon", art_moon },
    { "font", art_font },         { NULL, NULL },
};

static bool write_png(const char *dir, const char *name, const uint8_t *rgba, int w, int h)
{
    char path[1024];
    snprintf(path, sizeof path, "%s/%s.png", dir, name);
    if (stbi_write_png(path, w, h, 4, rgba, w * 4))
        return true;
    fprintf(stderr, "art: %s: cannot write\n", path);
    return false;
}

static void colour(uint8_t *px, uint32_t rgb, uint8_t alpha)
{
    px[0] = (uint8_t)(rgb >> 16);
    px[1] = (uint8_t)(rgb >> 8);
    px[2] = (uint8_t)rgb;
    px[3] = alpha;
}

static bool write_sheet(const char *dir, const char *name, const struct sheet *s, const uint32_t rgb[256])
{
    uint8_t *rgba = calloc((size_t)(s->w * s->h), 4);
    if (!rgba)
        return false;
    for (int i = 0; i < s->w * s->h; i++) {
        if (s->px[i])
            colour(&rgba[4 * i], rgb[s->bank * 16 + s->px[i]], 255);
    }
    bool ok = write_png(dir, name, rgba, s->w, s->h);
    free(rgba);
    return ok;
}

static bool write_palette(const char *dir, const char *name, const uint32_t rgb[256])
{
    uint8_t rgba[256 * 4];
    for (int i = 0; i < 256; i++)
        colour(&rgba[4 * i], rgb[i], 255);
    return write_png(dir, name, rgba, 16, 16);
}

/* The icon in three sizes: 48 is drawn as it is, 128 and 256 are 64 magnified. */
static bool write_icons(const char *dir, const uint32_t rgb[256])
{
    static const struct {
        const char *name;
        int size, scale;
    } icons[] = { { "48", 48, 1 }, { "128", 64, 2 }, { "256", 64, 4 } };
    bool ok = true;

    for (int i = 0; i < 3 && ok; i++) {
        struct sheet small = art_icon(icons[i].size);
        struct sheet s = sheet_new(small.w * icons[i].scale, small.h * icons[i].scale, small.bank);
        for (int k = 0; k < s.w * s.h; k++)
            s.px[k] = (uint8_t)sheet_get(&small, k % s.w / icons[i].scale, k / s.w / icons[i].scale);
        ok = write_sheet(dir, icons[i].name, &s, rgb);
        sheet_free(&s);
        sheet_free(&small);
    }
    return ok;
}

/* The pictures of what is asked for; NULL: it is not known. */
static const struct picture *pictures(const char *what)
{
    static const struct {
        const char *name;
        const struct picture *list;
    } lists[] = { { "", GAME },         { "card", CARD },  { "bench", BENCH },
                  { "cookbook", BOOK }, { "glow", LIGHT }, { "night", NIGHT } };

    for (size_t i = 0; i < sizeof lists / sizeof *lists; i++) {
        if (!strcmp(what, lists[i].name))
            return lists[i].list;
    }
    return NULL;
}

/* The palettes of the stages. */
static bool write_stages(const char *dir)
{
    static const char *const names[ART_STAGES] = { "",
                                                   "palette_one",
                                                   "palette_deep",
                                                   "palette_two",
                                                   "palette_three",
                                                   "palette_moon",
                                                   "palette_dark",
                                                   "palette_story" };
    uint32_t rgb[256];

    for (enum art_stage stage = ART_ONE; stage < ART_STAGES; stage++) {
        art_stage_palette(stage, rgb);
        if (!write_palette(dir, names[stage], rgb))
            return false;
    }
    return true;
}

int main(int argc, char **argv)
{
    const char *dir = argc > 1 ? argv[1] : "", *what = argc > 2 ? argv[2] : "";
    const struct picture *p = pictures(what);
    bool game = p == GAME, icon = !strcmp(what, "icon"), ok = true;
    uint32_t rgb[256];

    if (argc < 2 || argc > 3 || (!p && !icon)) {
        fprintf(stderr, "usage: art OUTDIR [card | bench | cookbook | glow | night | icon]\n");
        return 2;
    }
    if (p == NIGHT)
        art_night_palette(rgb);
    else
        art_palette(rgb);
    if (icon)
        return write_icons(dir, rgb) ? 0 : 3;
    for (; p->name && ok; p++) {
        struct sheet s = p->make();
        if (game)
            art_stage_palette(p->stage, rgb);
        ok = write_sheet(dir, p->name, &s, rgb);
        sheet_free(&s);
    }
    if (game)
        art_palette(rgb);
    ok = ok && write_palette(dir, "palette", rgb) && (!game || write_stages(dir));
    return ok ? 0 : 3;
}
