/*
 * mml_curve.c - curves and waves of MML instruments. A wave is the sum of its harmonics, stored in versions with fewer
 * and fewer harmonics (inst.h). Points are samples of a cycle; the wave is the band-limited curve through them. All
 * arithmetic is in integers, so that the bytes are the same on every host.
 */
#include "mml_parts.h"

#include <stdlib.h>
#include <string.h>
#include "../../base/bytes.h"
#include "../../base/trig.h"
#include "../../common/result.h"

/* Adds a table unless an equal one exists; returns its number. Takes ownership of the bytes. */
static uint32_t add_table(struct mml *m, uint32_t at, uint8_t *bytes, uint32_t n)
{
    for (uint32_t i = 0; i < m->n_tables; i++)
        if (m->tables[i].n == n && memcmp(m->tables[i].bytes, bytes, n) == 0) {
            free(bytes);
            return i + 1;
        }
    if (m->n_tables == MML_MAX_TABLES) {
        free(bytes);
        mml_fail(m, at, "more than %d curves and waves", (int)MML_MAX_TABLES);
    }
    m->tables[m->n_tables++] = (struct mml_table){ bytes, n, 0 };
    return m->n_tables;
}

static uint8_t *allocate(struct mml *m, uint32_t at, size_t n)
{
    uint8_t *p = calloc(1, n);

    if (p == NULL) {
        result_set_host_failed();
        mml_fail(m, at, "out of memory");
    }
    return p;
}

/* ---- curves ---- */

struct scale {
    const char *name;
    int64_t lo, hi;                 /* thousandths */
    int64_t numerator, denominator; /* factor to the curve's unit */
};

static struct scale get_scale(char kind)
{
    if (kind == 'E')
        return (struct scale){ "percent", 0, 100000, 32767, 100000 };
    if (kind == 'M')
        return (struct scale){ "cents", -4800000, 4800000, 256, 100000 };
    return (struct scale){ "a pan (-64 left, 0 the note's own, 64 right)", -128000, 128000, 1, 1000 };
}

uint32_t mml_read_curve(struct mml *m, uint32_t *at, uint32_t end, char kind)
{
    const uint32_t from = *at;
    const struct scale scale = get_scale(kind);
    uint8_t curve[4 + 2 * CURVE_MAX_VALUES] = { 0, CURVE_NO_LOOP };
    uint8_t n = 0;

    const int64_t frames = mml_parse_decimal(m, at, end, "frames per value", 1000, CURVE_MAX_FRAMES * 1000) / 1000;
    bytes_put16(curve + 2, (uint16_t)frames);
    if (*at == end || m->text[(*at)++] != ':')
        mml_fail(m, from,
                 "expected FRAMES:VALUE,VALUE...; | before a value marks the loop start, as in 2:100,60|50,40");
    do {
        if (n == CURVE_MAX_VALUES)
            mml_fail(m, from, "expected at most %d values", (int)CURVE_MAX_VALUES);
        bytes_put16(curve + 4 + 2 * n++, (uint16_t)(mml_parse_decimal(m, at, end, scale.name, scale.lo, scale.hi) *
                                                    scale.numerator / scale.denominator));
        if (*at < end && m->text[*at] == '|' && curve[1] == CURVE_NO_LOOP) {
            ++*at;
            curve[1] = n;
            continue;
        }
        if (!mml_take_comma(m, at, end))
            break;
    } while (true);
    curve[0] = n;
    uint8_t *bytes = allocate(m, from, inst_curve_size(curve));
    memcpy(bytes, curve, inst_curve_size(curve));
    return add_table(m, from, bytes, (uint32_t)inst_curve_size(curve));
}

void mml_read_curve_line(struct mml *m, uint32_t at, uint32_t end)
{
    const char kind = m->text[at + 1];
    uint32_t p = mml_skip_blanks(m, at + 2, end);
    char name[MML_NAME];
    const uint32_t name_at = p;

    mml_parse_word(m, &p, end, name, "the curve name, as in @E swell 2:0,50,100");
    if (name[0] < 'a' || name[0] > 'z')
        mml_fail(m, name_at, "expected a name that starts with a lower-case letter, got \"%s\"", name);
    for (int i = 0; i < m->n_curves; i++)
        if (m->curves[i].kind == kind && strcmp(m->curves[i].name, name) == 0)
            mml_fail(m, at, "duplicate curve \"%s\"", name);
    if (m->n_curves == MML_MAX_NAMES)
        mml_fail(m, at, "more than %d curves", (int)MML_MAX_NAMES);
    p = mml_skip_blanks(m, p, end);
    m->curves[m->n_curves].piece = mml_read_curve(m, &p, end, kind);
    m->curves[m->n_curves].kind = kind;
    memcpy(m->curves[m->n_curves++].name, name, MML_NAME);
    p = mml_skip_blanks(m, p, end);
    if (p < end)
        mml_fail(m, p, "expected the end of the line after the curve");
}

uint32_t mml_find_curve(const struct mml *m, char kind, const char *name)
{
    for (int i = 0; i < m->n_curves; i++)
        if (m->curves[i].kind == kind && strcmp(m->curves[i].name, name) == 0)
            return m->curves[i].piece;
    return 0;
}

/* ---- waves ---- */

/* A wave's harmonics, Q20: sine and cosine coefficients. */
struct harmonics {
    int n;
    int64_t coefficient[WAVE_MAX_HARMONICS + 1][2];
};

/* Returns the highest harmonic of version v. */
static int highest_harmonic(int v)
{
    static const uint8_t harmonics[WAVE_MAX_VERSIONS] = { 1, 2, 3, 4, 6, 8, 11, 16, 23, 32 };

    return harmonics[v];
}

/* Returns sample i of 2^bits per cycle, Q30, from the harmonics up to `up_to`. */
static int64_t sample_at(const struct harmonics *h, int up_to, uint32_t i, int bits)
{
    int64_t v = 0;

    for (int k = 1; k <= up_to && k <= h->n; k++) {
        const ang turn = (ang)i * (ang)k << (32 - bits);
        v += (trig_sin30(turn) * h->coefficient[k][0] + trig_sin30(turn + (1u << 30)) * h->coefficient[k][1]) >> 20;
    }
    return v;
}

enum { PEAK = 27600 /* the same as a saw's */ };

static uint32_t add_wave(struct mml *m, uint32_t from, const struct harmonics *h)
{
    int versions = 1;
    int64_t most = 1;

    while (highest_harmonic(versions - 1) < h->n)
        versions++;
    for (uint32_t i = 0; i < 4096; i++) {
        const int64_t v = sample_at(h, h->n, i, 12);
        most = v > most ? v : -v > most ? -v : most;
    }
    uint8_t *bytes = allocate(m, from, inst_wave_offset(versions));
    bytes[0] = (uint8_t)versions;
    for (int v = 0; v < versions; v++) {
        uint8_t *p = bytes + inst_wave_offset(v);
        const uint32_t n = 1u << inst_wave_bits(v);
        for (uint32_t i = 0; i <= n; i++) {
            const int64_t x = sample_at(h, highest_harmonic(v), i % n, inst_wave_bits(v)) * PEAK / most;
            bytes_put16(p + 2 * i, (uint16_t)(x < -32767 ? -32767 : x > 32767 ? 32767 : x));
        }
    }
    return add_table(m, from, bytes, (uint32_t)inst_wave_offset(versions));
}

uint32_t mml_read_harmonics(struct mml *m, uint32_t *at, uint32_t end)
{
    const uint32_t from = *at;
    struct harmonics h = { 0 };

    do {
        if (h.n == WAVE_MAX_HARMONICS)
            mml_fail(m, from, "expected at most %d harmonics", (int)WAVE_MAX_HARMONICS);
        h.coefficient[++h.n][0] = (mml_parse_decimal(m, at, end, "percent", -100000, 100000) << 20) / 100000;
    } while (mml_take_comma(m, at, end));
    while (h.n > 0 && h.coefficient[h.n][0] == 0)
        h.n--;
    if (h.n == 0)
        mml_fail(m, from, "expected at least one harmonic above 0");
    return add_wave(m, from, &h);
}

enum { POINTS = 2 * WAVE_MAX_HARMONICS };

/* Computes the harmonics of a cycle through the points (a discrete Fourier transform). */
static struct harmonics points_to_harmonics(const int64_t *point, int n)
{
    struct harmonics h = { .n = n / 2 };

    for (int k = 1; k <= h.n; k++) {
        for (int i = 0; i < n; i++) {
            const ang turn = (ang)(((uint64_t)(i * k % n) << 32) / (uint64_t)n);
            h.coefficient[k][0] += point[i] * trig_sin30(turn) >> 10;
            h.coefficient[k][1] += point[i] * trig_sin30(turn + (1u << 30)) >> 10;
        }
        for (int part = 0; part < 2; part++)
            h.coefficient[k][part] = h.coefficient[k][part] * (2 * k == n ? 1 : 2) / (n * (int64_t)100000);
    }
    return h;
}

uint32_t mml_read_points(struct mml *m, uint32_t *at, uint32_t end)
{
    const uint32_t from = *at;
    int64_t point[POINTS];
    int n = 0;
    bool same = true;

    do {
        if (n == POINTS)
            mml_fail(m, from, "expected at most %d points", (int)POINTS);
        point[n++] = mml_parse_decimal(m, at, end, "percent", -100000, 100000);
        same = same && point[n - 1] == point[0];
    } while (mml_take_comma(m, at, end));
    if (n < 4 || same)
        mml_fail(m, from, "expected 4 to %d points per cycle, not all equal", (int)POINTS);
    const struct harmonics h = points_to_harmonics(point, n);
    return add_wave(m, from, &h);
}
