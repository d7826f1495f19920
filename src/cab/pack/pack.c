/*
 * pack.c - see pack.h. The folder is walked once into a sorted list of paths; each path that belongs into the ROM and
 * each picture that rom.lua names adds a lump to a list; the list is sorted and written. The list owns all it holds, so
 * one close gives everything back wherever packing stopped.
 */
#include "pack.h"

#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../base/bits.h"
#include "../../base/err.h"
#include "../../common/result.h"
#include "../../base/hash.h"
#include "../../base/heap.h"
#include "../../board/board.h"
#include "../../rom/cart.h"
#include "../../rom/compressed.h"
#include "../../script/script.h"
#include "../../script/std.h"
#include "../../sound/tune.h"
#include "art.h"
#include "../bulletml/compile.h"
#include "../bulletml/document.h"
#include "../tables/blend.h"
#include "bdf.h"
#include "faces.h"
#include "lang.h"
#include "../../common/files.h"
#include "../host/progress.h"
#include "map.h"
#include "../tables/shade.h"
#include "sheet.h"
#include "../mml/mml.h"
#include "../sound/recording.h"
#include "tree.h"
#include "png.h"
#include "../picture/border.h"
#include "icon.h"

enum { PATH = TREE_PATH };

/* ---- the lumps ---- */

struct lumps {
    struct lump *lump; /* names and data are malloc */
    int n, room;
};

static void lumps_close(struct lumps *l)
{
    for (int i = 0; i < l->n; i++) {
        free((void *)(uintptr_t)l->lump[i].name);
        free((void *)(uintptr_t)l->lump[i].data);
    }
    free(l->lump);
}

static bool lumps_grow(struct lumps *l)
{
    int room = l->room == 0 ? 64 : l->room * 2;
    struct lump *more = realloc(l->lump, (size_t)room * sizeof *more);

    if (more == NULL)
        return false;
    l->lump = more;
    l->room = room;
    return true;
}

/* ---- packing ---- */

struct packer {
    const char *dir;
    bool nearest;
    struct tree files;
    struct lumps lumps;
    struct manifest m;
    struct art art;
    uint8_t palette[CART_PALETTE], palettes[MAX_ART_PALETTES][CART_PALETTE]; /* the first one, and art.palettes */
    struct faces_set shown;                                                  /* characters of the game's texts */
    char *rom_text;                                    /* of rom.lua, malloc, with a 0 behind it */
    uint64_t std;                                      /* modules that the scripts so far name (std.h) */
    void (*warn)(void *context, const char *sentence); /* NULL: nobody is told */
    void *context;
    int told; /* files that progress was told of */
    char *err;
    size_t err_size;
};

/* Adds the lump folder + name; data (malloc) is the list's from here, also when this fails. */
static bool add(struct packer *p, const char *folder, const char *name, uint8_t *data, size_t size)
{
    size_t n = strlen(folder) + strlen(name) + 1;
    char *full = malloc(n);

    if (full == NULL || (p->lumps.n == p->lumps.room && !lumps_grow(&p->lumps))) {
        free(full);
        free(data);
        return result_host(p->err, p->err_size, "out of memory");
    }
    snprintf(full, n, "%s%s", folder, name);
    p->lumps.lump[p->lumps.n++] = (struct lump){ full, data, (uint32_t)size };
    return n <= ROM_NAME ? true : err_set(p->err, p->err_size, "%s: name too long", name);
}

static bool add_copy(struct packer *p, const char *folder, const char *name, const void *data, size_t size)
{
    uint8_t *copy = malloc(size + 1);

    if (copy == NULL)
        return result_host(p->err, p->err_size, "out of memory");
    memcpy(copy, data, size);
    return add(p, folder, name, copy, size);
}

/* One more of the files that go in. */
static void tell(struct packer *p, const char *file)
{
    const int all = p->files.n + p->art.n_sheets + p->art.n_maps + p->art.n_sounds + p->art.n_tunes;

    progress_tell((uint64_t)p->told++, (uint64_t)all, "packing %s", file);
}

static bool load_in(struct packer *p, const char *name, size_t max, uint8_t **data, size_t *size)
{
    char path[PATH];

    if (!tree_join(path, p->dir, name))
        return err_set(p->err, p->err_size, "%s: path too long", name);
    return files_read(path, name, max, data, size, p->err, p->err_size);
}

static bool load_text(struct packer *p, const char *name, size_t max, uint8_t **text, size_t *size)
{
    char path[PATH];

    if (!tree_join(path, p->dir, name))
        return err_set(p->err, p->err_size, "%s: path too long", name);
    return files_read_text(path, name, max, text, size, p->err, p->err_size);
}

static bool ends_with(const char *s, const char *tail)
{
    size_t n = strlen(s), m = strlen(tail);

    return n > m && strcmp(s + n - m, tail) == 0;
}

static bool starts_with(const char *s, const char *head)
{
    return strncmp(s, head, strlen(head)) == 0;
}

static bool read_manifest(struct packer *p)
{
    char folder[64];
    uint8_t *text;
    size_t size;

    if (!load_text(p, "rom.lua", TREE_SCRIPT, &text, &size))
        return false;
    tree_id(p->dir, folder);
    void *block, *work = tree_work(MANIFEST_WORK, &block);
    bool good = work != NULL ? manifest_read((const char *)text, size, "rom.lua", folder, &p->m, &p->art, work, p->err,
                                             p->err_size)
                             : result_host(p->err, p->err_size, "out of memory");
    free(block);
    p->rom_text = realloc(text, size + 1);
    if (p->rom_text == NULL) {
        free(text);
        return result_host(p->err, p->err_size, "out of memory");
    }
    p->rom_text[size] = '\0';
    return good;
}

static bool add_manifest(struct packer *p)
{
    uint8_t bytes[MANIFEST_BYTES];
    const size_t size = manifest_pack(&p->m, bytes);

    return add_copy(p, "", "manifest", bytes, size);
}

/* Does p stand behind -- in its line? */
static bool in_comment(const char *text, const char *p)
{
    for (; p > text && p[-1] != '\n'; p--)
        if (p[0] == '-' && p[-1] == '-')
            return true;
    return false;
}

/* The line of rom.lua that spells the file's name; 0: none does. */
static int line_of(const char *text, const char *file)
{
    size_t n = strlen(file);
    int line = 1;

    for (const char *p = text; *p != '\0'; line += *p++ == '\n')
        if ((*p == '"' || *p == '\'') && strncmp(p + 1, file, n) == 0 && p[n + 1] == *p && !in_comment(text, p))
            return line;
    return 0;
}

static bool refuse_missing(struct packer *p, const char *file)
{
    int line = line_of(p->rom_text, file);

    if (line > 0)
        return err_set(p->err, p->err_size, "rom.lua:%d: %s does not exist", line, file);
    return err_set(p->err, p->err_size, "rom.lua: %s does not exist", file);
}

/* A file that rom.lua names, whole. */
static bool load_named(struct packer *p, const char *file, size_t most, uint8_t **data, size_t *size)
{
    if (!tree_portable(file))
        return err_set(p->err, p->err_size, "%s: not a valid file name on Windows", file);
    if (!tree_has(&p->files, file))
        return refuse_missing(p, file);
    return load_in(p, file, most, data, size);
}

/* Tells of pixels that nobody will see. */
static void tell_faint(struct packer *p, const char *file, const struct art_picture *picture, const uint8_t *marked)
{
    const struct art_faint f = art_find_faint(picture, marked);
    char why[128], sentence[ART_FILE + 160];

    if (f.n == 0 || p->warn == NULL)
        return;
    art_faint_say(picture, &f, why, sizeof why);
    snprintf(sentence, sizeof sentence, "%s: %s", file, why);
    p->warn(p->context, sentence);
}

/* A picture of the folder into *out (art_picture_free). */
static bool load_picture(struct packer *p, const char *file, bool by_index, struct art_picture *out)
{
    char why[256];
    uint8_t *data = NULL;
    size_t size = 0;

    if (!load_named(p, file, TREE_FILE, &data, &size))
        return false;
    bool good = sheet_read_png(out, data, size, by_index, why, sizeof why);
    free(data);
    return good ? true : err_set(p->err, p->err_size, "%s: %s", file, why);
}

static bool load_palette(struct packer *p, const char *file, uint8_t rgb[CART_PALETTE])
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
    if (!add_copy(p, "palette/", "main", p->palette, sizeof p->palette))
        return false;
    for (int i = 0; i < p->art.n_palettes; i++)
        if (!load_palette(p, p->art.palettes[i].file, p->palettes[i]) ||
            !add_copy(p, "palette/", p->art.palettes[i].name, p->palettes[i], CART_PALETTE))
            return false;
    return true;
}

/* The colours of a sheet, or of a map's tiles. */
static const uint8_t *palette_of(const struct packer *p, const char *name)
{
    for (int i = 0; i < p->art.n_palettes; i++)
        if (strcmp(p->art.palettes[i].name, name) == 0)
            return p->palettes[i];
    return p->palette;
}

static bool add_shades(struct packer *p)
{
    uint8_t tables[CART_SHADES];

    shade_make(p->palette, tables);
    if (!add_copy(p, "", "shades", tables, sizeof tables))
        return false;
    for (int i = 0; i < p->art.n_palettes; i++) {
        uint8_t own[CART_SHADES];
        shade_make(p->palettes[i], own);
        if (memcmp(own, tables, sizeof own) != 0 && !add_copy(p, "shade/", p->art.palettes[i].name, own, sizeof own))
            return false;
    }
    return true;
}

/* The table of a blend in one palette; malloc. NULL: out of memory. */
static uint8_t *blend_table(struct packer *p, const uint8_t *rgb, int mix)
{
    uint8_t *table = malloc(CART_BLEND);

    if (table != NULL && blend_make(rgb, mix, table))
        return table;
    free(table);
    result_host(p->err, p->err_size, "out of memory");
    return NULL;
}

/* Tables of the other palettes, where they differ. */
static bool add_blend_looks(struct packer *p, const struct art_blend *blend, const uint8_t *main)
{
    char folder[ROM_NAME + 16];

    for (int i = 0; i < p->art.n_palettes && blend->mix > BLEND_RULE; i++) {
        uint8_t *own = blend_table(p, p->palettes[i], blend->mix);
        if (own == NULL)
            return false;
        snprintf(folder, sizeof folder, "blends/%s/", p->art.palettes[i].name);
        if (memcmp(own, main, CART_BLEND) == 0)
            free(own);
        else if (!add(p, folder, blend->name, own, CART_BLEND))
            return false;
    }
    return true;
}

static bool add_blends(struct packer *p)
{
    for (int i = 0; i < p->art.n_blends; i++) {
        uint8_t *table = blend_table(p, p->palette, p->art.blends[i].mix);
        if (table == NULL || !add(p, "blend/", p->art.blends[i].name, table, CART_BLEND) ||
            !add_blend_looks(p, &p->art.blends[i], table))
            return false;
    }
    return true;
}

static bool add_font(struct packer *p)
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
    tell_faint(p, file, &picture, NULL);
    art_picture_free(&picture);
    return good ? add(p, "", "font", data, size) : err_set(p->err, p->err_size, "%s: %s", file, why);
}

static bool read_bdf(struct packer *p, const struct art_font *font, const struct faces_set *wanted, struct faces *f)
{
    char why[256];
    uint8_t *text;
    size_t size;

    if (!tree_has(&p->files, font->file))
        return refuse_missing(p, font->file);
    if (!load_text(p, font->file, BDF_FILE, &text, &size))
        return false;
    bool good = bdf_read(f, (const char *)text, size, wanted, why, sizeof why);
    free(text);
    return good ? true : err_set(p->err, p->err_size, "%s: %s", font->file, why);
}

static bool read_cells(struct packer *p, const struct art_font *font, const struct faces_set *wanted, struct faces *f)
{
    struct art_picture picture;
    char why[256];
    uint32_t code;

    if (!load_picture(p, font->file, font->by_index, &picture))
        return false;
    tell_faint(p, font->file, &picture, NULL);
    bool good = faces_cut(f, &picture, font, wanted, p->palette, p->nearest, why, sizeof why);
    if (good && !faces_sort(f, &code)) {
        snprintf(why, sizeof why, "`chars` contains U+%04X twice", (unsigned)code);
        good = false;
    }
    art_picture_free(&picture);
    return good ? true : err_set(p->err, p->err_size, "%s: %s", font->file, why);
}

/* Of a font only what the game's texts need comes into the ROM; of ASCII all, for numbers are made as it runs. */
static bool add_face(struct packer *p, const struct art_font *font)
{
    struct faces_set *wanted = malloc(sizeof *wanted);
    struct faces f = { 0 };
    uint8_t *data;
    size_t size = 0;

    if (wanted == NULL)
        return result_host(p->err, p->err_size, "out of memory");
    *wanted = p->shown;
    for (uint32_t c = 32; c < 127; c++)
        faces_add(wanted, c);
    faces_add_text(wanted, font->also, strlen(font->also));
    bool good = font->w == 0 ? read_bdf(p, font, wanted, &f) : read_cells(p, font, wanted, &f);
    free(wanted);
    if (good && (!font->shadow || faces_shadow(&f)))
        size = faces_make(&f, &data);
    faces_close(&f);
    if (!good)
        return false;
    return size > 0 ? add(p, "fonts/", font->name, data, size) : result_host(p->err, p->err_size, "out of memory");
}

static bool add_faces(struct packer *p)
{
    for (int i = 0; i < p->art.n_fonts; i++)
        if (!add_face(p, &p->art.fonts[i]))
            return false;
    return true;
}

/* Adds what became of a sprite, and its hit shape if one was drawn. */
static bool add_made(struct packer *p, const struct ase_sprite *made, const struct art_sheet *s)
{
    uint8_t hit[CART_HIT], *data;
    size_t size;
    char why[256];
    bool pixel;

    if (!art_make_sprite(&made->picture, &made->sprite, s->bank, palette_of(p, s->palette), p->nearest, &data, &size,
                         &pixel, why, sizeof why))
        return pixel && !made->picture.cell
                   ? err_set(p->err, p->err_size, "%s: %s", s->file, why)
                   : err_set(p->err, p->err_size, "%s: sprite \"%s\": %s", s->file, made->sprite.name, why);
    if (!add(p, "gfx/", made->sprite.name, data, size))
        return false;
    cart_hit_pack(&made->hit, hit);
    return made->hit.rows == 0 || add_copy(p, "hit/", made->sprite.name, hit, sizeof hit);
}

static bool add_sprite(struct packer *p, const struct sheet *sheet, const struct art_sheet *s,
                       const struct art_sprite *sprite)
{
    struct ase_sprite made;
    char why[256];

    if (!sheet_sprite(sheet, s, sprite, &made, why, sizeof why))
        return err_set(p->err, p->err_size, "%s: sprite \"%s\": %s", s->file, sprite->name, why);
    const bool good = add_made(p, &made, s);
    if (good && sheet->is_ase)
        tell_faint(p, s->file, &made.picture, NULL);
    sheet_sprite_close(sheet, &made);
    return good;
}

/* The sprites of one sheet. */
static bool add_sheet(struct packer *p, int i)
{
    const struct art_sheet *s = &p->art.sheets[i];
    struct sheet sheet;
    char why[256];
    uint8_t *data = NULL;
    size_t size = 0;

    if (!load_named(p, s->file, TREE_FILE, &data, &size))
        return false;
    bool good =
        sheet_read(&sheet, s, data, size, why, sizeof why) || err_set(p->err, p->err_size, "%s: %s", s->file, why);
    free(data);
    for (int k = 0; good && k < p->art.n_sprites; k++)
        good = p->art.sprites[k].sheet != i || add_sprite(p, &sheet, s, &p->art.sprites[k]);
    if (good && !sheet.is_ase && p->warn != NULL) {
        uint8_t *marked = sheet_marked(&sheet, &p->art, i);
        if (marked != NULL)
            tell_faint(p, s->file, &sheet.picture, marked);
        free(marked);
    }
    sheet_close(&sheet);
    return good;
}

/* The cells of a map whose rows are in rom.lua. */
static bool rows_of(struct packer *p, const struct art_map *m, struct map_cells *out)
{
    const size_t n = (size_t)m->cols * (size_t)m->rows;

    *out = (struct map_cells){ .cols = m->cols, .rows = m->rows, .cell = malloc(n * sizeof *out->cell), .sheets = 1 };
    for (size_t i = 0; out->cell != NULL && i < n; i++)
        out->cell[i] = p->art.cells[(size_t)m->cells + i];
    return out->cell != NULL ? true : result_host(p->err, p->err_size, "out of memory");
}

/* A tileset that a map names. */
static bool load_tileset(void *context, const char *file, uint8_t **text, size_t *n, char *err, size_t err_size)
{
    struct packer *p = context;

    if (!tree_has(&p->files, file))
        return err_set(err, err_size, "%s does not exist", file);
    return load_text(p, file, TREE_FILE, text, n);
}

static bool load_cells(struct packer *p, const struct art_map *m, struct map_cells *out)
{
    const struct map_files files = { load_tileset, p };
    uint8_t *text;
    size_t n;

    if (m->file[0] == '\0')
        return rows_of(p, m, out);
    if (!tree_portable(m->file))
        return err_set(p->err, p->err_size, "%s: not a valid file name on Windows", m->file);
    if (!tree_has(&p->files, m->file))
        return refuse_missing(p, m->file);
    if (!load_text(p, m->file, TREE_FILE, &text, &n))
        return false;
    bool good = ends_with(m->file, ".csv")
                    ? map_read_csv((const char *)text, n, m->file, m->first, out, p->err, p->err_size)
                    : map_read_tmx((const char *)text, n, m->file, m->layer, &files, out, p->err, p->err_size);
    free(text);
    if (!good || !out->side || !m->size || out->side == m->size)
        return good;
    free(out->cell);
    return err_set(p->err, p->err_size, "rom.lua: maps.%s.size: %d px, but tiles of %s are %d px", m->name,
                   (int)m->size, m->file, out->side);
}

/* Which picture of rom.lua sheet i is cut from; -1 with a sentence. */
static int picture_of(struct packer *p, const struct art_map *m, const struct map_cells *cells, int i)
{
    const struct map_sheet *s = &cells->sheet[i];

    if (!cells->named && m->n_tiles == 1)
        return 0;
    for (int k = 0; k < m->n_tiles; k++)
        if (strcmp(m->tiles[k], s->picture) == 0)
            return k;
    if (s->picture[0] == '\0')
        err_set(p->err, p->err_size, "%s: the tileset's picture is outside the game's folder", s->place);
    else
        err_set(p->err, p->err_size, "%s: the map uses tiles from %s; add it to `tiles` of map \"%s\" in rom.lua",
                s->place, s->picture, m->name);
    return -1;
}

/* Makes the lump of a map whose pictures were read. */
static bool make_map(struct packer *p, const struct art_map *m, const struct map_cells *cells,
                     const struct art_picture *art)
{
    struct map_picture picture[MAP_SHEETS];
    char where[ART_FILE + ART_NAME + 16];
    uint8_t *data;
    size_t size;

    snprintf(where, sizeof where, "%s: map \"%s\"", m->file[0] ? m->file : "rom.lua", m->name);
    for (int i = 0; i < cells->sheets; i++) {
        const int k = picture_of(p, m, cells, i);
        if (k < 0)
            return false;
        picture[i] = (struct map_picture){ &art[k], m->tiles[k] };
        if (!map_fits(cells, i, &picture[i], p->err, p->err_size))
            return false;
    }
    return map_make(cells, where, cells->side ? cells->side : m->size, picture, m->bank, palette_of(p, m->palette),
                    p->nearest, &data, &size, p->err, p->err_size) &&
           add(p, "map/", m->name, data, size);
}

static bool add_map(struct packer *p, const struct art_map *m)
{
    struct art_picture pictures[ART_TILES] = { 0 };
    struct map_cells cells;

    if (!load_cells(p, m, &cells))
        return false;
    bool good = true;
    for (int i = 0; good && i < m->n_tiles; i++) {
        good = load_picture(p, m->tiles[i], m->by_index, &pictures[i]);
        if (good)
            tell_faint(p, m->tiles[i], &pictures[i], NULL);
    }
    good = good && make_map(p, m, &cells, pictures);
    for (int i = 0; i < m->n_tiles; i++)
        art_picture_free(&pictures[i]);
    free(cells.cell);
    return good;
}

/* Adds what a recording becomes: a tune, and of music its samples. */
static bool make_recording(struct packer *p, const struct art_sound *s, const struct pcm *pcm, bool music, char *why,
                           size_t why_size)
{
    struct recording_bytes tune, wave;

    if (!music)
        return recording_sound(pcm, s, &tune, why, why_size) && add(p, "sound/", s->name, tune.data, tune.n);
    if (!recording_music(pcm, s, p->art.markers, &tune, &wave, why, why_size))
        return false;
    if (add(p, "tune/", s->name, tune.data, tune.n))
        return add(p, "wave/", s->name, wave.data, wave.n);
    free(wave.data);
    return false;
}

static bool add_recording(struct packer *p, const struct art_sound *s, bool music)
{
    struct pcm pcm;
    uint8_t *data;
    size_t n;
    char why[256] = "";

    if (!load_named(p, s->file, TREE_FILE, &data, &n))
        return false;
    bool good = recording_read(s->file, data, n, &s->loop, &pcm, why, sizeof why);
    free(data);
    if (good) {
        good = recording_prepare(&pcm, &s->loop, why, sizeof why) && make_recording(p, s, &pcm, music, why, sizeof why);
        pcm_free(&pcm);
    }
    return good || !why[0] ? good : err_set(p->err, p->err_size, "%s: %s", s->file, why);
}

/* The tune of a text: a file's, or one in rom.lua. */
static bool compile_mml(struct packer *p, const struct art_sound *s, const char *list, const struct mml_about *about,
                        uint8_t **tune, size_t *size)
{
    char place[64];
    uint8_t *text;
    size_t n;

    if (s->file[0] == '\0') {
        snprintf(place, sizeof place, "rom.lua: %s.%s.mml", list, s->name);
        return mml_compile(s->mml, strlen(s->mml), place, about, tune, size, p->err, p->err_size);
    }
    if (!load_named(p, s->file, MML_FILE, &text, &n))
        return false;
    files_drop_mark(text, &n);
    bool good = mml_compile((const char *)text, n, s->file, about, tune, size, p->err, p->err_size);
    free(text);
    return good;
}

/* The sound of that name if it is a recording; else NULL. */
static const struct art_sound *find_recording(const struct packer *p, const char *name)
{
    for (int i = 0; i < p->art.n_sounds; i++)
        if (strcmp(p->art.sounds[i].name, name) == 0 && art_is_recording(p->art.sounds[i].file))
            return &p->art.sounds[i];
    return NULL;
}

/* Instruments name recordings of `sounds`. */
static bool check_recordings(struct packer *p, const struct art_sound *s, const uint8_t *tune)
{
    const struct tune t = tune_of(tune);
    const char *where = s->file[0] ? s->file : s->name;

    for (int i = 0; i < t.insts; i++) {
        const char *sample = inst_sample(tune_inst(&t, i));
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
    const struct mml_about about = { .volume = s->volume,
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
        return add(p, music ? "tune/" : "sound/", s->name, tune, size);
    free(tune);
    return false;
}

static bool add_sounds(struct packer *p)
{
    for (int i = 0; i < p->art.n_sounds; i++) {
        tell(p, p->art.sounds[i].name);
        if (!add_sound(p, &p->art.sounds[i], false))
            return false;
    }
    for (int i = 0; i < p->art.n_tunes; i++) {
        tell(p, p->art.tunes[i].name);
        if (!add_sound(p, &p->art.tunes[i], true))
            return false;
    }
    return true;
}

/* The art round the picture goes in as it is: the board never sees it, and it has colours of its own. */
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
    if (!load_in(p, file, BORDER_BYTES, &data, &size))
        return false;
    bool good =
        png_read(data, size, &rgba, &w, &h, why, sizeof why) && border_open(&border, rgba, w, h, why, sizeof why);
    free(rgba);
    if (good)
        return add(p, "", BORDER_LUMP, data, size);
    free(data);
    return err_set(p->err, p->err_size, "%s: %s", file, why);
}

/* A file goes in as it is, a sprite by its name. */
static bool add_icon(struct packer *p)
{
    const char *icon = p->art.icon;
    char why[256];
    uint8_t *data;
    size_t size;

    if (!icon[0])
        return true;
    if (!ends_with(icon, ".png"))
        return add_copy(p, "", ICON_LUMP, icon, strlen(icon));
    if (!tree_has(&p->files, icon))
        return refuse_missing(p, icon);
    if (!load_in(p, icon, ICON_BYTES, &data, &size))
        return false;
    if (icon_check(data, size, why, sizeof why))
        return add(p, "", ICON_LUMP, data, size);
    free(data);
    return err_set(p->err, p->err_size, "%s: %s", icon, why);
}

static bool add_art(struct packer *p)
{
    if (!add_palettes(p) || !add_shades(p) || !add_blends(p) || !add_font(p) || !add_faces(p) || !add_border(p) ||
        !add_icon(p))
        return false;
    for (int i = 0; i < p->art.n_sheets; i++) {
        tell(p, p->art.sheets[i].file);
        if (!add_sheet(p, i))
            return false;
    }
    for (int i = 0; i < p->art.n_maps; i++) {
        tell(p, p->art.maps[i].name);
        if (!add_map(p, &p->art.maps[i]))
            return false;
    }
    return true;
}

bool pack_is_lang(const char *path)
{
    return starts_with(path, "lang/") && ends_with(path + strlen("lang/"), ".txt");
}

bool pack_is_std(const char *path)
{
    for (int i = 0; i < std_script_count; i++) {
        size_t n = strlen(std_scripts[i].name);
        if (strncmp(path + 4, std_scripts[i].name, n) == 0 && strcmp(path + 4 + n, ".lua") == 0)
            return true;
    }
    return false;
}

static bool add_script(struct packer *p, const char *path)
{
    bool std = starts_with(path, "std/");
    char chunk[PATH];
    uint8_t *text;
    size_t size;

    if (std && !pack_is_std(path))
        return err_set(p->err, p->err_size, "%s: the standard library has no script with this name", path);
    if (!load_text(p, path, TREE_SCRIPT, &text, &size))
        return false;
    snprintf(chunk, sizeof chunk, "@%s", path);
    void *block, *work = tree_work(TREE_WORK, &block);
    bool good = work != NULL ? script_check((const char *)text, size, chunk, work, TREE_WORK, p->err, p->err_size)
                             : result_host(p->err, p->err_size, "out of memory");
    free(block);
    if (!good) {
        free(text);
        return false;
    }
    p->std |= std_named((const char *)text, size);
    if (p->art.n_fonts > 0)
        faces_add_script(&p->shown, (const char *)text, size);
    return std ? add(p, "script/@std/", path + 4, text, size) : add(p, "script/", path, text, size);
}

/* demos/NAME.demo is the lump demo/NAME. */
static bool add_demo(struct packer *p, const char *path)
{
    char name[PATH];
    uint8_t *data;
    size_t size;

    if (!load_in(p, path, TREE_FILE, &data, &size))
        return false;
    snprintf(name, sizeof name, "%.*s", (int)(strlen(path) - strlen("demos/") - strlen(".demo")),
             path + strlen("demos/"));
    return add(p, "demo/", name, data, size);
}

static bool add_text(struct packer *p, const char *path)
{
    uint8_t *data;
    size_t size;

    if (!load_text(p, path, TREE_FILE, &data, &size))
        return false;
    if (size > MAX_TEXT) {
        free(data);
        return err_set(p->err, p->err_size, "%s: expected text of at most %d bytes, got %zu", path, (int)MAX_TEXT,
                       size);
    }
    return add(p, "data/", path, data, size);
}

/* lang/NAME.txt is the lump lang/NAME. */
static bool add_lang(struct packer *p, const char *path)
{
    char name[PATH];
    uint8_t *text, *data;
    struct lang lang;
    size_t size;

    snprintf(name, sizeof name, "%.*s", (int)(strlen(path) - strlen("lang/") - strlen(".txt")), path + strlen("lang/"));
    if (!manifest_word_ok(name))
        return err_set(p->err, p->err_size, "%s: expected a language name of 1 to %d letters, digits, _ and -", path,
                       MAX_WORD - 1);
    if (!load_text(p, path, LANG_FILE, &text, &size))
        return false;
    bool good = lang_read(&lang, (const char *)text, size, path, p->err, p->err_size);
    for (int i = 0; good && i < lang.n; i++)
        faces_add_text(&p->shown, lang.list[i].words, strlen(lang.list[i].words));
    size = good ? lang_make(&lang, &data) : 0;
    lang_close(&lang);
    free(text);
    if (!good)
        return false;
    return size > 0 ? add(p, "lang/", name, data, size) : result_host(p->err, p->err_size, "out of memory");
}

bool pack_is_bulletml(const char *path)
{
    return starts_with(path, "bulletml/") && ends_with(path + strlen("bulletml/"), ".xml");
}

/* The name of a document: what stands behind bulletml/, with _ for what no file of a ROM has in its name. Collections
 * have names such as "[game] boss 2.xml". */
static void name_bulletml(const char *path, char name[PATH])
{
    const char *from = path + strlen("bulletml/");
    const int n = (int)(strlen(from) - strlen(".xml"));

    snprintf(name, PATH, "%.*s", n, from);
    for (char *c = name; *c != '\0'; c++)
        if (strchr("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./", *c) == NULL)
            *c = '_';
}

/* Is it no document's that is in already? */
static bool name_free(const struct packer *p, const char *name)
{
    for (int i = 0; i < p->lumps.n; i++)
        if (starts_with(p->lumps.lump[i].name, "bulletml/") &&
            strcmp(p->lumps.lump[i].name + strlen("bulletml/"), name) == 0)
            return false;
    return true;
}

/* A document becomes the program that the board runs. */
static bool add_bulletml(struct packer *p, const char *path)
{
    char name[PATH];
    uint8_t *text, *data = NULL;
    struct document d;
    size_t size;

    if (!load_in(p, path, DOCUMENT_FILE, &text, &size))
        return false;
    const bool good = document_read(&d, (const char *)text, size, path, p->warn, p->context, p->err, p->err_size) &&
                      bulletml_compile(&d, path, &data, &size, p->err, p->err_size);
    document_close(&d);
    free(text);
    name_bulletml(path, name);
    if (good && !name_free(p, name)) {
        free(data);
        return err_set(p->err, p->err_size, "%s: another document is also packed as \"%s\"", path, name);
    }
    return good && add(p, "bulletml/", name, data, size);
}

/* Documents are there for a game that has room to run them. */
static bool goes_in(const struct packer *p, const char *path)
{
    return ends_with(path, ".txt") || (p->m.bulletml > 0 && pack_is_bulletml(path));
}

static bool add_file(struct packer *p, const char *path)
{
    bool lua = ends_with(path, ".lua"), demo = starts_with(path, "demos/") && ends_with(path + 6, ".demo");

    if (strcmp(path, "rom.lua") == 0 || (!lua && !demo && !goes_in(p, path)))
        return true;
    if (!manifest_path_ok(path) && !pack_is_bulletml(path))
        return err_set(p->err, p->err_size, "%s: expected a name of letters, digits, _ - and . only", path);
    if (!tree_portable(path))
        return err_set(p->err, p->err_size, "%s: not a valid file name on Windows", path);
    return lua                       ? add_script(p, path)
           : demo                    ? add_demo(p, path)
           : pack_is_lang(path)      ? add_lang(p, path)
           : ends_with(path, ".txt") ? add_text(p, path)
                                     : add_bulletml(p, path);
}

static bool add_files(struct packer *p)
{
    char path[PATH];
    const char *a, *b;

    if (tree_twins(&p->files, &a, &b))
        return err_set(p->err, p->err_size, "%s and %s differ only in case; on some systems they are the same file", a,
                       b);
    snprintf(path, sizeof path, "%s.lua", p->m.entry);
    if (!tree_has(&p->files, path))
        return err_set(p->err, p->err_size, "rom.lua: entry: %s does not exist", path);
    for (int i = 0; i < p->files.n; i++) {
        tell(p, p->files.name[i]);
        if (!add_file(p, p->files.name[i]))
            return false;
    }
    return true;
}

static bool replaced(const struct packer *p, const char *name)
{
    char path[PATH];

    snprintf(path, sizeof path, "std/%s.lua", name);
    return tree_has(&p->files, path);
}

static const struct embedded *library(const char *name)
{
    for (int i = 0; i < std_script_count; i++)
        if (strcmp(std_scripts[i].name, name) == 0)
            return &std_scripts[i];
    return NULL;
}

/* Modules the game has of its own are in the ROM whether something names them or not. */
static uint64_t own_modules(const struct packer *p)
{
    uint64_t own = 0;

    for (int i = 0; i < STD_MODULES; i++)
        own |= (uint64_t)replaced(p, std_module(i)) << i;
    return own;
}

static bool add_module(struct packer *p, const struct embedded *s)
{
    char file[PATH];

    snprintf(file, sizeof file, "%s.lua", s->name);
    return add_copy(p, "script/@std/", file, s->data, s->size);
}

/* The pieces of the modules that are there; the game's own are there already. */
static bool add_pieces(struct packer *p)
{
    for (int i = 0; i < std_script_count; i++) {
        int of = std_piece_of(std_scripts[i].name);
        if (of >= 0 && p->std >> of & 1 && !replaced(p, std_scripts[i].name) && !add_module(p, &std_scripts[i]))
            return false;
    }
    return true;
}

/* What the game's scripts name, and what these modules name in their turn; the prelude comes along with any other. */
static bool add_std(struct packer *p)
{
    uint64_t in = own_modules(p), missing;

    p->std |= (p->std | in) != 0 ? 1 : 0;
    while ((missing = p->std & ~in) != 0) {
        int i = (int)bits_lowest(missing);
        const struct embedded *s = library(std_module(i));
        if (!add_module(p, s))
            return false;
        p->std |= std_needed(i, (const char *)s->data, s->size);
        in |= (uint64_t)1 << i;
    }
    return add_pieces(p);
}

static int by_name(const void *a, const void *b)
{
    return strcmp(((const struct lump *)a)->name, ((const struct lump *)b)->name);
}

/* What was packed must be what the board takes. */
static bool check_image(const uint8_t *image, size_t size, struct rom *rom, char *err, size_t err_size)
{
    size_t ram;

    return rom_open(rom, image, size, err, err_size) && board_size(rom, &ram, err, err_size);
}

static bool write_image(struct packer *p, uint8_t **image, size_t *size)
{
    struct rom rom;

    qsort(p->lumps.lump, (size_t)p->lumps.n, sizeof p->lumps.lump[0], by_name);
    *size = rom_write_size(p->lumps.lump, p->lumps.n);
    *image = NULL;
    if (*size == 0)
        return err_set(p->err, p->err_size, "too large for a ROM");
    *image = malloc(*size);
    if (*image == NULL)
        return result_host(p->err, p->err_size, "out of memory");
    rom_write(*image, p->lumps.lump, p->lumps.n);
    if (check_image(*image, *size, &rom, p->err, p->err_size))
        return true;
    free(*image);
    *image = NULL;
    return false;
}

static bool gather(struct packer *p)
{
    if (!tree_walk(p->dir, &p->files, p->err, p->err_size))
        return false;
    return read_manifest(p) && add_manifest(p) && add_files(p) && add_std(p) && add_art(p) && add_sounds(p);
}

bool pack_folder(const char *dir, bool nearest, uint8_t **image, size_t *size, char *err, size_t err_size)
{
    return pack_folder_told(dir, nearest, NULL, NULL, image, size, err, err_size);
}

bool pack_folder_told(const char *dir, bool nearest, void (*warn)(void *context, const char *sentence), void *context,
                      uint8_t **image, size_t *size, char *err, size_t err_size)
{
    struct packer *p = calloc(1, sizeof *p);

    if (p == NULL)
        return result_host(err, err_size, "out of memory");
    p->dir = dir;
    p->nearest = nearest;
    p->warn = warn;
    p->context = context;
    p->err = err;
    p->err_size = err_size;
    bool good = gather(p) && write_image(p, image, size);
    tree_close(&p->files);
    lumps_close(&p->lumps);
    free(p->rom_text);
    free(p);
    return good;
}

/* ---- ROMs ---- */

bool rom_image_plain(uint8_t **bytes, size_t *size, char *err, size_t err_size)
{
    if (!compressed_is(*bytes, *size))
        return true;
    const size_t plain_size = compressed_size(*bytes, *size, err, err_size);
    if (plain_size == 0)
        return false;
    uint8_t *plain = malloc(plain_size);
    if (!plain)
        return result_host(err, err_size, "out of memory");
    if (!compressed_read(*bytes, *size, plain, err, err_size)) {
        free(plain);
        return false;
    }
    free(*bytes);
    *bytes = plain;
    *size = plain_size;
    return true;
}

static bool load_file(const char *path, struct rom_image *out, char *err, size_t err_size)
{
    char why[256];

    if (!files_read(path, path, TREE_FILE, &out->bytes, &out->size, err, err_size))
        return false;
    if (rom_image_plain(&out->bytes, &out->size, why, sizeof why) &&
        check_image(out->bytes, out->size, &out->rom, why, sizeof why))
        return true;
    rom_image_free(out);
    return err_set(err, err_size, "%s: %s", path, why);
}

static void ignore_entry(void *user, const struct plat_file *file)
{
    (void)user;
    (void)file;
}

bool rom_image_load(const char *path, bool nearest, struct rom_image *out, char *err, size_t err_size)
{
    return rom_image_load_told(path, nearest, NULL, NULL, out, err, err_size);
}

bool rom_image_load_told(const char *path, bool nearest, void (*warn)(void *context, const char *sentence),
                         void *context, struct rom_image *out, char *err, size_t err_size)
{
    char why[PATH + 256];

    memset(out, 0, sizeof *out);
    if (files_size(path) >= 0)
        return load_file(path, out, err, err_size);
    if (plat_list(path, ignore_entry, NULL) < 0) {
        files_absent(path, "file or folder", err, err_size);
        return false;
    }
    if (!pack_folder_told(path, nearest, warn, context, &out->bytes, &out->size, why, sizeof why)) {
        memset(out, 0, sizeof *out);
        return err_set(err, err_size, "%s: %s", path, why);
    }
    return rom_open(&out->rom, out->bytes, out->size, err, err_size);
}

void rom_image_free(struct rom_image *image)
{
    free(image->bytes);
    memset(image, 0, sizeof *image);
}

void pack_list(const struct rom *rom, void (*each)(void *user, const char *line), void *user)
{
    for (uint32_t i = 0; i < rom->count; i++) {
        char line[ROM_NAME + 32];
        struct lump l;
        rom_lump(rom, (int)i, &l);
        snprintf(line, sizeof line, "%s %" PRIu32 " %08" PRIx32, l.name, l.size, hash_crc32(l.data, l.size));
        each(user, line);
    }
}

/* ---- files again ---- */

/* The lump's file below the folder. */
static void unpacked_name(const char *name, char out[PATH])
{
    if (starts_with(name, "script/@std/"))
        snprintf(out, PATH, "std/%s", name + strlen("script/@std/"));
    else if (starts_with(name, "script/"))
        snprintf(out, PATH, "%s", name + strlen("script/"));
    else if (starts_with(name, "data/"))
        snprintf(out, PATH, "%s", name + strlen("data/"));
    else if (starts_with(name, "demo/"))
        snprintf(out, PATH, "demos/%s.demo", name + strlen("demo/"));
    else
        snprintf(out, PATH, "lumps/%s", name);
}

/* Is none of the folders that a file asks for a file itself, of the ROM's or there already? */
static bool folders_free(const struct tree *files, const char *name, const char *dir, char *err, size_t err_size)
{
    char folder[PATH], path[PATH];

    snprintf(folder, sizeof folder, "%s", name);
    for (char *slash = folder; (slash = strchr(slash, '/')) != NULL; *slash++ = '/') {
        *slash = '\0';
        if (tree_has(files, folder))
            return err_set(err, err_size, "%s would be both a file and a folder (for %s)", folder, name);
        if (tree_join(path, dir, folder) && plat_size(path) >= 0)
            return err_set(err, err_size, "%s: a file with this name exists, but %s needs a folder there", path, name);
    }
    return true;
}

/* May all of files (sorted) be written? */
static bool may_unpack(const struct tree *files, const char *dir, char *err, size_t err_size)
{
    char path[PATH];

    for (int i = 0; i < files->n; i++) {
        const char *name = files->name[i];
        if (!tree_join(path, dir, name))
            return err_set(err, err_size, "%s: path too long", name);
        if (!manifest_path_ok(name))
            return err_set(err, err_size, "\"%s\" is not a valid file name", name);
        if (i > 0 && strcmp(files->name[i - 1], name) == 0)
            return err_set(err, err_size, "two lumps would be written to %s", name);
        if (plat_size(path) >= 0)
            return err_set(err, err_size, "%s: already exists", path);
        if (!folders_free(files, name, dir, err, err_size))
            return false;
    }
    return true;
}

/* Takes the files of the first n lumps back. */
static void remove_lumps(const struct rom *rom, uint32_t n, const char *dir)
{
    char name[PATH], path[PATH];

    while (n-- > 0) {
        struct lump l;
        rom_lump(rom, (int)n, &l);
        unpacked_name(l.name, name);
        if (tree_join(path, dir, name))
            plat_remove(path);
    }
}

static bool save_lumps(const struct rom *rom, const char *dir, char *err, size_t err_size)
{
    char name[PATH], path[PATH];

    for (uint32_t i = 0; i < rom->count; i++) {
        struct lump l;
        rom_lump(rom, (int)i, &l);
        unpacked_name(l.name, name);
        bool named = tree_join(path, dir, name);
        if (named && files_save(path, l.data, l.size, err, err_size))
            continue;
        remove_lumps(rom, i, dir);
        return named ? false : err_set(err, err_size, "%s: path too long", name);
    }
    return true;
}

bool pack_unpack(const struct rom *rom, const char *dir, char *err, size_t err_size)
{
    struct tree files = { 0 };
    char name[PATH];

    for (uint32_t i = 0; i < rom->count; i++) {
        struct lump l;
        rom_lump(rom, (int)i, &l);
        unpacked_name(l.name, name);
        tree_add(&files, "", name);
    }
    tree_sort(&files);
    bool good =
        !files.failed ? may_unpack(&files, dir, err, err_size) : err_set(err, err_size, "%s", tree_failed(&files));
    tree_close(&files);
    return good && save_lumps(rom, dir, err, err_size);
}
