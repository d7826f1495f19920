/*
 * licences.c - lists licences (licences.h). A port reports its own library (plat_describe_build). tests/cli/licences.sh
 * compares the list with the libraries that the program is linked with.
 */
#include "licences.h"

#include <stdio.h>
#include <string.h>
#include "../../platform/platform.h"
#include "../board/board.h"
#include "../common/report.h"
#include "game/version.h"
#include "game/embedded_rom.h"

/* The texts of the MIT and zlib licences, which must accompany copies. */
static const char mit[] =
    "Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated\n"
    "documentation files (the \"Software\"), to deal in the Software without restriction, including without "
    "limitation\n"
    "the rights to use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and\n"
    "to permit persons to whom the Software is furnished to do so, subject to the following conditions:\n"
    "\n"
    "The above copyright notice and this permission notice shall be included in all copies or substantial portions of\n"
    "the Software.\n"
    "\n"
    "THE SOFTWARE IS PROVIDED \"AS IS\", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED "
    "TO\n"
    "THE WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE\n"
    "AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF\n"
    "CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER "
    "DEALINGS\n"
    "IN THE SOFTWARE.\n";

static const char zlib[] =
    "This software is provided 'as-is', without any express or implied warranty. In no event will the authors be held\n"
    "liable for any damages arising from the use of this software.\n"
    "\n"
    "Permission is granted to anyone to use this software for any purpose, including commercial applications, and to\n"
    "alter it and redistribute it freely, subject to the following restrictions:\n"
    "\n"
    "1. The origin of this software must not be misrepresented; you must not claim that you wrote the original\n"
    "   software. If you use this software in a product, an acknowledgment in the product documentation would be\n"
    "   appreciated but is not required.\n"
    "2. Altered source versions must be plainly marked as such, and must not be misrepresented as being the original\n"
    "   software.\n"
    "3. This notice may not be removed or altered from any source distribution.\n";

static const char mingw[] =
    "Redistribution and use in source and binary forms, with or without modification, are permitted provided that\n"
    "the following conditions are met:\n"
    "\n"
    "1. Redistributions in source code must retain the accompanying copyright notice, this list of conditions,\n"
    "   and the following disclaimer.\n"
    "2. Redistributions in binary form must reproduce the accompanying copyright notice, this list of conditions,\n"
    "   and the following disclaimer in the documentation and/or other materials provided with the distribution.\n"
    "3. Names of the copyright holders must not be used to endorse or promote products derived from this software\n"
    "   without prior written permission from the copyright holders.\n"
    "4. The right to distribute this software or to use it for any purpose does not give you the right to use\n"
    "   Servicemarks (sm) or Trademarks (tm) of the copyright holders.  Use of them is covered by separate\n"
    "   agreement with the copyright holders.\n"
    "5. If any files are modified, you must cause the modified files to carry prominent notices stating that you\n"
    "   changed the files and the date of any change.\n"
    "\n"
    "Disclaimer\n"
    "\n"
    "THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS \"AS IS\" AND ANY EXPRESSED OR IMPLIED WARRANTIES,\n"
    "INCLUDING, BUT NOT LIMITED TO, THE IMPLIED WARRANTIES OF MERCHANTABILITY AND FITNESS FOR A PARTICULAR\n"
    "PURPOSE ARE DISCLAIMED. IN NO EVENT SHALL THE COPYRIGHT HOLDERS BE LIABLE FOR ANY DIRECT, INDIRECT,\n"
    "INCIDENTAL, SPECIAL, EXEMPLARY, OR CONSEQUENTIAL DAMAGES (INCLUDING, BUT NOT LIMITED TO, PROCUREMENT OF\n"
    "SUBSTITUTE GOODS OR SERVICES; LOSS OF USE, DATA, OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER CAUSED AND ON\n"
    "ANY THEORY OF LIABILITY, WHETHER IN CONTRACT, STRICT LIABILITY, OR TORT (INCLUDING NEGLIGENCE OR OTHERWISE)\n"
    "ARISING IN ANY WAY OUT OF THE USE OF THIS SOFTWARE, EVEN IF ADVISED OF THE POSSIBILITY OF SUCH DAMAGE.\n"
    "\n"
    "Number conversion, by Lucent Technologies:\n"
    "\n"
    "Permission to use, copy, modify, and distribute this software and its documentation for any purpose and\n"
    "without fee is hereby granted, provided that the above copyright notice appear in all copies and that both\n"
    "that the copyright notice and this permission notice and warranty disclaimer appear in supporting\n"
    "documentation, and that the name of Lucent or any of its entities not be used in advertising or publicity\n"
    "pertaining to distribution of the software without specific, written prior permission.\n"
    "\n"
    "LUCENT DISCLAIMS ALL WARRANTIES WITH REGARD TO THIS SOFTWARE, INCLUDING ALL IMPLIED WARRANTIES OF\n"
    "MERCHANTABILITY AND FITNESS. IN NO EVENT SHALL LUCENT OR ANY OF ITS ENTITIES BE LIABLE FOR ANY SPECIAL,\n"
    "INDIRECT OR CONSEQUENTIAL DAMAGES OR ANY DAMAGES WHATSOEVER RESULTING FROM LOSS OF USE, DATA OR PROFITS,\n"
    "WHETHER IN AN ACTION OF CONTRACT, NEGLIGENCE OR OTHER TORTIOUS ACTION, ARISING OUT OF OR IN CONNECTION WITH\n"
    "THE USE OR PERFORMANCE OF THIS SOFTWARE.\n";

/* The two-clause BSD licence, without the copyright line. */
static const char bsd[] =
    "Redistribution and use in source and binary forms, with or without modification, are permitted provided that\n"
    "the following conditions are met:\n"
    "\n"
    "1. Redistributions of source code must retain the above copyright notice, this list of conditions and the\n"
    "   following disclaimer.\n"
    "2. Redistributions in binary form must reproduce the above copyright notice, this list of conditions and the\n"
    "   following disclaimer in the documentation and/or other materials provided with the distribution.\n"
    "\n"
    "THIS SOFTWARE IS PROVIDED BY THE AUTHOR AND CONTRIBUTORS \"AS IS\" AND ANY EXPRESS OR IMPLIED WARRANTIES,\n"
    "INCLUDING, BUT NOT LIMITED TO, THE IMPLIED WARRANTIES OF MERCHANTABILITY AND FITNESS FOR A PARTICULAR PURPOSE\n"
    "ARE DISCLAIMED. IN NO EVENT SHALL THE AUTHOR OR CONTRIBUTORS BE LIABLE FOR ANY DIRECT, INDIRECT, INCIDENTAL,\n"
    "SPECIAL, EXEMPLARY, OR CONSEQUENTIAL DAMAGES (INCLUDING, BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS\n"
    "OR SERVICES; LOSS OF USE, DATA, OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER CAUSED AND ON ANY THEORY OF\n"
    "LIABILITY, WHETHER IN CONTRACT, STRICT LIABILITY, OR TORT (INCLUDING NEGLIGENCE OR OTHERWISE) ARISING IN ANY\n"
    "WAY OUT OF THE USE OF THIS SOFTWARE, EVEN IF ADVISED OF THE POSSIBILITY OF SUCH DAMAGE.\n";

static const char misaki[] =
    "These fonts are free software. Unlimited permission is granted to use, copy, and distribute it, with or without\n"
    "modification, either commercially and noncommercially. THESE FONTS ARE PROVIDED \"AS IS\" WITHOUT WARRANTY.\n";

static const char efont_copyright[] =
    "Copyright (c) 2000-2004 /efont/ The Electronic Font Open Laboratory, Kazuhiko and "
    "Kenji Kano";
static const char efont[] =
    "Redistribution and use in source and binary forms, with or without modification, are permitted provided that the\n"
    "following conditions are met:\n"
    "\n"
    "1. Redistributions of source code must retain the above copyright notice, this list of conditions and the\n"
    "   following disclaimer.\n"
    "2. Redistributions in binary form must reproduce the above copyright notice, this list of conditions and the\n"
    "   following disclaimer in the documentation and/or other materials provided with the distribution.\n"
    "3. Neither the name of the team nor the names of its contributors may be used to endorse or promote products\n"
    "   derived from this font without specific prior written permission.\n"
    "\n"
    "THIS FONT IS PROVIDED BY THE TEAM AND CONTRIBUTORS \"AS IS\" AND ANY EXPRESS OR IMPLIED WARRANTIES, INCLUDING,\n"
    "BUT NOT LIMITED TO, THE IMPLIED WARRANTIES OF MERCHANTABILITY AND FITNESS FOR A PARTICULAR PURPOSE ARE\n"
    "DISCLAIMED. IN NO EVENT SHALL THE TEAM OR CONTRIBUTORS BE LIABLE FOR ANY DIRECT, INDIRECT, INCIDENTAL, SPECIAL,\n"
    "EXEMPLARY, OR CONSEQUENTIAL DAMAGES (INCLUDING, BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS OR\n"
    "SERVICES; LOSS OF USE, DATA, OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER CAUSED AND ON ANY THEORY OF\n"
    "LIABILITY, WHETHER IN CONTRACT, STRICT LIABILITY, OR TORT (INCLUDING NEGLIGENCE OR OTHERWISE) ARISING IN ANY\n"
    "WAY OUT OF THE USE OF THIS FONT, EVEN IF ADVISED OF THE POSSIBILITY OF SUCH DAMAGE.\n";

static const char curtain_copyright[] = "Copyright (c) The Curtain authors";
static const char sdl_copyright[] = "Copyright (C) Sam Lantinga and others";
static const char mingw_copyright[] = "Copyright (c) 2009-2016 the mingw-w64 project, 1997-2001 Lucent Technologies";

static const char no_notice[] = "No notice is required.\n";
#ifndef __MINGW32__
static const char system_library[] =
    "This library is part of the operating system, not of this program, so no notice is required.\n";
#endif
static const char unknown_licence[] = "The licence is unknown; ask the author of this port of Curtain.\n";

struct work {
    char name[32], version[128];
    const char *licence, *purpose, *copyright, *text;
};

enum { WORKS = 7 };

static struct work work(const char *name, const char *licence, const char *purpose, const char *copyright,
                        const char *text)
{
    struct work w = { .licence = licence, .purpose = purpose, .copyright = copyright, .text = text };

    snprintf(w.name, sizeof w.name, "%s", name);
    return w;
}

/* Describes the port's library, from "SDL 2.28.5, x11" or what another port reports. Returns false if it has none. */
static bool describe_port(struct work *w)
{
    char about[128];

    plat_describe_build(about, sizeof about);
    about[strcspn(about, ",")] = '\0';
    if (strcmp(about, "no window") == 0)
        return false;
    if (strncmp(about, "SDL ", 4) == 0) {
        *w = work("SDL", "zlib", "window, sound, controllers", sdl_copyright, zlib);
        snprintf(w->version, sizeof w->version, "%s", about + 4);
    } else {
        *w = work("port", "unknown", "window and other platform support", "", unknown_licence);
        snprintf(w->version, sizeof w->version, "%s", about);
    }
    return true;
}

static int list(struct work all[WORKS])
{
    int n = 0;

    all[n] = work("Curtain", "MIT", "engine, and the Lua library in every ROM", curtain_copyright, mit);
    snprintf(all[n++].version, sizeof all->version, "%s", CURTAIN_VERSION);
    all[n] = work("Lua", "MIT", "script interpreter", board_lua_copyright(), mit);
    snprintf(all[n++].version, sizeof all->version, "%s", board_lua_release());
    all[n++] = work("stb", "public domain", "PNG reader and writer, font reader",
                    "Sean Barrett and others; also available under MIT", no_notice);
    all[n++] =
        work("Misaki", "free", "Japanese characters, in games that use them", "Copyright 2002-2021 Num Kadoma", misaki);
    all[n++] = work("efont", "BSD-3-Clause", "Japanese characters, in games that use them", efont_copyright, efont);
    n += describe_port(&all[n]);
#ifdef __GLIBC__
    all[n] = work("glibc", "LGPL 2.1", "system C library", "the GNU C Library", system_library);
    snprintf(all[n++].version, sizeof all->version, "%d.%d", __GLIBC__, __GLIBC_MINOR__);
#elif defined __MINGW32__ /* parts of it are in the program's file */
    all[n] = work("mingw-w64", "ZPL 2.1, Lucent", "C library for Windows", mingw_copyright, mingw);
    snprintf(all[n++].version, sizeof all->version, "%s", __MINGW64_VERSION_STR);
#else
    all[n++] = work("libc", "its own", "system C library", "the system's C library", system_library);
#endif
    return n;
}

static void print_texts(const struct work *all, int n)
{
    for (int i = 0; i < n; i++) {
        report_print("\n---- %s %s: %s ----\n\n", all[i].name, all[i].version, all[i].licence);
        if (all[i].copyright[0])
            report_print("%s\n\n", all[i].copyright);
        report_print("%s", all[i].text);
    }
}

void licences_notices(struct byte_buffer *out)
{
    const struct {
        const char *name, *copyright, *texts[2];
    } all[] = {
        { "Curtain, the game engine", curtain_copyright, { mit } },
        { "Lua", board_lua_copyright(), { mit } },
        { "efont, the 12 px Japanese characters of Glass Tide", efont_copyright, { efont } },
        { "SDL, in Windows programs (Linux programs use the SDL that is installed)", sdl_copyright, { zlib } },
        { "mingw-w64, in Windows programs", mingw_copyright, { mingw } },
        { "wasi-libc, in web pages",
          "Copyright (c) 2005-2019 Rich Felker and others (musl: MIT), 1993-2004 Sun Microsystems, Inc. (musl's "
          "mathematics),\n2015-2017 Nuxi and contributors (cloudlibc: BSD)",
          { mit, bsd } },
    };

    byte_buffer_print(
        out, "This game contains software by others. The notices below cover the downloads for all systems. Your\n"
             "download may contain only some of this software.\n");
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        byte_buffer_print(out, "\n---- %s ----\n\n%s\n", all[i].name, all[i].copyright);
        for (int k = 0; k < 2 && all[i].texts[k]; k++)
            byte_buffer_print(out, "\n%s", all[i].texts[k]);
    }
}

enum result licences_run(bool full)
{
    struct work all[WORKS];
    const int n = list(all);
    const struct embedded_rom *own = embedded_rom_game();

    if (own->rom)
        report_print("%s is by %s. This program also contains:\n", own->m.title,
                     own->m.author[0] ? own->m.author : "an unnamed author");
    for (int i = 0; i < n; i++)
        report_print("%-8s %-8s %-14s %s\n", all[i].name, all[i].version[0] ? all[i].version : "-", all[i].licence,
                     all[i].purpose);
    puts("To pack a game, this program also loads these libraries if they are installed:");
    puts("libsndfile (LGPL 2.1 or later) for OGG and FLAC, and libopenmpt (BSD) for tracker modules.");
    puts("Playing a game needs none of them.");
    if (full)
        print_texts(all, n);
    else
        puts("When you distribute this program, include the texts that --full prints.");
    return report_stdout(RESULT_DONE);
}
