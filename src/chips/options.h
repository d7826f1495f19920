/* placeholder */
#ifndef CHIPS_OPTIONS_H
#define CHIPS_OPTIONS_H
enum { MAX_OPTIONS = 256 };
#endif
