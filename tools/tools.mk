# What publishes, ports, paints and measures.

.PHONY: windows players ports library web art demos cookbook patterns pace docs docs-stale survive accuracy sound pacing bench bench-fx
.PHONY: bench-fx-objects compare bulletml prove cross

# Glass Tide's Japanese fonts come from packages. Without them, the game has no kanji.
MISAKI ?= /usr/share/fonts/truetype/misaki/misaki_gothic.ttf
EFONT  ?= /usr/share/fonts/X11/misc/f12.pcf.gz
GAME_FONT := $(if $(wildcard $(MISAKI)),$(GAME)/art/misaki_gothic.ttf) \
             $(if $(and $(wildcard $(EFONT)),$(shell command -v pcf2bdf)),$(GAME)/art/efont_12.bdf)
$(GAME)/art/misaki_gothic.ttf: $(MISAKI)
	$(Q)cp $< $@
$(GAME)/art/efont_12.bdf: $(EFONT)
	$(Q)zcat $< | pcf2bdf -o $@

# LUA_INSIDE=1: programs contain Lua, compiled as Debian does it, without its program and what the sandbox leaves out.
LUA_SRC  := build/cross/lua-bookworm/src
LUA_H    := $(LUA_SRC)/lua.h build/cross/include/lua5.4-deb-multiarch.h
LUA_OBJ  := $(patsubst %,$(OUT)/lua/l%.o,api auxlib baselib code ctype debug do dump func gc lex mathlib mem object opcodes \
            parser state string strlib table tablib tm undump utf8lib vm zio)
ifdef LUA_INSIDE
LUA_C    := -I$(LUA_SRC) -Ibuild/cross/include
LUA_L    := $(LUA_OBJ)
endif
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

# The manual pages: one, and another name for it.
build/curtain.1: $(OUT)/curtain-bare tools/manpage.sh
	$(make)
	$(Q)tools/manpage.sh "$(RUN) $<" > $@
build/curtain-null.1:
	@mkdir -p $(@D)
	@echo '.so man1/curtain.1' > $@

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
	@$(MAKE) $(OUT)/curtain-bare
	@tools/windows/libraries.sh
	@$(MAKE) CONFIG=windows CC="$(WIN_CC)" BUILD_CC="$(CC)" BARE=$(OUT)/curtain-bare \
		CFLAGS="$(strip -D__USE_MINGW_ANSI_STDIO=1 $(CFLAGS))" WARN="$(WARN) $(WIN_WARN)" HARDEN_L= THREADS= LUA_INSIDE=1 \
		SDL_C="-I$(WIN)/lib/sdl2/include/SDL2 -DSDL_LINKED" $(WIN)/curtain.exe $(WIN)/curtain-null.exe $(WIN)/curtain-empty.exe \
		$(WIN)/curtain-player.exe

$(WIN)/curtain.ico: tools/windows/icon.py $(wildcard share/icons/*.png)
	$(make)
	$(Q)tools/windows/icon.py $@ $(wildcard share/icons/*.png)
$(WIN)/resource.o: tools/windows/curtain.rc tools/windows/curtain.manifest $(WIN)/curtain.ico src/player/game/version.h
	$(make)
	$(Q)$(WIN_RES) -I. -I$(WIN) -DVERSION='\"$(VERSION)\"' -DNUMBERS=$(subst .,$(comma),$(VERSION)),0 $< $@
$(WIN)/platform/sdl2/%.o: platform/%.c
	$(call compile,$(call OWN,platform/sdl2.c))
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
	@$(MAKE) $(WEB)/player.html
	@$(MAKE) windows
	@tools/old_glibc.sh make $(JOBS) CONFIG=linux CFLAGS="$(LINUX_C)" LUA_INSIDE=1 SDL_C="$(SDL_C)" V=$(V) \
		$(LINUX)/curtain-player $(LINUX)/curtain-empty $(LINUX)/curtain_libretro.so
	@mkdir -p $(PLAYERS)
	@cp $(WEB)/player.html $(LINUX)/curtain_libretro.so $(PLAYERS)
	@cp $(LINUX)/curtain-player $(PLAYERS)/curtain-player-linux
	@cp $(LINUX)/curtain-empty $(PLAYERS)/curtain-linux
	@cp $(WIN)/curtain-player.exe $(PLAYERS)
	@cp $(WIN)/curtain-empty.exe $(PLAYERS)/curtain.exe
	@ls -l $(PLAYERS)

LIB_NAMES  = $(shell grep -oP 'curtain_[a-z_]*(?=\x28)' src/lib/curtain.h | sort -u)
OBJCOPY   ?= objcopy

# ---- libcurtain: the board as calls, with no name of its own but those of curtain.h ----

WEB     := build/web
LIB_OBJ := $(patsubst %.c,$(OUT)/lib/%.o,$(BOARD_SRC) $(patsubst %,src/demo/%.c,demo demo_read demo_put demo_record demo_write rewind) $(wildcard src/lib/*.c) src/common/array.c) $(OUT)/lib/gen/std.o
LIB_C   := -DWITHOUT_HELP $(if $(findstring mingw,$(CC)),,-fPIC) -fvisibility=hidden -ffunction-sections -fdata-sections \
           $(if $(findstring profile,$(OPT)),-fno-profile-instr-generate -fno-coverage-mapping) # make coverage

$(OUT)/lib/gen/std.o: $(OUT)/gen/std.c
	$(call compile,$(LIB_C))
$(OUT)/lib/%.o: %.c
	$(call compile,$(LIB_C))

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
	@$(MAKE) $(JOBS) $(OUT)/curtain $(OUT)/curtain-null $(OUT)/curtain-bare $(OUT)/libcurtain.a \
		$(OUT)/libcurtain.so $(OUT)/need $(OUT)/libspeed build/curtain build/curtain-null
	@$(MAKE) players
	@OUT=$(OUT) tools/lab/ports/ports.sh $(ARGS)

library: say-null
	@$(MAKE) build/libcurtain.a build/libcurtain.so build/curtain.pc build/curtain_libretro.so build/players/curtain_libretro.so
build/libcurtain.a build/libcurtain.so build/curtain_libretro.so: build/%: $(OUT)/%
	@cp $< $@
build/curtain.pc: share/curtain.pc.in src/player/game/version.h
	@sed 's,@PREFIX@,$(PREFIX),; s,@VERSION@,$(VERSION),' $< > $@

RETRO_OBJ := $(patsubst %,$(OUT)/lib/%.o,platform/libretro/core platform/libretro/inside src/player/game/mark)
$(OUT)/curtain_libretro.so: $(RETRO_OBJ) $(OUT)/libcurtain.a | $(filter %.o,$(LUA_L))
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $(LIB_C) -shared -Wl,-z,defs -Wl,--exclude-libs,ALL $^ \
		$(filter-out -pie,$(HARDEN_L)) $(LUA_L) -lm -ldl -o $@

# ---- the web port: libcurtain and Lua for WebAssembly, and pages with games inside; docs/internals/porting.md ----

# Lua has tools/lab/cross/wasi in place of setjmp.
WEB_CC    ?= clang
WEB_OPT   ?= -Oz -msimd128
WEB_C      = --target=wasm32-wasi $(WEB_OPT) -DWITHOUT_HELP -ffunction-sections \
             -fdata-sections -I$(LUA_SRC) -Ibuild/cross/include -Itools/lab/cross/wasi
WEB_LUA   := $(LUA_OBJ:$(OUT)/%=$(WEB)/%)
WEB_OBJ   := $(patsubst $(OUT)/lib/%,$(WEB)/obj/%,$(LIB_OBJ)) \
             $(WEB)/obj/platform/web/web.o $(WEB)/obj/platform/web/no_host.o
WEB_PAGE  := $(patsubst %,platform/web/%,page.html player.css player.js worklet.js build.sh)

$(WEB)/lua/%.o: $(LUA_H)
	@mkdir -p $(@D)
	$(SAY) "  CC    $*.c (web)"
	$(Q)$(WEB_CC) -std=gnu99 $(WEB_C) -DLUA_COMPAT_5_3 -include tools/lab/cross/wasi/lua_try.h -c $(LUA_SRC)/$*.c -o $@
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
	$(make)
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
	@$(MAKE) $(OUT)/curtain-bare build/players/player.html
	@$(OUT)/curtain-bare export $(GAME) --web -o $(WEB)/$(basename $(notdir $(patsubst %/,%,$(GAME)))).html
	@ls -l $(WEB)/$(basename $(notdir $(patsubst %/,%,$(GAME)))).html

# ---- art: a program draws the pictures of Glass Tide and of the games that borrow them ----

$(OUT)/art: $(wildcard roms/glasstide/source/art/*.c)
	@mkdir -p $(@D)
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(SEMANTIC) -O2 -Wno-unused-function $^ -lm -o $@

art:
	@$(MAKE) $(OUT)/art
	$(Q)$(OUT)/art roms/glasstide/art
	$(Q)set -e; for made in roms/testcard/art=card roms/bench/art=bench roms/cookbook/art=cookbook \
		examples/shooter/art=night examples/sandbox/art=glow share/icons=icon; do \
		$(OUT)/art $${made%=*} $${made#*=}; done

$(OUT)/cookbook: tools/cookbook/cookbook.c $(NO_ROM)
	$(link)

BOT_OBJ := $(patsubst %.c,$(OUT)/%.o,$(wildcard tools/bot/*.c))

$(OUT)/bot: $(BOT_OBJ) $(NO_ROM)
	$(link)

# Both the program's board and the library's: one hides its names.
$(OUT)/libspeed: tools/lab/ports/speed.c $(NO_ROM) $(OUT)/libcurtain.a
	$(link)

$(OUT)/need: tools/lab/ports/need.c $(NO_ROM)
	$(link)

$(OUT)/lively: roms/glasstide/source/lively.c $(NO_ROM)
	$(link)

# Against libfixmath. The script builds the program, for it links several builds of that library.
BENCH_FX := $(filter-out %/trig.o,$(CORE_OBJ)) $(OUT)/platform/null.o $(OUT)/gen/no_rom.o \
            $(patsubst %,$(OUT)/tools/lab/bench_fx/%.o,bench_fx bench_fx_inputs)
bench-fx: deps-play-bench
	@$(MAKE) bench-fx-objects
	@OUT="$(OUT)" CC="$(CC)" FLAGS="$(SEMANTIC) $(OPT) $(CFLAGS)" LIBS="$(LIBS)" tools/lab/bench_fx/bench_fx.sh $(BENCH_FX)
bench-fx-objects: $(BENCH_FX)
	@:
$(OUT)/bench_fx_build/bench_fx: $(BENCH_FX) $(wildcard tools/lab/bench_fx/*)
	$(SAY) "  LINK  $@"
	$(Q)OUT="$(OUT)" CC="$(CC)" FLAGS="$(SEMANTIC) $(OPT) $(CFLAGS)" LIBS="$(LIBS)" \
		tools/lab/bench_fx/bench_fx.sh --build $(BENCH_FX)

# The demos are recorded by a program that plays; needed when scripts or the core change.
demos: deps-play
	@$(MAKE) $(OUT)/bot
	@OUT=$(OUT) tools/demos.sh

# The page of the cookbook, with its pictures, and what its test compares.
cookbook: deps-play
	@$(MAKE) $(OUT)/cookbook
	@OUT=$(OUT) tools/cookbook/cookbook.sh

# The patterns of Glass Tide with their pictures, docs/measured/patterns.md; of the demos that make demos records.
patterns: deps-play
	@$(MAKE) build/curtain-null $(OUT)/lively
	@OUT=$(OUT) python3 roms/glasstide/source/patterns.py

# Glass Tide's pace in a demo: of each part, its seconds, those of story, those without bullets, and the longest of these.
pace: deps-play
	@$(MAKE) build/curtain-null $(OUT)/lively
	@$(OUT)/lively roms/glasstide $(or $(DEMO),tests/demos/glasstide/clear-normal.demo) | awk -f roms/glasstide/source/pace.awk

# The measured pages that are older than what they measure (tools/lab/README.md).
docs-stale:
	@tools/docs/stale.sh

# README and docs/ as one file; make install takes it along, if it was made.
docs: deps-docs
	@tools/docs/docs.sh -o build/curtain.html

# What can be survived, of Glass Tide and the cookbook, and how hard it is; docs/measured/survive.md, docs/measured/game.md.
survive: deps-play
	@$(MAKE) build/curtain-null
	@tools/survive.sh

# ---- pages of measurements: text, tables, plots ----

REPORT_OBJ := $(patsubst %.c,$(OUT)/%.o,$(wildcard tools/lab/report/*.c))
$(OUT)/tools/lab/report/report.o: ALL_C += '-DREPORT_FLAGS="$(SEMANTIC) $(OPT) $(CFLAGS)"'

# ---- the lab: what each choice costs, measured; docs/measured/accuracy.md ----

LAB_SRC := $(wildcard tools/lab/accuracy/*.c)
LAB_OBJ := $(LAB_SRC:%.c=$(OUT)/%.o)
LAB_L   := -llibfixmath

$(OUT)/lab: $(LAB_OBJ) $(REPORT_OBJ) $(NO_ROM)
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $^ $(LIBS) $(LAB_L) -o $@

accuracy: deps-play-test
	@$(MAKE) $(JOBS) $(OUT)/lab
	@$(OUT)/lab

# ---- the ear: how good sound is, measured; docs/measured/sound.md ----

EAR_OBJ := $(patsubst %.c,$(OUT)/%.o,$(wildcard tools/lab/sound/*.c))

$(OUT)/ear: $(EAR_OBJ) $(REPORT_OBJ) $(NO_ROM)
	$(link)

sound: deps-play
	@$(MAKE) $(JOBS) $(OUT)/ear
	@$(OUT)/ear

# ---- pacing: frames, screens, and the way from a switch to the picture; docs/measured/pacing.md. It has a port of its own ----

PACING_OBJ := $(patsubst %.c,$(OUT)/%.o,$(wildcard tools/lab/pacing/*.c))

$(OUT)/pacing: $(PACING_OBJ) $(REPORT_OBJ) $(CORE_OBJ) $(OUT)/gen/no_rom.o
	$(link)

pacing: deps-play
	@$(MAKE) $(JOBS) $(OUT)/pacing
	@$(OUT)/pacing

# ---- the bench: what a frame costs; docs/measured/speed.md. ARGS="crowd battle" prints these sections only ----

BENCH_OBJ := $(patsubst %.c,$(OUT)/%.o,$(wildcard tools/lab/bench/*.c))

$(OUT)/bench: $(BENCH_OBJ) $(REPORT_OBJ) $(NO_ROM)
	$(link)

bench: deps-play
	@$(MAKE) $(JOBS) $(OUT)/bench
	@$(OUT)/bench $(ARGS)

# What a game costs beside another commit's engine: BASE=COMMIT, or a folder; GAME=, START= as in compare.sh.
# Functions start at cache lines: moved by 16 bytes, a drawing loop of the same instructions can take 1.1 times as long.
compare: export OPT += -falign-functions=64
compare: deps-null
	@OUT=build/aligned CC="$(CC)" FLAGS="$(ALL_C)" LIBS="$(LIBS)" TABLE="$(TABLE)" \
		tools/lab/compare/compare.sh "$(BASE)" "$(GAME)" "$(if $(filter undefined,$(origin START)),one,$(START))"

# ---- BulletML beside libbulletml, which is linked here and nowhere else; docs/measured/bulletml.md ----

CXX       ?= c++
BULLETML_OBJ := $(patsubst %.c,$(OUT)/%.o,$(wildcard tools/lab/bulletml/*.c)) $(OUT)/tools/lab/bulletml/reference.o \
                $(OUT)/tools/lab/bench/measure.o

$(OUT)/tools/lab/bulletml/reference.o: tools/lab/bulletml/reference.cpp tools/lab/bulletml/reference.h
	@mkdir -p $(@D)
	$(SAY) "  CXX   $<"
	$(Q)$(CXX) -std=c++11 -O2 -g -ffp-contract=off -Wall -Wextra -Wno-deprecated-declarations \
		-isystem /usr/include/bulletml -c $< -o $@

$(OUT)/bulletml: $(BULLETML_OBJ) $(REPORT_OBJ) $(NO_ROM)
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $^ $(LIBS) -lbulletml -lstdc++ -o $@

bulletml: deps-play-bulletml
	@$(MAKE) $(JOBS) $(OUT)/bulletml
	@$(OUT)/bulletml $(ARGS)

# ---- the proofs: every function of base is the correctly rounded one ----

PROVE := roots sines polar directions products
$(PROVE:%=$(OUT)/prove/%): $(OUT)/prove/%: $(OUT)/tools/lab/prove/%.o $(OUT)/tools/lab/prove/prove.o \
		$(OUT)/tools/lab/prove/oracle.o $(OUT)/src/base/trig.o
	@mkdir -p $(@D)
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $^ -lmpfr -lgmp -lm $(THREADS) -o $@

$(OUT)/prove/digest: $(OUT)/tools/lab/prove/digest.o $(OUT)/src/base/trig.o
	@mkdir -p $(@D)
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $^ -lm -o $@

$(OUT)/prove/shapes: $(OUT)/tools/lab/prove/shapes.o $(OUT)/src/base/geom.o
	@mkdir -p $(@D)
	$(SAY) "  LINK  $@"
	$(Q)$(CC) $(ALL_C) $^ -lm $(THREADS) -o $@

# With CONFIG=twins CFLAGS=-DFX_INTEGER: the same of the integer twins.
prove: deps-test
	@$(MAKE) $(JOBS) $(PROVE:%=$(OUT)/prove/%) $(OUT)/prove/digest $(OUT)/prove/shapes
	@OUT=$(OUT) tools/lab/prove/run.sh $(PROVE)

# ---- other machines; docs/internals/determinism.md. ARGS="s390x armhf" tries these builds only ----

cross: deps-play-cross
	@tools/lab/cross/run.sh $(ARGS)

