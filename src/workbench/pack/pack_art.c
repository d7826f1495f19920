/*
 * pack_art.c - makes the lumps of a game's pictures and sounds.
 */
#include "pack_parts.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/bytes.h"
#include "../../base/err.h"
#include "../../common/result.h"
#include "../../rom/cart.h"
#include "../../rom/theme.h"
#include "../../sound/tune.h"
#include "blend.h"
#include "bdf.h"
#include "../../common/files.h"
#include "map.h"
#include "../../player/picture/shade.h"
#include "sheet.h"
#include "ttf.h"
#include "../mml/mml.h"
#include "../samples/recording.h"
#include "../../player/picture/png.h"
#include "../../player/picture/border.h"
#include "../../player/picture/icon.h"
#include "../../player/run/sections.h"

/* Warns about pixels that vanish. */
static void warn_faint(struct packer *p, const char *file, const struct art_picture *picture, const uint8_t *marked)
{
    const struct art_faint f = art_find_faint(picture, marked);
    char why[128], sentence[ART_FILE_SIZE + 160];

    if (f.n == 0 || p->warn == NULL)
        return;
    art_faint_describe(picture, &f, why, sizeof why);
    snprintf(sentence, sizeof sentence, "%s: %s", file, why);
    p->warn(p->context, sentence);
}

/* Reads a picture of the folder; free it with art_picture_free. */
static bool load_picture(struct packer *p, const char *file, bool by_index, struct art_picture *out)
{
    char why[256];
    uint8_t *data = NULL;
    size_t size = 0;

    if (!pack_load_named(p, file, TREE_FILE, &data, &size))
        return false;
    bool good = sheet_read_png(out, data, size, by_index, why, sizeof why);
    free(data);
    return good ? true : err_set(p->err, p->err_size, "%s: %s", file, why);
}

static bool load_palette(struct packer *p, const char *file, uint8_t rgb[CART_PALETTE_SIZE])
{
    struct art_picture picture;
    char why[256];

    if (!load_picture(p, file, false, &picture))
        return false;
    bool good = art_make_palette(&picture, rgb, why, sizeof why);
    art_picture_free(&picture);
    return good ? true : err_set(p->err, p->err_size, "%s: %s", file, why);
}

static bool add_palettes(struct packer *p)
{
    if (p->art.palette[0] == '\0')
        art_default_palette(p->palette);
    else if (!load_palette(p, p->art.palette, p->palette))
        return false;
    if (!pack_add_copy(p, "palette/", "main", p->palette, sizeof p->palette))
        return false;
    for (int i = 0; i < p->art.n_palettes; i++)
        if (!load_palette(p, p->art.palettes[i].file, p->palettes[i]) ||
            !pack_add_copy(p, "palette/", p->art.palettes[i].name, p->palettes[i], CART_PALETTE_SIZE))
            return false;
    return true;
}

/* Returns the colours of the palette with the name; "" is the main palette. */
static const uint8_t *find_palette(const struct packer *p, const char *name)
{
    for (int i = 0; i < p->art.n_palettes; i++)
        if (strcmp(p->art.palettes[i].name, name) == 0)
            return p->palettes[i];
    return p->palette;
}

/* Returns the number of a palette in the header of a sprite's lump (struct sprite). */
static int palette_number(const struct packer *p, const char *name)
{
    int n = strcmp("main", name) < 0;

    for (int i = 0; i < p->art.n_palettes; i++)
        n += strcmp(p->art.palettes[i].name, name) < 0;
    return name[0] ? n + 1 : 0;
}

static bool add_shades(struct packer *p)
{
    uint8_t tables[CART_SHADES_SIZE];

    shade_make(p->palette, tables);
    if (!pack_add_copy(p, "", "shades", tables, sizeof tables))
        return false;
    for (int i = 0; i < p->art.n_palettes; i++) {
        uint8_t own[CART_SHADES_SIZE];
        shade_make(p->palettes[i], own);
        if (memcmp(own, tables, sizeof own) != 0 &&
            !pack_add_copy(p, "shade/", p->art.palettes[i].name, own, sizeof own))
            return false;
    }
    return true;
}

/* Makes the table of a blend for a palette (malloc). NULL: out of memory. */
static uint8_t *blend_table(struct packer *p, const uint8_t *rgb, int mix)
{
    uint8_t *table = malloc(CART_BLEND_SIZE);

    if (table != NULL && blend_make(rgb, mix, table))
        return table;
    free(table);
    result_set_host_error(p->err, p->err_size, "out of memory");
    return NULL;
}

/* Adds the tables for other palettes, if they differ. */
static bool add_palette_blends(struct packer *p, const struct art_blend *blend, const uint8_t *main)
{
    char folder[ROM_MAX_NAME + 16];

    for (int i = 0; i < p->art.n_palettes && blend->mix > BLEND_RULE; i++) {
        uint8_t *own = blend_table(p, p->palettes[i], blend->mix);
        if (own == NULL)
            return false;
        snprintf(folder, sizeof folder, "blends/%s/", p->art.palettes[i].name);
        if (memcmp(own, main, CART_BLEND_SIZE) == 0)
            free(own);
        else if (!pack_add(p, folder, blend->name, own, CART_BLEND_SIZE))
            return false;
    }
    return true;
}

static bool add_blends(struct packer *p)
{
    for (int i = 0; i < p->art.n_blends; i++) {
        uint8_t *table = blend_table(p, p->palette, p->art.blends[i].mix);
        if (table == NULL || !pack_add(p, "blend/", p->art.blends[i].name, table, CART_BLEND_SIZE) ||
            !add_palette_blends(p, &p->art.blends[i], table))
            return false;
    }
    return true;
}

static bool add_cell_font(struct packer *p)
{
    const char *file = p->art.font;
    struct art_picture picture;
    char why[256];
    uint8_t *data;
    size_t size;

    if (file[0] == '\0')
        return true;
    if (!load_picture(p, file, p->art.by_index, &picture))
        return false;
    bool good = art_make_font(&picture, p->palette, p->nearest, &data, &size, why, sizeof why);
    warn_faint(p, file, &picture, NULL);
    art_picture_free(&picture);
    return good ? pack_add(p, "", "font", data, size) : err_set(p->err, p->err_size, "%s: %s", file, why);
}

static bool read_ttf(struct packer *p, const struct art_font *font, const struct pack_font_chars *wanted,
                     struct pack_font *f)
{
    char why[256];
    uint8_t *data;
    size_t size;

    if (!pack_load_named(p, font->file, TTF_MAX_FILE, &data, &size))
        return false;
    bool good = ttf_read(f, data, size, font->size, wanted, why, sizeof why);
    free(data);
    return good ? true : err_set(p->err, p->err_size, "%s: %s", font->file, why);
}

static bool read_bdf(struct packer *p, const struct art_font *font, const struct pack_font_chars *wanted,
                     struct pack_font *f)
{
    char why[256];
    uint8_t *text;
    size_t size;

    if (!tree_has(&p->files, font->file))
        return pack_refuse_missing(p, font->file);
    if (!pack_load_text(p, font->file, BDF_MAX_FILE, &text, &size))
        return false;
    bool good = bdf_read(f, (const char *)text, size, wanted, why, sizeof why);
    free(text);
    return good ? true : err_set(p->err, p->err_size, "%s: %s", font->file, why);
}

static bool read_cells(struct packer *p, const struct art_font *font, const struct pack_font_chars *wanted,
                       struct pack_font *f)
{
    struct art_picture picture;
    char why[256];
    uint32_t code;

    if (!load_picture(p, font->file, font->by_index, &picture))
        return false;
    warn_faint(p, font->file, &picture, NULL);
    bool good = pack_font_cut(f, &picture, font, wanted, p->palette, p->nearest, why, sizeof why);
    if (good && !pack_font_sort(f, &code)) {
        snprintf(why, sizeof why, "`chars` contains U+%04X twice", (unsigned)code);
        good = false;
    }
    art_picture_free(&picture);
    return good ? true : err_set(p->err, p->err_size, "%s: %s", font->file, why);
}

/* Packs a font with all of ASCII, because numbers are formatted at run time, and with the characters of the game's
 * text. */
static bool add_proportional_font(struct packer *p, const struct art_font *font)
{
    struct pack_font_chars *wanted = malloc(sizeof *wanted);
    struct pack_font f = { 0 };
    uint8_t *data;
    size_t size = 0;

    if (wanted == NULL)
        return result_set_host_error(p->err, p->err_size, "out of memory");
    *wanted = p->shown;
    for (uint32_t c = 32; c < 127; c++)
        pack_font_add(wanted, c);
    pack_font_add_text(wanted, font->extra_chars, strlen(font->extra_chars));
    bool good = font->size != 0 ? read_ttf(p, font, wanted, &f)
                : font->w == 0  ? read_bdf(p, font, wanted, &f)
                                : read_cells(p, font, wanted, &f);
    free(wanted);
    if (good && font->ink)
        pack_font_darken(&f, font->ink);
    if (good && (!font->shadow || pack_font_add_shadow(&f)))
        size = pack_font_make(&f, &data);
    pack_font_free(&f);
    if (!good)
        return false;
    return size > 0 ? pack_add(p, "fonts/", font->name, data, size)
                    : result_set_host_error(p->err, p->err_size, "out of memory");
}

static void warn_left_out(struct packer *p, const struct art_font *font)
{
    char sentence[ART_FILE_SIZE + 160];

    snprintf(sentence, sizeof sentence, "%s: not found; the optional font \"%s\" is left out", font->file, font->name);
    if (p->warn)
        p->warn(p->context, sentence);
}

static bool add_proportional_fonts(struct packer *p)
{
    for (int i = 0; i < p->art.n_fonts; i++) {
        const struct art_font *font = &p->art.fonts[i];
        if (font->optional && !tree_has(&p->files, font->file))
            warn_left_out(p, font);
        else if (!add_proportional_font(p, font))
            return false;
    }
    return true;
}

/* Adds a sprite's lump, and its hitbox if it has one. */
static bool add_sprite_lump(struct packer *p, const struct ase_sprite *made, const struct art_sheet *s)
{
    uint8_t hit[CART_HITBOX_SIZE], *data;
    size_t size;
    char why[256];
    bool pixel;

    if (!art_make_sprite(&made->picture, &made->sprite, s->bank, find_palette(p, s->palette), p->nearest, &data, &size,
                         &pixel, why, sizeof why))
        return pixel && !made->picture.cell
                   ? err_set(p->err, p->err_size, "%s: %s", s->file, why)
                   : err_set(p->err, p->err_size, "%s: sprite \"%s\": %s", s->file, made->sprite.name, why);
    bytes_put16(data + 18, (uint16_t)palette_number(p, s->palette));
    if (!pack_add(p, "gfx/", made->sprite.name, data, size))
        return false;
    cart_pack_hitbox(&made->hit, hit);
    return made->hit.rows == 0 || pack_add_copy(p, "hit/", made->sprite.name, hit, sizeof hit);
}

static bool add_sprite(struct packer *p, const struct sheet *sheet, const struct art_sheet *s,
                       const struct art_sprite *sprite)
{
    struct ase_sprite made;
    char why[256];

    if (!sheet_sprite(sheet, s, sprite, &made, why, sizeof why))
        return err_set(p->err, p->err_size, "%s: sprite \"%s\": %s", s->file, sprite->name, why);
    const bool good = add_sprite_lump(p, &made, s);
    if (good && sheet->is_ase)
        warn_faint(p, s->file, &made.picture, NULL);
    sheet_sprite_close(sheet, &made);
    return good;
}

/* Adds the sprites of a sheet. */
static bool add_sheet(struct packer *p, int i)
{
    const struct art_sheet *s = &p->art.sheets[i];
    struct sheet sheet;
    char why[256];
    uint8_t *data = NULL;
    size_t size = 0;

    if (!pack_load_named(p, s->file, TREE_FILE, &data, &size))
        return false;
    bool good =
        sheet_read(&sheet, s, data, size, why, sizeof why) || err_set(p->err, p->err_size, "%s: %s", s->file, why);
    free(data);
    for (int k = 0; good && k < p->art.n_sprites; k++)
        good = p->art.sprites[k].sheet != i || add_sprite(p, &sheet, s, &p->art.sprites[k]);
    if (good && !sheet.is_ase && p->warn != NULL) {
        uint8_t *marked = sheet_marked(&sheet, &p->art, i);
        if (marked != NULL)
            warn_faint(p, s->file, &sheet.picture, marked);
        free(marked);
    }
    sheet_close(&sheet);
    return good;
}

/* Copies the cells of a map whose rows are in rom.lua. */
static bool copy_rows(struct packer *p, const struct art_map *m, struct map_cells *out)
{
    const size_t n = (size_t)m->cols * (size_t)m->rows;

    *out = (struct map_cells){ .cols = m->cols, .rows = m->rows, .cell = malloc(n * sizeof *out->cell), .tilesets = 1 };
    for (size_t i = 0; out->cell != NULL && i < n; i++)
        out->cell[i] = p->art.cells[(size_t)m->first_cell + i];
    return out->cell != NULL ? true : result_set_host_error(p->err, p->err_size, "out of memory");
}

/* Reads a tileset's file, for map_files. */
static bool load_tileset(void *context, const char *file, uint8_t **text, size_t *n, char *err, size_t err_size)
{
    struct packer *p = context;

    if (!tree_has(&p->files, file))
        return err_set(err, err_size, "%s does not exist", file);
    return pack_load_text(p, file, TREE_FILE, text, n);
}

static bool load_cells(struct packer *p, const struct art_map *m, struct map_cells *out)
{
    const struct map_files files = { load_tileset, p };
    uint8_t *text;
    size_t n;

    if (m->file[0] == '\0')
        return copy_rows(p, m, out);
    if (!tree_portable(m->file))
        return err_set(p->err, p->err_size, "%s: not a valid file name on Windows", m->file);
    if (!tree_has(&p->files, m->file))
        return pack_refuse_missing(p, m->file);
    if (!pack_load_text(p, m->file, TREE_FILE, &text, &n))
        return false;
    bool good = files_has_suffix(m->file, ".csv")
                    ? map_read_csv((const char *)text, n, m->file, m->first_tile, out, p->err, p->err_size)
                    : map_read_tmx((const char *)text, n, m->file, m->layer, &files, out, p->err, p->err_size);
    free(text);
    if (!good || !out->side || !m->tile_size || out->side == m->tile_size)
        return good;
    free(out->cell);
    return err_set(p->err, p->err_size, "rom.lua: maps.%s.size: %d px, but tiles of %s are %d px", m->name,
                   (int)m->tile_size, m->file, out->side);
}

/* Returns the index of the picture in rom.lua for tileset i; -1: an error. */
static int find_picture(struct packer *p, const struct art_map *m, const struct map_cells *cells, int i)
{
    const struct map_tileset *s = &cells->tileset[i];

    if (!cells->match_pictures && m->n_tile_files == 1)
        return 0;
    for (int k = 0; k < m->n_tile_files; k++)
        if (strcmp(m->tile_files[k], s->picture) == 0)
            return k;
    if (s->picture[0] == '\0')
        err_set(p->err, p->err_size, "%s: the tileset's picture is outside the game's folder", s->place);
    else
        err_set(p->err, p->err_size, "%s: the map uses tiles from %s; add it to `tiles` of map \"%s\" in rom.lua",
                s->place, s->picture, m->name);
    return -1;
}

static bool make_map(struct packer *p, const struct art_map *m, const struct map_cells *cells,
                     const struct art_picture *art)
{
    struct map_picture picture[MAP_MAX_TILESETS];
    char where[ART_FILE_SIZE + ART_NAME_SIZE + 16];
    uint8_t *data;
    size_t size;

    snprintf(where, sizeof where, "%s: map \"%s\"", m->file[0] ? m->file : "rom.lua", m->name);
    for (int i = 0; i < cells->tilesets; i++) {
        const int k = find_picture(p, m, cells, i);
        if (k < 0)
            return false;
        picture[i] = (struct map_picture){ &art[k], m->tile_files[k] };
        if (!map_check_columns(cells, i, &picture[i], p->err, p->err_size))
            return false;
    }
    return map_make(cells, where, cells->side ? cells->side : m->tile_size, picture, m->bank,
                    find_palette(p, m->palette), p->nearest, &data, &size, p->err, p->err_size) &&
           pack_add(p, "map/", m->name, data, size);
}

static bool add_map(struct packer *p, const struct art_map *m)
{
    struct art_picture pictures[MAX_ART_TILE_FILES] = { 0 };
    struct map_cells cells;

    if (!load_cells(p, m, &cells))
        return false;
    bool good = true;
    for (int i = 0; good && i < m->n_tile_files; i++) {
        good = load_picture(p, m->tile_files[i], m->by_index, &pictures[i]);
        if (good)
            warn_faint(p, m->tile_files[i], &pictures[i], NULL);
    }
    good = good && make_map(p, m, &cells, pictures);
    for (int i = 0; i < m->n_tile_files; i++)
        art_picture_free(&pictures[i]);
    free(cells.cell);
    return good;
}

/* Adds the tune of a sample file, and its samples separately if it is music. */
static bool make_recording(struct packer *p, const struct art_sound *s, const struct pcm *pcm, bool music, char *why,
                           size_t why_size)
{
    struct recording_bytes tune, wave;

    if (!music)
        return recording_sound(pcm, s, &tune, why, why_size) && pack_add(p, "sound/", s->name, tune.data, tune.n);
    if (!recording_music(pcm, s, p->art.markers, &tune, &wave, why, why_size))
        return false;
    if (pack_add(p, "tune/", s->name, tune.data, tune.n))
        return pack_add(p, "wave/", s->name, wave.data, wave.n);
    free(wave.data);
    return false;
}

static bool add_recording(struct packer *p, const struct art_sound *s, bool music)
{
    struct pcm pcm;
    uint8_t *data;
    size_t n;
    char why[256] = "";

    if (!pack_load_named(p, s->file, TREE_FILE, &data, &n))
        return false;
    bool good = recording_read(s->file, data, n, &s->loop, &pcm, why, sizeof why);
    free(data);
    if (good) {
        good = recording_prepare(&pcm, &s->loop, why, sizeof why) && make_recording(p, s, &pcm, music, why, sizeof why);
        pcm_free(&pcm);
    }
    return good || !why[0] ? good : err_set(p->err, p->err_size, "%s: %s", s->file, why);
}

/* Compiles MML from a file, or from rom.lua. */
static bool compile_mml(struct packer *p, const struct art_sound *s, const char *list, const struct mml_settings *about,
                        uint8_t **tune, size_t *size)
{
    char place[64];
    uint8_t *text;
    size_t n;

    if (s->file[0] == '\0') {
        snprintf(place, sizeof place, "rom.lua: %s.%s.mml", list, s->name);
        return mml_compile(s->mml, strlen(s->mml), place, about, tune, size, p->err, p->err_size);
    }
    if (!pack_load_named(p, s->file, MML_MAX_FILE, &text, &n))
        return false;
    files_strip_bom(text, &n);
    bool good = mml_compile((const char *)text, n, s->file, about, tune, size, p->err, p->err_size);
    free(text);
    return good;
}

/* Returns the sound with the name if it is a sample file; otherwise NULL. */
static const struct art_sound *find_recording(const struct packer *p, const char *name)
{
    for (int i = 0; i < p->art.n_sounds; i++)
        if (strcmp(p->art.sounds[i].name, name) == 0 && art_is_recording(p->art.sounds[i].file))
            return &p->art.sounds[i];
    return NULL;
}

/* Checks the samples that instruments name. */
static bool check_recordings(struct packer *p, const struct art_sound *s, const uint8_t *tune)
{
    const struct tune t = tune_of(tune);
    const char *where = s->file[0] ? s->file : s->name;

    for (int i = 0; i < t.n_insts; i++) {
        const char *sample = inst_sample_name(tune_inst(&t, i));
        const struct art_sound *found = sample[0] ? find_recording(p, sample) : NULL;
        if (sample[0] && !found)
            return err_set(p->err, p->err_size, "%s: \"%s\" is not a sample (.wav, .ogg, .flac) in rom.lua's sounds",
                           where, sample);
        if (found && found->stereo)
            return err_set(p->err, p->err_size, "%s: sample \"%s\" is stereo; instruments need mono samples", where,
                           sample);
    }
    return true;
}

static bool add_sound(struct packer *p, const struct art_sound *s, bool music)
{
    const struct mml_settings about = { .volume = s->volume,
                                        .priority = s->priority,
                                        .limit = s->limit,
                                        .title = s->title,
                                        .duck = s->duck,
                                        .warn = p->warn,
                                        .context = p->context };
    uint8_t *tune;
    size_t size;

    if (art_is_recording(s->file))
        return add_recording(p, s, music);
    if (!compile_mml(p, s, music ? "music" : "sounds", &about, &tune, &size))
        return false;
    if (check_recordings(p, s, tune))
        return pack_add(p, music ? "tune/" : "sound/", s->name, tune, size);
    free(tune);
    return false;
}

bool pack_add_sounds(struct packer *p)
{
    for (int i = 0; i < p->art.n_sounds; i++) {
        pack_progress(p, p->art.sounds[i].name);
        if (!add_sound(p, &p->art.sounds[i], false))
            return false;
    }
    for (int i = 0; i < p->art.n_tunes; i++) {
        pack_progress(p, p->art.tunes[i].name);
        if (!add_sound(p, &p->art.tunes[i], true))
            return false;
    }
    return true;
}

/* Adds the border's PNG file unchanged: the board never draws it, and it has its own colours. */
static bool add_border(struct packer *p)
{
    const char *file = p->art.border;
    char why[256];
    uint8_t *data, *rgba = NULL;
    struct border border;
    size_t size;
    int w, h;

    if (!file[0])
        return true;
    if (!pack_load(p, file, BORDER_MAX_BYTES, &data, &size))
        return false;
    bool good =
        png_read(data, size, &rgba, &w, &h, why, sizeof why) && border_open(&border, rgba, w, h, why, sizeof why);
    free(rgba);
    if (good)
        return pack_add(p, "", BORDER_LUMP, data, size);
    free(data);
    return err_set(p->err, p->err_size, "%s: %s", file, why);
}

/* Adds the icon: a PNG file unchanged, or the name of a sprite. */
static bool add_icon(struct packer *p)
{
    const char *icon = p->art.icon;
    char why[256];
    uint8_t *data;
    size_t size;

    if (!icon[0])
        return true;
    if (!files_has_suffix(icon, ".png"))
        return pack_add_copy(p, "", ICON_LUMP, icon, strlen(icon));
    if (!tree_has(&p->files, icon))
        return pack_refuse_missing(p, icon);
    if (!pack_load(p, icon, ICON_MAX_BYTES, &data, &size))
        return false;
    if (icon_check(data, size, why, sizeof why))
        return pack_add(p, "", ICON_LUMP, data, size);
    free(data);
    return err_set(p->err, p->err_size, "%s: %s", icon, why);
}

static bool add_theme(struct packer *p)
{
    uint8_t lump[THEME_SIZE];

    if (!p->art.theme.is_set)
        return true;
    theme_pack(&p->art.theme, lump);
    return pack_add_copy(p, "", THEME_LUMP, lump, sizeof lump);
}

static bool add_practice(struct packer *p)
{
    const char *word = p->art.practice;

    return !word[0] || pack_add_copy(p, "", PRACTICE_LUMP, word, strlen(word));
}

bool pack_add_art(struct packer *p)
{
    if (!add_palettes(p) || !add_shades(p) || !add_blends(p) || !add_cell_font(p) || !add_proportional_fonts(p) ||
        !add_border(p) || !add_icon(p) || !add_theme(p) || !add_practice(p))
        return false;
    for (int i = 0; i < p->art.n_sheets; i++) {
        pack_progress(p, p->art.sheets[i].file);
        if (!add_sheet(p, i))
            return false;
    }
    for (int i = 0; i < p->art.n_maps; i++) {
        pack_progress(p, p->art.maps[i].name);
        if (!add_map(p, &p->art.maps[i]))
            return false;
    }
    return true;
}
