# Curtain. `make help` lists the targets. A configuration has a build folder of its own: build/NAME.

# Goals that start makes of their own go one after another, for these would make the same objects at the same time.
FRONT := all null play install uninstall test torture golden asan ubsan monkey msan msan-short given valgrind \
         fuzz mutants nightly analyze accuracy sound bench bench-fx compare prove cross demos cookbook docs survive \
         patterns library ports players web windows bulletml walks
ifneq ($(and $(filter $(FRONT),$(MAKECMDGOALS)),$(word 2,$(MAKECMDGOALS))),)

.PHONY: $(MAKECMDGOALS) one-by-one
$(MAKECMDGOALS): one-by-one
	@:
one-by-one:
	@set -e; for goal in $(MAKECMDGOALS); do $(MAKE) --no-print-directory $$goal; done

else

CC      ?= cc
# For another machine: a compiler of this one, for what a build runs itself, and what runs that machine's programs here.
BUILD_CC ?= $(CC)
RUN     ?=
CONFIG  ?= release
OPT     ?= -O2
OUT     := build/$(CONFIG)
UNAME   := $(shell uname -s)
PREFIX  ?= /usr/local
GAME    := roms/glasstide

# -fwrapv and -ffp-contract=off are semantics: results may not depend on overflow rules or fused multiplications.
SEMANTIC := -std=c11 -fwrapv -ffp-contract=off
WARN     := -Wall -Wextra -Wshadow -Wconversion -Wpedantic
PKG_CONFIG := pkg-config
LINK_MAP  = -Wl,-Map=$@.map
# macOS, untested: docs/internals/macos.md. Homebrew does not link lua@5.4 into its prefix. stb is cloned into
# build/include. Libraries that the program opens by name are found by its rpath.
ifeq ($(UNAME),Darwin)
BREW      ?= $(shell brew --prefix 2>/dev/null)
PKG_CONFIG := PKG_CONFIG_PATH="$(BREW)/opt/lua@5.4/lib/pkgconfig:$$PKG_CONFIG_PATH" pkg-config
SYSTEM_C  := -isystem build/include -isystem $(BREW)/include
SYSTEM_L  := -L$(BREW)/lib -Wl,-rpath,$(BREW)/lib
LINK_MAP   = -Wl,-map,$@.map
endif
LUA_C    := $(shell $(PKG_CONFIG) --cflags lua5.4 2>/dev/null)
LUA_L    := $(shell $(PKG_CONFIG) --libs lua5.4 2>/dev/null)
# LUA_INSIDE=1: programs contain Lua, compiled as Debian does it, without its program and what the sandbox leaves out.
LUA_SRC  := build/cross/lua-bookworm/src
LUA_H    := $(LUA_SRC)/lua.h build/cross/include/lua5.4-deb-multiarch.h
LUA_OBJ  := $(patsubst %,$(OUT)/lua/l%.o,api auxlib baselib code ctype debug do dump func gc lex mathlib mem object opcodes \
            parser state string strlib table tablib tm undump utf8lib vm zio)
ifdef LUA_INSIDE
LUA_C    := -I$(LUA_SRC) -Ibuild/cross/include
LUA_L    := $(LUA_OBJ)
endif
SDL_C    := $(shell $(PKG_CONFIG) --cflags sdl2 2>/dev/null)
CFLAGS   ?=
# library.c opens libraries. Before glibc 2.34 what that needs are libraries of their own; WebAssembly has none.
THREADS  := $(if $(findstring wasm,$(CC)),,-pthread -ldl)
# Guards against memory errors, those this compiler and its linker have; a sanitizer has its own. Each asks once.
HARDEN_C = $(eval HARDEN_C := $(if $(findstring -fsanitize,$(OPT)),,$(shell tools/harden.sh compile $(CC) $(OPT) $(CFLAGS))))$(HARDEN_C)
HARDEN_L = $(eval HARDEN_L := $(if $(findstring -fsanitize,$(OPT)),,$(shell tools/harden.sh link $(CC) $(OPT) $(CFLAGS))))$(HARDEN_L)
ALL_C    = $(SEMANTIC) $(WARN) $(OPT) -g -D_DEFAULT_SOURCE $(HARDEN_C) $(patsubst -I%,-isystem %,$(LUA_C)) $(SYSTEM_C) $(CFLAGS)
# libopenmpt is opened late and throws; AddressSanitizer looks for what throws at the start alone.
THROWS   = $(if $(findstring address,$(OPT)),-Wl$(comma)--push-state$(comma)--no-as-needed -l:libstdc++.so.6 -Wl$(comma)--pop-state)
comma   := ,
LIBS     = $(HARDEN_L) $(LUA_L) -lm $(THREADS) $(SYSTEM_L) $(THROWS)

# Layers, the lowest first (tests/lint/layers.py): what the library has, and what only the program has.
BOARD_SRC := $(wildcard src/base/*.c fb/*.c src/sound/*.c src/entities/*.c src/rom/*.c src/machine/*.c src/machine/*/*.c \
                         src/script/*.c src/script/*/*.c src/board/*.c)
PROGRAM_SRC := $(filter-out %/main.c,$(wildcard src/common/*.c src/demo/*.c src/player/*.c src/player/*/*.c src/workbench/*.c src/workbench/*/*.c))
STD_LUA   := $(wildcard scripts/*.lua scripts/*/*.lua)
# The examples that `curtain help lua NAME` prints.
EXAMPLES  := $(sort $(wildcard share/help/*.md))
# What `curtain new` writes.
TEMPLATES := $(sort $(shell find $(patsubst %,examples/%,first pattern shooter bulletml) -type f ! -name '.*' ! -path '*/failed/*'))
# What `curtain register` writes, by its place in a data folder; tools/install.sh installs the same files.
DESKTOP   := applications/curtain.desktop=share/curtain.desktop mime/packages/curtain.xml=share/curtain-mime.xml \
             icons/hicolor/128x128/apps/curtain.png=share/icons/128.png
BOARD_OBJ := $(BOARD_SRC:%.c=$(OUT)/%.o)
PROGRAM_OBJ   := $(PROGRAM_SRC:%.c=$(OUT)/%.o) $(OUT)/gen/std.o
# The host's half of the platform: platform/host.h.
HOST      := $(if $(findstring mingw,$(CC)),win win_process win_register,$(if $(findstring wasm,$(CC)),posix no_process,posix posix_process))
HOST_OBJ  := $(patsubst %,$(OUT)/platform/%.o,stdio $(HOST))
CORE_OBJ  := $(BOARD_OBJ) $(PROGRAM_OBJ) $(HOST_OBJ) \
             $(if $(findstring sanitize=memory,$(OPT)),$(OUT)/tests/inject/unpoison.o)
LIB_NAMES  = $(shell grep -oP 'curtain_[a-z_]*(?=\x28)' src/lib/curtain.h | sort -u)
OBJCOPY   ?= objcopy
GAME_SRC  := $(shell find $(GAME) -type f 2>/dev/null)

UNIT      := $(patsubst tests/unit/%.c,$(OUT)/unit/%,$(wildcard tests/unit/test_*.c))
MACHINE   := $(patsubst tests/machine/%.c,$(OUT)/machine/%,$(wildcard tests/machine/test_*.c))

# V=1 shows the commands.
Q := $(if $(V),,@)
SAY = $(if $(V),@true,@echo)

.SECONDARY:
.DELETE_ON_ERROR:
.PHONY: FORCE all null play install uninstall deps format clean help programs tools test golden demos
.PHONY: asan ubsan monkey msan msan-short given valgrind analyze nightly torture mutants fuzz bench bench-fx bench-fx-objects compare accuracy sound pacing prove cross cookbook docs survive patterns library ports players web windows bulletml walks

# These build and install nothing: what is missing they say. play, test and deps get it.
all: say-play
	@$(MAKE) --no-print-directory build/curtain build/curtain-player build/curtain-null build/curtain.1 build/curtain-null.1

help:
	@echo "make play     build and play the built-in game (without a display: render its demo to PNG)"
	@echo "make test     all tests          make golden   rewrite the golden frames"
	@echo "make all      build/curtain, curtain-player, curtain-null  make null   curtain-null only, without SDL2"
	@echo "make GAME=DIR build/curtain     one file to give away: the program with that game built in"
	@echo "make asan     tests under AddressSanitizer              make ubsan  ... UndefinedBehaviorSanitizer"
	@echo "make msan     file readers under MemorySanitizer        make valgrind  ... those that use Lua, under Valgrind"
	@echo "make monkey   random input on all screens, under both sanitizers"
	@echo "make walks    the functions that a bullet, a button, a sound pass: docs/internals/design.md"
	@echo "make analyze  cppcheck and gcc -fanalyzer               make nightly   all of these, fuzz, torture, mutants"
	@echo "make torture  snapshot, overwrite RAM and restore after every frame"
	@echo "make fuzz     60 s of each parser    make mutants  planted faults that make test must find"
	@echo "make accuracy remeasure docs/measured/accuracy.md             make sound  remeasure docs/measured/sound.md"
	@echo "make cross    every demo on five other machines, with the same hashes and pixels: docs/internals/determinism.md"
	@echo "make prove    prove every function in src/base         make bench-fx compare arithmetic with libfixmath"
	@echo "make pacing   remeasure docs/measured/pacing.md"
	@echo "make bulletml documents from other games, on the board and in libbulletml: docs/measured/bulletml.md"
	@echo "make survive  what is clearable, and how hard: docs/measured/survive.md, docs/measured/game.md"
	@echo "make patterns describe and draw the patterns of Glass Tide: docs/measured/patterns.md"
	@echo "make cookbook rewrite docs/cookbook.md, its pictures and table"
	@echo "make docs     README and docs/ as one HTML file with a search box: build/curtain.html"
	@echo "make bench    remeasure docs/measured/speed.md                 make deps   make format   make clean"
	@echo "make compare BASE=COMMIT   compare bytes, loading and frame time with another commit"
	@echo "make library  libcurtain, its pkg-config file, and the libretro core: docs/internals/library.md"
	@echo "make web GAME=DIR   the game as one HTML file, for browsers and phones: build/web/NAME.html"
	@echo "make players  the programs that exports are copies of, for Linux, Windows, RetroArch, the web: build/players"
	@echo "make windows  the program for Windows, cross-compiled: build/windows/curtain.exe"
	@echo "make install PREFIX=/usr/local DESTDIR=   with manual page, menu entry, games     make uninstall"

deps:
	@tools/deps.sh
deps-%:
	@tools/deps.sh $(subst -, ,$*)
say-%:
	@tools/deps.sh --say $(subst -, ,$*)

null: say-null
	@$(MAKE) --no-print-directory build/curtain-null

build/curtain: $(OUT)/curtain
	@cp $< $@
build/curtain-player: $(OUT)/curtain-player
	@cp $< $@
build/curtain-null: $(OUT)/curtain-null
	@cp $< $@

# The manual pages: one, and another name for it.
build/curtain.1: $(OUT)/curtain-bare tools/manpage.sh
	$(SAY) "  MAKE  $@"
	$(Q)tools/manpage.sh "$(RUN) $<" > $@
build/curtain-null.1:
	@mkdir -p $(@D)
	@echo '.so man1/curtain.1' > $@

# ---- programs ----

$(OUT)/%.o: %.c
	@mkdir -p $(@D)
	$(SAY) "  CC    $<"
	$(Q)$(CC) $(ALL_C) -MMD -MP -c $< -o $@

$(OUT)/src/player/command_help.o $(OUT)/lib/src/player/command_help.o: ALL_C += '-DCURTAIN_CFLAGS="$(SEMANTIC) $(OPT) $(HARDEN_C) $(CFLAGS)"'
$(OUT)/platform/sdl2.o: ALL_C += $(patsubst -I%,-isystem %,$(SDL_C))
# Clang's -O3 unrolls the loops of sound, which is slower than -O2; gcc is told so in the files, clang has no such words.
$(OUT)/src/sound/%.o: ALL_C += $(if $(findstring clang,$(CC)),$(patsubst -O3,-O2,$(filter -O3,$(OPT))))
# -Wpedantic has two exceptions: the 128-bit products of src/base/fx.h (__extension__), and the constants of quadmath.h.
QUAD_TESTS := $(OUT)/machine/test_fine $(OUT)/machine/test_lead
$(QUAD_TESTS): ALL_C += -Wno-pedantic
$(QUAD_TESTS): LIBS += -lquadmath

$(OUT)/embed: tools/embed.c
	@mkdir -p $(@D)
	$(SAY) "  LINK  $@"
	$(Q)$(BUILD_CC) $(SEMANTIC) -O1 -D_DEFAULT_SOURCE $< -o $@

# Written when a file has come or gone.
$(OUT)/start.is: FORCE
	@mkdir -p $(@D)
	@echo '$(TEMPLATES)' | cmp -s - $@ || echo '$(TEMPLATES)' > $@

$(OUT)/gen/std.c: $(STD_LUA) $(TEMPLATES) $(EXAMPLES) $(foreach f,$(DESKTOP),$(lastword $(subst =, ,$f))) $(OUT)/start.is $(OUT)/embed
	@mkdir -p $(@D)
	$(SAY) "  MAKE  $@"
	$(Q)$(OUT)/embed std $(foreach f,$(STD_LUA),$(patsubst scripts/%.lua,%,$f)=$f) -- \
		$(foreach f,$(TEMPLATES),$(f:examples/%=%)=$f) -- $(foreach f,$(EXAMPLES),$(patsubst share/help/%.md,%,$f)=$f) -- $(DESKTOP) > $@

$(OUT)/gen/no_rom.c: $(OUT)/embed
	@mkdir -p $(@D)
	$(SAY) "  MAKE  $@"
	$(Q)$(OUT)/embed rom > $@

$(OUT)/gen/%.o: $(OUT)/gen/%.c
	$(SAY) "  CC    $<"
	$(Q)$(CC) $(ALL_C) -c $< -o $@

# Lua's sources are fetched once.
$(LUA_SRC)/lua.h:
	$(Q)tools/source.sh lua5.4 bookworm build/cross/lua-bookworm
build/cross/include/lua5.4-deb-multiarch.h:
	@mkdir -p $(@D)
	@ln -sfn /usr/include/stb $(@D)/stb
	@echo '#define DEB_HOST_MULTIARCH "none"' > $@
$(OUT)/lua/%.o: $(LUA_H)
	@mkdir -p $(@D)
	$(SAY) "  CC    $*.c"
	$(Q)$(CC) -std=gnu99 -O2 -DLUA_COMPAT_5_3 $(if $(findstring mingw,$(CC)),,-fPIC) -fvisibility=hidden $(LUA_C) $(CFLAGS) \
		-c $(LUA_SRC)/$*.c -o $@

# The program that packs the built-in game has none itself.
$(OUT)/curtain-bare: $(CORE_OBJ) $(OUT)/src/workbench/main.o $(OUT)/platform/null.o $(OUT)/gen/no_rom.o
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $^ $(LIBS) -o $@

# Names the game and its files; changes when they do, so that the ROM is packed again.
GAME_IS := $(GAME): $(sort $(GAME_SRC))
$(OUT)/game.is: FORCE
	@mkdir -p $(@D)
	@echo '$(GAME_IS)' | cmp -s - $@ || echo '$(GAME_IS)' > $@
FORCE:

# A program of this machine that packs it can be named, when another's is built.
BARE ?= $(OUT)/curtain-bare
$(OUT)/game.rom: $(BARE) $(OUT)/game.is $(GAME_SRC)
	$(SAY) "  MAKE  $@"
	$(Q)$(RUN) $(BARE) pack $(GAME) --plain -o $@ >/dev/null

$(OUT)/gen/rom.c: $(OUT)/game.rom $(OUT)/embed
	@mkdir -p $(@D)
	$(SAY) "  MAKE  $@"
	$(Q)$(OUT)/embed rom $(OUT)/game.rom > $@

$(OUT)/curtain: $(CORE_OBJ) $(OUT)/src/workbench/main.o $(OUT)/platform/sdl2.o $(OUT)/gen/rom.o
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $^ $(LIBS) -o $@

# The same without a game: exports with the developer keys are copies of it.
$(OUT)/curtain-empty: $(CORE_OBJ) $(OUT)/src/workbench/main.o $(OUT)/platform/sdl2.o $(OUT)/gen/no_rom.o | $(filter %.o,$(LUA_L))
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $^ $(LIBS) -o $@

# The player without a game, the workbench and the API's help: exports are copies of it.
PLAYER_OBJ := $(patsubst %.c,$(OUT)/lib/%.o,$(BOARD_SRC) $(wildcard src/common/*.c src/demo/*.c src/player/*.c src/player/*/*.c))
$(OUT)/curtain-player: $(PLAYER_OBJ) $(HOST_OBJ) $(OUT)/platform/sdl2.o $(OUT)/gen/no_rom.o | $(filter %.o,$(LUA_L))
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $(LINK_MAP) -Wl,--gc-sections $^ $(LIBS) -o $@

$(OUT)/curtain-null: $(CORE_OBJ) $(OUT)/src/workbench/main.o $(OUT)/platform/null.o $(OUT)/gen/rom.o
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $(LINK_MAP) $^ $(LIBS) -o $@

# ---- Windows: docs/internals/porting.md ----

WIN       := build/windows
WIN_CC    ?= x86_64-w64-mingw32-gcc
WIN_RES   ?= x86_64-w64-mingw32-windres
# SDL's own list, of libraries that every Windows has. The stack is as large as Linux's.
WIN_LIBS  := -lSDL2 -ldinput8 -ldxguid -lsetupapi -lwinmm -limm32 -lole32 -loleaut32 -lversion -luuid -luser32 -lgdi32 \
             -lshell32 -ladvapi32 -lm -lpthread
# MinGW's isnan looks like a conversion to gcc, and %zu like an error: formats are checked by the other builds.
WIN_WARN  := -Wno-float-conversion -Wno-format -Wno-format-extra-args
WIN_LINK  := -municode -static -s -Wl,--stack,8388608
# PE has no weak symbols that can be relied upon: of the defaults, those stay out that the port defines.
OWN        = $(addprefix -DPLAT_OWN_,$(shell grep -oP '^[a-z].*\bplat_\K[a-z_]+(?=\x28.*[^;]$$)' $1 | tr a-z A-Z))

# The tools, libraries and games are this machine's; the same objects are made by the rules above.
windows: say-windows $(LUA_H)
	@$(MAKE) --no-print-directory $(OUT)/curtain-bare
	@tools/windows/libraries.sh
	@$(MAKE) --no-print-directory CONFIG=windows CC="$(WIN_CC)" BUILD_CC="$(CC)" BARE=$(OUT)/curtain-bare \
		CFLAGS="$(strip -D__USE_MINGW_ANSI_STDIO=1 $(CFLAGS))" WARN="$(WARN) $(WIN_WARN)" HARDEN_L= THREADS= LUA_INSIDE=1 \
		SDL_C="-I$(WIN)/lib/sdl2/include/SDL2 -DSDL_LINKED" $(WIN)/curtain.exe $(WIN)/curtain-null.exe $(WIN)/curtain-empty.exe \
		$(WIN)/curtain-player.exe

$(WIN)/curtain.ico: tools/windows/icon.py $(wildcard share/icons/*.png)
	$(SAY) "  MAKE  $@"
	$(Q)tools/windows/icon.py $@ $(wildcard share/icons/*.png)
$(WIN)/resource.o: tools/windows/curtain.rc tools/windows/curtain.manifest $(WIN)/curtain.ico src/player/game/version.h
	$(SAY) "  MAKE  $@"
	$(Q)$(WIN_RES) -I. -I$(WIN) -DVERSION='\"$(VERSION)\"' -DNUMBERS=$(subst .,$(comma),$(VERSION)),0 $< $@
$(WIN)/platform/sdl2/%.o: platform/%.c
	@mkdir -p $(@D)
	$(SAY) "  CC    $<"
	$(Q)$(CC) $(ALL_C) $(call OWN,platform/sdl2.c) -MMD -MP -c $< -o $@
$(WIN)/curtain.exe: $(WIN)/gen/rom.o
$(WIN)/curtain-empty.exe $(WIN)/curtain-player.exe: $(WIN)/gen/no_rom.o
$(WIN)/curtain.exe $(WIN)/curtain-empty.exe: $(BOARD_OBJ) $(PROGRAM_OBJ) $(WIN)/src/workbench/main.o
$(WIN)/curtain-player.exe: $(PLAYER_OBJ)
$(WIN)/curtain.exe $(WIN)/curtain-empty.exe $(WIN)/curtain-player.exe: $(WIN)/platform/sdl2.o $(WIN)/resource.o $(LUA_OBJ) \
		$(patsubst %,$(WIN)/platform/sdl2/%.o,stdio $(HOST))
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $(WIN_LINK) -Wl,--gc-sections $^ -L$(WIN)/lib/sdl2/lib $(WIN_LIBS) -o $@
$(WIN)/curtain-null.exe: $(CORE_OBJ) $(WIN)/src/workbench/main.o $(WIN)/platform/null.o $(WIN)/gen/rom.o $(LUA_OBJ)
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $(WIN_LINK) $^ -lole32 -luuid -lm -lpthread -o $@

# ---- players: the programs without a game that exports are copies of; docs/internals/porting.md ----

# Without unwind tables: old linkers report those of libcurtain.a as an error.
LINUX_C := -g0 -fno-asynchronous-unwind-tables
LINUX   := build/linux
PLAYERS := build/players

players: say-play-web-windows-players $(LUA_H)
	@$(MAKE) --no-print-directory $(WEB)/player.html
	@$(MAKE) --no-print-directory windows
	@tools/old_glibc.sh make --no-print-directory -j2 CONFIG=linux CFLAGS="$(LINUX_C)" LUA_INSIDE=1 SDL_C="$(SDL_C)" V=$(V) \
		$(LINUX)/curtain-player $(LINUX)/curtain-empty $(LINUX)/curtain_libretro.so
	@mkdir -p $(PLAYERS)
	@cp $(WEB)/player.html $(LINUX)/curtain_libretro.so $(PLAYERS)
	@cp $(LINUX)/curtain-player $(PLAYERS)/curtain-player-linux
	@cp $(LINUX)/curtain-empty $(PLAYERS)/curtain-linux
	@cp $(WIN)/curtain-player.exe $(PLAYERS)
	@cp $(WIN)/curtain-empty.exe $(PLAYERS)/curtain.exe
	@ls -l $(PLAYERS)

# ---- libcurtain: the board as calls, with no name of its own but those of curtain.h ----

WEB     := build/web
LIB_OBJ := $(patsubst %.c,$(OUT)/lib/%.o,$(BOARD_SRC) $(patsubst %,src/demo/%.c,demo demo_read demo_put demo_record demo_write rewind) $(wildcard src/lib/*.c) src/common/array.c) $(OUT)/lib/gen/std.o
LIB_C   := -DWITHOUT_HELP $(if $(findstring mingw,$(CC)),,-fPIC) -fvisibility=hidden -ffunction-sections -fdata-sections

$(OUT)/lib/gen/std.o: $(OUT)/gen/std.c
	@mkdir -p $(@D)
	$(SAY) "  CC    $< (library)"
	$(Q)$(CC) $(ALL_C) $(LIB_C) -c $< -o $@
$(OUT)/lib/%.o: %.c
	@mkdir -p $(@D)
	$(SAY) "  CC    $< (library)"
	$(Q)$(CC) $(ALL_C) $(LIB_C) -MMD -MP -c $< -o $@

$(OUT)/libcurtain.so: $(LIB_OBJ)
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $(LIB_C) -shared -Wl,-soname,libcurtain.so.1 -Wl,--gc-sections -Wl,-z,defs $^ \
		$(filter-out -pie,$(HARDEN_L)) $(LUA_L) -lm -o $@
	$(Q)ln -sf $(@F) $@.1
$(OUT)/libcurtain.a: $(LIB_OBJ)
	$(SAY) "  LINK  $@"
	$(Q)$(CC) -r -nostdlib -Wl,--gc-sections $(patsubst %,-Wl$(comma)-u$(comma)%,$(LIB_NAMES)) $^ -o $(OUT)/lib/curtain.o
	$(Q)$(OBJCOPY) --localize-hidden $(OUT)/lib/curtain.o
	$(Q)rm -f $@ && $(AR) rcs $@ $(OUT)/lib/curtain.o

# Each port's test: build and play it where it is at home. ARGS="libretro web": these, of the others what they said last.
ports: deps-play-test-ports-web-firefox-windows-players
	@$(MAKE) --no-print-directory -j2 $(OUT)/curtain $(OUT)/curtain-null $(OUT)/curtain-bare $(OUT)/libcurtain.a \
		$(OUT)/libcurtain.so $(OUT)/need $(OUT)/libspeed build/curtain build/curtain-null
	@$(MAKE) --no-print-directory players
	@OUT=$(OUT) tools/ports/ports.sh $(ARGS)

library: say-null
	@$(MAKE) --no-print-directory build/libcurtain.a build/libcurtain.so build/curtain.pc build/curtain_libretro.so build/players/curtain_libretro.so
build/libcurtain.a build/libcurtain.so build/curtain_libretro.so: build/%: $(OUT)/%
	@cp $< $@
VERSION = $(shell sed -n 's/^.define CURTAIN_VERSION "\(.*\)"/\1/p' src/player/game/version.h)
build/curtain.pc: share/curtain.pc.in src/player/game/version.h
	@sed 's,@PREFIX@,$(PREFIX),; s,@VERSION@,$(VERSION),' $< > $@

RETRO_OBJ := $(patsubst %,$(OUT)/lib/%.o,platform/libretro/core platform/libretro/inside src/player/game/mark)
$(OUT)/curtain_libretro.so: $(RETRO_OBJ) $(OUT)/libcurtain.a | $(filter %.o,$(LUA_L))
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $(LIB_C) -shared -Wl,-z,defs -Wl,--exclude-libs,ALL $^ \
		$(filter-out -pie,$(HARDEN_L)) $(LUA_L) -lm -ldl -o $@

# ---- the web port: libcurtain and Lua for WebAssembly, and pages with games inside; docs/internals/porting.md ----

# Lua has tools/cross/wasi in place of setjmp.
WEB_CC    ?= clang
WEB_OPT   ?= -Oz -msimd128
WEB_C      = --target=wasm32-wasi $(WEB_OPT) -DWITHOUT_HELP -ffunction-sections \
             -fdata-sections -I$(LUA_SRC) -Ibuild/cross/include -Itools/cross/wasi
WEB_LUA   := $(LUA_OBJ:$(OUT)/%=$(WEB)/%)
WEB_OBJ   := $(patsubst $(OUT)/lib/%,$(WEB)/obj/%,$(LIB_OBJ)) \
             $(WEB)/obj/platform/web/web.o $(WEB)/obj/platform/web/no_host.o
WEB_PAGE  := $(patsubst %,platform/web/%,page.html player.css player.js worklet.js build.sh)

$(WEB)/lua/%.o: $(LUA_H)
	@mkdir -p $(@D)
	$(SAY) "  CC    $*.c (web)"
	$(Q)$(WEB_CC) -std=gnu99 $(WEB_C) -DLUA_COMPAT_5_3 -include tools/cross/wasi/lua_try.h -c $(LUA_SRC)/$*.c -o $@
$(WEB)/obj/gen/std.o: $(OUT)/gen/std.c $(LUA_H)
	@mkdir -p $(@D)
	$(SAY) "  CC    $< (web)"
	$(Q)$(WEB_CC) $(SEMANTIC) $(WEB_C) -c $< -o $@
$(WEB)/obj/%.o: %.c $(LUA_H)
	@mkdir -p $(@D)
	$(SAY) "  CC    $< (web)"
	$(Q)$(WEB_CC) $(SEMANTIC) $(WARN) $(WEB_C) -D_DEFAULT_SOURCE -MMD -MP -c $< -o $@
# Linked without -O: with it clang runs whatever wasm-opt it finds, which need not know SIMD.
$(WEB)/core.wasm: $(WEB_OBJ) $(WEB_LUA)
	$(SAY) "  LINK  $@"
	$(Q)$(WEB_CC) $(filter-out -O%,$(WEB_C)) -mexec-model=reactor -Wl,--gc-sections -Wl,--strip-all -Wl,--compress-relocations \
		-Wl,--export=__stack_pointer -Wl,--export-table -Wl,--stack-first -Wl,-z,stack-size=2097152 $^ -lm -o $@
$(WEB)/player.html: $(WEB)/core.wasm $(WEB_PAGE) $(OUT)/curtain-bare
	$(SAY) "  MAKE  $@"
	$(Q)OUT=$(OUT) platform/web/build.sh $(WEB)/core.wasm $@

# Players are in one folder, where the programs of build/ look for them, and by a link those of build/NAME.
build/players/player.html: $(WEB)/player.html
build/players/curtain_libretro.so: $(OUT)/curtain_libretro.so
build/players/%:
	@mkdir -p $(@D)
	@ln -sfn ../players $(OUT)/players
	@cp $^ $@

# One file with a game inside: make web GAME=DIR.
web: say-null-web
	@$(MAKE) --no-print-directory $(OUT)/curtain-bare build/players/player.html
	@$(OUT)/curtain-bare export $(GAME) --web -o $(WEB)/$(basename $(notdir $(patsubst %/,%,$(GAME)))).html
	@ls -l $(WEB)/$(basename $(notdir $(patsubst %/,%,$(GAME)))).html

# The limit of work lowered, so that a test of an endless loop ends soon; and the largest board's RAM.
SHORT := script/vm script/vm_fault script/vm_count board/board script/api/eval
$(OUT)/short/%.o: src/%.c
	@mkdir -p $(@D)
	$(SAY) "  CC    $< (short)"
	$(Q)$(CC) $(ALL_C) -DWORK_LIMIT=50000000 -DMAX_RAM="(64ull << 20)" -MMD -MP -c $< -o $@

$(OUT)/curtain-short: $(filter-out $(SHORT:%=$(OUT)/src/%.o),$(CORE_OBJ)) $(SHORT:%=$(OUT)/short/%.o) \
		$(OUT)/src/workbench/main.o $(OUT)/platform/null.o $(OUT)/gen/no_rom.o
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $^ $(LIBS) -o $@

play: deps-play
	@$(MAKE) --no-print-directory build/curtain
	@tools/play.sh

# PREFIX=/usr, DESTDIR=/where/a/package/is/made.
install: all
	@DESTDIR="$(DESTDIR)" PREFIX="$(PREFIX)" tools/install.sh install
uninstall:
	@DESTDIR="$(DESTDIR)" PREFIX="$(PREFIX)" tools/install.sh uninstall

# ---- art: the pictures of the games in roms/ are made by a program ----

$(OUT)/art: $(wildcard tools/art/*.c)
	@mkdir -p $(@D)
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(SEMANTIC) -O2 -Wno-unused-function $^ -lm -o $@

# ---- tests ----

$(OUT)/unit/%: tests/unit/%.c $(CORE_OBJ) $(OUT)/platform/null.o $(OUT)/gen/no_rom.o
	@mkdir -p $(@D)
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) -Itests $^ $(LIBS) -lcmocka -o $@

# Of these, some are ports themselves.
OWN_PORT := test_random_play test_calls
$(OUT)/machine/%: tests/machine/%.c $(CORE_OBJ) $(OUT)/platform/null.o $(OUT)/gen/no_rom.o
	@mkdir -p $(@D)
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) -Itests $(filter-out $(if $(filter $*,$(OWN_PORT)),%/null.o),$^) $(LIBS) -lcmocka -o $@

$(OUT)/unit/test_pace: $(OUT)/tools/pacing/simulate.o
$(OUT)/machine/test_worst: $(patsubst %,$(OUT)/tools/bench/%.o,scene worst dearest)
$(OUT)/machine/test_answers: $(OUT)/tools/bulletml/board.o
$(OUT)/machine/test_bench: $(patsubst %,$(OUT)/tools/bench/%.o,scene crowd reference array columns)

# A fuzz target that takes what it is given from files, and no more: for valgrind.
$(OUT)/given/%: tests/fuzz/%.c tests/fuzz/given.c $(CORE_OBJ) $(OUT)/platform/null.o $(OUT)/gen/no_rom.o
	@mkdir -p $(@D)
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) -Itests $^ $(LIBS) -lcmocka -o $@

# tests/fuzz/run.sh makes these with clang and its flags.
$(OUT)/fuzz/%: tests/fuzz/%.c $(CORE_OBJ) $(OUT)/platform/null.o $(OUT)/gen/no_rom.o
	@mkdir -p $(@D)
	$(CC) $(ALL_C) -fsanitize=fuzzer $^ $(LIBS) -lcmocka -o $@

programs: $(OUT)/lab $(OUT)/ear $(OUT)/bench $(OUT)/pacing $(OUT)/cookbook $(OUT)/curtain $(OUT)/curtain-player $(OUT)/curtain-null \
          $(OUT)/curtain-short $(OUT)/libcurtain.a $(OUT)/libcurtain.so $(OUT)/curtain_libretro.so \
          $(UNIT) $(MACHINE)

ifeq ($(UNAME),Darwin)
test: deps-play-test
	-@$(MAKE) --no-print-directory -k $(OUT)/curtain-null $(UNIT) $(filter-out $(QUAD_TESTS),$(MACHINE))
	@OUT=$(OUT) tests/macos/run.sh
else
test: deps-play-test-ports-web
	@$(MAKE) --no-print-directory -j2 build/curtain build/curtain-null programs tools build/players/player.html \
		build/players/curtain_libretro.so
	@OUT=$(OUT) tests/run.sh
endif

torture: deps-play-test
	@$(MAKE) --no-print-directory -j2 programs
	@OUT=$(OUT) tests/run.sh torture

golden: deps-play
	@$(MAKE) --no-print-directory build/curtain-null
	@tests/golden/run.sh --update

asan: deps-play-test
	@$(MAKE) --no-print-directory -j2 CONFIG=asan OPT="-O1 -fsanitize=address -fno-omit-frame-pointer" programs
	@OUT=build/asan tests/run.sh sanitizer

# Without -fwrapv, so that an overflow is a finding.
UBSAN := CONFIG=ubsan SEMANTIC="-std=c11 -ffp-contract=off" \
	OPT="-O1 -fsanitize=undefined,float-cast-overflow -fno-sanitize-recover=undefined,float-cast-overflow"
ubsan: deps-play-test
	@$(MAKE) --no-print-directory -j2 $(UBSAN) programs
	@OUT=build/ubsan tests/run.sh sanitizer
# Every function reports when it is entered; not position-independent, so that addr2line knows the addresses.
WALKS := CONFIG=walks OPT="-O0 -finstrument-functions" CFLAGS="-fno-pie -no-pie"
walks: deps-play-test
	@$(MAKE) --no-print-directory -j2 $(WALKS) build/walks/walks
	@python3 tests/walks/walks.py build/walks/walks docs/internals/design.md
$(OUT)/walks: tests/walks/walks.c $(CORE_OBJ) $(OUT)/platform/null.o $(OUT)/gen/no_rom.o
	@mkdir -p $(@D)
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) -fno-instrument-functions -Wno-frame-address -Itests $^ $(LIBS) -lcmocka -o $@

# A monkey in the window's screens, in several games, for thousands of frames, under both sanitizers.
monkey: deps-play-test
	@$(MAKE) --no-print-directory -j2 CONFIG=monkey SEMANTIC="-std=c11 -ffp-contract=off" \
		OPT="-O1 -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all" build/monkey/machine/test_random_play
	@CURTAIN_LONG=1 ASAN_OPTIONS=abort_on_error=1 LSAN_OPTIONS=suppressions=$(CURDIR)/tests/lsan.supp \
		UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1 build/monkey/machine/test_random_play

# MemorySanitizer sees our code alone: what goes through Lua is looked at by valgrind.
MSAN := CONFIG=msan CC=clang OPT="-O1 -fsanitize=memory -fsanitize-memory-track-origins -fno-omit-frame-pointer"
MSAN_GIVEN := $(patsubst %,build/msan/given/fuzz_%,args bdf bisect card config demo game lang nvram png records rom sound symbols)
MSAN_UNIT  := $(patsubst %,build/msan/unit/test_%,keys png records rom stdio)
msan: given
	@OUT=$(OUT) tests/machine/uninitialised.sh whole lua
valgrind: given
	@OUT=$(OUT) tests/machine/uninitialised.sh lua
given: deps-play-test-nightly
	@$(MAKE) --no-print-directory -j2 $(OUT)/curtain-null $(patsubst %,$(OUT)/given/fuzz_%,manifest board recording) \
		$(patsubst %,$(OUT)/unit/test_%,cli demo manifest pack script)
msan-short:
	@$(MAKE) --no-print-directory -j2 $(MSAN) $(MSAN_GIVEN) $(MSAN_UNIT)

fuzz: deps-play-fuzz
	@tests/fuzz/run.sh

mutants: deps-play-test
	@tests/mutants.sh

analyze: deps-play-nightly
	@tools/analyze.sh $(ARGS)

# All that takes long, one after another. FUZZ_SECONDS=600 a fuzz target; ARGS="asan fuzz" runs these only.
nightly: deps-play-test-fuzz-nightly
	@tests/nightly.sh $(ARGS)

$(OUT)/cookbook: tools/cookbook/cookbook.c $(CORE_OBJ) $(OUT)/platform/null.o $(OUT)/gen/no_rom.o
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $^ $(LIBS) -o $@

BOT_OBJ := $(patsubst %.c,$(OUT)/%.o,$(wildcard tools/bot/*.c))

$(OUT)/bot: $(BOT_OBJ) $(CORE_OBJ) $(OUT)/platform/null.o $(OUT)/gen/no_rom.o
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $^ $(LIBS) -o $@

# Both the program's board and the library's: one hides its names.
$(OUT)/libspeed: tools/ports/speed.c $(CORE_OBJ) $(OUT)/platform/null.o $(OUT)/gen/no_rom.o $(OUT)/libcurtain.a
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $^ $(LIBS) -o $@

$(OUT)/need: tools/ports/need.c $(CORE_OBJ) $(OUT)/platform/null.o $(OUT)/gen/no_rom.o
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $^ $(LIBS) -o $@

$(OUT)/lively: $(OUT)/%: tools/%.c $(CORE_OBJ) $(OUT)/platform/null.o $(OUT)/gen/no_rom.o
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $^ $(LIBS) -o $@

# Against libfixmath. The script builds the program, for it links several builds of that library.
BENCH_FX := $(filter-out %/trig.o,$(CORE_OBJ)) $(OUT)/platform/null.o $(OUT)/gen/no_rom.o \
            $(patsubst %,$(OUT)/tools/bench_fx/%.o,bench_fx bench_fx_inputs)
bench-fx: deps-play-bench
	@$(MAKE) --no-print-directory bench-fx-objects
	@OUT="$(OUT)" CC="$(CC)" FLAGS="$(SEMANTIC) $(OPT) $(CFLAGS)" LIBS="$(LIBS)" tools/bench_fx/bench_fx.sh $(BENCH_FX)
bench-fx-objects: $(BENCH_FX)
	@:
$(OUT)/bench_fx_build/bench_fx: $(BENCH_FX) $(wildcard tools/bench_fx/*)
	$(SAY) "  LINK  $@"
	$(Q)OUT="$(OUT)" CC="$(CC)" FLAGS="$(SEMANTIC) $(OPT) $(CFLAGS)" LIBS="$(LIBS)" \
		tools/bench_fx/bench_fx.sh --build $(BENCH_FX)

# The demos are recorded by a program that plays; needed when scripts or the core change.
demos: deps-play
	@$(MAKE) --no-print-directory $(OUT)/bot
	@OUT=$(OUT) tools/demos.sh

# The page of the cookbook, with its pictures, and what its test compares.
cookbook: deps-play
	@$(MAKE) --no-print-directory $(OUT)/cookbook
	@OUT=$(OUT) tools/cookbook/cookbook.sh

# The patterns of Glass Tide with their pictures, docs/measured/patterns.md; of the demos that make demos records.
patterns: deps-play
	@$(MAKE) --no-print-directory build/curtain-null $(OUT)/lively
	@OUT=$(OUT) python3 tools/patterns.py

# README and docs/ as one file; make install takes it along, if it was made.
docs: deps-docs
	@tools/docs/docs.sh -o build/curtain.html

# What can be survived, of Glass Tide and the cookbook, and how hard it is; docs/measured/survive.md, docs/measured/game.md.
survive: deps-play
	@$(MAKE) --no-print-directory build/curtain-null
	@tools/survive.sh

# ---- pages of measurements: text, tables, plots ----

REPORT_OBJ := $(patsubst %.c,$(OUT)/%.o,$(wildcard tools/report/*.c))
$(OUT)/tools/report/report.o: ALL_C += '-DREPORT_FLAGS="$(SEMANTIC) $(OPT) $(CFLAGS)"'

# ---- the lab: what each choice costs, measured; docs/measured/accuracy.md ----

LAB_SRC := $(wildcard tools/lab/*.c)
LAB_OBJ := $(LAB_SRC:%.c=$(OUT)/%.o)
LAB_L   := -llibfixmath

$(OUT)/lab: $(LAB_OBJ) $(REPORT_OBJ) $(CORE_OBJ) $(OUT)/platform/null.o $(OUT)/gen/no_rom.o
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $^ $(LIBS) $(LAB_L) -o $@

accuracy: deps-play-test
	@$(MAKE) --no-print-directory -j2 $(OUT)/lab
	@$(OUT)/lab

# ---- the ear: how good sound is, measured; docs/measured/sound.md ----

EAR_OBJ := $(patsubst %.c,$(OUT)/%.o,$(wildcard tools/sound/*.c))

$(OUT)/ear: $(EAR_OBJ) $(REPORT_OBJ) $(CORE_OBJ) $(OUT)/platform/null.o $(OUT)/gen/no_rom.o
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $^ $(LIBS) -o $@

sound: deps-play
	@$(MAKE) --no-print-directory -j2 $(OUT)/ear
	@$(OUT)/ear

# ---- pacing: frames, screens, and the way from a switch to the picture; docs/measured/pacing.md. It has a port of its own ----

PACING_OBJ := $(patsubst %.c,$(OUT)/%.o,$(wildcard tools/pacing/*.c))

$(OUT)/pacing: $(PACING_OBJ) $(REPORT_OBJ) $(CORE_OBJ) $(OUT)/gen/no_rom.o
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $^ $(LIBS) -o $@

pacing: deps-play
	@$(MAKE) --no-print-directory -j2 $(OUT)/pacing
	@$(OUT)/pacing

# ---- the bench: what a frame costs; docs/measured/speed.md. ARGS="crowd battle" prints these sections only ----

BENCH_OBJ := $(patsubst %.c,$(OUT)/%.o,$(wildcard tools/bench/*.c))

$(OUT)/bench: $(BENCH_OBJ) $(REPORT_OBJ) $(CORE_OBJ) $(OUT)/platform/null.o $(OUT)/gen/no_rom.o
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $^ $(LIBS) -o $@

bench: deps-play
	@$(MAKE) --no-print-directory -j2 $(OUT)/bench
	@$(OUT)/bench $(ARGS)

# What a game costs beside another commit's engine: BASE=COMMIT, or a folder; GAME=, START= as in compare.sh.
# Functions start at cache lines: moved by 16 bytes, a drawing loop of the same instructions can take 1.1 times as long.
compare: export OPT += -falign-functions=64
compare: deps-null
	@OUT=build/aligned CC="$(CC)" FLAGS="$(ALL_C)" LIBS="$(LIBS)" TABLE="$(TABLE)" \
		tools/compare/compare.sh "$(BASE)" "$(GAME)" "$(if $(filter undefined,$(origin START)),one,$(START))"

# ---- BulletML beside libbulletml, which is linked here and nowhere else; docs/measured/bulletml.md ----

CXX       ?= c++
BULLETML_OBJ := $(patsubst %.c,$(OUT)/%.o,$(wildcard tools/bulletml/*.c)) $(OUT)/tools/bulletml/reference.o \
                $(OUT)/tools/bench/measure.o

$(OUT)/tools/bulletml/reference.o: tools/bulletml/reference.cpp tools/bulletml/reference.h
	@mkdir -p $(@D)
	$(SAY) "  CXX   $<"
	$(Q)$(CXX) -std=c++11 -O2 -g -ffp-contract=off -Wall -Wextra -Wno-deprecated-declarations \
		-isystem /usr/include/bulletml -c $< -o $@

$(OUT)/bulletml: $(BULLETML_OBJ) $(REPORT_OBJ) $(CORE_OBJ) $(OUT)/platform/null.o $(OUT)/gen/no_rom.o
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $^ $(LIBS) -lbulletml -lstdc++ -o $@

bulletml: deps-play-bulletml
	@$(MAKE) --no-print-directory -j2 $(OUT)/bulletml
	@$(OUT)/bulletml $(ARGS)

# ---- the proofs: every function of base is the correctly rounded one ----

PROVE := roots sines polar directions products
$(PROVE:%=$(OUT)/prove/%): $(OUT)/prove/%: $(OUT)/tools/prove/%.o $(OUT)/tools/prove/prove.o \
		$(OUT)/tools/prove/oracle.o $(OUT)/src/base/trig.o
	@mkdir -p $(@D)
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $^ -lmpfr -lgmp -lm $(THREADS) -o $@

$(OUT)/prove/digest: $(OUT)/tools/prove/digest.o $(OUT)/src/base/trig.o
	@mkdir -p $(@D)
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $^ -lm -o $@

$(OUT)/prove/shapes: $(OUT)/tools/prove/shapes.o $(OUT)/src/base/geom.o
	@mkdir -p $(@D)
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $^ -lm $(THREADS) -o $@

# The programs behind other goals that no test runs: make test builds them, so that these goals work.
tools: $(OUT)/bot $(OUT)/lively $(OUT)/need $(OUT)/libspeed $(OUT)/bench_fx_build/bench_fx \
       $(PROVE:%=$(OUT)/prove/%) $(OUT)/prove/digest $(OUT)/prove/shapes

# With CONFIG=twins CFLAGS=-DFX_INTEGER: the same of the integer twins.
prove: deps-test
	@$(MAKE) --no-print-directory -j2 $(PROVE:%=$(OUT)/prove/%) $(OUT)/prove/digest $(OUT)/prove/shapes
	@OUT=$(OUT) tools/prove/run.sh $(PROVE)

# ---- other machines; docs/internals/determinism.md. ARGS="s390x armhf" tries these builds only ----

cross: deps-play-cross
	@tools/cross/run.sh $(ARGS)

format:
	clang-format -i $$(git ls-files '*.c' '*.h')

clean:
	rm -rf build

-include $(shell find $(OUT) $(WEB)/obj -name '*.d' 2>/dev/null)

endif
