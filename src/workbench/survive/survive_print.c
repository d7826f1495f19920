/*
 * survive_print.c - see survive_print.h.
 */
#include "survive_print.h"

#include <stdio.h>
#include "../../common/json.h"
#include "../../common/report.h"

static const char *verdict_text(enum search_verdict v)
{
    switch (v) {
    case SEARCH_SURVIVED:
        return "survived";
    case SEARCH_LASTED:
        return "survived so far";
    case SEARCH_CANNOT:
        return "proved unavoidable";
    case SEARCH_NO_SHIP:
        return "no ship";
    case SEARCH_FAULT:
        return "fault";
    case SEARCH_BOTS:
        return "bots only";
    default:
        return "no way found";
    }
}

static unsigned tenths_of_second(uint32_t frames)
{
    return (unsigned)(frames * 10 / 60);
}

static void print_survived(const struct search *s)
{
    report_print("survived: frames %u to %u without a hit, %u.%u s%s\n", (unsigned)s->begin, (unsigned)s->frames,
                 tenths_of_second(s->frames - s->begin) / 10, tenths_of_second(s->frames - s->begin) % 10,
                 s->verdict == SEARCH_LASTED ? "; the section continues (--frames sets the limit)" : "");
}

static void print_cannot(const struct search *s)
{
    report_print("proved unavoidable: by frame %u the ship is hit, whatever buttons are pressed, unless it bombs\n",
                 (unsigned)s->last);
    report_print(
        "  covered: every position the ship can reach from frame %u on (rounded up), with hitboxes rounded down\n",
        (unsigned)s->begin);
    report_print("  valid for these bullets, which flew identically in %u more runs with other buttons, some of them "
                 "with fire held\n",
                 (unsigned)s->probes);
    report_print("  not valid if a script reads player positions that none of these runs reached, or if a bomb saves "
                 "the ship\n");
    report_print("  longest run found: until frame %u\n", (unsigned)s->frames);
}

static void print_not_found(const struct search *s)
{
    report_print("no way found: in %u plans the ship never got past frame %u (from frame %u). This does not prove that "
                 "there is no way:\n",
                 (unsigned)s->plans, (unsigned)s->frames, (unsigned)s->begin);
    report_print("  the ship has 17 moves per frame, and only one position was followed in each %s cell of the field\n",
                 s->reacts ? "two-pixel" : "half-pixel");
    if (s->reacts)
        report_print("  bullets depend on what the ship does (from frame %u or earlier), so nothing can be proved\n",
                     (unsigned)s->reacts_at);
    else
        report_print("  raise --effort to make more plans\n");
}

static void print_measure(const struct measure *m, bool survived)
{
    const struct bots *b = &m->bots;

    report_print("  surviving bots     %d of %d (stand %d/%d, wander %d/%d, dodge %d/%d); average lifetime %u.%u s\n",
                 bots_survived(b), bots_count(b), b->survived[BOT_STAND], b->n[BOT_STAND], b->survived[BOT_WANDER],
                 b->n[BOT_WANDER], b->survived[BOT_DODGE], b->n[BOT_DODGE], tenths_of_second(bots_mean(b)) / 10,
                 tenths_of_second(bots_mean(b)) % 10);
    if (!survived)
        return;
    report_print("  narrowest gap      at least %d.%d px; the ship is %d.%d px wide\n", m->gap / 10, m->gap % 10,
                 m->ship / 10, m->ship % 10);
    report_print("  bullets            %u.%u per second, at most %u at a time\n",
                 (unsigned)(measure_per_second(m) / 100), (unsigned)(measure_per_second(m) / 10 % 10),
                 (unsigned)m->most);
    if (m->aimed)
        report_print("  reaction           %d frames from firing to impact (10th percentile of %d bullets on course "
                     "for the ship)\n",
                     m->reaction, m->aimed);
    else
        report_print("  reaction           no bullet was on course for the ship\n");
}

static void print_bots(const struct bots *b)
{
    const unsigned rate = bots_rate(b), each = tenths_of_second(bots_flown(b) / (uint32_t)bots_count(b));

    report_print("%u.%u hits per minute: %u hits on %d bots in %u.%u s each; %d were not hit\n", rate / 10, rate % 10,
                 (unsigned)bots_hits(b), bots_count(b), each / 10, each % 10, bots_survived(b));
}

void survive_print_section(const struct survive_output *of, const struct section_run *s)
{
    const struct search *k = &s->search;

    report_print("%s%s%s: ", of->section[0] ? of->section : "from the title", of->difficulty[0] ? ", " : "",
                 of->difficulty);
    if (k->verdict == SEARCH_BOTS) {
        print_bots(&s->measure.bots);
        return;
    }
    if (section_survived(s))
        print_survived(k);
    else if (k->verdict == SEARCH_CANNOT)
        print_cannot(k);
    else if (k->verdict == SEARCH_NO_SHIP)
        report_print("no ship could be controlled in %u frames\n", (unsigned)k->frames);
    else
        print_not_found(k);
    if (k->verdict != SEARCH_NO_SHIP)
        print_measure(&s->measure, section_survived(s));
    if (of->demo)
        report_print("  demo               %s\n", of->demo);
    if (of->picture)
        report_print("  picture            %s\n", of->picture);
    if (of->map)
        report_print("  map                %s\n", of->map);
}

static const char *json_verdict(enum search_verdict v)
{
    static const char *const words[] = {
        [SEARCH_SURVIVED] = "survived",       [SEARCH_LASTED] = "lasted",   [SEARCH_CANNOT] = "cannot",
        [SEARCH_NOT_FOUND] = "not found",     [SEARCH_NO_SHIP] = "no ship", [SEARCH_FAULT] = "fault",
        [SEARCH_NO_MEMORY] = "out of memory", [SEARCH_BOTS] = "bots",
    };

    return words[v];
}

static void json_bots(struct json *j, const struct bots *b)
{
    static const char *const names[BOT_KINDS] = { "stand", "wander", "dodge" };

    json_open(j, "bots", '{');
    for (int i = 0; i < BOT_KINDS; i++) {
        json_open(j, names[i], '{');
        json_number(j, "lived", b->survived[i]);
        json_number(j, "of", b->n[i]);
        if (bots_flown(b)) {
            json_number(j, "hits", b->hits[i]);
            json_number(j, "flown", b->flown[i]); /* frames of all */
        }
        json_close(j, '}');
    }
    json_number(j, "frames", bots_mean(b)); /* on average */
    json_close(j, '}');
}

static void json_measure(struct json *j, const struct measure *m)
{
    json_open(j, "tenths", '{'); /* of px, and of bullets a second */
    json_number(j, "gap", m->gap);
    json_number(j, "ship", m->ship);
    json_number(j, "rate", measure_per_second(m) / 10);
    json_close(j, '}');
    json_number(j, "most", m->most);
    json_number(j, "aimed", m->aimed);
    json_number(j, "reaction", m->reaction);
}

void survive_print_json(const struct survive_output *of, const struct section_run *s)
{
    const struct search *k = &s->search;
    struct json j = { .out = stdout };

    json_open(&j, NULL, '{');
    json_text(&j, "section", of->section);
    json_text(&j, "difficulty", of->difficulty);
    json_text(&j, "verdict", json_verdict(k->verdict));
    json_number(&j, "begin", k->begin);
    json_number(&j, "frames", k->frames);
    json_number(&j, "last", k->last);
    json_number(&j, "plans", k->plans);
    json_number(&j, "probes", k->probes);
    json_bool(&j, "reacts", k->reacts);
    if (k->verdict != SEARCH_NO_SHIP && k->verdict != SEARCH_FAULT)
        json_bots(&j, &s->measure.bots);
    if (section_survived(s))
        json_measure(&j, &s->measure);
    json_text(&j, "demo", of->demo);
    json_text(&j, "picture", of->picture);
    json_text(&j, "map", of->map);
    json_close(&j, '}');
    putchar('\n');
}

void survive_print_head(void)
{
    report_print("%-24s %-10s %-18s %7s %5s %6s %9s %8s %8s\n", "section", "difficulty", "verdict", "seconds", "bots",
                 "last", "gap px", "bullets", "reaction");
}

void survive_print_row(const struct survive_output *of, const struct section_run *s)
{
    const struct measure *m = &s->measure;
    const unsigned length = tenths_of_second(s->search.frames - s->search.begin),
                   last = tenths_of_second(bots_mean(&m->bots));
    char bots[16], gap[24] = "", rate[24] = "", reaction[16] = "";

    snprintf(bots, sizeof bots, "%d/%d", bots_survived(&m->bots), bots_count(&m->bots));
    if (section_survived(s)) {
        snprintf(gap, sizeof gap, ">= %d.%d", m->gap / 10, m->gap % 10);
        snprintf(rate, sizeof rate, "%u.%u/s", (unsigned)(measure_per_second(m) / 100),
                 (unsigned)(measure_per_second(m) / 10 % 10));
        if (m->aimed)
            snprintf(reaction, sizeof reaction, "%d", m->reaction);
    }
    report_print("%-24s %-10s %-18s %5u.%u %5s %4u.%u %9s %8s %8s\n", of->section, of->difficulty,
                 verdict_text(s->search.verdict), length / 10, length % 10, bots, last / 10, last % 10, gap, rate,
                 reaction);
}

void survive_print_bots_head(void)
{
    report_print("%-24s %-10s %6s %8s %6s %14s %10s\n", "section", "difficulty", "bots", "seconds", "hits",
                 "hits/minute", "dodge bots");
}

void survive_print_bots_row(const struct survive_output *of, const struct section_run *s)
{
    const struct bots *b = &s->measure.bots;
    const unsigned rate = bots_rate(b), dodging = bots_rate_of(b, BOT_DODGE);
    const unsigned each = tenths_of_second(bots_flown(b) / (uint32_t)bots_count(b));

    report_print("%-24s %-10s %6d %6u.%u %6u %12u.%u %8u.%u\n", of->section, of->difficulty, bots_count(b), each / 10,
                 each % 10, (unsigned)bots_hits(b), rate / 10, rate % 10, dodging / 10, dodging % 10);
}
