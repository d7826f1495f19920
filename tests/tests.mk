# The tests' programs, and what make test-all runs (docs/internals/testing.md).

UNIT    := $(patsubst tests/unit/%.c,$(OUT)/unit/%,$(wildcard tests/unit/test_*.c))
MACHINE := $(patsubst tests/machine/%.c,$(OUT)/machine/%,$(wildcard tests/machine/test_*.c))
CHECKED := $(UNIT) $(patsubst check_%,$(OUT)/%,$(filter check_machine/test_%,$(shell sed -n 's/^check /check_/p' tests/tiers)))
TEST_H  := $(wildcard tests/*.h tests/unit/*.h tests/machine/*.h)
NO_ROM  := $(CORE_OBJ) $(OUT)/platform/null.o $(OUT)/gen/no_rom.o

.PHONY: products checked named golden asan ubsan monkey msan msan-short given valgrind analyze torture mutants fuzz walks tools coverage

# -Wpedantic has two exceptions: the 128-bit products of src/base/fx.h (__extension__), and the constants of quadmath.h.
QUAD_TESTS := $(OUT)/machine/test_fine $(OUT)/machine/test_lead
$(QUAD_TESTS): ALL_C += -Wno-pedantic -idirafter $(shell gcc -print-file-name=include)
$(QUAD_TESTS): LIBS += $(shell gcc -print-file-name=libquadmath.so)

# The limit of work lowered, so that a test of an endless loop ends soon; and the largest board's RAM.
SHORT := script/vm script/vm_fault script/vm_count board/board script/api/eval
$(OUT)/short/%.o: src/%.c
	$(call compile,-DWORK_LIMIT=50000000 -DMAX_RAM="(64ull << 20)")

$(OUT)/curtain-short: $(filter-out $(SHORT:%=$(OUT)/src/%.o),$(CORE_OBJ)) $(SHORT:%=$(OUT)/short/%.o) \
		$(OUT)/src/workbench/main.o $(OUT)/platform/null.o $(OUT)/gen/no_rom.o
	$(link)

$(OUT)/unit/% $(OUT)/machine/% $(OUT)/given/% $(OUT)/fuzz/% $(OUT)/walks: LIBS += -lcmocka
$(OUT)/unit/%: tests/unit/%.c $(TEST_H) $(NO_ROM)
	$(call link,-Itests)

# Of these, some are ports themselves.
OWN_PORT := test_random_play test_calls
$(OUT)/machine/%: tests/machine/%.c $(TEST_H) $(NO_ROM)
	$(call link,-Itests,$(if $(filter $*,$(OWN_PORT)),%/null.o))

$(OUT)/unit/test_pace: $(OUT)/tools/lab/pacing/simulate.o
$(OUT)/machine/test_worst: $(patsubst %,$(OUT)/tools/lab/bench/%.o,scene worst dearest)
$(OUT)/machine/test_answers: $(OUT)/tools/lab/bulletml/board.o
$(OUT)/machine/test_bench: $(patsubst %,$(OUT)/tools/lab/bench/%.o,scene crowd reference array columns)

# A fuzz target that takes what it is given from files, and no more: for valgrind.
$(OUT)/given/%: tests/fuzz/%.c tests/fuzz/given.c $(NO_ROM)
	$(call link,-Itests)

# tests/fuzz/run.sh makes these with clang and its flags.
$(OUT)/fuzz/%: tests/fuzz/%.c $(NO_ROM)
	$(call link,-fsanitize=fuzzer)

products: $(OUT)/cookbook $(OUT)/curtain $(OUT)/curtain-player $(OUT)/curtain-null $(OUT)/curtain-short \
          $(OUT)/libcurtain.a $(OUT)/libcurtain.so $(OUT)/curtain_libretro.so
programs: products $(UNIT) $(MACHINE)
checked: $(OUT)/curtain-null $(CHECKED)
# What the tests of ONLY need: those in C with one of its words, and the products if a script has one.
named: $(foreach word,$(ONLY),$(foreach t,$(UNIT) $(MACHINE),$(if $(findstring $(word),$t),$t))) \
       $(if $(filter %.sh,$(wildcard $(foreach word,$(ONLY),tests/*/*$(word)* tests/*$(word)*))),products)
products programs checked named tools: ; @:
# The programs of other goals: make test-all builds them, so that these goals work.
tools: $(OUT)/lab $(OUT)/ear $(OUT)/bench $(OUT)/pacing $(OUT)/bot $(OUT)/lively $(OUT)/need $(OUT)/libspeed \
       $(OUT)/bench_fx_build/bench_fx $(PROVE:%=$(OUT)/prove/%) $(OUT)/prove/digest $(OUT)/prove/shapes

torture: deps-play-test
	@$(MAKE) $(JOBS) programs
	@OUT=$(OUT) tests/run.sh torture

golden: deps-play
	@$(MAKE) build/curtain-null
	@tests/golden/run.sh --update
	@tests/golden/sheets.sh --update

asan: deps-play-test
	@$(MAKE) $(JOBS) CONFIG=asan OPT="-O1 -fsanitize=address -fno-omit-frame-pointer" programs
	@OUT=build/asan tests/run.sh sanitizer

# Without -fwrapv, so that an overflow is a finding.
UBSAN := CONFIG=ubsan SEMANTIC="-std=c11 -ffp-contract=off" \
	OPT="-O1 -fsanitize=undefined,float-cast-overflow -fno-sanitize-recover=undefined,float-cast-overflow"
ubsan: deps-play-test
	@$(MAKE) $(JOBS) $(UBSAN) programs
	@OUT=build/ubsan tests/run.sh sanitizer
# Every function reports when it is entered; not position-independent, so that addr2line knows the addresses.
WALKS := CONFIG=walks OPT="-O0 -finstrument-functions" CFLAGS="-fno-pie -no-pie"
walks: deps-play-test
	@$(MAKE) $(JOBS) $(WALKS) build/walks/walks
	@python3 tests/walks/walks.py build/walks/walks docs/internals/design.md
$(OUT)/walks: tests/walks/walks.c $(NO_ROM)
	$(call link,-fno-instrument-functions -Wno-frame-address -Itests)

# Lines of the sources that make test runs, by directory, in build/coverage/report.txt. Tests of what is in the programs
# (lint/objects.sh, machine/library.sh, cli/export.sh) fail here: the counters are in them, too. All runs of a program
# in one test count in one file (%m) while they run (%c), so killed ones count too; those killed before that damage the
# file for the rest of the test, whose programs say so on stderr.
COVERED := -O1 -fprofile-instr-generate -fcoverage-mapping -mllvm -runtime-counter-relocation -Qunused-arguments
coverage: deps-play-test
	@$(MAKE) $(JOBS) CONFIG=coverage CC=clang OPT="$(COVERED)" CFLAGS=-w programs
	@OUT=build/coverage CC="clang $(COVERED)" tests/run.sh test >build/coverage/tests.txt || tail -n 1 build/coverage/tests.txt
	@find build/coverage/results -name '*.profraw' >build/coverage/counts.txt
	@llvm-profdata merge -failure-mode=all -f build/coverage/counts.txt -o build/coverage/counts.profdata
	@for sources in fb $(filter-out src/lib,$(wildcard src/*)) 'src fb'; do \
		llvm-cov report -instr-profile build/coverage/counts.profdata build/coverage/curtain \
			-object build/coverage/curtain-null $$sources | awk -v of="$$sources" \
			'$$1 == "TOTAL" { printf "%-16s %6d of %6d lines, %6s\n", of, $$8 - $$9, $$8, $$10 }'; \
	done >build/coverage/report.txt
	@cat build/coverage/report.txt

# A monkey in the window's screens, in several games, for thousands of frames, under both sanitizers.
monkey: deps-play-test
	@$(MAKE) $(JOBS) CONFIG=monkey SEMANTIC="-std=c11 -ffp-contract=off" \
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
given: deps-play-test-all
	@$(MAKE) $(JOBS) $(OUT)/curtain-null $(patsubst %,$(OUT)/given/fuzz_%,manifest board recording) \
		$(patsubst %,$(OUT)/unit/test_%,cli demo manifest pack script)
msan-short:
	@$(MAKE) $(JOBS) $(MSAN) $(MSAN_GIVEN) $(MSAN_UNIT)

fuzz: deps-play-fuzz
	@tests/fuzz/run.sh

mutants: deps-play-test
	@tests/mutants.sh

analyze: deps-play-test-all
	@tools/analyze.sh $(ARGS)

