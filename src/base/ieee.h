/*
 * ieee.h - does this build compute as IEEE 754 says? Some flags of compilers change results and leave no macro by which
 * fx.h could refuse them.
 */
#ifndef BASE_IEEE_H
#define BASE_IEEE_H

/* NULL: it does. Else one sentence: what it does otherwise, and flags that make it do so. Takes less than a
 * microsecond. The thread has to round to nearest and to keep small numbers (host.h). */
const char *ieee_fault(void);

#endif
