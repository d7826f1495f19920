/*
 * fuzz_manifest.c - libFuzzer: any bytes as the binary manifest and as the text of rom.lua and of a script. What is
 * taken is in range and survives packing; what is refused comes with one line. A script that compiles is one that the
 * lint reads to its end.
 */
#include "../../src/rom/manifest.h"
#include "../../src/script/script.h"
#include "../../src/workbench/check/symbols.h"
#include "../../src/workbench/check/builtins.h"
#include "fuzz.h"

static void binary(const uint8_t *data, size_t size)
{
    uint8_t again[MANIFEST_BYTES];
    struct manifest m;
    char err[256] = "";

    if (!manifest_unpack(data, size, &m, err, sizeof err)) {
        need_line(err);
        return;
    }
    const uint32_t packed = manifest_pack(&m, again);
    need(size != packed || memcmp(again, data, packed) == 0); /* older formats have other sizes */
}

static void text(const char *data, size_t size)
{
    static struct art art;
    static _Alignas(16) uint8_t work[MANIFEST_SCRATCH_SIZE];
    uint8_t bytes[MANIFEST_BYTES];
    struct manifest m, back;
    char err[256] = "";

    if (!manifest_read(data, size, "rom.lua", "game", &m, &art, work, err, sizeof err)) {
        need_line(err);
        return;
    }
    const uint32_t packed = manifest_pack(&m, bytes);
    need(manifest_unpack(bytes, packed, &back, err, sizeof err));
}

/* What the compiler takes, the lint reads to its end. */
static void symbols(const char *data, size_t size, bool compiles)
{
    struct symbols f;

    need(symbols_read(&f, data, size, builtins_global) || !compiles);
    for (int i = 0; i < f.n_globals; i++)
        need(f.globals[i].line > 0 && f.globals[i].name != NULL);
    symbols_free(&f);
}

static void script(const char *data, size_t size)
{
    static _Alignas(16) char work[4 << 20];
    char err[256] = "";

    if (!script_check(data, size, "@a.lua", work, sizeof work, err, sizeof err))
        need_line(err);
    symbols(data, size, script_compile(data, size, "@a.lua", work, sizeof work, err, sizeof err));
}

/* The first byte chooses the reader. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size == 0)
        return 0;
    size_t n = size - 1;
    uint8_t *copy = fuzz_copy(data + 1, n);
    if (data[0] % 4 == 0)
        binary(copy, n);
    else if (data[0] % 4 == 1)
        script((const char *)copy, n);
    else
        text((const char *)copy, n);
    free(copy);
    return 0;
}
