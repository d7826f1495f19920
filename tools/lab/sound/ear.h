/*
 * ear.h - the ear: what the page of sound measures, and with which means. Each section measures one thing, reports it,
 * and says which figure of the prototype it reaches.
 *
 * What is measured is the engine's own code; what it is measured against is computed with doubles. No figure depends on
 * the machine: they are integers, and decibels of one decimal.
 */
#ifndef SOUND_EAR_H
#define SOUND_EAR_H

#include "../../../src/sound/voices.h"
#include "../../../src/sound/fm.h"
#include "../report/report.h"

void section_waves(void);
void section_fm(void);
void section_pitch(void);
void section_recordings(void);
void section_adpcm(void);
void section_levels(void);
void section_clicks(void);
void section_mix(void);
void section_formats(void);

extern struct snd_tables ear_tables;

/* A figure of the table that opens the page: what the prototype had, and whether it is reached. If it is not, the ear
 * says so and ends with exit code 1. */
void ear_figure(const char *what, const char *here, const char *prototype, bool reached);

/* "-84.7" */
const char *ear_db(double v);

enum { EAR_LONG = 1 << 14 /* samples of a spectrum */ };

/* The levels of x's frequencies, 0 to EAR_LONG / 2. */
void ear_spectrum(const double x[EAR_LONG], double level[EAR_LONG / 2 + 1]);

/* An odd number of turns in EAR_LONG samples, near that note; its step in 2^-56 turns. */
int ear_turns(int note);
uint64_t ear_step(int turns);

/* Decibels of what is right over what is wrong. */
double ear_snr(const double *right, const double *heard, int n);

/* An instrument as MML has it behind its name, in a block of bytes that is a ROM: free(rom). */
struct ear_inst {
    uint8_t *rom;
    uint32_t at;
    struct inst inst;
};
struct ear_inst ear_inst(const char *settings);

/* n samples of a note at that step, from its beginning, without its envelope. */
void ear_wave(const struct ear_inst *i, uint64_t step, double *out, int n);

/* Voices that play it. */
struct ear_voices {
    struct voices v;
    uint8_t *block; /* malloc */
};
void ear_open(struct ear_voices *e);

#endif
