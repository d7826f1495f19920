/*
 * fuzz_symbols.c - libFuzzer: any bytes as a Lua script, read without Lua: tokens, and the symbols that `check` finds.
 * All that is found is there to its last byte. (fuzz_manifest.c looks at what the compiler takes.)
 */
#include "../../src/workbench/check/symbols.h"
#include "fuzz.h"

/* A text that may be missing. */
static size_t text(const char *s)
{
    return s ? strlen(s) : 0;
}

static size_t calls_and_tables(const struct symbols *f)
{
    size_t n = 0;

    for (int i = 0; i < f->n_calls; i++) {
        n += text(f->calls[i].space) + strlen(f->calls[i].name);
        for (int k = 0; k < SYMBOL_ARGS; k++)
            n += text(f->calls[i].arg[k]);
        need(f->calls[i].line > 0 && f->calls[i].args >= 0);
    }
    for (int i = 0; i < f->n_tables; i++) {
        n += text(f->tables[i].space) + text(f->tables[i].name);
        need(f->tables[i].key >= -1 && f->tables[i].key < f->n_keys);
    }
    for (int i = 0; i < f->n_keys; i++) {
        n += strlen(f->keys[i].name) + text(f->keys[i].value);
        need(f->keys[i].table >= 0 && f->keys[i].table < f->n_tables);
    }
    for (int i = 0; i < f->n_members; i++)
        n += strlen(f->members[i].field);
    need(f->result_table >= -1 && f->result_table < f->n_tables);
    return n;
}

static size_t names(const struct symbols *f)
{
    size_t n = 0;

    for (int i = 0; i < f->n_globals; i++) {
        n += strlen(f->globals[i].name) + text(f->globals[i].field) + text(f->globals[i].local);
        need(f->globals[i].line > 0);
    }
    for (int i = 0; i < f->n_iterations; i++) {
        const struct symbol_origin *of = &f->iterations[i].origin;
        n += strlen(f->iterations[i].operation) + text(of->space) + text(of->name) + text(of->key);
    }
    for (int i = 0; i < f->n_divisions; i++)
        n += strlen(f->divisions[i].operation);
    for (int i = 0; i < f->n_formats; i++)
        n += strlen(f->formats[i].s);
    for (int i = 0; i < f->n_texts; i++)
        n += strlen(f->texts[i].s);
    return n;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char *const path[] = { "sheets", "small", "file", NULL };
    char *copy = fuzz_copy(data, size);
    struct symbols f;

    bool whole = symbols_read(&f, copy, size, NULL);
    need(whole == f.complete && names(&f) + calls_and_tables(&f) < SIZE_MAX / 2 && symbols_line(&f, path) > 0);
    symbols_free(&f);
    free(copy);
    return 0;
}
