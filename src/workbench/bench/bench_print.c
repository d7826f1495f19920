/*
 * bench_print.c - see bench_print.h.
 */
#include "bench_print.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../common/clean.h"
#include "ram.h"
#include "capacities.h"
#include "../../common/report.h"

enum {
    MIN_NAME_WIDTH = 10, /* columns of a section's name */
    MAX_NAME_WIDTH = 24,
    TEXT_WIDTH = 44,      /* columns of a line's text */
    MIN_SAVING = 16 << 10 /* bytes; smaller savings are not mentioned */
};

static const char outside[] = "(outside)";

static double ms(uint64_t usec, uint32_t frames)
{
    return frames ? (double)usec / frames / 1000 : 0;
}

static int percent(double usec, const struct bench *b)
{
    return (int)(100 * usec * b->slower / MEASURE_FRAME_USEC + 0.5);
}

/* Formats 19200 as "19,200". */
static const char *group_digits(char text[32], uint64_t n)
{
    char digits[24];
    int len = snprintf(digits, sizeof digits, "%llu", (unsigned long long)n), at = 0;

    for (int i = 0; i < len; i++) {
        if (i > 0 && (len - i) % 3 == 0)
            text[at++] = ',';
        text[at++] = digits[i];
    }
    text[at] = 0;
    return text;
}

/* ---- sections ---- */

static int name_width(const struct measure *m)
{
    int width = MIN_NAME_WIDTH;

    for (int i = 0; i < m->n; i++) {
        const int n = (int)strlen(m->section[i].name);
        width = n > width ? n : width;
    }
    return width < MAX_NAME_WIDTH ? width : MAX_NAME_WIDTH;
}

static void print_heading(const struct bench *b, int width)
{
    char share[32] = "% of a frame";

    if (b->slower > 1)
        snprintf(share, sizeof share, "%dx slower", b->slower);
    report_print("%*s %-37s %12s\n", width + 15, "", "milliseconds", share);
    report_print("%-*s %7s %6s %6s %6s %6s %6s %6s %6s %5s %6s%s  %s\n", width, "section", "frames", "Lua", "tick",
                 "draw", "sound", "mean", "99 %", "worst", "mean", "worst", b->slower > 1 ? "   late" : "",
                 "slowest frame");
}

static void print_section(const struct bench *b, const struct measure_section *s, const char *name, int width)
{
    const uint64_t all = s->tick + s->draw + s->sound;

    if (!s->frames)
        return;
    report_print("%-*.*s %7u %6llu %6.3f %6.3f %6.3f %6.3f %6.3f %6.3f %4d%% %5d%%", width, width, name,
                 (unsigned)s->frames, (unsigned long long)(s->lua / s->frames), ms(s->tick, s->frames),
                 ms(s->draw, s->frames), ms(s->sound, s->frames), ms(all, s->frames), ms(measure_percentile(s, 99), 1),
                 ms(s->worst, 1), percent((double)all / s->frames, b), percent((double)s->worst, b));
    if (b->slower > 1)
        report_print(" %6u", (unsigned)measure_count_over(s, (uint64_t)(MEASURE_FRAME_USEC / b->slower)));
    report_print("  %u of %s\n", (unsigned)s->worst_frame, s->worst_run);
}

static void print_sections(const struct bench *b, const struct measure *m)
{
    const int width = name_width(m);

    print_heading(b, width);
    for (int i = 1; i < m->n; i++)
        print_section(b, &m->section[i], m->section[i].name, width);
    print_section(b, &m->section[0], outside, width);
    if (m->n > 1)
        print_section(b, &m->all, "all", width);
}

/* ---- phases ---- */

static void print_phases(const struct measure *m)
{
    static const char *const words[PHASES] = {
        [PHASE_SCRIPTS] = "script tasks",       [PHASE_MOTION] = "movement", [PHASE_HITS] = "hits",
        [PHASE_EVENTS] = "events and handlers", [PHASE_CLEANUP] = "other",
    };
    uint64_t sum = 0;

    for (int i = 0; i < PHASES; i++)
        sum += m->all.phase[i];
    report_print("\nTime per tick:");
    for (int i = 0; i < PHASES; i++)
        report_print("%s %s %.0f %%", i ? "," : "", words[i], sum ? 100.0 * (double)m->all.phase[i] / (double)sum : 0);
    report_print(".\n");
}

static double slowdown(uint32_t usec)
{
    return (double)MEASURE_FRAME_USEC / (usec ? usec : 1);
}

static void print_verdict(const struct bench *b, const struct measure *m)
{
    const uint32_t late = measure_count_over(&m->all, (uint64_t)(MEASURE_FRAME_USEC / b->slower));
    const uint32_t p99 = measure_percentile(&m->all, 99);
    char text[32];

    report_print("On a machine %.1f times slower than this one, 99 %% of the frames would be on time at 60 frames per "
                 "second;\non a machine %.1f times slower, all of them.",
                 slowdown(p99), slowdown(m->all.worst));
    if (b->slower > 1 && late)
        report_print(" On a machine %d times slower, %s frame%s would be late (%.2f %%).", b->slower,
                     group_digits(text, late), late == 1 ? "" : "s", 100.0 * late / m->all.frames);
    else if (b->slower > 1)
        report_print(" On a machine %d times slower, no frame would be late.", b->slower);
    report_print("\n");
}

/* ---- lines ---- */

static int by_work(const void *a, const void *b)
{
    const struct profile_line *x = *(const struct profile_line *const *)a, *y = *(const struct profile_line *const *)b;
    const uint64_t v = profile_work(x), w = profile_work(y);

    return v != w ? (v < w ? 1 : -1) : strcmp(x->location, y->location);
}

int bench_top_lines(const struct measure *m, const struct profile_line *out[], int n)
{
    const struct profile_line **all = malloc(PROFILE_CAPACITY * sizeof *all);
    int found = 0;

    if (!all)
        return 0;
    for (int i = 0; i < PROFILE_CAPACITY; i++)
        if (profile_work(&m->profile.line[i]))
            all[found++] = &m->profile.line[i];
    qsort(all, (size_t)found, sizeof *all, by_work);
    found = found < n ? found : n;
    memcpy(out, all, (size_t)found * sizeof *all);
    free(all);
    return found;
}

void bench_line_text(const struct measure *m, const char *place, char *text, size_t size)
{
    const char *colon = strrchr(place, ':'), *from, *end;
    char name[PROFILE_LOCATION_SIZE];
    size_t left;

    text[0] = 0;
    if (!colon || colon - place < 4)
        return;
    snprintf(name, sizeof name, "%.*s", (int)(colon - place) - 4, place); /* without .lua */
    if (!cart_find_script(m->cart, name, &from, &left))
        return;
    end = from + left;
    for (long line = strtol(colon + 1, NULL, 10); line > 1 && from < end; line--) {
        const char *newline = memchr(from, '\n', (size_t)(end - from));
        from = newline ? newline + 1 : end;
    }
    const char *newline = memchr(from, '\n', (size_t)(end - from));
    end = newline ? newline : end;
    while (from < end && (*from == ' ' || *from == '\t'))
        from++;
    while (end > from && (end[-1] == ' ' || end[-1] == '\t' || end[-1] == '\r'))
        end--;
    const int n = end - from < (long)size - 1 ? (int)(end - from) : (int)size - 4;
    snprintf(text, size, "%.*s%s", n, from, n < end - from ? "..." : "");
    clean_line(text);
}

static int percent_of(uint64_t part, uint64_t all)
{
    return all ? (int)((100 * part + all / 2) / all) : 0;
}

static void print_line(const struct measure *m, const struct profile_line *line)
{
    const uint64_t work = profile_work(line), all = profile_work(&m->profile.total);
    char text[TEXT_WIDTH + 1];

    bench_line_text(m, line->location, text, sizeof text);
    report_print("%6.1f %% %8.1f %5d %% %5d %%   %-24s %s\n", 100.0 * (double)work / (double)all,
                 (double)work / m->all.frames, percent_of(line->call_work, work),
                 percent_of(line->library_instructions, work), line->location, text);
}

static void print_lines(const struct measure *m)
{
    const struct profile_line *line[BENCH_LINES];
    const int n = bench_top_lines(m, line, BENCH_LINES);
    const uint64_t work = profile_work(&m->profile.total);
    char text[32];

    if (!n)
        return;
    report_print("\nScripts use %s units of work per frame: a Lua instruction is one unit, an API call 100 or "
                 "more.\nThe most expensive lines:\n\n",
                 group_digits(text, work / m->all.frames));
    report_print("%8s %8s %7s %7s   %s\n", "share", "per frame", "in API", "in @std", "line");
    for (int i = 0; i < n; i++)
        print_line(m, line[i]);
}

/* ---- capacities ---- */

static void print_capacity(const struct capacity *r)
{
    report_print("%-20s %8lld %8lld %6d %%", r->name, (long long)r->limit, (long long)r->peak,
                 (int)(100 * r->peak / r->limit));
    if (r->saves >= MIN_SAVING)
        report_print(" %9lld %7llu KiB", (long long)r->enough, (unsigned long long)r->saves / 1024);
    if (r->refused)
        report_print("   full: rejected %u times", (unsigned)r->refused);
    report_print("\n");
}

static void print_capacities(const struct measure *m)
{
    struct capacity list[CAPACITIES];
    const int n = capacities_measure(m, list);
    const uint64_t saved = capacities_saved(m, list, n);
    char ram[32], less[32];

    report_print("\n%-20s %8s %8s %8s %9s %11s\n", "capacity", "limit", "peak", "used", "enough", "saves");
    for (int i = 0; i < n; i++)
        print_capacity(&list[i]);
    report_print("\nThe board uses %s KiB of RAM", group_digits(ram, board_ram_needed(m->cart) / 1024));
    if (saved >= MIN_SAVING)
        report_print("; %s KiB less with capacities that are just enough for these runs",
                     group_digits(less, saved / 1024));
    report_print(".\n");
}

static void print_ram(const struct measure *m)
{
    struct ram_part part[RAM_MAX_PARTS];
    uint64_t sum;
    const int n = ram_parts(m->cart, part, &sum);
    char kib[32];

    report_print("With its picture and sound, the game uses %s KiB:\n\n", group_digits(kib, (sum + 1023) / 1024));
    for (int i = 0; i < n; i++)
        report_print("%-20s %8s KiB %5d %%\n", part[i].name, group_digits(kib, part[i].bytes / 1024),
                     percent_of(part[i].bytes, sum));
}

void bench_print(const struct bench *b, const struct measure *m)
{
    char frames[32];

    report_print("%s: %s frames from %d run%s, each timed %d times; at 60 frames per second a frame lasts 16.67 ms\n\n",
                 b->path, group_digits(frames, m->all.frames), m->runs, m->runs == 1 ? "" : "s", MEASURE_ROUNDS);
    print_sections(b, m);
    print_phases(m);
    print_verdict(b, m);
    print_lines(m);
    print_capacities(m);
    print_ram(m);
}
