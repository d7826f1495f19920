/*
 * ieee.h - checks that this build computes as IEEE 754 requires. Some compiler flags change results and define no macro
 * by which fx.h could reject them.
 */
#ifndef BASE_IEEE_H
#define BASE_IEEE_H

/* Returns NULL if the build conforms, otherwise one sentence that names the deviation and the flags that cause it.
 * Takes less than a microsecond. The thread must round to nearest and keep denormals (host.h). */
const char *ieee_find_fault(void);

#endif
