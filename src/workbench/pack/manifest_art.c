/*
 * manifest_art.c - the pictures of rom.lua: palettes, blends, fonts, sheets, sprites, the icon, maps, theme, practice;
 * and the list of all tables of art and sounds.
 */
#include <stdio.h>
#include <string.h>
#include "manifest_parts.h"
#include "ttf.h"
#include "../../common/files.h"
#include "../../../fb/utf8.h"

static void read_palette(const struct manifest_value *v, void *entry, struct art *art)
{
    struct art_palette *p = entry;

    (void)art;
    value_to_file(v, p->file);
    if (strcmp(p->name, "main") == 0)
        value_fail(v, "this name is already used by `palette`");
}

/* "add", { mix = percent } or { ramp = rule }. */
static void read_blend(const struct manifest_value *v, void *entry, struct art *art)
{
    static const char *const others[] = { "mix", "ramp", NULL };
    static const char *const rules[] = { "add", "half", "max" };
    struct art_blend *blend = entry;
    struct manifest_value one;

    (void)art;
    if (lua_type(v->lua, v->index) == LUA_TSTRING && strcmp(lua_tostring(v->lua, v->index), "add") == 0)
        return;
    if (!lua_istable(v->lua, v->index))
        value_fail(v, "expected \"add\", { mix = percent } or { ramp = rule }, got %s", value_describe(v));
    value_check_keys(v, NULL, 0, others);
    if (!value_get(v, "ramp", &one)) {
        blend->mix = value_get_whole(v, "mix", 1, 99);
        return;
    }
    blend->mix = -1 - value_to_choice(&one, rules, 3, "\"add\", \"half\" or \"max\"");
    if (value_get(v, "mix", &one))
        value_fail(v, "expected mix or ramp, got both");
}

/* Reads the name of the palette that a picture uses; "" is the main palette. */
static void read_palette_name(const struct manifest_value *picture, const struct art *art, char name[ART_NAME_SIZE])
{
    struct manifest_value v;

    if (!value_get(picture, "palette", &v))
        return;
    value_to_text(&v, "a palette's name", name, ART_NAME_SIZE);
    if (strcmp(name, "main") == 0) {
        name[0] = '\0';
        return;
    }
    for (int i = 0; i < art->n_palettes; i++)
        if (strcmp(art->palettes[i].name, name) == 0)
            return;
    value_fail(&v, "\"%s\" is not listed in palettes", name);
}

static void read_font(const struct manifest_value *v, void *entry, struct art *art)
{
    static const struct manifest_field fields[] = {
        FILE_PATH("file", art_font, file),
        WHOLE("size", art_font, size, 1, TTF_MAX_SIZE),
        PAIR("cell", art_font, w, 1, 64, "{ w, h }"),
        TEXT("chars", art_font, chars, "characters"),
        TEXT("also", art_font, extra_chars, "characters"),
        FLAG("fixed", art_font, fixed),
        WHOLE("ink", art_font, ink, 2, 15),
        FLAG("shadow", art_font, shadow),
        FLAG("optional", art_font, optional),
        MATCH("match", art_font, by_index),
    };
    struct art_font *f = entry;
    struct manifest_value chars;

    f->by_index = art->by_index;
    READ_TABLE(v, fields, NULL, f);
    if (f->file[0] == '\0')
        value_fail(v, "expected file=\"art/NAME.ttf\", \"art/NAME.bdf\" or \"art/NAME.png\"");
    const bool is_ttf = files_has_suffix(f->file, ".ttf");
    if (is_ttf && f->size == 0)
        value_fail(v, "a .ttf file needs `size`, its height in px");
    if (!is_ttf && f->size != 0)
        value_fail(v, "`size` is for .ttf files, got \"%s\"", f->file);
    if (is_ttf && f->w != 0)
        value_fail(v, "`cell` is for pictures, got \"%s\"", f->file);
    const bool has_chars = value_get(v, "chars", &chars);
    if (has_chars && f->w == 0)
        value_fail(v, "`chars` needs `cell = { w, h }`");
    if (!has_chars && f->w != 0)
        value_fail(v, "expected `chars`, the characters of the cells from left to right and top to bottom");
}

static void read_sheet(const struct manifest_value *v, void *entry, struct art *art)
{
    static const struct manifest_field fields[] = {
        FILE_PATH("file", art_sheet, file),
        WHOLE("bank", art_sheet, bank, 0, 15),
        MATCH("match", art_sheet, by_index),
    };
    static const char *const others[] = { "palette", NULL };
    struct art_sheet *s = entry;

    s->by_index = art->by_index;
    READ_TABLE(v, fields, others, s);
    if (s->file[0] == '\0')
        value_fail(v, "expected file=\"art/NAME.png\" (or .ase, .aseprite)");
    read_palette_name(v, art, s->palette);
}

static int32_t read_sheet_index(const struct manifest_value *sprite, const struct art *art)
{
    char name[ART_NAME_SIZE] = "";
    struct manifest_value v;

    if (!value_get(sprite, "sheet", &v))
        value_fail(&v, "expected the name of a sheet, got nil");
    value_to_text(&v, "a sheet's name", name, sizeof name);
    for (int i = 0; i < art->n_sheets; i++)
        if (strcmp(art->sheets[i].name, name) == 0)
            return i;
    value_fail(&v, "\"%s\" is not listed in sheets", name);
}

bool art_is_ase(const char *file)
{
    const char *dot = strrchr(file, '.');

    return dot != NULL && (strcmp(dot, ".ase") == 0 || strcmp(dot, ".aseprite") == 0);
}

/* sizes = { 50, 150 } appends scaled copies of the sprite: orb_50, orb_150. */
static void read_sprite_sizes(const struct manifest_value *sprite, const struct art_sprite *s, struct art *art)
{
    struct manifest_value sizes, v;

    if (!value_get_table(sprite, "sizes", &sizes))
        return;
    const int n = value_to_length(&sizes, MAX_ART_SIZES);
    for (int i = 1; i <= n; i++) {
        value_get_item(&sizes, i, &v);
        const int percent = (int)value_to_whole(&v, 1, 1000);
        if (art->n_sprites == MAX_ART_SPRITES)
            value_fail(&v, "more than %d sprites", MAX_ART_SPRITES);
        struct art_sprite *more = &art->sprites[art->n_sprites++];
        *more = *s;
        more->scale_percent = percent;
        if (snprintf(more->name, ART_NAME_SIZE, "%s_%d", s->name, percent) >= ART_NAME_SIZE)
            value_fail(&v, "sprite name %s_%d is longer than %d bytes", s->name, percent, ART_NAME_SIZE - 1);
    }
}

static void read_sprite(const struct manifest_value *v, void *entry, struct art *art)
{
    static const struct manifest_field fields[] = {
        WHOLE("x", art_sprite, x, 0, 16383),
        WHOLE("y", art_sprite, y, 0, 16383),
        WHOLE("w", art_sprite, w, 1, 1024),
        WHOLE("h", art_sprite, h, 1, 1024),
        WHOLE("frames", art_sprite, frames, 1, 256),
        WHOLE("every", art_sprite, frame_ticks, 1, 3600),
        WHOLE("rotations", art_sprite, rotations, 1, 256),
        PAIR("origin", art_sprite, ox, -1024, 1024, "{ x, y }"),
        TEXT("tag", art_sprite, tag, "a tag's name"),
    };
    static const char *const others[] = { "sheet", "sizes", NULL };
    struct art_sprite *s = entry;
    struct manifest_value one;

    s->rotations = 1;
    s->scale_percent = 100;
    READ_TABLE(v, fields, others, s);
    s->sheet = read_sheet_index(v, art);
    if (art_is_ase(art->sheets[s->sheet].file)) {
        if (value_get(v, "frames", &one))
            value_fail(&one,
                       "sprites from an .ase file use all its frames; to choose some of them, use tag = \"NAME\"");
    } else {
        if (value_get(v, "tag", &one))
            value_fail(&one, "only .ase and .aseprite files have tags");
        s->w = value_get_whole(v, "w", 1, 1024);
        s->h = value_get_whole(v, "h", 1, 1024);
        s->frames = s->frames > 0 ? s->frames : 1;
        s->frame_ticks = s->frame_ticks > 0 ? s->frame_ticks : 6;
    }
    s->has_origin = value_get(v, "origin", &one);
    if (!s->has_origin) {
        s->ox = s->w / 2;
        s->oy = s->h / 2;
    }
    read_sprite_sizes(v, s, art);
}

/* Restores the alphabetical order after `sizes` has appended sprites. */
static void sort_sprites(const struct manifest_value *root, struct art *art)
{
    struct art_sprite *s = art->sprites;
    struct manifest_value v;

    for (int i = 1; i < art->n_sprites; i++) {
        struct art_sprite one = s[i];
        int at = i;
        for (; at > 0 && strcmp(s[at - 1].name, one.name) > 0; at--)
            s[at] = s[at - 1];
        s[at] = one;
        if (at == 0 || strcmp(s[at - 1].name, one.name) != 0)
            continue;
        value_get(root, "sprites", &v);
        value_fail(&v, "two sprites are named %s; one of them gets this name from `sizes`", one.name);
    }
}

static void read_row(const struct manifest_value *row, bool is_first, struct art *art, struct art_map *map)
{
    struct manifest_value v;

    if (!lua_istable(row->lua, row->index))
        value_fail(row, "expected a list of tiles, got %s", value_describe(row));
    const int n = value_to_length(row, MAX_ART_CELLS);
    if (is_first)
        map->cols = n;
    if (n != map->cols || n == 0)
        value_fail(row, "expected %d tiles, as in the first row, got %d", map->cols > 0 ? map->cols : 1, n);
    if (n > MAX_ART_CELLS - art->n_cells)
        value_fail(row, "more than %d tiles in rom.lua; use a map file instead", MAX_ART_CELLS);
    for (int k = 1; k <= n; k++) {
        value_get_item(row, k, &v);
        art->cells[art->n_cells++] = (uint16_t)(value_to_whole(&v, map->first_tile - 1, 65534) - map->first_tile + 1);
    }
}

static void read_rows(const struct manifest_value *table, struct art *art, struct art_map *map)
{
    struct manifest_value rows, row;

    if (!value_get_table(table, "rows", &rows))
        return;
    map->first_cell = art->n_cells;
    map->rows = value_to_length(&rows, MAX_ART_CELLS);
    for (int i = 1; i <= map->rows; i++) {
        value_get_item(&rows, i, &row);
        read_row(&row, i == 1, art, map);
    }
    if (map->rows == 0)
        value_fail(&rows, "expected at least one row");
}

/* Reads `tiles`: a picture, or a list of pictures. */
static void read_tiles(const struct manifest_value *table, struct art_map *map)
{
    struct manifest_value tiles, v;

    if (!value_get(table, "tiles", &tiles))
        value_fail(table, "expected tiles=\"art/NAME.png\"");
    if (!lua_istable(tiles.lua, tiles.index)) {
        value_to_file(&tiles, map->tile_files[0]);
        map->n_tile_files = 1;
        return;
    }
    map->n_tile_files = value_to_length(&tiles, MAX_ART_TILE_FILES);
    for (int i = 0; i < map->n_tile_files; i++) {
        value_get_item(&tiles, i + 1, &v);
        value_to_file(&v, map->tile_files[i]);
    }
    if (map->n_tile_files == 0)
        value_fail(&tiles, "expected at least one picture");
}

/* Checks the tile size; it stays 0 if only the map file has it. */
static void check_tile_size(const struct manifest_value *table, bool is_tmx, struct art_map *map)
{
    struct manifest_value v;

    if (map->tile_size == 0 && !is_tmx)
        map->tile_size = 16;
    if (map->tile_size == 0 || map->tile_size == 8 || map->tile_size == 16 || map->tile_size == 32)
        return;
    value_get(table, "size", &v);
    value_fail(&v, "expected 8, 16 or 32, got %d", (int)map->tile_size);
}

static void read_map(const struct manifest_value *v, void *entry, struct art *art)
{
    static const struct manifest_field fields[] = {
        FILE_PATH("file", art_map, file),          TEXT("layer", art_map, layer, "a layer's name"),
        WHOLE("size", art_map, tile_size, 8, 32),  WHOLE("bank", art_map, bank, 0, 15),
        WHOLE("first", art_map, first_tile, 0, 1), MATCH("match", art_map, by_index),
    };
    static const char *const others[] = { "tiles", "palette", "rows", NULL };
    struct art_map *map = entry;

    map->first_tile = 1;
    map->by_index = art->by_index;
    READ_TABLE(v, fields, others, map);
    read_tiles(v, map);
    read_palette_name(v, art, map->palette);
    const bool is_file = map->file[0] != '\0', is_tmx = files_has_suffix(map->file, ".tmx");
    if (is_file && !is_tmx && !files_has_suffix(map->file, ".csv"))
        value_fail(v, "file: expected a .csv or .tmx file, got \"%s\"", map->file);
    if (map->n_tile_files > 1 && !is_tmx)
        value_fail(v, "tiles: only a .tmx map can use tiles from several pictures");
    if (map->layer[0] != '\0' && !is_tmx)
        value_fail(v, "layer: only a .tmx map has layers");
    check_tile_size(v, is_tmx, map);
    read_rows(v, art, map);
    if (is_file == (map->rows > 0))
        value_fail(v, "expected either file=\"maps/NAME.tmx\" (or .csv) or rows={ { 1, 2, .. }, .. }");
}

/* Reads `icon`: a file, or the name of a sprite. */
static void read_icon(const struct manifest_value *root, struct art *art)
{
    struct manifest_value v;
    int i = 0;

    if (!value_get(root, "icon", &v))
        return;
    value_to_text(&v, "a file or a sprite's name", art->icon, sizeof art->icon);
    if (files_has_suffix(art->icon, ".png")) {
        value_to_file(&v, art->icon);
        return;
    }
    while (i < art->n_sprites && strcmp(art->sprites[i].name, art->icon) != 0)
        i++;
    if (i == art->n_sprites)
        value_fail(&v, "expected a .png file or the name of a sprite, got \"%s\"", art->icon);
}

/* Raises an error if a name in `theme` is set and none of n entries, which start with their names, has it. */
static void check_theme_name(const struct manifest_value *table, const char *key, const char *name, const void *entries,
                             int n, size_t stride, const char *list)
{
    struct manifest_value v;

    for (int i = 0; i < n; i++)
        if (strcmp((const char *)entries + (size_t)i * stride, name) == 0)
            return;
    if (value_get(table, key, &v))
        value_fail(&v, "\"%s\" is not listed in %s", name, list);
}

static void read_theme_sounds(const struct manifest_value *theme, struct art *art)
{
    static const struct manifest_field fields[] = {
        TEXT("open", art_theme, sounds[THEME_OPEN], "a sound's name"),
        TEXT("move", art_theme, sounds[THEME_MOVE], "a sound's name"),
        TEXT("accept", art_theme, sounds[THEME_ACCEPT], "a sound's name"),
        TEXT("back", art_theme, sounds[THEME_BACK], "a sound's name"),
    };
    struct manifest_value sounds;

    if (!value_get_table(theme, "sounds", &sounds))
        return;
    READ_TABLE(&sounds, fields, NULL, &art->theme);
    for (int i = 0; i < THEME_SOUNDS; i++)
        check_theme_name(&sounds, fields[i].key, art->theme.sounds[i], art->sounds, art->n_sounds, sizeof *art->sounds,
                         "sounds");
}

/* Reads the character in front of the chosen row. */
static void read_cursor(const struct manifest_value *theme, struct art_theme *t)
{
    char text[8] = "";
    const char *s = text;
    struct manifest_value v;

    if (!value_get(theme, "cursor", &v))
        return;
    value_to_text(&v, "a character", text, sizeof text);
    t->cursor = text[0] ? utf8_next(&s, text + strlen(text)) : 0;
    if (!t->cursor || *s)
        value_fail(&v, "expected one character, got %s", value_describe(&v));
}

static void read_theme(const struct manifest_value *root, struct art *art)
{
    static const struct manifest_field fields[] = {
        WHOLE("ink", art_theme, ink, 0, 15),
        WHOLE("accent", art_theme, accent, 0, 15),
        WHOLE("rule", art_theme, rule, 0, 15),
        WHOLE("paper", art_theme, paper, 0, 255),
        TEXT("font", art_theme, font, "a font's name"),
        TEXT("frame", art_theme, frame, "a sprite's name"),
    };
    static const char *const others[] = { "cursor", "sounds", NULL };
    struct art_theme *t = &art->theme;
    struct manifest_value v;

    t->ink = t->accent = t->rule = t->paper = THEME_DEFAULT;
    t->is_set = value_get(root, "theme", &v);
    if (!t->is_set)
        return;
    READ_TABLE(&v, fields, others, t);
    check_theme_name(&v, "font", t->font, art->fonts, art->n_fonts, sizeof *art->fonts, "fonts");
    check_theme_name(&v, "frame", t->frame, art->sprites, art->n_sprites, sizeof *art->sprites, "sprites");
    read_cursor(&v, t);
    read_theme_sounds(&v, art);
}

static void read_practice(const struct manifest_value *root, struct art *art)
{
    static const char *const words[] = { "all", "reached" };
    struct manifest_value v;

    if (value_get(root, "practice", &v))
        snprintf(art->practice, sizeof art->practice, "%s",
                 words[value_to_choice(&v, words, 2, "\"all\" or \"reached\"")]);
}

/* The tables of named entries, ordered so that entries refer only to earlier tables. An entry starts with its name. */
static const struct art_table {
    const char *key;
    size_t offset, stride, count_offset; /* offset: of the array in struct art */
    int max;
    void (*read)(const struct manifest_value *v, void *entry, struct art *art);
} art_tables[] = {
#define ART_TABLE(key, array, count, read)                                                                             \
    {                                                                                                                  \
        key, offsetof(struct art, array), sizeof((struct art *)NULL)->array[0], offsetof(struct art, count),           \
            sizeof((struct art *)NULL)->array / sizeof((struct art *)NULL)->array[0], read                             \
    }
    ART_TABLE("palettes", palettes, n_palettes, read_palette),
    ART_TABLE("blends", blends, n_blends, read_blend),
    ART_TABLE("fonts", fonts, n_fonts, read_font),
    ART_TABLE("sheets", sheets, n_sheets, read_sheet),
    ART_TABLE("sprites", sprites, n_sprites, read_sprite),
    ART_TABLE("maps", maps, n_maps, read_map),
    ART_TABLE("sounds", sounds, n_sounds, manifest_read_sound),
    ART_TABLE("music", tunes, n_tunes, manifest_read_tune),
};

static void read_art_table(const struct manifest_value *root, const struct art_table *t, struct art *art)
{
    char *entry = (char *)art + t->offset;
    struct manifest_value table, v;

    if (!value_get_table(root, t->key, &table))
        return;
    const int n = value_to_names(&table, entry, t->max, t->stride, ART_NAME_SIZE);
    *(int *)(void *)((char *)art + t->count_offset) = n;
    for (int i = 0; i < n; i++, entry += t->stride) {
        value_get(&table, entry, &v);
        t->read(&v, entry, art);
    }
}

void manifest_read_art(const struct manifest_value *root, struct art *art)
{
    static const struct manifest_field fields[] = {
        FILE_PATH("palette", art, palette),
        FILE_PATH("font", art, font),
        FILE_PATH("border", art, border),
        MATCH("match", art, by_index),
    };

    value_read_fields(root, fields, sizeof fields / sizeof *fields, art);
    for (size_t i = 0; i < sizeof art_tables / sizeof *art_tables; i++)
        read_art_table(root, &art_tables[i], art);
    sort_sprites(root, art);
    read_icon(root, art);
    read_theme(root, art);
    read_practice(root, art);
}
