/*
 * replays_print.c - prints a game's replays (replays_print.h).
 */
#include "replays_print.h"

#include <inttypes.h>
#include <stdio.h>
#include <time.h>
#include "../../../platform/platform.h"
#include "../../common/json.h"
#include "../../demo/demo.h"
#include "../../common/report.h"

static const char *end_text(enum replay_meta_end end)
{
    static const char *const words[REPLAY_ENDS] = { "unfinished", "all stages", "game over", "quit", "script error" };

    return words[end];
}

/* The values in JSON must stay the same for programs that read them. */
static const char *end_key(enum replay_meta_end end)
{
    static const char *const words[REPLAY_ENDS] = { "left", "all stages", "game over", "quit", "a fault" };

    return words[end];
}

static void date_text(int64_t date, char *out, size_t size)
{
    const time_t t = (time_t)date;
    const struct tm *tm = gmtime(&t);

    if (!tm || strftime(out, size, "%Y-%m-%dT%H:%M:%SZ", tm) == 0)
        snprintf(out, size, "-");
}

static void print_flags(unsigned flags)
{
    for (int i = 0; demo_flag_name(i); i++)
        if (flags >> i & 1)
            report_print(", %s", demo_flag_name(i));
}

static void print_line(const char *path, const struct replay_meta *c)
{
    const unsigned seconds = (c->last - c->first) / 60;
    char date[32];

    date_text(c->date, date, sizeof date);
    report_print("%s %s %u:%02u %s %s %" PRId64, path, date, seconds / 60, seconds % 60, c->ship[0] ? c->ship : "-",
                 c->difficulty[0] ? c->difficulty : "-", c->points[0]);
    if (c->players > 1)
        report_print("+%" PRId64, c->points[1]);
    report_print(" %s", end_text(c->end));
    print_flags(c->flags);
    if (c->name[0])
        report_print(" \"%s\"", c->name);
    putchar('\n');
}

static void json_row(struct json *j, const struct replay_meta_row *r)
{
    json_open(j, NULL, '{');
    json_text(j, "table", r->table);
    json_text(j, "name", r->row.name);
    json_text(j, "ship", r->row.ship);
    json_number(j, "score", r->row.score);
    json_number(j, "stage", r->row.stage);
    json_number(j, "continues", r->row.continues);
    json_close(j, '}');
}

static void print_json(const char *path, const struct replay_meta *c)
{
    struct json j = { .out = stdout };
    char date[32];

    date_text(c->date, date, sizeof date);
    json_open(&j, NULL, '{');
    json_text(&j, "file", path);
    json_text(&j, "name", c->name);
    json_text(&j, "date", date);
    json_text(&j, "game", c->id);
    json_text(&j, "ship", c->ship);
    json_text(&j, "difficulty", c->difficulty);
    json_text(&j, "stage", c->stage);
    json_text(&j, "mission", c->mission);
    json_bool(&j, "favourite", c->is_favourite);
    json_open(&j, "score", '[');
    for (int p = 0; p < MAX_PLAYERS; p++)
        json_number(&j, NULL, c->points[p]);
    json_close(&j, ']');
    json_text(&j, "end", end_key(c->end));
    json_number(&j, "stages", c->stages);
    json_number(&j, "first", c->first);
    json_number(&j, "frames", c->last);
    json_names(&j, "flags", c->flags, demo_flag_name);
    json_open(&j, "rows", '[');
    for (int i = 0; i < c->rows; i++)
        json_row(&j, &c->row[i]);
    json_close(&j, ']');
    json_number(&j, "core", c->core);
    json_hex(&j, "rom", c->rom);
    json_hex(&j, "hash", c->hash);
    json_close(&j, '}');
    putchar('\n');
}

bool replays_print(const char *id, bool json)
{
    struct replays r;
    char path[REPLAY_PATH], file[DEMO_PATH_SIZE];
    const bool all = replays_open(&r, id);

    for (int i = 0; i < r.n; i++) {
        replays_path(&r, i, path);
        (json ? print_json : print_line)(plat_path(path, file, sizeof file) ? file : path, &r.list[i].meta);
    }
    replays_close(&r);
    return all;
}
