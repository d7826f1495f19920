/* temp_lump.c - until the packer packs documents. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../src/board/rom/cart.h"
#include "../../src/cab/bulletml/compile.h"
#include "../../src/cab/bulletml/document.h"
#include "../../src/cab/pack/pack.h"
bool temp_lump(struct rom_image *image, const char *file, char *err, size_t err_size);
static int by_name(const void *a, const void *b)
{
    return strcmp(((const struct lump *)a)->name, ((const struct lump *)b)->name);
}
bool temp_lump(struct rom_image *image, const char *file, char *err, size_t err_size)
{
    struct rom_image had = *image;
    struct lump *l = calloc(had.rom.count + 1, sizeof *l);
    static char bytes[1 << 20];
    FILE *f = fopen(file, "rb");
    size_t n = fread(bytes, 1, sizeof bytes, f), size;
    struct document d;
    uint8_t *prog;
    fclose(f);
    if (!document_read(&d, bytes, n, "document.xml", NULL, NULL, err, err_size))
        return false;
    if (!bulletml_compile(&d, "document.xml", &prog, &size, err, err_size))
        return false;
    document_close(&d);
    for (uint32_t i = 0; i < had.rom.count; i++) {
        rom_lump(&had.rom, (int)i, &l[i]);
        if (!strncmp(l[i].name, "bulletml/", 9))
            return true;
    }
    l[had.rom.count] = (struct lump){ "bulletml/document", prog, (uint32_t)size };
    qsort(l, had.rom.count + 1, sizeof *l, by_name);
    image->size = rom_write_size(l, (int)had.rom.count + 1);
    image->bytes = malloc(image->size);
    rom_write(image->bytes, l, (int)had.rom.count + 1);
    return rom_open(&image->rom, image->bytes, image->size, err, err_size);
}
