/*
 * pacing.h - the sections of docs/measured/pacing.md: what pace.h makes of screens, how long a switch takes to the
 * picture, and what composing a window and looking ahead cost.
 */
#ifndef PACING_PACING_H
#define PACING_PACING_H

void section_screens(void);
void section_latency(void);
void section_costs(void);

#endif
