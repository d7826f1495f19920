/*
 * manifest_art.c - the pictures of rom.lua: palettes, blends, fonts, sheets, sprites, the icon, maps.
 */
#include <stdio.h>
#include <string.h>
#include "manifest_at.h"
#include "../../common/files.h"

static void read_palettes(const struct at *root, struct art *art)
{
    struct at a;

    at_file(root, "palette", art->palette);
    at_file(root, "font", art->font);
    at_file(root, "border", art->border);
    if (!at_table(root, "palettes", &a))
        return;
    art->n_palettes = at_keys(&a, art->palettes, MAX_ART_PALETTES, sizeof art->palettes[0], ART_NAME_SIZE);
    for (int i = 0; i < art->n_palettes; i++) {
        at_file(&a, art->palettes[i].name, art->palettes[i].file);
        if (strcmp(art->palettes[i].name, "main") == 0)
            at_bad(a.lua, "palettes.main", "this name is already used by `palette`");
    }
    lua_pop(a.lua, 1);
}

/* The number of the rule for ramps that is on top; popped. */
static int32_t read_ramp(const struct at *a)
{
    static const char *const rules[] = { "add", "half", "max" };
    char path[MAX_PATH];

    at_path(a, "ramp", path);
    for (int32_t i = 0; i < 3; i++)
        if (lua_type(a->lua, -1) == LUA_TSTRING && strcmp(lua_tostring(a->lua, -1), rules[i]) == 0) {
            lua_pop(a->lua, 1);
            return -1 - i;
        }
    at_bad(a->lua, path, "expected \"add\", \"half\" or \"max\", got %s", at_got(a->lua));
    return 0;
}

/* "add", { mix = percent } or { ramp = rule }. */
static int32_t read_blend(const struct at *a, const char *name)
{
    static const char *const names[] = { "mix", "ramp", NULL };
    char path[MAX_PATH];
    struct at one;
    int32_t mix = 0;

    at_path(a, name, path);
    at_get(a, name);
    if (lua_type(a->lua, -1) == LUA_TSTRING && strcmp(lua_tostring(a->lua, -1), "add") == 0) {
        lua_pop(a->lua, 1);
        return 0;
    }
    if (!lua_istable(a->lua, -1))
        at_bad(a->lua, path, "expected \"add\", { mix = percent } or { ramp = rule }, got %s", at_got(a->lua));
    lua_pop(a->lua, 1);
    at_table(a, name, &one);
    at_only(&one, names);
    if (at_get(&one, "ramp")) {
        mix = read_ramp(&one);
        if (at_get(&one, "mix"))
            at_bad(a->lua, path, "expected mix or ramp, got both");
    } else
        at_need_whole(&one, "mix", 1, 99, &mix);
    lua_pop(a->lua, 1);
    return mix;
}

static void read_blends(const struct at *root, struct art *art)
{
    struct at a;

    if (!at_table(root, "blends", &a))
        return;
    art->n_blends = at_keys(&a, art->blends, MAX_ART_BLENDS, sizeof art->blends[0], ART_NAME_SIZE);
    for (int i = 0; i < art->n_blends; i++)
        art->blends[i].mix = read_blend(&a, art->blends[i].name);
    lua_pop(a.lua, 1);
}

/* match = "index" or "colour"; where it says neither, as `usual`. */
static bool get_match(const struct at *a, bool usual)
{
    static const char *const ways[] = { "colour", "index" };
    char path[MAX_PATH];

    at_path(a, "match", path);
    if (!at_get(a, "match"))
        return usual;
    for (int i = 0; i < 2; i++)
        if (lua_type(a->lua, -1) == LUA_TSTRING && strcmp(lua_tostring(a->lua, -1), ways[i]) == 0) {
            lua_pop(a->lua, 1);
            return i == 1;
        }
    at_bad(a->lua, path, "expected \"colour\" or \"index\", got %s", at_got(a->lua));
}

/* palette = NAME: the picture is drawn in the colours of that one. */
static void get_palette(const struct at *a, const struct art *art, char name[ART_NAME_SIZE])
{
    char path[MAX_PATH];

    at_path(a, "palette", path);
    if (!at_text(a, "palette", "a palette's name", name, ART_NAME_SIZE) || strcmp(name, "main") == 0) {
        name[0] = '\0';
        return;
    }
    for (int i = 0; i < art->n_palettes; i++)
        if (strcmp(art->palettes[i].name, name) == 0)
            return;
    at_bad(a->lua, path, "\"%s\" is not listed in palettes", name);
}

/* cell = { w, h }, and what stands in the cells. */
static void read_cells(const struct at *a, struct art_font *f)
{
    struct at cell;
    char path[MAX_PATH];

    if (!at_table(a, "cell", &cell)) {
        if (at_text(a, "chars", "characters", f->chars, sizeof f->chars))
            at_bad(a->lua, a->path, "`chars` needs `cell = { w, h }`");
        return;
    }
    if (at_list(&cell, 2) != 2)
        at_bad(a->lua, cell.path, "expected { w, h }");
    at_item(&cell, 1, path);
    f->w = (int32_t)at_to_whole(a->lua, path, 1, 64);
    at_item(&cell, 2, path);
    f->h = (int32_t)at_to_whole(a->lua, path, 1, 64);
    lua_pop(a->lua, 1);
    if (!at_text(a, "chars", "characters", f->chars, sizeof f->chars))
        at_bad(a->lua, a->path, "expected `chars`, the characters of the cells from left to right and top to bottom");
}

static void read_fonts(const struct at *root, struct art *art)
{
    static const char *const names[] = { "file", "cell", "chars", "also", "fixed", "shadow", "match", NULL };
    struct at a, one;

    if (!at_table(root, "fonts", &a))
        return;
    art->n_fonts = at_keys(&a, art->fonts, MAX_ART_FONTS, sizeof art->fonts[0], ART_NAME_SIZE);
    for (int i = 0; i < art->n_fonts; i++) {
        struct art_font *f = &art->fonts[i];
        at_table(&a, f->name, &one);
        at_only(&one, names);
        if (!at_file(&one, "file", f->file))
            at_bad(a.lua, one.path, "expected file=\"art/NAME.bdf\" or \"art/NAME.png\"");
        read_cells(&one, f);
        at_text(&one, "also", "characters", f->extra_chars, sizeof f->extra_chars);
        f->fixed = at_flag(&one, "fixed");
        f->shadow = at_flag(&one, "shadow");
        f->by_index = get_match(&one, art->by_index);
        lua_pop(a.lua, 1);
    }
    lua_pop(a.lua, 1);
}

static void read_sheets(const struct at *root, struct art *art)
{
    static const char *const names[] = { "file", "bank", "match", "palette", NULL };
    struct at a, one;

    if (!at_table(root, "sheets", &a))
        return;
    art->n_sheets = at_keys(&a, art->sheets, MAX_ART_SHEETS, sizeof art->sheets[0], ART_NAME_SIZE);
    for (int i = 0; i < art->n_sheets; i++) {
        struct art_sheet *s = &art->sheets[i];
        at_table(&a, s->name, &one);
        at_only(&one, names);
        if (!at_file(&one, "file", s->file))
            at_bad(a.lua, one.path, "expected file=\"art/NAME.png\" (or .ase, .aseprite)");
        at_whole(&one, "bank", 0, 15, &s->bank);
        get_palette(&one, art, s->palette);
        s->by_index = get_match(&one, art->by_index);
        lua_pop(a.lua, 1);
    }
    lua_pop(a.lua, 1);
}

static int32_t sheet_index(const struct at *a, const struct art *art)
{
    char name[ART_NAME_SIZE] = "", path[MAX_PATH];

    at_path(a, "sheet", path);
    if (!at_text(a, "sheet", "a sheet's name", name, sizeof name))
        at_bad(a->lua, path, "expected the name of a sheet, got nil");
    for (int i = 0; i < art->n_sheets; i++)
        if (strcmp(art->sheets[i].name, name) == 0)
            return i;
    at_bad(a->lua, path, "\"%s\" is not listed in sheets", name);
}

static void read_origin(const struct at *a, struct art_sprite *s)
{
    struct at o;
    char path[MAX_PATH];

    if (!at_table(a, "origin", &o))
        return;
    if (at_list(&o, 2) != 2)
        at_bad(a->lua, o.path, "expected { x, y }");
    at_item(&o, 1, path);
    s->ox = (int32_t)at_to_whole(a->lua, path, -1024, 1024);
    at_item(&o, 2, path);
    s->oy = (int32_t)at_to_whole(a->lua, path, -1024, 1024);
    s->has_origin = true;
    lua_pop(a->lua, 1);
}

bool art_is_ase(const char *file)
{
    const char *dot = strrchr(file, '.');

    return dot != NULL && (strcmp(dot, ".ase") == 0 || strcmp(dot, ".aseprite") == 0);
}

/* One whose sheet is a file of Aseprite's: what is not said here, its file says. */
static void read_tagged(const struct at *a, struct art_sprite *s)
{
    char path[MAX_PATH];

    at_text(a, "tag", "a tag's name", s->tag, sizeof s->tag);
    if (at_get(a, "frames")) {
        at_path(a, "frames", path);
        at_bad(a->lua, path,
               "sprites from an .ase file use all its frames; to choose some of them, use tag = \"NAME\"");
    }
    s->frames = s->frame_ticks = 0;
    at_whole(a, "w", 1, 1024, &s->w);
    at_whole(a, "h", 1, 1024, &s->h);
    at_whole(a, "every", 1, 3600, &s->frame_ticks);
}

static void read_cut(const struct at *a, struct art_sprite *s)
{
    char path[MAX_PATH];

    if (at_get(a, "tag")) {
        at_path(a, "tag", path);
        at_bad(a->lua, path, "only .ase and .aseprite files have tags");
    }
    at_need_whole(a, "w", 1, 1024, &s->w);
    at_need_whole(a, "h", 1, 1024, &s->h);
    at_whole(a, "frames", 1, 256, &s->frames);
    at_whole(a, "every", 1, 3600, &s->frame_ticks);
}

static void read_sprite(const struct at *a, const struct art *art, struct art_sprite *s)
{
    static const char *const names[] = { "sheet", "x",         "y",      "w",     "h",   "frames",
                                         "every", "rotations", "origin", "sizes", "tag", NULL };

    at_only(a, names);
    s->sheet = sheet_index(a, art);
    s->frames = s->rotations = 1;
    s->frame_ticks = 6;
    s->scale_percent = 100;
    at_whole(a, "x", 0, 16383, &s->x);
    at_whole(a, "y", 0, 16383, &s->y);
    if (art_is_ase(art->sheets[s->sheet].file))
        read_tagged(a, s);
    else
        read_cut(a, s);
    at_whole(a, "rotations", 1, 256, &s->rotations);
    s->ox = s->w / 2;
    s->oy = s->h / 2;
    read_origin(a, s);
}

/* sizes = { 50, 150 }: sprites of their own, behind the others, named after it: orb_50, orb_150. */
static void read_sprite_sizes(const struct at *a, struct art *art, const struct art_sprite *s)
{
    struct at sizes;
    char path[MAX_PATH];

    if (!at_table(a, "sizes", &sizes))
        return;
    int n = at_list(&sizes, MAX_ART_SIZES);
    for (int i = 1; i <= n; i++) {
        at_item(&sizes, i, path);
        int percent = (int)at_to_whole(a->lua, path, 1, 1000);
        if (art->n_sprites == MAX_ART_SPRITES)
            at_bad(a->lua, path, "more than %d sprites", MAX_ART_SPRITES);
        struct art_sprite *more = &art->sprites[art->n_sprites++];
        *more = *s;
        more->scale_percent = percent;
        if (snprintf(more->name, ART_NAME_SIZE, "%s_%d", s->name, percent) >= ART_NAME_SIZE)
            at_bad(a->lua, path, "sprite name %s_%d is longer than %d bytes", s->name, percent, ART_NAME_SIZE - 1);
    }
    lua_pop(a->lua, 1);
}

/* Puts the sprites from `first` on among those before them, by name. */
static void sort_sprites(lua_State *lua, struct art *art, int first)
{
    struct art_sprite *s = art->sprites;

    for (int i = first; i < art->n_sprites; i++) {
        struct art_sprite one = s[i];
        int at = i;
        for (; at > 0 && strcmp(s[at - 1].name, one.name) > 0; at--)
            s[at] = s[at - 1];
        s[at] = one;
        if (at > 0 && strcmp(s[at - 1].name, one.name) == 0)
            at_bad(lua, "sprites", "two sprites are named %s; one of them gets this name from `sizes`", one.name);
    }
}

static void read_sprites(const struct at *root, struct art *art)
{
    struct at a, one;

    if (!at_table(root, "sprites", &a))
        return;
    art->n_sprites = at_keys(&a, art->sprites, MAX_ART_SPRITES, sizeof art->sprites[0], ART_NAME_SIZE);
    const int n = art->n_sprites;
    for (int i = 0; i < n; i++) {
        at_table(&a, art->sprites[i].name, &one);
        read_sprite(&one, art, &art->sprites[i]);
        read_sprite_sizes(&one, art, &art->sprites[i]);
        lua_pop(a.lua, 1);
    }
    sort_sprites(a.lua, art, n);
    lua_pop(a.lua, 1);
}

/* One row of a map's numbers. */
static void read_row(const struct at *rows, int i, int first, struct art *art, struct art_map *map)
{
    struct at row = { rows->lua, 0, "" };
    char path[MAX_PATH];

    at_item(rows, i, row.path);
    if (!lua_istable(rows->lua, -1))
        at_bad(rows->lua, row.path, "expected a list of tiles, got %s", at_got(rows->lua));
    row.index = lua_gettop(rows->lua);
    const int n = at_list(&row, MAX_ART_CELLS);
    if (i == 1)
        map->cols = n;
    if (n != map->cols || n == 0)
        at_bad(rows->lua, row.path, "expected %d tiles, as in the first row, got %d", map->cols > 0 ? map->cols : 1, n);
    if (n > MAX_ART_CELLS - art->n_cells)
        at_bad(rows->lua, row.path, "more than %d tiles in rom.lua; use a map file instead", MAX_ART_CELLS);
    for (int k = 1; k <= n; k++) {
        at_item(&row, k, path);
        art->cells[art->n_cells++] = (uint16_t)(at_to_whole(rows->lua, path, first - 1, 65534) - first + 1);
    }
    lua_pop(rows->lua, 1);
}

static void read_rows(const struct at *a, struct art *art, struct art_map *map)
{
    struct at rows;

    if (!at_table(a, "rows", &rows))
        return;
    map->first_cell = art->n_cells;
    map->rows = at_list(&rows, MAX_ART_CELLS);
    for (int i = 1; i <= map->rows; i++)
        read_row(&rows, i, map->first_tile, art, map);
    if (map->rows == 0)
        at_bad(a->lua, rows.path, "expected at least one row");
    lua_pop(a->lua, 1);
}

/* A picture, or a list of them. */
static void read_tiles(const struct at *a, struct art_map *map)
{
    char path[MAX_PATH];
    struct at pictures;

    if (!at_get(a, "tiles"))
        at_bad(a->lua, a->path, "expected tiles=\"art/NAME.png\"");
    const bool several = lua_istable(a->lua, -1);
    lua_pop(a->lua, 1);
    if (!several) {
        at_file(a, "tiles", map->tile_files[0]);
        map->n_tile_files = 1;
        return;
    }
    at_table(a, "tiles", &pictures);
    map->n_tile_files = at_list(&pictures, MAX_ART_TILE_FILES);
    for (int i = 0; i < map->n_tile_files; i++) {
        at_item(&pictures, i + 1, path);
        at_to_file(a->lua, path, map->tile_files[i]);
    }
    if (map->n_tile_files == 0)
        at_bad(a->lua, pictures.path, "expected at least one picture");
    lua_pop(a->lua, 1);
}

static void read_map(const struct at *a, struct art *art, struct art_map *map)
{
    static const char *const names[] = { "tiles", "file",  "rows",  "layer",   "size",
                                         "bank",  "first", "match", "palette", NULL };
    char path[MAX_PATH];

    at_only(a, names);
    at_path(a, "size", path);
    map->first_tile = 1;
    read_tiles(a, map);
    at_whole(a, "bank", 0, 15, &map->bank);
    get_palette(a, art, map->palette);
    map->by_index = get_match(a, art->by_index);
    at_whole(a, "size", 8, 32, &map->tile_size);
    at_whole(a, "first", 0, 1, &map->first_tile);
    at_text(a, "layer", "a layer's name", map->layer, sizeof map->layer);
    const bool file = at_file(a, "file", map->file), tmx = files_has_suffix(map->file, ".tmx");
    if (file && !tmx && !files_has_suffix(map->file, ".csv"))
        at_bad(a->lua, a->path, "file: expected a .csv or .tmx file, got \"%s\"", map->file);
    if (map->n_tile_files > 1 && !tmx)
        at_bad(a->lua, a->path, "tiles: only a .tmx map can use tiles from several pictures");
    if (map->layer[0] != '\0' && !tmx)
        at_bad(a->lua, a->path, "layer: only a .tmx map has layers");
    if (map->tile_size == 0 && !tmx)
        map->tile_size = 16;
    if (map->tile_size != 0 && map->tile_size != 8 && map->tile_size != 16 && map->tile_size != 32)
        at_bad(a->lua, path, "expected 8, 16 or 32, got %d", (int)map->tile_size);
    read_rows(a, art, map);
    if (file == (map->rows > 0))
        at_bad(a->lua, a->path, "expected either file=\"maps/NAME.tmx\" (or .csv) or rows={ { 1, 2, .. }, .. }");
}

/* A file, or one of the sprites. */
static void read_icon(const struct at *root, struct art *art)
{
    int i = 0;

    if (!at_text(root, "icon", "a file or a sprite's name", art->icon, sizeof art->icon))
        return;
    if (files_has_suffix(art->icon, ".png")) {
        if (!manifest_path_ok(art->icon))
            at_bad(root->lua, "icon", "expected a file inside the folder (letters, digits, _ - . /), got \"%s\"",
                   art->icon);
        return;
    }
    while (i < art->n_sprites && strcmp(art->sprites[i].name, art->icon) != 0)
        i++;
    if (i == art->n_sprites)
        at_bad(root->lua, "icon", "expected a .png file or the name of a sprite, got \"%s\"", art->icon);
}

/* Maps alone switch backgrounds on. */
static void read_maps(const struct at *root, struct manifest *m, struct art *art)
{
    struct at a, one;

    if (!at_table(root, "maps", &a))
        return;
    art->n_maps = at_keys(&a, art->maps, MAX_ART_MAPS, sizeof art->maps[0], ART_NAME_SIZE);
    for (int i = 0; i < art->n_maps; i++) {
        at_table(&a, art->maps[i].name, &one);
        read_map(&one, art, &art->maps[i]);
        lua_pop(a.lua, 1);
    }
    m->has_backgrounds = m->has_backgrounds || art->n_maps > 0;
    lua_pop(a.lua, 1);
}

void manifest_read_art(const struct at *root, struct manifest *m, struct art *art)
{
    art->by_index = get_match(root, false);
    read_palettes(root, art);
    read_blends(root, art);
    read_fonts(root, art);
    read_sheets(root, art);
    read_sprites(root, art);
    read_icon(root, art);
    read_maps(root, m, art);
}
