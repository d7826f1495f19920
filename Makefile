# Curtain. `make help` lists the goals. tests/tests.mk and tools/tools.mk have the rules that nobody needs who builds and
# plays. A configuration has a build folder of its own: build/NAME.

# Several goals run one after another: most start a make of their own, and two would make the same objects at once.
ifeq ($(MAKELEVEL)$(if $(word 2,$(MAKECMDGOALS)),several),0several)
.NOTPARALLEL:
endif
MAKEFLAGS += --no-print-directory
# For a make in a recipe: as many jobs as there are processors, unless -j was given.
JOBS = $(if $(filter -j%,$(MAKEFLAGS)),,-j$(shell getconf _NPROCESSORS_ONLN))

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
VERSION  = $(shell sed -n 's/^.define CURTAIN_VERSION "\(.*\)"/\1/p' src/player/game/version.h)

# -fwrapv and -ffp-contract=off are semantics: results may not depend on overflow rules or fused multiplications.
SEMANTIC := -std=c11 -fwrapv -ffp-contract=off
WARN     := -Wall -Wextra -Wshadow -Wconversion -Wpedantic
PKG_CONFIG := pkg-config
LINK_MAP  = -Wl,-Map=$@.map
ifeq ($(UNAME),Darwin)
include tools/macos/macos.mk
endif
LUA_C    := $(shell $(PKG_CONFIG) --cflags lua5.4 2>/dev/null)
LUA_L    := $(shell $(PKG_CONFIG) --libs lua5.4 2>/dev/null)
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
PLAYER_OBJ := $(patsubst %.c,$(OUT)/lib/%.o,$(BOARD_SRC) $(wildcard src/common/*.c src/demo/*.c src/player/*.c src/player/*/*.c))
GAME_SRC  := $(shell find $(GAME) -type f ! -path '$(GAME)/source/*' 2>/dev/null)

# V=1 shows the commands.
Q := $(if $(V),,@)
SAY = $(if $(V),@true,@echo)

define compile
@mkdir -p $(@D)
$(SAY) "  CC    $<"
$(Q)$(CC) $(ALL_C) $(1) -MMD -MP -c $< -o $@
endef
define link
@mkdir -p $(@D)
$(SAY) "  LINK  $@"
$(Q)$(CC) $(ALL_C) $(1) $(filter-out %.h $(2),$^) $(LIBS) -o $@
endef

define make
@mkdir -p $(@D)
$(SAY) "  MAKE  $@"
endef

.SECONDARY:
.DELETE_ON_ERROR:
.PHONY: FORCE all null help deps play install uninstall check test test-all format clean programs

include tests/tests.mk tools/tools.mk
.DEFAULT_GOAL := all

# These build and install nothing: what is missing they say. play, test and deps get it.
all: say-play
	@$(MAKE) build/curtain build/curtain-player build/curtain-null build/curtain.1 build/curtain-null.1
null: say-null
	@$(MAKE) build/curtain-null
build/curtain build/curtain-player build/curtain-null: build/%: $(OUT)/%
	@cp $< $@

help:
	@cat tools/help.txt

deps:
	@tools/deps.sh
deps-%:
	@tools/deps.sh $(subst -, ,$*)
say-%:
	@tools/deps.sh --say $(subst -, ,$*)

play: deps-play
	@$(MAKE) $(JOBS) build/curtain
	@tools/play.sh

# PREFIX=/usr, DESTDIR=/where/a/package/is/made.
install: all
	@DESTDIR="$(DESTDIR)" PREFIX="$(PREFIX)" tools/install.sh install
uninstall:
	@DESTDIR="$(DESTDIR)" PREFIX="$(PREFIX)" tools/install.sh uninstall

# ONLY="lasers groups": the tests with one of these words in their names.
check: deps-test
	@$(MAKE) $(JOBS) checked
	@OUT=$(OUT) tests/run.sh check $(ONLY)
ifneq ($(UNAME),Darwin)
test: deps-play-test
	@$(MAKE) $(JOBS) $(if $(ONLY),named,build/curtain build/curtain-null programs)
	@OUT=$(OUT) tests/run.sh test $(ONLY)
endif
# Everything, in hours; resumes. ARGS="asan fuzz": these parts only.
test-all: deps-play-test-fuzz-web-ports-all
	@tests/all.sh $(ARGS)

format:
	clang-format -i $$(tests/files.sh '*.c' '*.h')
clean:
	rm -rf build

# ---- programs ----
$(OUT)/%.o: %.c
	$(compile)

$(OUT)/src/player/command_help.o $(OUT)/lib/src/player/command_help.o: ALL_C += '-DCURTAIN_CFLAGS="$(SEMANTIC) $(OPT) $(HARDEN_C) $(CFLAGS)"'
$(foreach d,args play replays screens settings,$(OUT)/lib/src/player/$(d)/%.o): ALL_C += $(OPT:-O2=-Os) # exports stay small
$(OUT)/platform/sdl2.o: ALL_C += $(patsubst -I%,-isystem %,$(SDL_C))
# Clang's -O3 unrolls the loops of sound, which is slower than -O2; gcc is told so in the files, clang has no such words.
$(OUT)/src/sound/%.o: ALL_C += $(if $(findstring clang,$(CC)),$(patsubst -O3,-O2,$(filter -O3,$(OPT))))

$(OUT)/embed: tools/embed.c
	@mkdir -p $(@D)
	$(SAY) "  LINK  $@"
	$(Q)$(BUILD_CC) $(SEMANTIC) -O1 -D_DEFAULT_SOURCE $< -o $@

# Lists of files; written when a file has come or gone.
start_IS := $(TEMPLATES)
game_IS  := $(GAME): $(sort $(GAME_SRC))
$(OUT)/start.is $(OUT)/game.is: $(OUT)/%.is: FORCE
	@mkdir -p $(@D)
	@echo '$($*_IS)' | cmp -s - $@ || echo '$($*_IS)' > $@
FORCE:

$(OUT)/gen/std.c: $(STD_LUA) $(TEMPLATES) $(EXAMPLES) $(foreach f,$(DESKTOP),$(lastword $(subst =, ,$f))) $(OUT)/start.is $(OUT)/embed
	$(make)
	$(Q)$(OUT)/embed std $(foreach f,$(STD_LUA),$(patsubst scripts/%.lua,%,$f)=$f) -- \
		$(foreach f,$(TEMPLATES),$(f:examples/%=%)=$f) -- $(foreach f,$(EXAMPLES),$(patsubst share/help/%.md,%,$f)=$f) -- $(DESKTOP) > $@

$(OUT)/gen/no_rom.c: $(OUT)/embed
	$(make)
	$(Q)$(OUT)/embed rom > $@

$(OUT)/gen/%.o: $(OUT)/gen/%.c
	$(compile)

# A program of this machine that packs it can be named, when another's is built.
BARE ?= $(OUT)/curtain-bare
$(OUT)/game.rom: $(BARE) $(OUT)/game.is $(GAME_SRC) $(GAME_FONT)
	$(make)
	$(Q)$(RUN) $(BARE) pack $(GAME) --plain -o $@ >/dev/null

$(OUT)/gen/rom.c: $(OUT)/game.rom $(OUT)/embed
	$(make)
	$(Q)$(OUT)/embed rom $(OUT)/game.rom > $@

# The program, with a window and without. bare packs the built-in game and has none itself; exports with the developer
# keys are copies of empty.
$(OUT)/curtain $(OUT)/curtain-empty: $(OUT)/platform/sdl2.o
$(OUT)/curtain-null $(OUT)/curtain-bare: $(OUT)/platform/null.o
$(OUT)/curtain $(OUT)/curtain-null: $(OUT)/gen/rom.o
$(OUT)/curtain-empty $(OUT)/curtain-bare: $(OUT)/gen/no_rom.o
$(patsubst %,$(OUT)/curtain%,-null -bare -empty) $(OUT)/curtain: $(CORE_OBJ) $(OUT)/src/workbench/main.o | $(filter %.o,$(LUA_L))
	$(call link,$(LINK_MAP))

# The player without a game, the workbench and the API's help: exports are copies of it.
$(OUT)/curtain-player: $(PLAYER_OBJ) $(HOST_OBJ) $(OUT)/platform/sdl2.o $(OUT)/gen/no_rom.o | $(filter %.o,$(LUA_L))
	$(call link,$(LINK_MAP) -Wl$(comma)--gc-sections)

-include $(shell find $(OUT) build/web/obj -name '*.d' 2>/dev/null)
