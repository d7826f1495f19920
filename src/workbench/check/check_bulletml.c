/*
 * check_bulletml.c - mistakes in all BulletML documents of a game, and documents that are never packed.
 */
#include <stdlib.h>
#include "../bulletml/compile.h"
#include "../bulletml/document.h"
#include "../pack/pack.h"
#include "check_parts.h"

static void add_sentence(void *context, const char *sentence)
{
    struct check *c = context;

    diagnostics_add_sentence(&c->found, "bulletml", sentence);
}

static void check_document(struct check *c, const char *path)
{
    uint8_t *text, *program = NULL;
    struct document d;
    char err[1200];
    size_t size;

    if (!check_load(c, path, DOCUMENT_MAX_FILE, &text, &size))
        return;
    if (!document_read(&d, (const char *)text, size, path, add_sentence, c, err, sizeof err) ||
        !bulletml_compile(&d, path, &program, &size, err, sizeof err)) {
        diagnostics_add_sentence(&c->found, path, err);
        c->broken = c->broken || c->m.bulletml_runners > 0;
    }
    document_free(&d);
    free(program);
    free(text);
}

void check_bulletml(struct check *c)
{
    int n = 0;

    for (int i = 0; i < c->files.n; i++)
        if (pack_is_bulletml(c->files.name[i])) {
            check_document(c, c->files.name[i]);
            n++;
        }
    if (n > 0 && c->manifest && c->m.bulletml_runners == 0)
        diagnostics_add(&c->found, "rom.lua", 0,
                        "documents in bulletml/ are not packed: BulletML is disabled; add bulletml = 1024 to board");
    if (n == 0 && c->manifest && c->m.bulletml_runners > 0)
        diagnostics_add(&c->found, "rom.lua", CHECK_LINE(c, "board", "bulletml"),
                        "board.bulletml is set, but the game has no document bulletml/NAME.xml");
}
