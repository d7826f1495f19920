/*
 * page.c - docs/measured/bulletml.md: every document beside libbulletml, what the last bit of a double decides, times,
 * pictures.
 */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "../report/report.h"
#include "all.h"
#include "tool.h"

static const char ABOUT[] =
    "# BulletML compared with libbulletml\n"
    "\n"
    "`make bulletml` measures and writes this page; do not edit it. The command runs the BulletML documents of seven "
    "Debian\n"
    "packages in Curtain and in libbulletml 0.0.6, the library that the games in these packages use. Both programs get "
    "the\n"
    "same random numbers, the same rank and the same player, who moves around in the lower half of a field of 320 x "
    "240 px.\n"
    "\n"
    "Every bullet is compared in each of 1,500 frames, at ranks 0, 0.35, 0.5 and 1. Each bullet must appear and vanish "
    "in the\n"
    "same frames in both programs, and its two positions may differ by at most 1/16 px; otherwise the command fails. "
    "BulletML\n"
    "documents do not define the borders of the field. The comparison therefore removes a bullet from both sides when "
    "its\n"
    "position in libbulletml is more than 192.4 px horizontally or 152.4 px vertically from the centre.\n"
    "\n"
    "The list of documents is `tools/lab/bulletml/documents.list`; the tool is in the same folder. `tests/bulletml` "
    "has\n"
    "libbulletml's results for single elements, which `make test` compares with Curtain's.\n"
    "\n";

static const char CONCLUSIONS[] = "| | |\n|---|---:|\n";

static struct list documents, exceptions;
static bool failed;

static void conclude(const char *what, const char *figure)
{
    const char *const cells[] = { what, figure };

    report_conclude(cells, 2);
}

/* What some runs come to. */
struct sums {
    int alike, documents, listed;
    int64_t bullets, places, left, otherwise;
    double greatest; /* of those that are alike */
};

static void add(struct sums *s, const struct all_result *r)
{
    for (int i = 0; i < ALL_RANKS; i++) {
        const struct compared *c = &r->board[i];
        s->bullets += c->bullets;
        s->places += c->places;
        s->left += c->left;
        s->otherwise += c->otherwise;
        if (compared_alike(c) && c->greatest > s->greatest)
            s->greatest = c->greatest;
    }
    s->documents++;
    s->alike += all_alike(r);
}

static struct all_result *compare(enum all_what what, bool loop)
{
    const long cores = sysconf(_SC_NPROCESSORS_ONLN);
    const struct all_setup setup = { what, &documents, &exceptions, NULL, TOOL_SEED, loop, cores > 1 ? (int)cores : 1 };
    struct all_result *r = all_compare(&setup);

    if (!r)
        report_fail(strerror(errno));
    return r;
}

/* ---- every document ---- */

/* The rank at which it was worst. */
static int worst(const struct all_result *r)
{
    int w = 0;

    for (int i = 1; i < ALL_RANKS; i++)
        if (compared_alike(&r->board[w]) &&
            (!compared_alike(&r->board[i]) || r->board[i].greatest > r->board[w].greatest))
            w = i;
    return w;
}

static void document_row(const char *path, const struct all_result *r)
{
    const int w = worst(r);
    const struct compared *c = &r->board[w];
    struct sums s = { 0 };
    int most = 0;

    add(&s, r);
    for (int i = 0; i < ALL_RANKS; i++)
        most = r->board[i].most > most ? r->board[i].most : most;
    report_row(0, list_name(path), report_count(s.bullets), report_count(s.places), report_count(most),
               report_string("%.5f", c->greatest), report_string("%g", all_rank[w]),
               s.alike ? "" : report_string("**out**: %s", *c->what ? c->what : "too far"), NULL);
}

/* One that is out has to be on the list, and to be decided by the last bit; and one on the list to be out. */
static void judge(const char *path, const struct all_result *r, struct sums *s)
{
    const bool listed = list_has(&exceptions, path);

    s->listed += listed;
    if (!all_alike(r) && !(listed && all_excused(r))) {
        fprintf(stderr, "bulletml: %s: out, and %s\n", path,
                listed ? "libbulletml does the same however it rounds" : "not on " TOOL_EXCEPTIONS);
        failed = true;
    }
    if (all_alike(r) && listed) {
        fprintf(stderr, "bulletml: %s: on %s, and within 1/16 px\n", path, TOOL_EXCEPTIONS);
        failed = true;
    }
}

static void section_documents(void)
{
    struct all_result *r = compare(ALL_BOARD, false);
    struct sums s = { 0 };

    for (int i = 0; i < documents.n; i++) {
        add(&s, &r[i]);
        judge(documents.path[i], &r[i], &s);
    }
    failed |= s.listed > TOOL_EXCEPTIONS_MOST;
    conclude("documents within 1/16 px", report_string("%d of %d", s.alike, s.documents));
    conclude("documents allowed to differ because they [depend on the last bit](#decided-by-the-last-bit) of a double",
             report_string("%d", s.listed));
    conclude("bullets compared", report_count(s.bullets));
    conclude("positions compared (one bullet in one frame)", report_count(s.places));
    conclude("greatest distance", report_string("%.5f px", s.greatest));
    conclude("frames compared per document", report_string("%d, at each of %d ranks", ALL_FRAMES, ALL_RANKS));
    report_section("Every document");
    report_text(
        "*Bullets* and *positions* are totals over all four ranks. *Greatest distance* is in px; *rank* is the rank at "
        "which it occurred. A document's name is its path without `/usr/share/games` or `/usr/share/doc`.");
    report_table(NULL, "document|bullets>|positions>|most at once>|greatest distance>|rank>|");
    for (int i = 0; i < documents.n; i++)
        document_row(documents.path[i], &r[i]);
    report_table_end();
    report_text(
        "%s bullets left the area around the field. By their positions in Curtain, %s of these bullets would have left "
        "the area in a different frame: they were so close to its border that a rounding error made the difference.",
        report_count(s.left), report_count(s.otherwise));
    all_free(r, documents.n);
}

/* ---- and again ---- */

static void section_loop(void)
{
    struct all_result *r = compare(ALL_BOARD, true);
    struct sums s = { 0 };

    for (int i = 0; i < documents.n; i++)
        add(&s, &r[i]);
    report_section("Restarted");
    report_text("Most documents end within 1,500 frames. With `loop = true`, a document restarts when it ends, as in "
                "the boss fights of these games. The comparison covers %s positions of %s bullets. With `loop = true`, "
                "%d of %d documents stay within 1/16 px; the greatest distance in these documents is %.5f px.",
                report_count(s.places), report_count(s.bullets), s.alike, s.documents, s.greatest);
    if (s.alike < s.documents) {
        report_text(
            "When a bullet aims at the player from less than a pixel away, a rounding error of a few ten-thousandths "
            "of a pixel changes the direction visibly. This happens in the following documents:");
        report_table(NULL, "document|greatest distance>|frame>|rank>|");
        for (int i = 0; i < documents.n; i++) {
            const struct compared *c = &r[i].board[worst(&r[i])];
            if (!all_alike(&r[i]))
                report_row(0, list_name(documents.path[i]), report_string("%.3f", c->greatest),
                           report_string("%d", c->at_frame), report_string("%g", all_rank[worst(&r[i])]), c->what,
                           NULL);
        }
        report_table_end();
    }
    all_free(r, documents.n);
}

/* ---- the last bit ---- */

static bool rounding_row(const char *path, const struct all_result *r, int rank)
{
    char how[128] = "", first[SIDE_ERROR + 60] = "";
    bool any = false;

    for (int k = 1; k < SIDE_ROUNDINGS; k++) {
        const struct compared *c = &r->rounding[rank][k];
        if (compared_alike(c))
            continue;
        snprintf(how + strlen(how), sizeof how - strlen(how), "%s%s", any ? ", " : "", side_rounding_name[k]);
        snprintf(first, sizeof first, "%s", *c->what ? c->what : report_string("%.3f px off", c->greatest));
        any = true;
    }
    if (any)
        report_row(0, list_name(path), report_string("%g", all_rank[rank]), how, first, NULL);
    return any;
}

static void section_rounding(void)
{
    struct all_result *r = compare(ALL_ROUNDINGS, false);
    int n = 0;

    report_section("Decided by the last bit");
    report_text(
        "BulletML does not say how numbers are rounded. Doubles normally round to nearest, but rounding down, up or "
        "towards zero is equally valid. The documents below behave differently in libbulletml itself when the rounding "
        "mode changes, because `0.35 * 20`, the number of rounds of a `repeat`, is then slightly less than 7. A "
        "document may differ from libbulletml only if its behaviour depends on the rounding mode and it is listed in "
        "`%s`.\n"
        "\n"
        "Each document runs twice in libbulletml: the first run rounds to nearest, and the second run rounds as the "
        "column *rounding* says.",
        TOOL_EXCEPTIONS);
    report_table(NULL, "document|rank>|rounding|first difference");
    for (int i = 0; i < documents.n; i++) {
        bool any = false;
        for (int k = 0; k < ALL_RANKS; k++)
            any |= rounding_row(documents.path[i], &r[i], k);
        n += any;
    }
    report_table_end();
    report_text("%s", exceptions.n ? ""
                                   : "When libbulletml rounds to nearest, Curtain matches it for all of these "
                                     "documents, so the list is empty.");
    conclude("documents that libbulletml itself runs differently in another rounding mode", report_string("%d", n));
    all_free(r, documents.n);
}

/* ---- times ---- */

static void section_speed(void)
{
    struct tool_times t;

    if (!tool_speed(&t)) {
        failed = true;
        return;
    }
    conclude("[speed](#speed) relative to a plain host of libbulletml, for bullets with actions",
             report_string("%.1f times as fast", t.scripted));
    conclude("... relative to a fast host", report_string("%.1f times as fast", t.scripted_quick));
    conclude("speed relative to a plain host of libbulletml, for bullets without actions",
             report_string("%.1f times as fast", t.straight));
    conclude("... relative to a fast host", report_string("%.1f times as fast", t.straight_quick));
}

static void section_sheet(void)
{
    failed |= !tool_sheet(&documents, TOOL_SHEET);
    report_section("Pictures");
    report_text("These are the 64 documents with the most bullets in the field at once, each in the frame with the "
                "most bullets. The documents run at rank 1 and restart when they end. A bullet's colour depends on its "
                "number. Only bullets are shown; the documents belong to their games.");
    report_text("![Eight rows of eight small black fields with patterns of coloured dots; below each field is the name "
                "of its document](../images/bulletml.png)");
}

/* ---- the command line ---- */

static const struct report_part SECTIONS[] = {
    { "documents", section_documents }, { "loop", section_loop },   { "rounding", section_rounding },
    { "speed", section_speed },         { "sheet", section_sheet },
};
enum { COUNT = sizeof SECTIONS / sizeof *SECTIONS };

int tool_page(int argc, char **argv)
{
    struct report_options o = { .usage = "bulletml [--out FOLDER]", .folder = "docs/measured" };
    char err[256];

    if (!report_options(&o, argc, argv, SECTIONS, COUNT))
        return 2;
    if (!list_read(&documents, TOOL_DOCUMENTS, err, sizeof err) ||
        !list_read(&exceptions, TOOL_EXCEPTIONS, err, sizeof err)) {
        fprintf(stderr, "bulletml: %s\n", err);
        return 2;
    }
    report_begin(
        &(struct report){ .program = "bulletml", .folder = o.all ? o.folder : NULL, .page = "bulletml", .echo = true });
    report_run(&o, SECTIONS, COUNT);
    report_finish(ABOUT, CONCLUSIONS);
    list_free(&documents);
    list_free(&exceptions);
    return failed;
}
