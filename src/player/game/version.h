/*
 * version.h - which release of Curtain this is. CHANGELOG.md says what is in it, and begins with the same number.
 *
 * What a release computes is told by CORE_VERSION (board.h), which changes by other rules.
 */
#ifndef PLAYER_VERSION_H
#define PLAYER_VERSION_H

#define CURTAIN_VERSION "0.1.0"

#endif
