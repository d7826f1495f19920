/*
 * page.c - see page.h.
 *
 * The page contains its pictures, in base64, and shows them at twice their size without smoothing. It has a light and a
 * dark style.
 */
#include "page.h"

#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../common/files.h"
#include "../../player/picture/png.h"
#include "golden.h"

static const char style[] =
    ":root{color-scheme:light dark;--line:#8886;--bad:#c62f3b;--good:#2d8a4e;--dim:#777}"
    "@media(prefers-color-scheme:dark){:root{--bad:#ff7b85;--good:#6ad28f;--dim:#999}}"
    "body{font:16px/1.5 system-ui,sans-serif;margin:2rem auto;max-width:98rem;padding:0 1.5rem}"
    "h1{font-size:1.5rem;margin:0}h2{font-size:1.1rem;margin:0 0 .6rem}"
    "section{border:1px solid var(--line);border-left:6px solid var(--bad);border-radius:6px;padding:1rem 1.2rem;"
    "margin:1.4rem 0}"
    ".dim{color:var(--dim)}.bad{color:var(--bad)}.good{color:var(--good)}"
    "ul.why{margin:.4rem 0;padding-left:1.2rem}pre{overflow:auto;font-size:.85rem;margin:.6rem 0;color:var(--dim)}"
    ".shots{display:flex;gap:1rem;margin-top:.8rem}figure{margin:0;min-width:0}"
    "@media(max-width:50rem){.shots{flex-wrap:wrap}}"
    "figcaption{font-size:.85rem;color:var(--dim);margin-bottom:.2rem}"
    "img{image-rendering:pixelated;display:block;border:1px solid var(--line);max-width:100%;height:auto}"
    "table{border-collapse:collapse;font-size:.95rem}td{padding:.15rem 1.2rem .15rem 0}td.n{text-align:right}";

/* ---- pictures ---- */

static void base64(FILE *out, const uint8_t *p, size_t n)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

    for (size_t i = 0; i < n; i += 3) {
        const size_t left = n - i;
        const uint32_t v = (uint32_t)p[i] << 16 | (left > 1 ? (uint32_t)p[i + 1] << 8 : 0) | (left > 2 ? p[i + 2] : 0);
        fputc(digits[v >> 18], out);
        fputc(digits[v >> 12 & 63], out);
        fputc(left > 1 ? digits[v >> 6 & 63] : '=', out);
        fputc(left > 2 ? digits[v & 63] : '=', out);
    }
}

static uint32_t be32(const uint8_t *p)
{
    return (uint32_t)p[0] << 24 | (uint32_t)p[1] << 16 | (uint32_t)p[2] << 8 | p[3];
}

struct page {
    FILE *out;
    const char *dir;
};

static void figure(const struct page *p, const char *name, const char *which)
{
    enum { SIZES = 24 }; /* bytes of a PNG up to the end of its width and height */
    char path[FILES_PATH_SIZE], err[FILES_ERR_SIZE];
    uint8_t *data;
    size_t n;

    if (snprintf(path, sizeof path, "%s/" FAILED "/%s.%s.png", p->dir, name, which) >= (int)sizeof path ||
        plat_file_size(path) < SIZES || !files_read(path, path, PNG_MAX_BYTES, &data, &n, err, sizeof err))
        return;
    fputs("<figure><figcaption>", p->out);
    reporter_put_escaped(p->out, name);
    fprintf(p->out, ": %s</figcaption><img alt=\"", which);
    reporter_put_escaped(p->out, name);
    fprintf(p->out, ", %s\" width=\"%u\" height=\"%u\" src=\"", which, (unsigned)be32(data + 16) * 2,
            (unsigned)be32(data + 20) * 2);
    fputs("data:image/png;base64,", p->out);
    base64(p->out, data, n);
    fputs("\"></figure>\n", p->out);
    free(data);
}

static void pictures(void *context, const char *name)
{
    const struct page *p = context;

    fputs("<div class=\"shots\">\n", p->out);
    figure(p, name, "expected");
    figure(p, name, "got");
    figure(p, name, "difference");
    fputs("</div>\n", p->out);
}

/* ---- text ---- */

static void item(void *context, const char *words)
{
    FILE *out = ((const struct page *)context)->out;

    fputs("<li>", out);
    reporter_put_escaped(out, words);
    fputs("</li>\n", out);
}

static void line(void *context, const char *words)
{
    FILE *out = ((const struct page *)context)->out;

    reporter_put_escaped(out, words);
    fputc('\n', out);
}

static void count(void *context, const char *words)
{
    (void)words;
    ++*(int *)context;
}

static void lines(struct page *p, const struct test *t, enum line_kind kind)
{
    int n = 0;

    outcome_each(t, kind, count, &n);
    if (n == 0)
        return;
    fputs("<pre>", p->out);
    outcome_each(t, kind, line, p);
    fputs("</pre>\n", p->out);
}

static void failed(struct page *p, const struct test *t)
{
    fputs("<section><h2>", p->out);
    reporter_put_escaped(p->out, t->name);
    fprintf(p->out, " <span class=\"dim\">%u frames, %.2f s</span></h2>\n<ul class=\"why\">\n", (unsigned)t->frames,
            (double)t->usec / 1e6);
    outcome_each(t, LINE_HOST_ERROR, item, p);
    outcome_each(t, LINE_FAILURE, item, p);
    fputs("</ul>\n", p->out);
    lines(p, t, LINE_TRACE);
    lines(p, t, LINE_PRINTED);
    outcome_each(t, LINE_PICTURE, pictures, p);
    fputs("</section>\n", p->out);
}

static void row(FILE *out, const struct test *t)
{
    const bool good = t->verdict == TEST_PASSES;

    fprintf(out, "<tr><td class=\"%s\">%s</td><td>", good ? "good" : "bad", good ? "passes" : "fails");
    reporter_put_escaped(out, t->name);
    fprintf(out, "</td><td class=\"n\">%u frames</td><td class=\"n\">%.2f s</td></tr>\n", (unsigned)t->frames,
            (double)t->usec / 1e6);
}

void page_write(FILE *out, const char *dir, const char *title, const struct test *tests, const struct sums *s)
{
    struct page p = { out, dir };

    fputs("<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<meta name=\"viewport\" "
          "content=\"width=device-width\">\n<title>Tests of ",
          out);
    reporter_put_escaped(out, title);
    fprintf(out, "</title>\n<style>%s</style></head>\n<body>\n<h1>Tests of ", style);
    reporter_put_escaped(out, title);
    fprintf(out,
            "</h1>\n<p><span class=\"%s\">%d of %d fail.</span> <span class=\"dim\">%u frames in %.2f s</span></p>\n",
            s->fail ? "bad" : "good", s->fail, s->tests, (unsigned)s->frames, (double)s->usec / 1e6);
    for (int i = 0; i < s->tests; i++)
        if (tests[i].verdict != TEST_PASSES)
            failed(&p, &tests[i]);
    fputs("<h2>All tests</h2>\n<table>\n", out);
    for (int i = 0; i < s->tests; i++)
        row(out, &tests[i]);
    fputs("</table>\n</body></html>\n", out);
}
