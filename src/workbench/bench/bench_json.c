/*
 * bench_json.c - see bench_json.h.
 */
#include "bench_json.h"

#include <stdio.h>
#include "../../common/json.h"
#include "bench_print.h"
#include "ram.h"
#include "capacities.h"

enum { NANO = 1000 /* in a microsecond */, LINES = 100, TEXT = 160 };

static int64_t nsec_per_frame(uint64_t usec, uint32_t frames)
{
    return frames ? (int64_t)(usec * NANO / frames) : 0;
}

static void put_section(struct json *j, const struct bench *b, const char *key, const struct measure_section *s)
{
    json_open(j, key, '{');
    if (!key)
        json_text(j, "name", s->name[0] ? s->name : NULL);
    json_number(j, "frames", s->frames);
    json_number(j, "tick", nsec_per_frame(s->tick, s->frames));
    json_number(j, "draw", nsec_per_frame(s->draw, s->frames));
    json_number(j, "sound", nsec_per_frame(s->sound, s->frames));
    json_number(j, "mean", nsec_per_frame(s->tick + s->draw + s->sound, s->frames));
    json_number(j, "p99", (int64_t)measure_percentile(s, 99) * NANO);
    json_number(j, "worst", (int64_t)s->worst * NANO);
    json_number(j, "late", measure_count_over(s, (uint64_t)(MEASURE_FRAME_USEC / b->slower)));
    json_number(j, "lua", (int64_t)s->lua);
    json_text(j, "worst_run", s->worst_run);
    json_number(j, "worst_frame", s->worst_frame);
    json_close(j, '}');
}

static void put_sections(struct json *j, const struct bench *b, const struct measure *m)
{
    json_open(j, "sections", '[');
    for (int i = 0; i < m->n; i++)
        if (m->section[i].frames)
            put_section(j, b, NULL, &m->section[i]);
    json_close(j, ']');
}

static void put_phases(struct json *j, const struct measure *m)
{
    static const char *const names[PHASES] = { [PHASE_SCRIPTS] = "scripts",
                                               [PHASE_MOTION] = "moves",
                                               [PHASE_HITS] = "hits",
                                               [PHASE_EVENTS] = "events",
                                               [PHASE_CLEANUP] = "rest" };

    json_open(j, "phases", '{');
    for (int i = 0; i < PHASES; i++)
        json_number(j, names[i], nsec_per_frame(m->all.phase[i], m->all.frames));
    json_close(j, '}');
}

static void put_line(struct json *j, const struct measure *m, const struct profile_line *line)
{
    char text[TEXT];

    bench_line_text(m, line->location, text, sizeof text);
    json_open(j, NULL, '{');
    json_text(j, "line", line->location);
    json_text(j, "text", text);
    json_number(j, "work", (int64_t)profile_work(line));
    json_number(j, "instructions", (int64_t)line->instructions);
    json_number(j, "calls", (int64_t)line->call_work);
    json_number(j, "bytes", (int64_t)line->allocated_bytes);
    json_number(j, "library", (int64_t)line->library_instructions);
    json_close(j, '}');
}

static void put_lines(struct json *j, const struct measure *m)
{
    const struct profile_line *line[LINES];
    const int n = bench_top_lines(m, line, LINES);

    json_number(j, "work", (int64_t)profile_work(&m->profile.total));
    json_open(j, "lines", '[');
    for (int i = 0; i < n; i++)
        put_line(j, m, line[i]);
    json_close(j, ']');
}

static void put_capacities(struct json *j, const struct measure *m)
{
    struct capacity list[CAPACITIES];
    const int n = capacities_measure(m, list);

    json_number(j, "ram", (int64_t)board_ram_needed(m->cart));
    json_open(j, "rooms", '[');
    for (int i = 0; i < n; i++) {
        json_open(j, NULL, '{');
        json_text(j, "name", list[i].name);
        json_number(j, "asked", list[i].limit);
        json_number(j, "most", list[i].peak);
        json_number(j, "refused", list[i].refused);
        json_number(j, "would_do", list[i].enough);
        json_number(j, "saves", (int64_t)list[i].saves);
        json_close(j, '}');
    }
    json_close(j, ']');
}

static void put_ram(struct json *j, const struct measure *m)
{
    struct ram_part part[RAM_MAX_PARTS];
    uint64_t sum;
    const int n = ram_parts(m->cart, part, &sum);

    json_number(j, "ram_sum", (int64_t)sum);
    json_open(j, "ram_parts", '{');
    for (int i = 0; i < n; i++)
        json_number(j, part[i].name, (int64_t)part[i].bytes);
    json_close(j, '}');
}

void bench_json(const struct bench *b, const struct measure *m)
{
    struct json j = { .out = stdout };

    json_open(&j, NULL, '{');
    json_text(&j, "game", m->cart->manifest.id);
    json_number(&j, "runs", m->runs);
    json_number(&j, "slower", b->slower);
    put_section(&j, b, "all", &m->all);
    put_sections(&j, b, m);
    put_phases(&j, m);
    put_lines(&j, m);
    put_capacities(&j, m);
    put_ram(&j, m);
    json_close(&j, '}');
    putchar('\n');
}
