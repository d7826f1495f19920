/*
 * pe.c - see pe.h. Microsoft's "PE Format" has the layout of the file, "VS_VERSIONINFO" and "Icons" that of resources.
 *
 * All resources are written to a new section at the end, and the header points to it. The bytes of the old resources
 * are overwritten with zeroes.
 */
#include "pe.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/bytes.h"
#include "../../../fb/utf8.h"
#include "../../base/err.h"
#include "../../common/byte_buffer.h"
#include "../../common/clean.h"
#include "../../common/result.h"
#include "../../player/game/version.h"
#include "../../player/picture/icon.h"
#include "../../player/picture/png.h"

enum {                   /* sizes, and offsets in the optional header */
       FILE_HEADER = 24, /* with the signature PE\0\0 */
       SECTION = 40,
       INITIALIZED = 8,
       SECTION_ALIGN = 32,
       FILE_ALIGN = 36,
       IMAGE_SIZE = 56,
       HEADERS_SIZE = 60,
       CHECKSUM = 64,
       RESOURCES = 128, /* the directory's address and size */
       SIGNATURE = 144,
       OPTIONAL_HEADER = 152 /* up to the end of SIGNATURE */
};

enum { RT_ICON = 3, RT_GROUP_ICON = 14, RT_VERSION = 16, ENGLISH = 0x409, MAX_RESOURCES = 64 };

struct resource {
    uint32_t type, id, language;
    const uint8_t *data;
    uint32_t size;
};

struct pe {
    uint8_t *file, *header, *optional, *sections;
    uint32_t size, n_sections;
    uint32_t address_end, file_end;                               /* end of the last section: in memory, in the file */
    struct resource old[MAX_RESOURCES], resources[MAX_RESOURCES]; /* resources of the input, of the output */
    int n_old, n;
};

/* ---- reading ---- */

static uint32_t align(uint32_t v, uint32_t to)
{
    return (v + to - 1) / to * to;
}

static bool is_alignment(uint32_t v)
{
    return v >= 512 && v <= 65536 && !(v & (v - 1));
}

static bool read_header(struct pe *pe)
{
    const uint32_t at = bytes_get32(pe->file + 60);

    if (at > pe->size || pe->size - at < FILE_HEADER + OPTIONAL_HEADER || memcmp(pe->file + at, "PE\0\0", 4) != 0)
        return false;
    pe->header = pe->file + at;
    pe->optional = pe->header + FILE_HEADER;
    pe->n_sections = bytes_get16(pe->header + 6);
    const uint32_t optional = bytes_get16(pe->header + 20), headers = bytes_get32(pe->optional + HEADERS_SIZE);
    pe->sections = pe->optional + optional;
    return optional >= OPTIONAL_HEADER && bytes_get16(pe->header + 4) == 0x8664 && bytes_get16(pe->optional) == 0x20b &&
           bytes_get32(pe->optional + 108) >= 5 && headers <= pe->size &&
           (uint64_t)at + FILE_HEADER + optional + (uint64_t)(pe->n_sections + 1) * SECTION <= headers &&
           is_alignment(bytes_get32(pe->optional + SECTION_ALIGN)) &&
           is_alignment(bytes_get32(pe->optional + FILE_ALIGN));
}

static bool read_sections(struct pe *pe)
{
    for (uint32_t i = 0; i < pe->n_sections; i++) {
        const uint8_t *s = pe->sections + i * SECTION;
        const uint32_t size = bytes_get32(s + 8), address = bytes_get32(s + 12);
        const uint32_t raw = bytes_get32(s + 16), from = bytes_get32(s + 20);
        if (size > 1u << 30 || address > 1u << 30 || from > pe->size || raw > pe->size - from)
            return false;
        pe->address_end = address + size > pe->address_end ? address + size : pe->address_end;
        pe->file_end = from + raw > pe->file_end ? from + raw : pe->file_end;
    }
    return pe->file_end >= bytes_get32(pe->optional + HEADERS_SIZE);
}

/* Returns the n bytes loaded at an address, or NULL if they are not all in one section. */
static uint8_t *bytes_at(const struct pe *pe, uint32_t address, uint32_t n)
{
    for (uint32_t i = 0; i < pe->n_sections; i++) {
        const uint8_t *s = pe->sections + i * SECTION;
        const uint32_t from = bytes_get32(s + 12), raw = bytes_get32(s + 16);
        if (address >= from && address - from <= raw && n <= raw - (address - from))
            return pe->file + bytes_get32(s + 20) + (address - from);
    }
    return NULL;
}

/* Reads the resource directory at offset `at` and its subdirectories. Levels: 0 types, 1 ids, 2 languages. */
static bool read_directory(struct pe *pe, uint32_t at, int level, struct resource r)
{
    const uint32_t base = bytes_get32(pe->optional + RESOURCES), size = bytes_get32(pe->optional + RESOURCES + 4);
    const uint8_t *tree = bytes_at(pe, base, size);

    if (!tree || at > size || size - at < 16)
        return false;
    const uint32_t names = bytes_get16(tree + at + 12), n = bytes_get16(tree + at + 14);
    if (names > 0 || n == 0 || n > (size - at - 16) / 8)
        return false;
    for (uint32_t i = 0; i < n; i++) {
        const uint8_t *entry = tree + at + 16 + 8 * i;
        const uint32_t id = bytes_get32(entry), to = bytes_get32(entry + 4);
        *(level == 0 ? &r.type : level == 1 ? &r.id : &r.language) = id;
        if (level < 2) {
            if (!(to >> 31) || !read_directory(pe, to & 0x7fffffff, level + 1, r))
                return false;
            continue;
        }
        if (to > size || size - to < 16 || pe->n_old == MAX_RESOURCES)
            return false;
        r.size = bytes_get32(tree + to + 4);
        r.data = bytes_at(pe, bytes_get32(tree + to), r.size);
        if (!r.data)
            return false;
        pe->old[pe->n_old++] = r;
    }
    return true;
}

/* ---- the icon ---- */

static void put16(struct byte_buffer *r, unsigned v)
{
    byte_buffer_byte(r, (uint8_t)v);
    byte_buffer_byte(r, (uint8_t)(v >> 8));
}

static void put32(struct byte_buffer *r, uint32_t v)
{
    put16(r, v & 0xffff);
    put16(r, v >> 16);
}

/* Writes a bitmap: 32 bits per pixel, bottom row first, then a 1-bit mask of the transparent pixels. */
static void put_bitmap(struct byte_buffer *r, const uint8_t *rgba, int side)
{
    put32(r, 40);
    put32(r, (uint32_t)side);
    put32(r, 2 * (uint32_t)side); /* mask included */
    put16(r, 1);
    put16(r, 32);
    for (int i = 0; i < 6; i++)
        put32(r, 0);
    for (int y = side - 1; y >= 0; y--)
        for (const uint8_t *p = rgba + 4 * y * side; p < rgba + 4 * (y + 1) * side; p += 4)
            put32(r, (uint32_t)p[3] << 24 | (uint32_t)p[0] << 16 | (uint32_t)p[1] << 8 | p[2]);
    for (int y = side - 1; y >= 0; y--)
        for (int x = 0; x < (side + 31) / 32 * 32; x += 8) {
            unsigned bits = 0;
            for (int i = x; i < x + 8 && i < side; i++)
                bits |= rgba[4 * (y * side + i) + 3] < 128 ? 128u >> (i - x) : 0;
            byte_buffer_byte(r, (uint8_t)bits);
        }
}

enum { ICONS = 4 };

/* Writes the icon's pictures one after another, the size of each, and the group that lists them. False if the game has
 * no icon or memory runs out. */
static bool make_icons(const struct cart *cart, struct byte_buffer *pictures, uint32_t sizes[ICONS],
                       struct byte_buffer *group)
{
    static const int sides[ICONS] = { 16, 32, 48, 256 };

    put16(group, 0);
    put16(group, 1);
    put16(group, ICONS);
    for (int i = 0; i < ICONS; i++) {
        const size_t from = pictures->n;
        uint8_t *rgba = icon_fit(cart, sides[i]), *png = NULL;
        size_t n;
        bool good = rgba != NULL;
        if (good && sides[i] < 256) /* PNG is allowed at 256 only */
            put_bitmap(pictures, rgba, sides[i]);
        else if (good && (good = png_write_rgba(rgba, sides[i], sides[i], &png, &n)))
            byte_buffer_put(pictures, png, n);
        free(png);
        free(rgba);
        if (!good)
            return false;
        sizes[i] = (uint32_t)(pictures->n - from);
        put16(group, (unsigned)(sides[i] & 255) * 257); /* width and height; 0 means 256 */
        put16(group, 0);
        put16(group, 1);
        put16(group, 32);
        put32(group, sizes[i]);
        put16(group, (unsigned)i + 1);
    }
    return !pictures->failed && !group->failed;
}

/* ---- the version ---- */

static void pad(struct byte_buffer *r, size_t to)
{
    while (!r->failed && r->n % to)
        byte_buffer_byte(r, 0);
}

/* Writes UTF-16 with a terminating 0; returns the number of units, the 0 included. */
static unsigned put_text(struct byte_buffer *r, const char *text)
{
    const char *end = text + strlen(text);
    const size_t from = r->n;

    while (text < end) {
        const uint32_t c = utf8_next(&text, end);
        if (c > 0xffff)
            put16(r, 0xd7c0 + (c >> 10));
        put16(r, c > 0xffff ? 0xdc00 | (c & 0x3ff) : c);
    }
    put16(r, 0);
    return (unsigned)(r->n - from) / 2;
}

/* Starts a block of a version resource and returns its offset; close_block writes its length. */
static size_t open_block(struct byte_buffer *r, const char *key, unsigned value_length, bool is_text)
{
    pad(r, 4);
    const size_t at = r->n;
    put16(r, 0);
    put16(r, value_length);
    put16(r, is_text);
    put_text(r, key);
    pad(r, 4);
    return at;
}

static void close_block(struct byte_buffer *r, size_t at)
{
    if (!r->failed)
        bytes_put16(r->bytes + at, (uint16_t)(r->n - at));
}

static void put_string(struct byte_buffer *r, const char *name, const char *format, const char *text)
{
    char value[128];

    snprintf(value, sizeof value, format, text);
    clean_line(value);
    const size_t at = open_block(r, name, 0, true);
    const unsigned n = put_text(r, value);
    if (!r->failed)
        bytes_put16(r->bytes + at + 2, (uint16_t)n);
    close_block(r, at);
}

static void make_version(struct byte_buffer *r, const struct manifest *m)
{
    unsigned v[3] = { 0 };
    char game[16];

    sscanf(CURTAIN_VERSION, "%u.%u.%u", &v[0], &v[1], &v[2]);
    snprintf(game, sizeof game, "%d", (int)m->version);
    const size_t all = open_block(r, "VS_VERSION_INFO", 52, false);
    put32(r, 0xfeef04bd);
    put32(r, 1u << 16);
    put32(r, v[0] << 16 | v[1]); /* of the file */
    put32(r, v[2] << 16);
    put32(r, (uint32_t)m->version << 16); /* of the product */
    put32(r, 0);
    put32(r, 0x3f);
    put32(r, 0);
    put32(r, 0x40004); /* VOS_NT_WINDOWS32 */
    put32(r, 1);       /* VFT_APP */
    for (int i = 0; i < 3; i++)
        put32(r, 0);
    const size_t strings = open_block(r, "StringFileInfo", 0, true), table = open_block(r, "040904B0", 0, true);
    if (m->author[0])
        put_string(r, "CompanyName", "%s", m->author);
    put_string(r, "FileDescription", "%s", m->title);
    put_string(r, "FileVersion", "%s", CURTAIN_VERSION);
    put_string(r, "InternalName", "%s", m->id);
    put_string(r, "OriginalFilename", "%s.exe", m->id);
    put_string(r, "ProductName", "%s", m->title);
    put_string(r, "ProductVersion", "%s", game);
    put_string(r, "Comments", "Made with Curtain %s", CURTAIN_VERSION);
    close_block(r, table);
    close_block(r, strings);
    const size_t info = open_block(r, "VarFileInfo", 0, true), language = open_block(r, "Translation", 4, false);
    put32(r, 0x04b00409); /* US English, Unicode */
    close_block(r, language);
    close_block(r, info);
    close_block(r, all);
}

/* ---- writing ---- */

static void add_resource(struct pe *pe, struct resource r)
{
    if (pe->n < MAX_RESOURCES)
        pe->resources[pe->n++] = r;
}

/* Orders by type, then by id, as a directory requires. */
static int compare_resources(const void *a, const void *b)
{
    const struct resource *x = a, *y = b;

    if (x->type != y->type)
        return x->type < y->type ? -1 : 1;
    return x->id < y->id ? -1 : x->id > y->id;
}

static void put_directory(struct byte_buffer *r, unsigned n)
{
    for (int i = 0; i < 3; i++) /* flags, time, version */
        put32(r, 0);
    put16(r, 0);
    put16(r, n);
}

/* Writes the directory tree of the sorted resources, and their data. address: where the tree is loaded. */
static void put_tree(const struct pe *pe, struct byte_buffer *r, uint32_t address)
{
    const struct resource *all = pe->resources;
    const uint32_t n = (uint32_t)pe->n;
    uint32_t types = 0, at;

    for (uint32_t i = 0; i < n; i++)
        types += i == 0 || all[i].type != all[i - 1].type;
    const uint32_t numbers = 16 + 8 * types, languages = numbers + 16 * types + 8 * n, entries = languages + 24 * n;
    put_directory(r, types);
    at = numbers;
    for (uint32_t i = 0, last; i < n; i = last) {
        for (last = i; last < n && all[last].type == all[i].type;)
            last++;
        put32(r, all[i].type);
        put32(r, at | 1u << 31);
        at += 16 + 8 * (last - i);
    }
    for (uint32_t i = 0, last; i < n; i = last) {
        for (last = i; last < n && all[last].type == all[i].type;)
            last++;
        put_directory(r, last - i);
        for (uint32_t k = i; k < last; k++) {
            put32(r, all[k].id);
            put32(r, (languages + 24 * k) | 1u << 31);
        }
    }
    for (uint32_t i = 0; i < n; i++) {
        put_directory(r, 1);
        put32(r, all[i].language);
        put32(r, entries + 16 * i);
    }
    at = align(entries + 16 * n, 8);
    for (uint32_t i = 0; i < n; i++) {
        put32(r, address + at);
        put32(r, all[i].size);
        put32(r, 0);
        put32(r, 0);
        at += align(all[i].size, 8);
    }
    for (uint32_t i = 0; i < n; i++) {
        pad(r, 8);
        byte_buffer_put(r, all[i].data, all[i].size);
    }
}

/* Writes the header of the new section and updates the file's header. */
static void put_section(struct pe *pe, uint32_t address, uint32_t from, uint32_t size, uint32_t raw)
{
    uint8_t *s = pe->sections + pe->n_sections * SECTION, *o = pe->optional;

    for (uint32_t i = 0; i < pe->n_sections; i++)
        if (memcmp(pe->sections + i * SECTION, ".rsrc\0\0", 8) == 0)
            memcpy(pe->sections + i * SECTION, ".unused", 8);
    memset(s, 0, SECTION);
    memcpy(s, ".rsrc", 5);
    bytes_put32(s + 8, size);
    bytes_put32(s + 12, address);
    bytes_put32(s + 16, raw);
    bytes_put32(s + 20, from);
    bytes_put32(s + 36, 0x40000040); /* initialized data, readable */
    bytes_put16(pe->header + 6, (uint16_t)(pe->n_sections + 1));
    memset(pe->header + 8, 0, 12); /* time stamp and symbol table */
    bytes_put32(o + INITIALIZED, bytes_get32(o + INITIALIZED) + raw);
    bytes_put32(o + IMAGE_SIZE, align(address + size, bytes_get32(o + SECTION_ALIGN)));
    bytes_put32(o + CHECKSUM, 0); /* none */
    bytes_put32(o + RESOURCES, address);
    bytes_put32(o + RESOURCES + 4, size);
    memset(o + SIGNATURE, 0, 8);
}

/* Replaces the file by a copy of its sections, old resources zeroed, followed by the new section. */
static bool write_copy(struct pe *pe, uint8_t **file, size_t *size)
{
    const uint32_t address = align(pe->address_end, bytes_get32(pe->optional + SECTION_ALIGN));
    const uint32_t file_align = bytes_get32(pe->optional + FILE_ALIGN), from = align(pe->file_end, file_align);
    struct byte_buffer tree = { 0 };

    qsort(pe->resources, (size_t)pe->n, sizeof pe->resources[0], compare_resources);
    put_tree(pe, &tree, address);
    const uint32_t raw = align((uint32_t)tree.n, file_align);
    uint8_t *out = tree.failed ? NULL : calloc((size_t)from + raw, 1);
    if (out) {
        put_section(pe, address, from, (uint32_t)tree.n, raw);
        memcpy(out, pe->file, pe->file_end);
        for (int i = 0; i < pe->n_old; i++)
            memset(out + (pe->old[i].data - pe->file), 0, pe->old[i].size);
        memcpy(out + from, tree.bytes, tree.n);
        free(*file);
        *file = out;
        *size = (size_t)from + raw;
    }
    byte_buffer_close(&tree);
    return out != NULL;
}

/* ---- replacing resources ---- */

bool pe_is(const uint8_t *file, size_t size)
{
    return size >= 64 && memcmp(file, "MZ", 2) == 0;
}

bool pe_set_resources(uint8_t **file, size_t *size, const struct cart *cart, char *err, size_t err_size)
{
    struct pe pe = { .file = *file, .size = (uint32_t)*size };
    struct byte_buffer pictures = { 0 }, group = { 0 }, version = { 0 };
    uint32_t sizes[ICONS], at = 0;

    if (!pe_is(*file, *size) || *size > INT32_MAX || !read_header(&pe) || !read_sections(&pe))
        return err_set(err, err_size, "expected an x86-64 Windows program with space for another section");
    if (!read_directory(&pe, 0, 0, (struct resource){ 0 }))
        return err_set(err, err_size, "the program's resources are damaged");
    const bool icon = make_icons(cart, &pictures, sizes, &group);
    make_version(&version, &cart->manifest);
    for (int i = 0; i < pe.n_old; i++)
        if (pe.old[i].type != RT_VERSION && !(icon && (pe.old[i].type == RT_ICON || pe.old[i].type == RT_GROUP_ICON)))
            add_resource(&pe, pe.old[i]);
    for (uint32_t i = 0; icon && i < ICONS; at += sizes[i++])
        add_resource(&pe, (struct resource){ RT_ICON, i + 1, ENGLISH, pictures.bytes + at, sizes[i] });
    if (icon)
        add_resource(&pe, (struct resource){ RT_GROUP_ICON, 1, ENGLISH, group.bytes, (uint32_t)group.n });
    add_resource(&pe, (struct resource){ RT_VERSION, 1, ENGLISH, version.bytes, (uint32_t)version.n });
    const bool good = !version.failed && write_copy(&pe, file, size);
    byte_buffer_close(&pictures);
    byte_buffer_close(&group);
    byte_buffer_close(&version);
    return good ? true : result_set_host_error(err, err_size, "out of memory");
}
