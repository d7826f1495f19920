/*
 * replays.c - lists, adds and removes replays (replays.h).
 */
#include "replays.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "../../../platform/platform.h"
#include "../../base/err.h"
#include "../../base/hash.h"
#include "../../common/array.h"
#include "../../common/files.h"
#include "roms.h"
#include "../../common/result.h"

/* ---- names ---- */

static void path_of(const struct replays *r, const char *stem, const char *ending, char path[REPLAY_PATH])
{
    snprintf(path, REPLAY_PATH, "user:replays/%s/%s.%s", r->id, stem, ending);
}

void replays_path(const struct replays *r, int i, char path[REPLAY_PATH])
{
    path_of(r, r->list[i].stem, "demo", path);
}

static struct tm utc(int64_t date)
{
    const time_t t = (time_t)date;
    const struct tm *tm = gmtime(&t);

    return tm ? *tm : (struct tm){ .tm_year = 70, .tm_mday = 1 };
}

/* Returns the number in a stem of this second, or -1 for a stem of another second. */
static int number_of(const char *stem, const char *second, size_t n)
{
    return strncmp(stem, second, n) != 0 ? -1 : stem[n] == '-' ? atoi(stem + n + 1) : 1;
}

/* Writes the next free name of that second, which sorts after all listed ones. */
static void free_stem(const struct replays *r, int64_t date, char stem[REPLAY_STEM])
{
    const struct tm tm = utc(date);
    const size_t n = strftime(stem, REPLAY_STEM, "%Y%m%d-%H%M%S", &tm);
    char path[REPLAY_PATH];
    int last = 0;

    for (int i = 0; i < r->n; i++) {
        const int k = number_of(r->list[i].stem, stem, n);
        last = k > last ? k : last;
    }
    do {
        if (last > 0)
            snprintf(stem + n, REPLAY_STEM - n, "-%03d", last + 1);
        path_of(r, stem, "demo", path);
        last++;
    } while (plat_file_size(path) >= 0 && last < 999);
}

/* Returns the days from 1970-01-01 to a date of the Gregorian calendar. */
static int64_t days_to(int year, int month, int day)
{
    const int64_t y = year - (month <= 2), era = y / 400, of_era = y - era * 400;
    const int64_t of_year = (153 * (month + (month > 2 ? -3 : 9)) + 2) / 5 + day - 1;

    return era * 146097 + of_era * 365 + of_era / 4 - of_era / 100 + of_year - 719468;
}

/* Reads the date in a file's name. Returns false if the name has another form. */
static bool date_of(const char *stem, int64_t *date)
{
    unsigned y, mo, d, h, mi, s;

    if (sscanf(stem, "%4u%2u%2u-%2u%2u%2u", &y, &mo, &d, &h, &mi, &s) != 6 || mo < 1 || mo > 12 || y < 1970)
        return false;
    *date = days_to((int)y, (int)mo, (int)d) * 86400 + h * 3600 + mi * 60 + s;
    return true;
}

/* ---- the list ---- */

static int by_stem(const void *left, const void *right)
{
    const struct replay_entry *a = left, *b = right;

    return strcmp(b->stem, a->stem);
}

/* The files in the directory. */
struct found {
    struct replays *r;
    char (*meta)[REPLAY_STEM]; /* stems of metadata files; malloc */
    int n_meta;
    int64_t newest; /* time of the newest complete file */
    struct {
        char name[REPLAY_PATH];
        int64_t time;
    } temp[32]; /* partially written files, left by a killed program */
    int temps;
    bool full; /* out of memory */
};

/* If a name is "STEM" and the ending, copies the stem and returns true. */
static bool has_ending(const char *name, const char *ending, char stem[REPLAY_STEM])
{
    const size_t n = strlen(name) - strlen(ending);

    if (!files_has_suffix(name, ending) || n >= REPLAY_STEM)
        return false;
    memcpy(stem, name, n);
    stem[n] = 0;
    return true;
}

static void find_meta(struct found *f, const char *stem)
{
    char *meta = array_append(&f->meta, (size_t)f->n_meta, sizeof f->meta[0]);

    f->full |= !meta;
    if (meta) {
        snprintf(meta, REPLAY_STEM, "%s", stem);
        f->n_meta++;
    }
}

static void find(void *user, const struct plat_folder_entry *file)
{
    struct found *f = user;
    char stem[REPLAY_STEM];
    const size_t n = strlen(file->name);
    const bool temp = files_has_suffix(file->name, ".tmp");

    if (file->is_folder)
        return;
    if (temp && f->temps < 32 && n < sizeof f->temp[0].name) {
        snprintf(f->temp[f->temps].name, sizeof f->temp[0].name, "%s", file->name);
        f->temp[f->temps++].time = file->time;
    }
    if (!temp && file->time > f->newest)
        f->newest = file->time;
    if (has_ending(file->name, ".card", stem))
        find_meta(f, stem);
    if (!has_ending(file->name, ".demo", stem) || f->r->n == REPLAYS_MAX)
        return;
    struct replay_entry *e = array_append(&f->r->list, (size_t)f->r->n, sizeof *e);
    f->full = f->full || !e;
    if (!e)
        return;
    memcpy(e->stem, stem, sizeof stem);
    f->r->n++;
}

static bool load_meta(struct replays *r, struct replay_entry *e)
{
    uint8_t head[REPLAY_META_HEAD];
    char meta[REPLAY_PATH], demo[REPLAY_PATH];

    path_of(r, e->stem, "card", meta);
    path_of(r, e->stem, "demo", demo);
    const long n = plat_load(meta, head, sizeof head);
    r->loads++;
    r->loaded += n > 0 ? (uint32_t)n : 0;
    return n > 0 && replay_meta_read(&e->meta, head, (size_t)n) && strcmp(e->meta.id, r->id) == 0 &&
           plat_file_size(demo) == (long)e->meta.bytes;
}

static bool save_meta(const struct replays *r, const char *stem, const struct replay_meta *c, const struct thumb *t,
                      struct unsaved **unsaved, char *err, size_t err_size)
{
    static const struct thumb none;
    uint8_t bytes[REPLAY_META_BYTES];
    char path[REPLAY_PATH];

    path_of(r, stem, "card", path);
    const size_t size = replay_meta_write(c, t ? t : &none, bytes);
    return unsaved ? unsaved_save(unsaved, path, bytes, size, err, err_size)
                   : files_save(path, bytes, size, err, err_size);
}

/* Rebuilds metadata from the demo. If the metadata is damaged, the replay may have had a name, so it gets the name
 * "recovered" and is not removed automatically. Returns false if the file is not a demo of a run of this game. */
static bool repair(struct replays *r, struct replay_entry *e)
{
    struct demo d;
    char path[REPLAY_PATH], err[DEMO_ERR_SIZE];
    uint8_t *bytes;
    size_t size;

    path_of(r, e->stem, "card", path);
    const bool damaged = plat_file_size(path) >= 0;
    path_of(r, e->stem, "demo", path);
    if (!files_read(path, path, DEMO_MAX_BYTES, &bytes, &size, err, sizeof err))
        return false;
    r->loads++;
    r->loaded += (uint32_t)size;
    bool good = demo_read(&d, bytes, size, err, sizeof err) && replay_meta_of_demo(&e->meta, &d) &&
                strcmp(e->meta.id, r->id) == 0;
    e->meta.hash = hash_bytes(0, bytes, size);
    e->meta.bytes = size;
    if (!date_of(e->stem, &e->meta.date))
        e->meta.date = 0;
    if (damaged)
        replay_meta_take_name(&e->meta, "recovered");
    if (good)
        save_meta(r, e->stem, &e->meta, NULL, NULL, err, sizeof err);
    demo_free(&d);
    free(bytes);
    return good;
}

static bool is_listed(const struct replays *r, const char *stem)
{
    struct replay_entry key;

    memcpy(key.stem, stem, sizeof key.stem);
    return r->n > 0 && bsearch(&key, r->list, (size_t)r->n, sizeof key, by_stem) != NULL;
}

/* Removes metadata without a demo, and partially written files that are older than some complete file. */
static void remove_leftovers(const struct found *f)
{
    char path[2 * REPLAY_PATH];

    for (int i = 0; i < f->n_meta; i++) {
        path_of(f->r, f->meta[i], "card", path);
        if (!is_listed(f->r, f->meta[i]))
            plat_remove(path);
    }
    for (int i = 0; i < f->temps; i++) {
        snprintf(path, sizeof path, "user:replays/%s/%s", f->r->id, f->temp[i].name);
        if (f->temp[i].time < f->newest)
            plat_remove(path);
    }
}

bool replays_open(struct replays *r, const char *id)
{
    struct found f = { .r = r };
    char folder[REPLAY_PATH];
    int n = 0;

    memset(r, 0, sizeof *r);
    snprintf(r->id, sizeof r->id, "%s", id);
    snprintf(folder, sizeof folder, "user:replays/%s", r->id);
    plat_list(folder, find, &f);
    if (r->n)
        qsort(r->list, (size_t)r->n, sizeof r->list[0], by_stem);
    if (!f.full)
        remove_leftovers(&f);
    for (int i = 0; i < r->n; i++)
        if (load_meta(r, &r->list[i]) || repair(r, &r->list[i]))
            r->list[n++] = r->list[i];
    r->n = n;
    free(f.meta);
    return !f.full;
}

void replays_close(struct replays *r)
{
    free(r->list);
    memset(r, 0, sizeof *r);
}

bool replays_thumb(const struct replays *r, int i, struct thumb *t)
{
    uint8_t bytes[REPLAY_META_BYTES + 1];
    char path[REPLAY_PATH];

    path_of(r, r->list[i].stem, "card", path);
    const long n = plat_load(path, bytes, sizeof bytes);
    t->w = t->h = 0;
    return n > 0 && replay_meta_read_thumb(t, bytes, (size_t)n);
}

/* ---- changes ---- */

bool replays_add(struct replays *r, const uint8_t *demo, size_t size, const struct replay_meta *c,
                 const struct thumb *t, char *err, size_t err_size)
{
    struct replay_entry *e = array_append(&r->list, (size_t)r->n, sizeof *e);
    struct replay_entry new = { .meta = *c };
    char path[REPLAY_PATH];

    new.meta.hash = hash_bytes(0, demo, size);
    new.meta.bytes = size;
    free_stem(r, c->date, new.stem);
    path_of(r, new.stem, "demo", path);
    if (!e)
        return result_set_host_error(err, err_size, "%s: out of memory", path);
    if (!files_save(path, demo, size, err, err_size))
        return false;
    if (!save_meta(r, new.stem, &new.meta, t, NULL, err, err_size)) {
        plat_remove(path);
        return false;
    }
    memmove(r->list + 1, r->list, (size_t)r->n * sizeof r->list[0]);
    r->list[0] = new;
    r->n++;
    return true;
}

/* Saves changed metadata with the same thumbnail. */
static bool replace_meta(struct replays *r, int i, const struct replay_meta *c, struct unsaved **unsaved, char *err,
                         size_t err_size)
{
    struct thumb t;

    replays_thumb(r, i, &t);
    if (!save_meta(r, r->list[i].stem, c, &t, unsaved, err, err_size))
        return false;
    r->list[i].meta = *c;
    return true;
}

bool replays_name(struct replays *r, int i, const char *name, char *err, size_t err_size)
{
    struct replay_meta c = r->list[i].meta;

    replay_meta_take_name(&c, name);
    return replace_meta(r, i, &c, NULL, err, err_size);
}

bool replays_set_favourite(struct replays *r, int i, bool on, char *err, size_t err_size)
{
    struct replay_meta c = r->list[i].meta;

    c.is_favourite = on;
    return replace_meta(r, i, &c, NULL, err, err_size);
}

bool replays_add_row(struct replays *r, int i, const struct replay_meta_row *row, struct unsaved **unsaved, char *err,
                     size_t err_size)
{
    struct replay_meta c = r->list[i].meta;

    c.rows += c.rows < REPLAY_MAX_ROWS;
    c.row[c.rows - 1] = *row;
    return replace_meta(r, i, &c, unsaved, err, err_size);
}

bool replays_delete(struct replays *r, int i, char *err, size_t err_size)
{
    char demo[REPLAY_PATH], meta[REPLAY_PATH];

    replays_path(r, i, demo);
    path_of(r, r->list[i].stem, "card", meta);
    errno = 0;
    if (!plat_remove(demo) && plat_file_size(demo) >= 0)
        return err_set(err, err_size, "%s: cannot be removed%s%s%s", demo, errno ? " (" : "",
                       errno ? strerror(errno) : "", errno ? ")" : "");
    plat_remove(meta);
    r->n--;
    memmove(r->list + i, r->list + i + 1, (size_t)(r->n - i) * sizeof r->list[0]);
    return true;
}

static bool is_protected(const struct replay_meta *c,
                         bool (*in_table)(void *context, const struct replay_meta_row *row), void *context)
{
    for (int i = 0; in_table && i < c->rows; i++)
        if (in_table(context, &c->row[i]))
            return true;
    return c->name[0] != 0 || c->is_favourite;
}

void replays_prune(struct replays *r, int keep, bool (*in_table)(void *context, const struct replay_meta_row *row),
                   void *context)
{
    char err[256];
    int kept_count = 0;

    for (int i = 0; i < r->n;) {
        if (is_protected(&r->list[i].meta, in_table, context) || kept_count < keep) {
            kept_count += !is_protected(&r->list[i].meta, in_table, context);
            i++;
        } else if (!replays_delete(r, i, err, sizeof err)) {
            i++; /* try again next time */
        }
    }
}

/* ---- importing ---- */

static bool is_saved(const struct replays *r, uint64_t hash)
{
    for (int i = 0; i < r->n; i++)
        if (r->list[i].meta.hash == hash)
            return true;
    return false;
}

/* Returns why a demo can't be imported; NULL: it can. */
static const char *refusal(const struct replays *r, const struct replay_meta *c, uint64_t hash, const struct rom *rom)
{
    if (strcmp(c->id, r->id) != 0)
        return "it was recorded in another game";
    if (is_saved(r, hash))
        return "it is in the list already";
    if (c->core > CORE_VERSION)
        return "it was recorded with a newer version of Curtain";
    if (c->rom != rom_hash(rom) && c->game != rom_game_hash(rom) && !roms_has(c->id, c->rom))
        return "it was recorded in another version of this game, which is not stored here";
    return NULL;
}

/* Returns the date in a file's name, "ID-20261123-154412.demo", or now. */
static int64_t date_of_file(const char *path)
{
    const char *name = path;
    int64_t date;

    for (const char *s = path; *s; s++)
        if (strchr("/\\:-", *s))
            name = date_of(s + 1, &date) ? s + 1 : name;
    return date_of(name, &date) ? date : (int64_t)time(NULL);
}

bool replays_import(struct replays *r, const char *path, const struct rom *rom, char *err, size_t err_size)
{
    struct demo d;
    struct replay_meta c;
    uint8_t *bytes;
    size_t size;

    if (!files_read(path, path, DEMO_MAX_BYTES, &bytes, &size, err, err_size))
        return false;
    bool good = demo_read(&d, bytes, size, err, err_size);
    if (good && !replay_meta_of_demo(&c, &d))
        good = err_set(err, err_size, "it is not a recording of a game");
    const char *why = good ? refusal(r, &c, hash_bytes(0, bytes, size), rom) : NULL;
    if (why)
        good = err_set(err, err_size, "%s", why);
    c.is_favourite = 1;
    if (good) {
        c.date = date_of_file(path);
        good = replays_add(r, bytes, size, &c, NULL, err, err_size);
        qsort(r->list, (size_t)r->n, sizeof r->list[0], by_stem);
    }
    demo_free(&d);
    free(bytes);
    return good;
}

/* ---- rows and ROMs ---- */

static bool is_row(const struct replay_meta_row *a, const char *table, const struct nv_row *b)
{
    return a->row.score == b->score && a->row.stage == b->stage && a->row.continues == b->continues &&
           strcmp(a->table, table) == 0 && strcmp(a->row.name, b->name) == 0 && strcmp(a->row.ship, b->ship) == 0;
}

int replays_of_row(const struct replays *r, const char *table, const struct nv_row *row)
{
    for (int i = 0; i < r->n; i++)
        for (int k = 0; k < r->list[i].meta.rows; k++)
            if (is_row(&r->list[i].meta.row[k], table, row))
                return i;
    return -1;
}

struct needs {
    const struct replays *r;
    uint64_t also;
};

static bool needed(void *context, uint64_t hash)
{
    const struct needs *n = context;

    for (int i = 0; i < n->r->n; i++)
        if (n->r->list[i].meta.rom == hash)
            return true;
    return hash == n->also;
}

void replays_collect_roms(struct replays *r, uint64_t also)
{
    struct needs n = { r, also };

    roms_collect(r->id, needed, &n);
}
