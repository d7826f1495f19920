/*
 * pads_log.c - the run-length encoding of a run's pads (pads_log.h).
 */
#include "pads_log.h"

#include <string.h>
#include "../base/bytes.h"

void pads_log_begin(struct pads_log *log, uint64_t start_hash)
{
    *log = (struct pads_log){ .bytes = log->bytes, .cap = log->cap, .digest = hash_fold(HASH_START, start_hash) };
}

static size_t put_run(uint8_t *out, uint32_t frames, const uint16_t pads[MAX_PLAYERS])
{
    uint8_t *p = out;

    for (; frames >= 0x80; frames >>= 7)
        *p++ = (uint8_t)(frames | 0x80);
    *p++ = (uint8_t)frames;
    for (int i = 0; i < MAX_PLAYERS; i++, p += 2)
        bytes_put16(p, pads[i]);
    return (size_t)(p - out);
}

void pads_log_add(struct pads_log *log, const uint16_t pads[MAX_PLAYERS])
{
    if (log->run_frames > 0 && memcmp(log->pads, pads, sizeof log->pads) != 0) {
        if (log->cap - log->used < PADS_LOG_RUN_BYTES)
            log->incomplete = true;
        else
            log->used += put_run(log->bytes + log->used, log->run_frames, log->pads);
        log->run_frames = 0;
    }
    memcpy(log->pads, pads, sizeof log->pads);
    log->run_frames++;
    log->frames++;
    log->incomplete = log->incomplete || log->frames > PADS_LOG_MAX_FRAMES;
    log->digest = pads_log_update_digest(log->digest, pads);
}

size_t pads_log_write(const struct pads_log *log, uint8_t *out)
{
    memcpy(out, log->bytes, log->used);
    return log->used + (log->run_frames > 0 ? put_run(out + log->used, log->run_frames, log->pads) : 0);
}

struct pads_reader pads_log_reader(const struct pads_log *log)
{
    struct pads_reader r = { .at = log->bytes, .end = log->bytes + log->used, .last_frames = log->run_frames };

    memcpy(r.last_pads, log->pads, sizeof r.last_pads);
    return r;
}

bool pads_reader_next(struct pads_reader *r)
{
    const uint8_t *p = r->at;
    uint64_t frames = 0;
    int shift = 0;

    if (p == r->end && r->last_frames > 0) {
        memcpy(r->pads, r->last_pads, sizeof r->pads);
        r->frames = r->last_frames;
        r->last_frames = 0;
        return true;
    }
    do {
        if (p == r->end || shift > 28)
            return false;
        frames |= (uint64_t)(*p & 0x7f) << shift;
        shift += 7;
    } while (*p++ & 0x80);
    if (frames == 0 || frames > PADS_LOG_MAX_FRAMES || r->end - p < 2 * MAX_PLAYERS)
        return false;
    for (int i = 0; i < MAX_PLAYERS; i++, p += 2) {
        r->pads[i] = bytes_get16(p);
        if (!pad_is_valid(r->pads[i]))
            return false;
    }
    r->frames = (uint32_t)frames;
    r->at = p;
    return true;
}
