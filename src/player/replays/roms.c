/*
 * roms.c - stores ROMs (roms.h). An id contains no '-', so file names are unambiguous.
 */
#include "roms.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../common/files.h"

#define FOLDER "user:roms"

enum { HASH_DIGITS = 16, MAX_REMOVED = 64 /* removed by one call of roms_collect */ };

void roms_path(char path[ROMS_PATH], const char *id, uint64_t hash)
{
    snprintf(path, ROMS_PATH, FOLDER "/%s-%016" PRIx64 ".rom", id, hash);
}

bool roms_has(const char *id, uint64_t hash)
{
    char path[ROMS_PATH];

    roms_path(path, id, hash);
    return plat_file_size(path) > 0;
}

bool roms_store(struct unsaved **unsaved, const char *id, const struct rom *rom, char *err, size_t err_size)
{
    char path[ROMS_PATH];

    roms_path(path, id, rom_hash(rom));
    return plat_file_size(path) == (long)rom->size || unsaved_save(unsaved, path, rom->data, rom->size, err, err_size);
}

struct collection {
    const char *id;
    bool (*needed)(void *context, uint64_t hash);
    void *context;
    uint64_t unneeded[MAX_REMOVED];
    int n;
};

/* Reads the hash in "ID-HASH.rom". Returns false for other names. */
static bool hash_in(const char *name, const char *id, uint64_t *hash)
{
    const size_t n = strlen(id);
    char rest[8] = "";

    if (strncmp(name, id, n) != 0 || name[n] != '-' || strlen(name) != n + 1 + HASH_DIGITS + 4)
        return false;
    return sscanf(name + n + 1, "%16" SCNx64 "%7s", hash, rest) == 2 && strcmp(rest, ".rom") == 0;
}

static void find_unneeded(void *user, const struct plat_folder_entry *file)
{
    struct collection *c = user;
    uint64_t hash;

    if (file->is_folder || c->n == MAX_REMOVED || !hash_in(file->name, c->id, &hash) || c->needed(c->context, hash))
        return;
    c->unneeded[c->n++] = hash;
}

void roms_collect(const char *id, bool (*needed)(void *context, uint64_t hash), void *context)
{
    struct collection c = { .id = id, .needed = needed, .context = context };
    char path[ROMS_PATH];

    plat_list(FOLDER, find_unneeded, &c);
    for (int i = 0; i < c.n; i++) {
        roms_path(path, id, c.unneeded[i]);
        plat_remove(path);
    }
}
