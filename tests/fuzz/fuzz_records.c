/*
 * fuzz_records.c - libFuzzer: any bytes as a file of practice records. What is read and counted on is written as a text
 * that reads as the same; what is refused says the line and why, and holds nothing.
 */
#include <stdio.h>
#include "../../src/player/replays/records.h"
#include "fuzz.h"

/* Each record is found, counts, and is never captured more often than tried. */
static void count(struct records *r)
{
    for (int i = 0, n = r->n; i < n; i++) {
        const struct record got = r->line[i].r;
        if (!got.section[0])
            continue;
        need(memchr(got.section, 0, sizeof got.section) && memchr(got.difficulty, 0, sizeof got.difficulty));
        need(got.captures >= 0 && got.captures <= got.attempts && got.attempts <= MAX_RECORD_COUNT);
        records_attempt(r, got.section, got.difficulty);
        records_capture(r, got.section, got.difficulty);
        const struct record *now = records_find(r, got.section, got.difficulty);
        need(now && now->captures <= now->attempts);
        need(now->attempts <= MAX_RECORD_COUNT && now->attempts >= got.attempts);
        need(r->n == n);
    }
}

/* What is written reads, and is written the same again. */
static void round_trip(const struct records *r)
{
    struct records back;
    char err[256], *text, *again;
    size_t n, m;

    text = records_text(r, &n);
    if (!text)
        return;
    need(records_read(&back, text, n, err, sizeof err));
    again = records_text(&back, &m);
    need(!again || (n == m && memcmp(text, again, n) == 0));
    records_free(&back);
    free(again);
    free(text);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *copy = fuzz_copy(data, size);
    struct records r;
    char err[256] = "";

    if (records_read(&r, copy, size, err, sizeof err)) {
        round_trip(&r);
        count(&r);
        round_trip(&r);
    } else {
        need(strncmp(err, "line ", 5) == 0 && r.n == 0 && r.line == NULL);
    }
    records_free(&r);
    free(copy);
    return 0;
}
