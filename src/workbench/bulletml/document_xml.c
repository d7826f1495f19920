/*
 * document_xml.c - a document's XML, read by expat, to nodes. The library is opened when the first document is met
 * (library.h), so a program that packs none runs without it.
 *
 * A document type is passed over as it is written, and never fetched. Entities of a document's own are refused where
 * they are declared: no document needs them, and a bomb is made of nothing else. Old documents are often Shift_JIS or
 * EUC-JP, for their comments; these encodings are taken as far as comments need it.
 */
#include "document_parts.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../common/library.h"
#include "../../common/result.h"

/* ---- libexpat, as its version 1 declares it in expat.h ---- */

typedef struct XML_ParserStruct *XML_Parser;
typedef char XML_Char;
typedef unsigned char XML_Bool;
typedef long XML_Index;
typedef unsigned long XML_Size;
enum XML_Status { XML_STATUS_ERROR, XML_STATUS_OK };
enum XML_Error { XML_ERROR_INVALID_TOKEN = 4 };
enum { XML_FALSE = 0 };

typedef struct {
    int map[256];
    void *data;
    int (*convert)(void *data, const char *s);
    void (*release)(void *data);
} XML_Encoding;

typedef void (*XML_StartElementHandler)(void *user, const XML_Char *name, const XML_Char **attributes);
typedef void (*XML_EndElementHandler)(void *user, const XML_Char *name);
typedef void (*XML_CharacterDataHandler)(void *user, const XML_Char *s, int length);
typedef void (*XML_CommentHandler)(void *user, const XML_Char *s);
typedef void (*XML_ProcessingInstructionHandler)(void *user, const XML_Char *target, const XML_Char *s);
typedef void (*XML_EntityDeclHandler)(void *user, const XML_Char *name, int parameter, const XML_Char *value, int n,
                                      const XML_Char *base, const XML_Char *system, const XML_Char *public,
                                      const XML_Char *notation);
typedef void (*XML_SkippedEntityHandler)(void *user, const XML_Char *name, int parameter);
typedef int (*XML_UnknownEncodingHandler)(void *user, const XML_Char *name, XML_Encoding *info);

struct functions {
    XML_Parser (*create)(const XML_Char *encoding);
    void (*free)(XML_Parser parser);
    enum XML_Status (*parse)(XML_Parser parser, const char *bytes, int n, int last);
    enum XML_Status (*stop)(XML_Parser parser, XML_Bool resumable);
    void (*user)(XML_Parser parser, void *user);
    void (*elements)(XML_Parser parser, XML_StartElementHandler start, XML_EndElementHandler end);
    void (*text)(XML_Parser parser, XML_CharacterDataHandler text);
    void (*comment)(XML_Parser parser, XML_CommentHandler comment);
    void (*instruction)(XML_Parser parser, XML_ProcessingInstructionHandler instruction);
    void (*entity)(XML_Parser parser, XML_EntityDeclHandler entity);
    void (*skipped)(XML_Parser parser, XML_SkippedEntityHandler skipped);
    void (*encoding)(XML_Parser parser, XML_UnknownEncodingHandler encoding, void *user);
    enum XML_Error (*error)(XML_Parser parser);
    const char *(*say)(enum XML_Error error);
    XML_Size (*line)(XML_Parser parser);
    XML_Size (*column)(XML_Parser parser);
    XML_Index (*index)(XML_Parser parser);
};

static bool find(struct functions *f)
{
    const struct library_function list[] = { { "XML_ParserCreate", &f->create },
                                             { "XML_ParserFree", &f->free },
                                             { "XML_Parse", &f->parse },
                                             { "XML_StopParser", &f->stop },
                                             { "XML_SetUserData", &f->user },
                                             { "XML_SetElementHandler", &f->elements },
                                             { "XML_SetCharacterDataHandler", &f->text },
                                             { "XML_SetCommentHandler", &f->comment },
                                             { "XML_SetProcessingInstructionHandler", &f->instruction },
                                             { "XML_SetEntityDeclHandler", &f->entity },
                                             { "XML_SetSkippedEntityHandler", &f->skipped },
                                             { "XML_SetUnknownEncodingHandler", &f->encoding },
                                             { "XML_GetErrorCode", &f->error },
                                             { "XML_ErrorString", &f->say },
                                             { "XML_GetCurrentLineNumber", &f->line },
                                             { "XML_GetCurrentColumnNumber", &f->column },
                                             { "XML_GetCurrentByteIndex", &f->index } };

    return library_open(LIBRARY_EXPAT, list, sizeof list / sizeof *list);
}

enum { TEXT = 8192 /* bytes of a number */ };

struct reader {
    struct document_reader *r;
    struct functions f;
    XML_Parser parser;
    int32_t open; /* the innermost element's node */
    int depth;    /* of elements */
    int passed;   /* elements in one another within a vanish, which are passed over */
    bool foreign; /* Shift_JIS or EUC-JP */
    char text[TEXT];
    size_t n;
    int line, column; /* where the text begins */
    bool closed;      /* a comment stands behind the number: what follows does not count, as in libbulletml */
    bool told;
};

static int line_of(const struct reader *x)
{
    return (int)x->f.line(x->parser);
}

static int column_of(const struct reader *x)
{
    return (int)x->f.column(x->parser) + 1;
}

/* Nothing is read on after the first sentence. */
static bool go_on(struct reader *x)
{
    if (x->r->failed)
        x->f.stop(x->parser, XML_FALSE);
    return !x->r->failed;
}

static bool blank(const char *s, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (s[i] != ' ' && s[i] != '\t' && s[i] != '\n' && s[i] != '\r')
            return false;
    return true;
}

static const char *name_of(const struct reader *x, int32_t node)
{
    return document_element_name(x->r->d->node[node].element);
}

/* ---- elements ---- */

static void bad_element(struct reader *x, const char *name, const char *near)
{
    document_bad(x->r, line_of(x), column_of(x), "<%.40s> is not a BulletML element%s%s%s", name,
                 near[0] ? " (did you mean <" : "", near, near[0] ? ">?)" : "");
}

static void begin_element(void *user, const XML_Char *name, const XML_Char **attributes)
{
    struct reader *x = user;
    const char *near;

    if (!go_on(x))
        return;
    if (x->open != DOCUMENT_NONE && x->r->d->node[x->open].element == NODE_VANISH) {
        if (!x->told)
            document_told(x->r, x->open, "its content has no effect");
        x->told = true;
        x->passed++;
        return;
    }
    const enum document_element element = document_element_of(name, &near);
    if (element == NODE_ELEMENTS)
        bad_element(x, name, near);
    else if ((x->open == DOCUMENT_NONE) != (element == NODE_BULLETML))
        document_bad(x->r, line_of(x), column_of(x),
                     element == NODE_BULLETML ? "<%s> is inside another element"
                                              : "<%s>: expected <bulletml> as the root element",
                     name);
    else if (++x->depth > DOCUMENT_NEST)
        document_bad(x->r, line_of(x), column_of(x), "<%s>: elements nested deeper than %d", name, (int)DOCUMENT_NEST);
    const int32_t at = x->r->failed ? DOCUMENT_NONE : document_add(x->r, x->open, element, line_of(x), column_of(x));
    if (at != DOCUMENT_NONE) {
        x->open = at;
        x->n = 0;
        x->closed = x->told = false;
        document_attributes(x->r, at, attributes, x->foreign);
    }
    go_on(x);
}

/* The place of a byte of the text in the file. */
static void text_place(const struct reader *x, size_t at, int *line, int *column)
{
    *line = x->line;
    *column = x->column;
    for (size_t i = 0; i < at && i < x->n; i++)
        if (x->text[i] == '\n') {
            ++*line;
            *column = 1;
        } else if ((x->text[i] & 0xc0) != 0x80) {
            ++*column;
        }
}

static void read_number(struct reader *x, int32_t at)
{
    struct document_node *node = &x->r->d->node[at];
    struct expression_op ops[EXPRESSION_OPS];
    struct expression_error error;
    bool large;
    int line, column;

    if (blank(x->text, x->n)) {
        document_bad(x->r, node->line, node->column, "<%s>: expected a number, got nothing", name_of(x, at));
        return;
    }
    node->ops = expression_read(x->text, x->n, ops, &large, &error);
    if (node->ops == 0) {
        text_place(x, error.at, &line, &column);
        document_bad(x->r, line, column, "<%s>: %s", name_of(x, at), error.text);
        return;
    }
    node->op = document_keep(x->r, ops, (size_t)node->ops * sizeof *ops);
    if (large)
        document_told(x->r, at, "numbers above 2147483647 are clamped to 2147483647");
}

static void end_element(void *user, const XML_Char *name)
{
    struct reader *x = user;

    (void)name;
    if (!go_on(x))
        return;
    if (x->passed > 0) {
        x->passed--;
        return;
    }
    if (document_has_number(x->r->d->node[x->open].element))
        read_number(x, x->open);
    x->open = x->r->d->node[x->open].parent;
    x->depth--;
    x->n = 0;
    go_on(x);
}

/* ---- text ---- */

static void add_text(void *user, const XML_Char *s, int length)
{
    struct reader *x = user;
    const size_t n = (size_t)length;

    if (!go_on(x) || x->open == DOCUMENT_NONE)
        return;
    const enum document_element element = x->r->d->node[x->open].element;
    if (element == NODE_VANISH || (blank(s, n) && (x->closed || !document_has_number(element))))
        return;
    if (!document_has_number(element)) {
        document_bad(x->r, line_of(x), column_of(x), "<%s>: expected elements, got text", name_of(x, x->open));
    } else if (x->closed) {
        if (!x->told)
            document_told(x->r, x->open, "text after the comment is ignored");
        x->told = true;
    } else if (n > TEXT - x->n) {
        document_bad(x->r, line_of(x), column_of(x), "<%s>: number longer than %d bytes", name_of(x, x->open),
                     (int)TEXT);
    } else {
        if (x->n == 0) {
            x->line = line_of(x);
            x->column = column_of(x);
        }
        memcpy(x->text + x->n, s, n);
        x->n += n;
    }
    go_on(x);
}

/* Before the number a comment is nothing; behind it, it ends the number. */
static void pass_comment(struct reader *x)
{
    if (!blank(x->text, x->n))
        x->closed = true;
    else
        x->n = 0;
}

static void on_comment(void *user, const XML_Char *s)
{
    (void)s;
    pass_comment(user);
}

static void on_instruction(void *user, const XML_Char *target, const XML_Char *s)
{
    (void)target, (void)s;
    pass_comment(user);
}

/* ---- what is refused ---- */

static void on_entity(void *user, const XML_Char *name, int parameter, const XML_Char *value, int n,
                      const XML_Char *base, const XML_Char *system, const XML_Char *public, const XML_Char *notation)
{
    struct reader *x = user;

    (void)parameter, (void)value, (void)n, (void)base, (void)system, (void)public, (void)notation;
    document_bad(x->r, line_of(x), column_of(x), "<!ENTITY %.40s>: entities are not supported; write the text out",
                 name);
    go_on(x);
}

static void on_skipped(void *user, const XML_Char *name, int parameter)
{
    struct reader *x = user;

    if (parameter)
        return;
    document_bad(x->r, line_of(x), column_of(x), "&%.40s; is not an entity that XML defines", name);
    go_on(x);
}

/* ---- encodings ---- */

/* A character beyond ASCII becomes some one: comments alone have such, labels are refused. */
static int some_character(void *user, const char *s)
{
    (void)user;
    return (s[1] & 0xff) >= 0x40 ? 0x3000 : -1;
}

static bool same_word(const char *a, const char *b)
{
    while (*a && (*a | 0x20) == (*b | 0x20))
        a++, b++;
    return *a == *b;
}

static int on_encoding(void *user, const XML_Char *name, XML_Encoding *info)
{
    static const char *const shift[] = { "Shift_JIS", "x-sjis", "Windows-31J", "cp932" };
    struct reader *x = user;
    bool is_shift = false;

    for (int i = 0; i < 4; i++)
        is_shift |= same_word(name, shift[i]);
    if (!is_shift && !same_word(name, "EUC-JP")) {
        document_bad(x->r, 1, 1, "unknown encoding \"%.40s\"; save the document as UTF-8", name);
        return XML_STATUS_ERROR;
    }
    for (int i = 0; i < 256; i++) {
        const bool lead = is_shift ? (i >= 0x81 && i <= 0x9f) || (i >= 0xe0 && i <= 0xfc)
                                   : (i >= 0xa1 && i <= 0xfe) || i == 0x8e || i == 0x8f;
        const bool kana = is_shift && i >= 0xa1 && i <= 0xdf;
        info->map[i] = i < 0x80 ? i : lead ? i == 0x8f && !is_shift ? -3 : -2 : kana ? 0xff61 + i - 0xa1 : -1;
    }
    info->convert = some_character;
    info->release = NULL;
    info->data = NULL;
    x->foreign = true;
    return XML_STATUS_OK;
}

/* ---- the whole ---- */

static void bad_xml(struct reader *x, const char *bytes, size_t n)
{
    const XML_Index at = x->f.index(x->parser);
    const enum XML_Error error = x->f.error(x->parser);
    const struct document *d = x->r->d;
    const bool high = error == XML_ERROR_INVALID_TOKEN && at >= 0 && (size_t)at < n && (bytes[at] & 0x80);

    if (high && x->foreign)
        document_bad(x->r, line_of(x), column_of(x), "byte 0x%02x is not valid in the document's encoding",
                     bytes[at] & 0xff);
    else if (high)
        document_bad(
            x->r, line_of(x), column_of(x),
            "byte 0x%02x is not valid UTF-8; save the document as UTF-8, or name its encoding in the first line",
            bytes[at] & 0xff);
    else if (error == XML_ERROR_INVALID_TOKEN)
        document_bad(x->r, line_of(x), column_of(x), "invalid XML (a stray \"<\" or \"&\", or an invalid character)");
    else if (x->open != DOCUMENT_NONE && x->open < d->n)
        document_bad(x->r, line_of(x), column_of(x), "<%s>, which starts in line %d: %s", name_of(x, x->open),
                     d->node[x->open].line, x->f.say(error));
    else
        document_bad(x->r, line_of(x), column_of(x), "invalid XML: %s", x->f.say(error));
}

void document_xml(struct document_reader *r, const char *bytes, size_t n)
{
    struct reader *x = calloc(1, sizeof *x);
    char why[128];

    if (!x) {
        result_set_host_failed();
        document_bad(r, 1, 1, "out of memory");
        return;
    }
    x->r = r;
    x->open = DOCUMENT_NONE;
    if (!find(&x->f)) {
        library_missing(LIBRARY_EXPAT, why, sizeof why);
        document_bad(r, 1, 1, "%s", why);
    } else if (!(x->parser = x->f.create(NULL))) {
        result_set_host_failed();
        document_bad(r, 1, 1, "out of memory");
    }
    if (x->parser) {
        x->f.user(x->parser, x);
        x->f.elements(x->parser, begin_element, end_element);
        x->f.text(x->parser, add_text);
        x->f.comment(x->parser, on_comment);
        x->f.instruction(x->parser, on_instruction);
        x->f.entity(x->parser, on_entity);
        x->f.skipped(x->parser, on_skipped);
        x->f.encoding(x->parser, on_encoding, x);
        if (x->f.parse(x->parser, bytes, (int)n, 1) != XML_STATUS_OK)
            bad_xml(x, bytes, n);
        x->f.free(x->parser);
    }
    free(x);
}
