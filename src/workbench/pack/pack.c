/*
 * pack.c - see pack.h. The folder is walked once, which gives a sorted list of paths. Each file that belongs in the ROM
 * and each picture and sound of rom.lua adds a lump to a list, which is then sorted and written. The list owns its
 * lumps, so lumps_free frees everything if packing fails.
 */
#include "pack_parts.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../base/bits.h"
#include "../../base/err.h"
#include "../../common/array.h"
#include "../../common/result.h"
#include "../../board/board.h"
#include "../../rom/cart.h"
#include "../../script/script.h"
#include "../../script/std.h"
#include "../bulletml/compile.h"
#include "../bulletml/document.h"
#include "lang.h"
#include "../../common/files.h"
#include "../../common/progress.h"

static void lumps_free(struct lumps *l)
{
    for (int i = 0; i < l->n; i++) {
        free((void *)(uintptr_t)l->lump[i].name);
        free((void *)(uintptr_t)l->lump[i].data);
    }
    free(l->lump);
}

bool pack_add(struct packer *p, const char *folder, const char *name, uint8_t *data, size_t size)
{
    size_t n = strlen(folder) + strlen(name) + 1;
    char *full = malloc(n);

    if (full == NULL || !array_append(&p->lumps.lump, (size_t)p->lumps.n, sizeof *p->lumps.lump)) {
        free(full);
        free(data);
        return result_set_host_error(p->err, p->err_size, "out of memory");
    }
    snprintf(full, n, "%s%s", folder, name);
    p->lumps.lump[p->lumps.n++] = (struct lump){ full, data, (uint32_t)size };
    return n <= ROM_MAX_NAME ? true : err_set(p->err, p->err_size, "%s: name too long", name);
}

bool pack_add_copy(struct packer *p, const char *folder, const char *name, const void *data, size_t size)
{
    uint8_t *copy = malloc(size + 1);

    if (copy == NULL)
        return result_set_host_error(p->err, p->err_size, "out of memory");
    memcpy(copy, data, size);
    return pack_add(p, folder, name, copy, size);
}

void pack_progress(struct packer *p, const char *file)
{
    const int all = p->files.n + p->art.n_sheets + p->art.n_maps + p->art.n_sounds + p->art.n_tunes;

    progress_update((uint64_t)p->done++, (uint64_t)all, "packing %s", file);
}

bool pack_load(struct packer *p, const char *name, size_t max, uint8_t **data, size_t *size)
{
    char path[PATH];

    if (!tree_join(path, p->dir, name))
        return err_set(p->err, p->err_size, "%s: path too long", name);
    return files_read(path, name, max, data, size, p->err, p->err_size);
}

bool pack_load_text(struct packer *p, const char *name, size_t max, uint8_t **text, size_t *size)
{
    char path[PATH];

    if (!tree_join(path, p->dir, name))
        return err_set(p->err, p->err_size, "%s: path too long", name);
    return files_read_text(path, name, max, text, size, p->err, p->err_size);
}

bool pack_starts_with(const char *s, const char *head)
{
    return strncmp(s, head, strlen(head)) == 0;
}

static bool read_manifest(struct packer *p)
{
    char folder[64];
    uint8_t *text;
    size_t size;

    if (!pack_load_text(p, "rom.lua", TREE_SCRIPT, &text, &size))
        return false;
    tree_id(p->dir, folder);
    void *block, *work = tree_work(MANIFEST_SCRATCH_SIZE, &block);
    bool good = work != NULL ? manifest_read((const char *)text, size, "rom.lua", folder, &p->m, &p->art, work, p->err,
                                             p->err_size)
                             : result_set_host_error(p->err, p->err_size, "out of memory");
    free(block);
    p->rom_text = realloc(text, size + 1);
    if (p->rom_text == NULL) {
        free(text);
        return result_set_host_error(p->err, p->err_size, "out of memory");
    }
    p->rom_text[size] = '\0';
    return good;
}

static bool add_manifest(struct packer *p)
{
    uint8_t bytes[MANIFEST_BYTES];
    const size_t size = manifest_pack(&p->m, bytes);

    return pack_add_copy(p, "", "manifest", bytes, size);
}

/* Returns whether p is in a comment that starts with --. */
static bool in_comment(const char *text, const char *p)
{
    for (; p > text && p[-1] != '\n'; p--)
        if (p[0] == '-' && p[-1] == '-')
            return true;
    return false;
}

/* Returns the line of rom.lua that contains the file's name; 0: none. */
static int find_line(const char *text, const char *file)
{
    size_t n = strlen(file);
    int line = 1;

    for (const char *p = text; *p != '\0'; line += *p++ == '\n')
        if ((*p == '"' || *p == '\'') && strncmp(p + 1, file, n) == 0 && p[n + 1] == *p && !in_comment(text, p))
            return line;
    return 0;
}

bool pack_refuse_missing(struct packer *p, const char *file)
{
    int line = find_line(p->rom_text, file);

    if (line > 0)
        return err_set(p->err, p->err_size, "rom.lua:%d: %s does not exist", line, file);
    return err_set(p->err, p->err_size, "rom.lua: %s does not exist", file);
}

bool pack_load_named(struct packer *p, const char *file, size_t most, uint8_t **data, size_t *size)
{
    if (!tree_portable(file))
        return err_set(p->err, p->err_size, "%s: not a valid file name on Windows", file);
    if (!tree_has(&p->files, file))
        return pack_refuse_missing(p, file);
    return pack_load(p, file, most, data, size);
}

bool pack_is_lang(const char *path)
{
    return pack_starts_with(path, "lang/") && files_has_suffix(path + strlen("lang/"), ".txt");
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
    bool std = pack_starts_with(path, "std/");
    char chunk[PATH];
    uint8_t *text;
    size_t size;

    if (std && !pack_is_std(path))
        return err_set(p->err, p->err_size, "%s: the standard library has no script with this name", path);
    if (!pack_load_text(p, path, TREE_SCRIPT, &text, &size))
        return false;
    snprintf(chunk, sizeof chunk, "@%s", path);
    void *block, *work = tree_work(TREE_WORK, &block);
    bool good = work != NULL ? script_check((const char *)text, size, chunk, work, TREE_WORK, p->err, p->err_size)
                             : result_set_host_error(p->err, p->err_size, "out of memory");
    free(block);
    if (!good) {
        free(text);
        return false;
    }
    p->std |= std_find_used_modules((const char *)text, size);
    if (p->art.n_fonts > 0)
        pack_font_add_script(&p->shown, (const char *)text, size);
    return std ? pack_add(p, "script/@std/", path + 4, text, size) : pack_add(p, "script/", path, text, size);
}

/* Adds demos/NAME.demo as the lump demo/NAME. */
static bool add_demo(struct packer *p, const char *path)
{
    char name[PATH];
    uint8_t *data;
    size_t size;

    if (!pack_load(p, path, TREE_FILE, &data, &size))
        return false;
    snprintf(name, sizeof name, "%.*s", (int)(strlen(path) - strlen("demos/") - strlen(".demo")),
             path + strlen("demos/"));
    return pack_add(p, "demo/", name, data, size);
}

static bool add_text(struct packer *p, const char *path)
{
    uint8_t *data;
    size_t size;

    if (!pack_load_text(p, path, TREE_FILE, &data, &size))
        return false;
    if (size > MAX_TEXT) {
        free(data);
        return err_set(p->err, p->err_size, "%s: expected text of at most %d bytes, got %zu", path, (int)MAX_TEXT,
                       size);
    }
    return pack_add(p, "data/", path, data, size);
}

/* Adds lang/NAME.txt as the lump lang/NAME. */
static bool add_lang(struct packer *p, const char *path)
{
    char name[PATH];
    uint8_t *text, *data;
    struct lang lang;
    size_t size;

    snprintf(name, sizeof name, "%.*s", (int)(strlen(path) - strlen("lang/") - strlen(".txt")), path + strlen("lang/"));
    if (!manifest_setting_name_ok(name))
        return err_set(p->err, p->err_size, "%s: expected a language name of 1 to %d letters, digits, _ and -", path,
                       MAX_SETTING_NAME - 1);
    if (!pack_load_text(p, path, LANG_MAX_FILE, &text, &size))
        return false;
    bool good = lang_read(&lang, (const char *)text, size, path, p->err, p->err_size);
    for (int i = 0; good && i < lang.n; i++)
        pack_font_add_text(&p->shown, lang.list[i].words, strlen(lang.list[i].words));
    size = good ? lang_make(&lang, &data) : 0;
    lang_free(&lang);
    free(text);
    if (!good)
        return false;
    return size > 0 ? pack_add(p, "lang/", name, data, size)
                    : result_set_host_error(p->err, p->err_size, "out of memory");
}

bool pack_is_bulletml(const char *path)
{
    return pack_starts_with(path, "bulletml/") && files_has_suffix(path + strlen("bulletml/"), ".xml");
}

/* Makes the name of a document: the path after bulletml/, with _ for characters that are not allowed in names, because
 * collections of documents contain names such as "[game] boss 2.xml". */
static void name_bulletml(const char *path, char name[PATH])
{
    const char *from = path + strlen("bulletml/");
    const int n = (int)(strlen(from) - strlen(".xml"));

    snprintf(name, PATH, "%.*s", n, from);
    for (char *c = name; *c != '\0'; c++)
        if (strchr("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./", *c) == NULL)
            *c = '_';
}

/* Returns whether no other document has the name. */
static bool is_name_unused(const struct packer *p, const char *name)
{
    for (int i = 0; i < p->lumps.n; i++)
        if (pack_starts_with(p->lumps.lump[i].name, "bulletml/") &&
            strcmp(p->lumps.lump[i].name + strlen("bulletml/"), name) == 0)
            return false;
    return true;
}

/* Adds a document as a compiled program. */
static bool add_bulletml(struct packer *p, const char *path)
{
    char name[PATH];
    uint8_t *text, *data = NULL;
    struct document d;
    size_t size;

    if (!pack_load(p, path, DOCUMENT_MAX_FILE, &text, &size))
        return false;
    const bool good = document_read(&d, (const char *)text, size, path, p->warn, p->context, p->err, p->err_size) &&
                      bulletml_compile(&d, path, &data, &size, p->err, p->err_size);
    document_free(&d);
    free(text);
    name_bulletml(path, name);
    if (good && !is_name_unused(p, name)) {
        free(data);
        return err_set(p->err, p->err_size, "%s: another document is also packed as \"%s\"", path, name);
    }
    return good && pack_add(p, "bulletml/", name, data, size);
}

/* Documents are packed only if the game enables BulletML. */
static bool is_packed(const struct packer *p, const char *path)
{
    return files_has_suffix(path, ".txt") || (p->m.bulletml_runners > 0 && pack_is_bulletml(path));
}

static bool add_file(struct packer *p, const char *path)
{
    bool lua = files_has_suffix(path, ".lua"),
         demo = pack_starts_with(path, "demos/") && files_has_suffix(path + 6, ".demo");

    if (strcmp(path, "rom.lua") == 0 || (!lua && !demo && !is_packed(p, path)))
        return true;
    if (!manifest_path_ok(path) && !pack_is_bulletml(path))
        return err_set(p->err, p->err_size, "%s: expected a name of letters, digits, _ - and . only", path);
    if (!tree_portable(path))
        return err_set(p->err, p->err_size, "%s: not a valid file name on Windows", path);
    return lua                              ? add_script(p, path)
           : demo                           ? add_demo(p, path)
           : pack_is_lang(path)             ? add_lang(p, path)
           : files_has_suffix(path, ".txt") ? add_text(p, path)
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
        pack_progress(p, p->files.name[i]);
        if (!add_file(p, p->files.name[i]))
            return false;
    }
    return true;
}

static bool is_replaced(const struct packer *p, const char *name)
{
    char path[PATH];

    snprintf(path, sizeof path, "std/%s.lua", name);
    return tree_has(&p->files, path);
}

static const struct embedded *find_library_script(const char *name)
{
    for (int i = 0; i < std_script_count; i++)
        if (strcmp(std_scripts[i].name, name) == 0)
            return &std_scripts[i];
    return NULL;
}

/* Returns the modules that the game replaces, which are always packed. */
static uint64_t replaced_modules(const struct packer *p)
{
    uint64_t own = 0;

    for (int i = 0; i < STD_MODULE_COUNT; i++)
        own |= (uint64_t)is_replaced(p, std_modules[i].name) << i;
    return own;
}

static bool add_module(struct packer *p, const struct embedded *s)
{
    char file[PATH];

    snprintf(file, sizeof file, "%s.lua", s->name);
    return pack_add_copy(p, "script/@std/", file, s->data, s->size);
}

/* Adds the additional files of packed modules; files of the game have been added. */
static bool add_extra_files(struct packer *p)
{
    for (int i = 0; i < std_script_count; i++) {
        int of = std_module_of_file(std_scripts[i].name);
        if (of >= 0 && p->std >> of & 1 && !is_replaced(p, std_scripts[i].name) && !add_module(p, &std_scripts[i]))
            return false;
    }
    return true;
}

/* Adds the modules that the game's scripts use, and those that these modules use. Every module needs the prelude. */
static bool add_std(struct packer *p)
{
    uint64_t in = replaced_modules(p), missing;

    p->std |= (p->std | in) != 0 ? 1 : 0;
    while ((missing = p->std & ~in) != 0) {
        int i = (int)bits_lowest(missing);
        const struct embedded *s = find_library_script(std_modules[i].name);
        if (!add_module(p, s))
            return false;
        p->std |= std_find_needed_modules(i, (const char *)s->data, s->size);
        in |= (uint64_t)1 << i;
    }
    return add_extra_files(p);
}

static int compare_names(const void *a, const void *b)
{
    return strcmp(((const struct lump *)a)->name, ((const struct lump *)b)->name);
}

static bool write_image(struct packer *p, uint8_t **image, size_t *size)
{
    struct rom rom;

    qsort(p->lumps.lump, (size_t)p->lumps.n, sizeof p->lumps.lump[0], compare_names);
    *size = rom_write_size(p->lumps.lump, p->lumps.n);
    *image = NULL;
    if (*size == 0)
        return err_set(p->err, p->err_size, "too large for a ROM");
    *image = malloc(*size);
    if (*image == NULL)
        return result_set_host_error(p->err, p->err_size, "out of memory");
    rom_write(*image, p->lumps.lump, p->lumps.n);
    if (rom_image_check(*image, *size, &rom, p->err, p->err_size))
        return true;
    free(*image);
    *image = NULL;
    return false;
}

static bool add_all(struct packer *p)
{
    if (!tree_walk(p->dir, &p->files, p->err, p->err_size))
        return false;
    return read_manifest(p) && add_manifest(p) && add_files(p) && add_std(p) && pack_add_art(p) && pack_add_sounds(p);
}

bool pack_folder(const char *dir, bool nearest, pack_warning *warn, void *context, uint8_t **image, size_t *size,
                 char *err, size_t err_size)
{
    struct packer *p = calloc(1, sizeof *p);

    if (p == NULL)
        return result_set_host_error(err, err_size, "out of memory");
    p->dir = dir;
    p->nearest = nearest;
    p->warn = warn;
    p->context = context;
    p->err = err;
    p->err_size = err_size;
    bool good = add_all(p) && write_image(p, image, size);
    tree_close(&p->files);
    lumps_free(&p->lumps);
    free(p->rom_text);
    free(p);
    return good;
}

bool pack_load_game(const char *path, bool nearest, struct rom_image *out, char *err, size_t err_size)
{
    return pack_load_game_warn(path, nearest, NULL, NULL, out, err, err_size);
}

bool pack_load_game_warn(const char *path, bool nearest, pack_warning *warn, void *context, struct rom_image *out,
                         char *err, size_t err_size)
{
    char why[FILES_PATH_SIZE + 256];

    memset(out, 0, sizeof *out);
    if (files_size(path) >= 0)
        return rom_image_read(path, nearest, out, err, err_size);
    if (files_count_entries(path) < 0) {
        files_set_missing_error(path, "file or folder", err, err_size);
        return false;
    }
    if (!pack_folder(path, nearest, warn, context, &out->bytes, &out->size, why, sizeof why)) {
        memset(out, 0, sizeof *out);
        return err_set(err, err_size, "%s: %s", path, why);
    }
    return rom_open(&out->rom, out->bytes, out->size, err, err_size);
}
