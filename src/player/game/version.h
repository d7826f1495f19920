/*
 * version.h - the release of Curtain. CHANGELOG.md starts with the same number.
 *
 * CORE_VERSION (board.h) is a separate number, which changes when the same ROM and demo could give a different hash.
 */
#ifndef PLAYER_VERSION_H
#define PLAYER_VERSION_H

#define CURTAIN_VERSION "0.1.0"

#endif
