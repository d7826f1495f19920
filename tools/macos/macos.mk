# What macOS needs otherwise; untested: docs/internals/macos.md. Homebrew does not link lua@5.4 into its prefix. stb is
# cloned into build/include. Libraries that the program opens by name are found by its rpath.
BREW      ?= $(shell brew --prefix 2>/dev/null)
PKG_CONFIG := PKG_CONFIG_PATH="$(BREW)/opt/lua@5.4/lib/pkgconfig:$$PKG_CONFIG_PATH" pkg-config
SYSTEM_C  := -isystem build/include -isystem $(BREW)/include
SYSTEM_L  := -L$(BREW)/lib -Wl,-rpath,$(BREW)/lib
LINK_MAP   = -Wl,-map,$@.map

# What can be tested there.
test: deps-play-test
	-@$(MAKE) $(JOBS) -k $(OUT)/curtain-null $(UNIT) $(filter-out $(QUAD_TESTS),$(MACHINE))
	@OUT=$(OUT) tests/macos/run.sh
