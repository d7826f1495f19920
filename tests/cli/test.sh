#!/usr/bin/env bash
# test.sh - `curtain test`: what it says when all holds and of planted faults (a picture, a hash, a script's error, an
# endless loop, a missing file); each function of test scripts; the reports, which other programs read; exit codes; and
# the tests of the games in the repository.
. "$(dirname "$0")/../tap.sh"
sandbox

plain() { # blanks for tabs, N for frames, T for times
    sed -E 's/\t/ /; s/ +[0-9]+ frames/ N frames/; s/[0-9]+\.[0-9]+ s/T s/; s/; [0-9]+ frames in/; N frames in/'
}
said() { # ARG...: what test says of g, times and frames left out, and its exit code
    "$curtain" test g "$@" 2>&1 | plain
    echo "exit ${PIPESTATUS[0]}"
}
says() { # WORDS ARG...: one of its lines is like that
    said "${@:2}" >lines
    grep -qE -- "$1" lines || { cat lines; return 1; }
}
script() { # NAME: tests/NAME.lua of g is standard input
    mkdir -p g/tests
    cat >"g/tests/$1.lua"
}
alone() { rm -rf g/tests g/demos; } # g has no tests any more
wrong() { # NAME SENTENCE CODE: a test of these words fails with that sentence, its place before it
    script try <<<"$3"
    local got
    got=$("$curtain" test g try 2>&1)
    local code=$?
    got=$(sed -n 's/^      //p' <<<"$got" | grep -v '^ \|^kept' | head -1)
    same "$1" "1 $2" "$code $got"
}
holds() { # NAME CODE
    script try <<<"$2"
    check "$1" "$curtain" test g try
}

game g <<'LUA'
bullet.def("orb", { sprite = "dot", hit = { circle = 2 } })
shot.def("dart", { sprite = "dart", hit = { circle = 2 }, damage = 1 })
enemy.def("mote", { sprite = "dot", hit = { circle = 6 }, hp = 3, score = 70, run = function(e)
  wait(20)
  pattern.ring { from = e, kind = "orb", n = 8, speed = 1 }
end })
player.def("ship", { sprite = "dot", hit = { circle = 2 }, lives = 2, run = function(p)
  while true do
    if pad.down("fire", p) then shot.fire { kind = "dart", from = p, dy = -6, speed = 4 } sound.play("hit") end
    wait(4)
  end
end, registers = { power = { start = 1, max = 8 } } })
stage.def("one", function()
  music.play("tide")
  print("the stage begins")
  enemy.spawn { kind = "mote", x = 32, y = 12 }
  wait(600)
end)
boot.run { stages = { "one" }, players = { "ship" } }
LUA
sed -i '1s/.*/return {/' g/rom.lua

# ---- every function ----

mkdir -p g/demos
"$curtain" hash g --stage one --frames 120 --every 500 --press fire --record g/demos/run.demo >/dev/null 2>&1
mkdir -p g/tests/helpers
echo 'return { twice = function(n) return 2 * n end }' >g/tests/helpers/sums.lua
script all <<'LUA'
local sums = require "helpers/sums"
test.equal(sums.twice(21), 42)
test.expect(require "helpers/sums" == sums, "a script is read once")

local run = test.run { stage = "one", seed = 5, difficulty = "hard", lives = 7, registers = { power = 3 },
                       dips = { ships = 4, coins = "one" }, frames = 10 }
test.equal(run.frame, 10)
test.equal(run.difficulty, "hard")
test.equal(run.fault, nil)
test.equal(run.music, "tide")
test.equal({ run:eval "player.get(1).lives, player.get(1).power" }, { 6, 3 }, "7 in all, 6 left")
test.equal(run:eval "{ 1, x = 2.5, 'a', { true } }", { 1, "a", { true }, x = 2.5 })
test.equal(run:eval "nil", nil)
test.equal(#{ run:eval "1, 2, 3" }, 3)
test.equal(run:live("enemies"), 1, "one mote")
test.equal(run:live("bullets"), 0)
test.equal(run:refused("bullets"), 0)
test.expect(run:printed("stage begins"), "the game's line")
test.expect(not run:printed("nothing of the kind"))
test.equal(run.log[1], "the stage begins")
test.equal(run:moment("stage").name, "one")
test.equal(run:moment("stage", "two"), nil)
test.equal(run:moment("death"), nil)

-- Looking changes nothing, whatever is asked; exec does.
local was = run.hash
test.equal(run:eval "rng.int(1, 6), bullet.fire { kind = 'orb', x = 1, y = 1, speed = 0 }" ~= nil, true)
test.equal(run.hash, was, "eval is undone")
test.equal(run:live("bullets"), 0)
run:exec "bullet.fire { kind = 'orb', x = 5, y = 50, speed = 0 }"
test.equal(run:live("bullets"), 1, "exec stays")
test.expect(run.hash ~= was)

-- Buttons: as a text, with frames, by a function, and none.
local x = run:eval "player.get(1).x"
run:press("left")
run:step(4)
test.expect(run:eval "player.get(1).x" < x, "left")
run:press()
x = run:eval "player.get(1).x"
run:step()
test.equal(run:eval "player.get(1).x", x, "nothing is held")
local asked = 0
run:press(function(r)
  asked = asked + 1
  return r.frame % 2 == 0 and "right" or nil
end)
run:step(6)
test.equal(asked, 6, "asked before each frame")
test.expect(run:eval "player.get(1).x" > x, "right")

-- Waiting, for Lua of the game or for a function; sounds are counted when they begin.
local fight = test.run { stage = "one", pads = "fire@0:200:2,fire@1:200:2", invincible = true }
test.equal(fight:heard("hit"), 0)
test.expect(fight:wait("score.get and player.get(1).score >= 70 or player.get(1).score >= 70", 300), "the mote dies")
test.expect(fight:heard("hit") > 3, "shots are heard")
test.equal(fight.score, 70)
test.equal(fight.score2, 0)
test.expect(not fight:wait(function(r) return r.frame < 0 end, 5))
test.expect(fight:wait("true", 0), "at once")

-- The same start and buttons: the same run; a demo's too.
local a = test.run { stage = "one", frames = 120, pads = "fire" }
local b = test.run { demo = "demos/run.demo" }
test.equal(b.frame, 120, "a demo's frames")
test.equal(a.hash, b.hash)
test.shot("fight", b)
test.hash("fight", b)
test.equal(test.run { demo = "demos/run.demo", frames = 30 }.frame, 30)
test.expect(test.run { stage = "one", seed = 6, frames = 5 }.hash ~= test.run { stage = "one", frames = 5 }.hash)
test.equal(test.run().frame, 0)

-- Without a run, the newest.
local other = test.run { stage = "one", frames = 60 }
test.shot("newest")
test.equal(other.frame, 60)
print("seen by who reads", 3)
LUA
same "at first a picture is missing" 1 "$("$curtain" test g >/dev/null 2>&1; echo $?)"
same "it is kept by --update, and a script of a folder below is no test" "ok    demos/run.demo N frames     T s
ok    tests/all.lua N frames     T s
      kept tests/golden/fight.png
      kept tests/golden/fight.hash
      kept tests/golden/newest.png
      | seen by who reads 3
2 tests: all passed; N frames in T s
exit 0" "$(said --update)"
same "all holds" "ok    demos/run.demo N frames     T s
ok    tests/all.lua N frames     T s
      | seen by who reads 3
2 tests: all passed; N frames in T s
exit 0" "$(said)"
same "and leaves nothing to look at" "" "$(ls g/tests/failed)"
same "a kept picture is the frame that render draws" "" \
    "$("$curtain" render g --demo g/demos/run.demo --frames 120 -o out 2>/dev/null &&
        cmp out/000120.png g/tests/golden/fight.png)"
"$curtain" list g >with
mv g/tests away
"$curtain" list g >without
mv away g/tests
same "tests are in no ROM, and change no hash of it" "$(cat without)" "$(cat with)"

# ---- planted: a picture, a hash, an error, endless loops, what is missing ----

keep() { rm -rf kept && cp -r g kept; }
back() { rm -rf g && cp -r kept g; }
keep

python3 "$repo/tests/cli/png_make.py" g/tests/golden/newest.png 64 64 00ff00
same "a picture" "FAILS tests/all.lua N frames     T s
      tests/all.lua:NN: newest: frame 60: 4096 of 4096 pixels differ from tests/golden/newest.png, from 0,0 to \
63,63
      | seen by who reads 3
1 test: 0 passed, 1 failed; N frames in T s
pictures: g/tests/failed
exit 1" "$(said all | sed -E 's/all.lua:[0-9]+/all.lua:NN/')"
same "its three pictures" "newest.difference.png newest.expected.png newest.got.png" \
    "$(ls g/tests/failed | xargs)"
cp g/tests/golden/newest.png green.png
check "the one that is expected is the one that was kept" python3 "$repo/tests/golden/png.py" \
    green.png g/tests/failed/newest.expected.png differs.png
refuse "and is not the one that came" "" python3 "$repo/tests/golden/png.py" green.png g/tests/failed/newest.got.png \
    differs.png
"$curtain" test g all --update >/dev/null 2>&1
same "--update keeps the picture of now" 0 "$("$curtain" test g all >/dev/null 2>&1; echo $?)"
check "what failed before is taken away" test ! -e g/tests/failed/newest.got.png
python3 "$repo/tests/cli/png_make.py" g/tests/golden/newest.png 32 64 00ff00
check "another size" says 'the picture is 64 x 64, but tests/golden/newest.png is 32 x 64$' all

back
sed -i 's/hp = 3/hp = 4/' g/main.lua
check "the hashes of a demo" says \
    '^ +demos/run.demo: frame [0-9]+: script, .*enemy_kinds differ \(recorded with another game version\)$'
check "the frame from which a demo differs is there to look at" test -s g/tests/failed/demo-run.got.png
sed -i 's/^bullets .*/bullets 0123456789abcdef/' kept/tests/golden/fight.hash
back
check "a part of a kept hash" says \
    '^ +tests/all.lua:[0-9]+: fight: frame 120: bullets differs from tests/golden/fight.hash$' all

alone
wrong "a script's error" 'tests/try.lua:2: attempt to index a nil value (local '"'x'"')' $'local x\nprint(x.y)'
wrong "a script that is no Lua" "tests/try.lua:2: syntax error near <eof>" 'local x y'
back
sed -i 's/  print("the stage begins")/  wait(1) error("planted")/' g/main.lua
rm -r g/tests g/demos
script try <<<'test.run { stage = "one", frames = 10 }'
check "an error of the game" says '^ +tests/try.lua:1: the game stopped at frame [0-9]+: main.lua:15: planted$'
holds "an error that is wanted" 'local run = test.run { stage = "one", frames = 10, faults = true }
test.expect(run.fault:find("planted"))
run:step(5)
test.expect(run.frame < 5, "it has stopped")'
rm -rf g && cp -r kept g
alone

script try <<<'while true do end'
same "an endless loop of a test" "FAILS tests/try.lua       0 frames
      tests/try.lua:1: infinite loop: more than 1000000000 instructions in one test" \
    "$("$curtain" test g 2>&1 | sed -E 's/ +[0-9.]+ s$//' | head -2)"
sed -i 's/  print("the stage begins")/  wait(1) while true do end/' g/main.lua
script try <<<'test.run { stage = "one", frames = 10 }'
curtain=$OUT/curtain-short
check "an endless loop of the game" says \
    '^ +tests/try.lua:1: the game stopped at frame [0-9]+: main.lua:15: infinite loop: more than 50000000 instructions'
curtain=$OUT/curtain-null
rm -rf g && cp -r kept g
alone
wrong "frames without end" \
    'tests/try.lua:2: more than 216000 frames (an hour of play) in one test (infinite loop?)' \
    $'local run = test.run()\nwhile true do run:step(50000) end'
wrong "a text without end" 'tests/try.lua:1: out of memory (16 MiB for a test)' \
    'local s = "x" while true do s = s .. s end'

wrong "no such demo" 'tests/try.lua:1: test.run: g/demos/no.demo: no such file' 'test.run { demo = "demos/no.demo" }'
wrong "no such script" 'tests/try.lua:1: require: no script tests/no.lua' 'require "no"'
wrong "no such picture" "tests/try.lua:1: new: frame 0: no tests/golden/new.png yet: check \
tests/failed/new.got.png, then run with --update to save it" 'test.run() test.shot("new")'

# ---- what scripts get wrong: one sentence each ----

while IFS='|' read -r code sentence; do
    wrong "$code" "tests/try.lua:1: $sentence" "$code"
done < <(sed -e ':a' -e '/\\$/{N;s/\\\n//;ba' -e '}' <<'END'
test.run { stge = "one" }|test.run: unknown field "stge" (did you mean "stage"?)
test.run("one")|test.run: expected a table such as { stage = "one", frames = 600 }, got string
test.run { seed = 1.5 }|test.run: seed: expected a whole number from -9223372036854775808 to \
9223372036854775807, got 1.5
test.run { difficulty = "hrad" }|test.run: difficulty: unknown difficulty "hrad" (did you mean "hard"?)
test.run { lives = 3 }|test.run: lives, invincible and registers require stage
test.run { dips = { f = {}, e = {}, d = {}, c = {}, b = {}, a = {} } }|test.run: dips.a: expected a string or \
a number, got a table
test.run { zf = 1, ze = 1, zd = 1, zc = 1, zb = 1, za = 1, zg = 1, zh = 1 }|test.run: unknown field "za" \
(fields: stage, seed, difficulty, frames, pads, demo, lang, lives, invincible, dips, registers, faults)
test.run { pads = "jump" }|test.run: pads: expected buttons, as in fire or fire,focus or bomb@200 or left@60:90, got \
"jump" (buttons: up down left right fire bomb focus special start select)
test.run { pads = function() return 3 end, frames = 1 }|pads: expected the function to return buttons such as \
"left,fire", got number
test.run { demo = "../x.demo" }|test.run: demo: expected a file of the game, as in "demos/run.demo", got "../x.demo"
test.run { demo = "demos/x.demo", seed = 3 }|test.run: a demo has its own start settings and buttons; combine demo \
only with frames and faults
test.run { stage = "two" }|the game stopped at frame 0: main.lua:19: boot.run: unknown stage \
"two" (known: one)
test.run():step(-1)|run:step: expected a whole number of frames from 0 to 216000
test.run():eval("1 +")|run:eval: unexpected symbol near '1'
test.run():live("bulets")|run:live: unknown part "bulets" (curtain hash --parts lists them)
test.run():heard("bang")|run:heard: unknown sound "bang" (curtain sound lists them)
test.run().stage()|a run has no field "stage" (curtain help test lists them)
test.run().frame = 3|the fields of a run are read-only; change the game with run:exec "..."
test.shot("x")|no run yet (start one with test.run)
test.run() test.shot("A b")|test.shot: name: expected 1 to 63 of the characters a-z 0-9 _ -, got "A b"
local r = test.run() for _ = 1, 4 do test.run() end r:step()|the run has ended (only the last 4 runs of a test \
stay open)
test.equal({ 1, { a = "x" } }, { 1, { a = "y" } })|expected { 1, { a = "y" } }, got { 1, { a = "x" } }
bullet.fire {}|undeclared global "bullet" (tests can use only Lua's library and `test`; \
read the game's globals with run:eval "bullet")
speed = 3|undeclared global "speed" (scripts cannot create globals; write "local speed")
END
)
wrong "a circle of tables" 'tests/try.lua:1: run:eval: tables nested more than 8 deep' \
    'test.run():eval("(function() local t = {} t.t = t return t end)()")'
script try <<<'test.expect(false, string.rep("x", 5000))'
refuse "a sentence of 5000 letters" "tests/try.lua:1: expected: xxx" "$curtain" test g try
wrong "a name that is taken twice" 'tests/try.lua:1: a: frame 0: no tests/golden/a.png yet: check '\
'tests/failed/a.got.png, then run with --update to save it' 'test.run() test.shot("a") test.shot("a")'
check "is reported" says 'tests/try.lua:1: a: frame 0: duplicate name in this test' try
for other in one two; do script $other <<<'test.run() test.shot("both")'; done
check "a name of two tests" says \
    '^ +tests/golden/both.png is also used by tests/one.lua: tests cannot share pictures and hashes$' one two \
        --update
alone
script try <<<'print("a\27[31mb")'
check "what is printed obeys nobody" says '^ +\| a \[31mb$'
same "a picture that no test takes" "tests/golden/old.png: not used by any test" \
    "$(mkdir -p g/tests/golden && touch g/tests/golden/old.png && said | grep old.png)"
same "is not told when some tests are left out" "" "$(said try | grep old.png)"
alone

# ---- the command ----

refuse "nothing to test" "g: no tests: no demos/*.demo and no tests/*.lua (see curtain help test)" \
    "$curtain" test g
same "with exit code 2" 2 "$("$curtain" test g >/dev/null 2>&1; echo $?)"
for name in boss bomb title; do script $name <<<'test.run { frames = 30 }'; done
script slow <<<'test.run { frames = 4500 }'
refuse "no such test" 'test: g has no test "bos" (did you mean tests/boss.lua?)' "$curtain" test g bos
refuse "nothing like it" 'test: g has no test "zzzzzzzz" (tests are demos/*.demo and tests/*.lua)' \
    "$curtain" test g zzzzzzzz
same "names choose tests, in whatever form" "ok tests/bomb.lua ok tests/boss.lua ok tests/title.lua 3 tests: all" \
    "$(said bomb tests/boss.lua title.lua | awk '/^ok/ { print $1, $2 } / tests: / { print $1, $2, $3 }' | xargs)"
same "one at a time and eight say the same" "$(said --jobs 1)" "$(said --jobs 8)"
refuse "a report that cannot be written" "no/such/x.xml" "$curtain" test g --junit /proc/no/such/x.xml
same "is the host's fault" 3 "$("$curtain" test g --junit /proc/no/such/x.xml >/dev/null 2>&1; echo $?)"

# A test whose process dies has failed, and no other.
script slow <<<'print("so far") local run = test.run() for _ = 1, 60 do run:step(3600) end'
("$curtain" test g --jobs 1 >died 2>&1; echo "exit $?" >>died) &
for _ in $(seq 500); do
    child=$(pgrep -P "$(pgrep -P $! -f 'curtain-null test g' | head -1)" 2>/dev/null | head -1)
    [ -n "$child" ] && grep -q boss died && kill -SEGV "$child" && break
    sleep 0.02
done
wait
check "a test whose process dies" grep -qE '^      the program was killed by signal 11 during the test$' died
check "what it said before is reported" grep -qE '^ +\| so far$' died
check "takes no other with it" grep -qE '^ok +tests/title.lua' died
check "and has failed" grep -qx 'exit 1' died

# ---- reports that others read ----

alone
script good <<<'test.run { frames = 5 }'
script bad <<<'test.expect(false, "a < b & \"c\"") print("<seen>")'
same "TAP" "TAP version 13
1..2
not ok 1 - tests/bad.lua
# tests/bad.lua:1: expected: a < b & \"c\"
# | <seen>
# N frames, T s
ok 2 - tests/good.lua
# N frames, T s
exit 1" "$(said --tap)"
echo "exec '$curtain' test g --tap" >t.sh
prove -e bash t.sh >proved 2>&1
check "prove reads it" grep -q 'Failed test: *1$' proved
"$curtain" test g --junit report.xml >/dev/null 2>&1
junit() {
    python3 - <<'PY'
import xml.etree.ElementTree as tree
root = tree.parse("report.xml").getroot()
assert root.tag == "testsuites"
assert (root.get("tests"), root.get("failures"), root.get("errors")) == ("2", "1", "0")
suite = root.find("testsuite")
assert suite.get("name") == "Probe" and suite.get("failures") == "1"
bad, good = suite.findall("testcase")
assert (bad.get("name"), bad.get("classname")) == ("tests/bad.lua", "tests") and float(bad.get("time")) >= 0
assert bad.find("failure").get("message") == 'tests/bad.lua:1: expected: a < b & "c"'
assert "<seen>" in bad.find("system-out").text
assert good.find("failure") is None and "5 frames" in good.find("system-out").text
PY
}
check "JUnit" junit

# ---- help, editors, the games of the repository ----

"$curtain" help test >help
for name in test.run test.expect test.equal test.shot test.hash run:step run:wait run:press run:eval run:exec run:live \
    run:refused run:heard run:printed run:moment run.frame run.hash run.moments; do
    grep -q "^  $name" help || echo "$name"
done >missing
same "help test has each function" "" "$(cat missing)"
"$curtain" help test --annotations >test.lua
check "the definitions are Lua" "${LUAC:-luac5.4}" -p test.lua
for name in roms/glasstide roms/cookbook examples/first; do
    cp -r "$repo/$name" .
    check "the tests of $name hold" "$curtain" test "$(basename $name)" --jobs 2
done

# ---- names and words of others, in each report ----

mkdir hostile
cp -r g hostile/g
rm -rf hostile/g/tests hostile/g/demos
mkdir hostile/g/tests
name=$'a\033[31m\nnot ok \xe2\x80\xae # TODO'
printf 'print("\\27[2J\\u{202E}\\u{FFFF}<&")\ntest.expect(false, "\\27]0;x\\7")\n' >"hostile/g/tests/$name.lua"
hidden() { # FILE: nothing that controls is in it
    ! LC_ALL=C grep -qP '[\x00-\x08\x0b-\x1f\x7f]|\xc2[\x80-\x9f]|\xe2\x80[\xa8-\xae]|\xef\xbf[\xbe\xbf]' "$1"
}
"$curtain" test hostile/g >lines 2>&1
check "lines for people show nothing that controls" hidden lines
"$curtain" test hostile/g --tap --junit ci.xml >lines 2>/dev/null
check "nor does TAP" hidden lines
same "which has one result" 1 "$(grep -c '^not ok' lines)"
check "and no directive in its name" grep -qF '\# TODO' lines
check "nor JUnit" hidden ci.xml
check "which is XML" python3 -c 'import sys, xml.dom.minidom; xml.dom.minidom.parse(sys.argv[1])' ci.xml
finish
