#!/usr/bin/env bash
# badinput.sh - wrong words, files, games and disks: each ends with the right exit code and one line that names file and
# cause. The whole of stderr is compared.
. "$(dirname "$0")/../tap.sh"
sandbox

idle() { echo 'task.go(function() while true do wait(1) end end)'; }

idle | game g
"$curtain" pack g --plain -o g.rom || not_ok 'the game is packed'

# ---- ROMs ----

mkdir empty
: >zero.rom
cp g.rom other.rom
printf '\143' | dd of=other.rom bs=1 seek=8 conv=notrunc 2>/dev/null
cp g.rom damaged.rom
printf '\1' | dd of=damaged.rom bs=1 seek=5000 conv=notrunc 2>/dev/null
usage_errors 2 <<'END'
hash none.rom|none.rom: no such file or folder
none.rom|none.rom: no such command, file or folder (see curtain help)
hash empty|empty: rom.lua: no such file
hash zero.rom|zero.rom: too short for a ROM (0 bytes)
hash g/art/all.png|g/art/all.png: not a Curtain ROM
hash other.rom|other.rom: unknown ROM format 99 (this program reads format 1)
hash damaged.rom|damaged.rom: damaged: the checksum does not match
pack g.rom|g.rom: expected a game's folder, got a file
END

# ---- what is no file, or cannot be read though it has a size ----

kernel=/sys/kernel/mm/transparent_hugepage/enabled # says that it has 4096 bytes, and gives fewer
if [ "$(stat -c %s $kernel 2>/dev/null)" = 4096 ]; then
    input_error 'a ROM that cannot be read' "$kernel: cannot be read" hash $kernel
    mkdir kernel
    ln -s $kernel kernel/rom.lua
    input_error 'rom.lua that cannot be read' 'kernel: rom.lua: cannot be read' hash kernel
    "$curtain" check kernel >out 2>err
    got=$?
    same 'check of a rom.lua that cannot be read' 'rom.lua: cannot be read 1' "$(head -1 out) $got"
    cp -r g unread
    rm unread/main.lua
    ln -s $kernel unread/main.lua
    input_error 'a script that cannot be read' 'unread: main.lua: cannot be read' hash unread
    input_error 'a demo that cannot be read' "$kernel: cannot be read" hash g.rom --demo $kernel
fi
ln -s loop loop
for command in hash check 'verify g'; do
    input_error "$command of a link to itself" 'loop: cannot be read (Too many levels of symbolic links)' $command loop
done
input_error "an endless argument" "argument longer than 900 characters: \"$(printf '%032d' 0)...\"" hash \
    "$(printf '%05000d' 0)"
mkfifo fifo
input_error 'a pipe as a ROM' 'fifo: cannot be read' hash fifo
mknod nul c 1 3 && {
    "$curtain" pack g -o nul 2>err
    same 'pack into a device' '0 character special file' "$? $(stat -c %F nul)"
}
ln -s g.rom link.rom
"$curtain" pack g -o link.rom 2>err
same 'pack to a link: it stays one' '0 symbolic link' "$? $(stat -c %F link.rom)"
mkdir -p taken && mkfifo taken/main.lua
input_error 'unpack where a pipe is' 'taken/main.lua: already exists' unpack g.rom taken
mkdir -p taken2 && : >taken2/lumps
input_error 'unpack where a file is, and a folder would be' \
    'taken2/lumps: a file with this name exists, but lumps/gfx/dart needs a folder there' unpack g.rom taken2

# ---- manifests ----

rom_errors() { # lines "SED-SCRIPT|TEXT": rom.lua, changed by the script, is refused
    local change text
    while IFS='|' read -r change text; do
        idle | game bad
        sed -i "$change" bad/rom.lua
        input_error "rom.lua: $change" "bad: $text" hash bad --frames 1
        rm -rf bad
    done
}
rom_errors <<'END'
s/h = 8 }/h = 99 }/|art/all.png: sprite "dot": 1 frames of 8x99 at 0,0 do not fit in the sheet of 16x16 pixels
s/bullets = 256/bulets = 256/|rom.lua: board.bulets: unknown key (did you mean "bullets"?)
s/id = "probe"/{} probe/|rom.lua:2: '}' expected (to close '{' at line 1) near 'probe'
s/.*//;1s/.*/return 5/|rom.lua: expected `return { ... }`, got 5
s/art\/all.png/art\/none.png/|rom.lua:4: art/none.png does not exist
s/id = "probe"/id = "probe", entry = "start"/|rom.lua: entry: start.lua does not exist
END
# All maxima together are below the limit of 1 GiB; in $OUT/curtain-short the limit is 64 MiB.
idle | game bad
sed -i 's/bullets = 256/bullets = 200000/;s/lua_kib = 1024/lua_kib = 51200/' bad/rom.lua
for command in 'hash bad --frames 1' 'pack bad'; do
    line=$("$OUT/curtain-short" $command 2>&1)
    same "more RAM than a board may have: $command" \
        '2 curtain: bad: the capacities in rom.lua need N MiB of RAM (at most 64); lower them' \
        "$? $(sed -E 's/need (6[5-9]|[7-9][0-9]|1[0-9][0-9]) MiB/need N MiB/' <<<"$line")"
done
expect_error 'the same game has room in a whole board' 0 '' "$curtain" hash bad --frames 1
rm -rf bad

# ---- art and scripts ----

art() { # NAME LINE COMMAND...: run in the game's folder
    local name=$1 line=$2
    shift 2
    idle | game bad
    (cd bad && "$@")
    input_error "$name" "bad: $line" pack bad -o bad.rom
    check "$name: nothing is written" [ ! -e bad.rom ]
    rm -rf bad
}
dotted() { python3 "$repo/tests/cli/png_make.py" art/all.png 16 16 ffffff 3 2 123456; }
by_index='match = "index" in rom.lua to use the indices of an indexed picture'
art 'colour that is not in its bank' \
    "art/all.png: pixel 3,2: colour #123456 is not in bank 0 (use --nearest for the nearest colour, or $by_index)" \
        dotted
idle | game near
(cd near && dotted)
expect_error 'and --nearest takes it' 0 '' "$curtain" hash near --nearest --frames 1
art 'art that is not a PNG' 'art/all.png: not a PNG' cp rom.lua art/all.png
art 'script with an odd name' 'my file.lua: expected a name of letters, digits, _ - and . only' cp main.lua \
    'my file.lua'

# ---- scripts that fail ----

game bad <<'LUA'
enemy.def("e", { sprite = "dot", hit = { box = { 4, 4 } } })
on.leave(function() error("boo") end)
task.go(function() wait(1) enemy.spawn { kind = "e", x = -500, y = 0 } end)
LUA
expect_error 'error in a handler' 2 'main.lua:2: boo' "$curtain" hash bad --frames 5
rm -rf bad

# ---- demos ----

"$curtain" hash g --frames 200 --record a.demo >/dev/null 2>&1 || not_ok 'a demo is recorded'
cp -r g else
sed -i 's/"probe"/"else"/' else/rom.lua
usage_errors 2 <<'END'
hash else --demo a.demo|a.demo: demo for another game ("probe"; this game is "else")
hash g --demo none.demo|none.demo: no such file
hash g --demo g/rom.lua|g/rom.lua: not a demo
END
cp -r g later
echo '-- later' >>later/main.lua
expect_error 'demo of another build plays' 0 \
    'curtain: a.demo: recorded with another game version; playback may diverge' "$curtain" hash later --demo a.demo
size=$(stat -c %s a.demo)
head -c $((size - 90)) a.demo >cut.demo
expect_error 'a demo cut short plays as far as it goes' 0 \
    'curtain: cut.demo: truncated (no end mark); playing the first 180 frames' "$curtain" hash g --demo cut.demo
expect_error 'good and bad demos in one go' 2 'curtain: none.demo: no such file' "$curtain" verify g a.demo none.demo
same 'and the good one is checked' 'a.demo: holds, 200 frames' "$(cat out)"

# ---- words ----

# test_cli.c has those that need no game.
usage_errors 2 <<'END'
frobnicate|frobnicate: no such command, file or folder (see curtain help)
render g|render needs --frames (see curtain help render)
render g --frames 1:5:0|--frames: expected frames from 0 to 8388608, as in 600 or 1,60,600 or 0:600:60, got "1:5:0"
hash g --frames 1,2|--frames: hash takes one number, the number of frames to run
verify g a.demo -0|--null works only with names from standard input: verify ROM -
verify --bisect a.demo a.demo a.demo|verify --bisect: expected two outputs of curtain hash
hash g --trace input,bulets|--trace: unknown part "bulets" (did you mean "bullets"?)
hash g --trace input,|--trace: unknown part "" (hash --parts lists all parts)
verify --bisect - -|verify --bisect: only one of the outputs can be standard input
hash g --dip coin=one|--dip: unknown DIP switch "coin" (did you mean "coins"?)
hash g --dip coins=oen|--dip: coins: unknown value "oen" (did you mean "one"?)
hash g --dip coins=two|--dip: coins: unknown value "two" (expected free or one)
hash g --dip ships=10|--dip: ships: expected a whole number from 1 to 9, got "10"
hash g --dip ships=99999999999999999999|--dip: ships: expected a whole number from 1 to 9, got "99999999999999999999"
hash g --difficulty hrd|--difficulty: unknown difficulty "hrd" (did you mean "hard"?)
hash g --difficulty insane|--difficulty: unknown difficulty "insane" (expected easy, normal or hard)
help pakc|help: unknown command "pakc" (did you mean pack?)
help lua pattrn.ring|help lua: no entry for "pattrn.ring" (did you mean pattern.ring?)
help lua hud.bnaks|help lua: no entry for "hud.bnaks" (did you mean hud.banks?)
END
# ---- stages ----

game s <<LUA
player.def("p", { sprite = "dot", hit = { circle = 1 }, registers = { bombs = 2, power = 0 } })
enemy.def("e", { sprite = "dot", hit = { box = { 4, 4 } } })
boss.def("queen", { title = "Q", kind = "e", x = 32, y = 20, \
phases = { { id = "bloom", hp = 9, time = 60, run = function(e) wait(forever) end } } })
stage.def("one", function() stage.at(10) stage.mark("guard") stage.at(60) end)
stage.def("ever", function() while enemy.count() == 0 do wait(1) end end)
boot.run { stages = { "one" }, players = { "p" } }
LUA
for start in one one:guard queen/bloom; do
    expect_error "--stage $start" 0 '' "$curtain" hash s --stage $start --frames 20
done
while IFS='|' read -r start text; do
    expect_error "--stage $start" 2 "$text" "$curtain" hash s --stage $start --frames 20
done <<'END'
oen|main.lua:6: boot.run: unknown stage "oen" (did you mean "one"?)
one:gurad|main.lua:6: stage one: unknown mark "gurad" (did you mean "guard"?)
one:middle|main.lua:6: stage one: unknown mark "middle" (known: guard)
quene/bloom|main.lua:6: boot.run: unknown boss "quene" (did you mean "queen"?)
queen/bloon|main.lua:6: boot.run: unknown phase "bloon" (did you mean "bloom"?)
ever:on|main.lua:5: wait: more than 100000 waits while skipping to a mark (waiting for something that is skipped?)
one --register bombz=1|main.lua:6: --register: ship "p" has no register "bombz" (did you mean "bombs"?)
one --register speed=1|main.lua:6: --register: ship "p" has no register "speed" (known: bombs, power)
END
expect_error 'a game without stages' 2 '--stage: cannot start at "one", because main.lua does not call boot.run' \
    "$curtain" hash g --stage one
# by_difficulty: by names, by a list, both; the nearest easier one, else the easiest.
game d <<'LUA'
task.go(function()
  print(by_difficulty { easy = 1, hard = 3 }, by_difficulty { hard = 3 }, by_difficulty { 7, 8 },
    by_difficulty { 4, 5, 6 })
  wait(1)
  print(by_difficulty { 1, 2, 3, 4 })
end)
LUA
while read -r difficulty values; do
    same "by_difficulty on $difficulty" "$values" \
        "$("$curtain" hash d --difficulty $difficulty --frames 1 --every 1 2>&1 >/dev/null | tr '\t' ' ' | head -n 1)"
done <<'DIFFICULTIES'
easy 1 3 7 4
normal 1 3 8 5
hard 3 3 8 6
DIFFICULTIES
refuse "more values than difficulties" "main.lua:5: by_difficulty: got 4 values for 3 difficulties" "$curtain" \
    hash d --frames 3

expect_error 'lives, registers, invincible' 0 '' "$curtain" hash s --stage one --lives 9 --register power=4 \
    --register bombs=0 --invincible --frames 20
usage_errors 2 <<END
hash s --stage ?|--stage: expected NAME, NAME:MARK or BOSS/PHASE, got "?"
hash s --stage $(printf '%064d' 0)|--stage: longer than 63 characters
hash s --lives 3|--lives needs --stage: it applies only to practice starts
hash s --register power=3|--register needs --stage: it applies only to practice starts
hash s --invincible|--invincible needs --stage: it applies only to practice starts
hash s --stage one --lives 100|--lives: expected a whole number from 1 to 99, got "100"
hash s --stage one --register power=1 --register power=2|--register: power is given twice
hash s --stage one --register power=2147483648|--register: power: expected a whole number from -2147483647 to \
2147483647, got "2147483648"
hash s --stage one --register $(printf '%032d' 0)=1|--register: name longer than 31 characters
hash s --stage one $(printf -- '--register r%d=1 ' {1..17})|--register: given more than 16 times
END

# ---- what others wrote ----

# Names and texts that a terminal would obey: ESC, a newline, CSI in UTF-8.
nasty=$(printf 'a\033[31m\nb\302\233c')
obeyed() { LC_ALL=C grep -qP '[\x00-\x08\x0b-\x1f\x7f]|\xc2[\x80-\x9f]' out err; }
quiet() { # NAME LINES ARGUMENT...
    local name=$1 lines=$2
    shift 2
    "$curtain" "$@" >out 2>err </dev/null
    check "$name: nothing for the terminal" eval '! obeyed'
    same "$name: lines" "$lines" "$(cat out err | wc -l)"
}
cp -r g "$nasty"
mkdir "$nasty/demos"
"$curtain" hash g --frames 70 --record "$nasty/demos/$nasty.demo" >/dev/null
quiet 'verify of such names' 1 verify g "$nasty/demos/$nasty.demo"
quiet 'no such name' 1 hash "$nasty/none"
quiet 'check of such names' 4 check "$nasty"
"$curtain" hash g --frames 3 >"$nasty/one" && sed '4s/ .*/ 0123456789abcdef/' "$nasty/one" >"$nasty/two"
quiet 'bisect of such names' 2 verify --bisect "$nasty/one" "$nasty/two"
quiet 'such words' 1 "$nasty"
printf 'print("a\\27[31mb\\194\\155c\\rd") %s' "$(idle)" >"$nasty/main.lua"
rm -r "$nasty/demos"
quiet 'what a game prints' 3 hash "$nasty" --frames 1
printf 'error("a\\27[31m\\nb\\194\\155c", 0)' >"$nasty/main.lua"
quiet 'what a game raises' 1 hash "$nasty" --frames 1
quiet 'with its traceback' 6 hash "$nasty" --frames 1 -v

# ---- disks ----

touch file
usage_errors 3 <<'END'
render g --frames 1 -o file|file/000001.png: cannot be written (Not a directory)
render g --frames 1 --sheet file/a.png|file/a.png: cannot be written (Not a directory)
pack g -o file/a.rom|file/a.rom: cannot be written (Not a directory)
hash g --frames 2 --record file/a.demo|file/a.demo: cannot be written (Not a directory)
unpack g file|file/lumps/gfx/dart: cannot be written (Not a directory)
END
input_error 'unpack over files' 'g/main.lua: already exists' unpack g.rom g
for command in 'list g' 'pack g -o full.rom' 'hash g --frames 1' 'help' 'version' 'check g' 'verify g a.demo'; do
    line=$("$curtain" $command 2>&1 >/dev/full)
    same "standard output is full: $command" '3 curtain: cannot write to standard output' "$? $line"
done

if small_disk full size=256k; then
    cp g.rom full/a.rom
    cp a.demo full/a.demo
    "$curtain" render g --frames 1 -o full 2>/dev/null
    cp full/000001.png picture
    cp full/000001.png full/a.png
    dd if=/dev/zero of=full/filler bs=1k >/dev/null 2>&1
    usage_errors 3 <<'END'
pack later -o full/a.rom|full/a.rom: cannot be written (No space left on device)
render later --frames 1 -o full|full/000001.png: cannot be written (No space left on device)
render later --frames 1:9 --sheet full/a.png|full/a.png: cannot be written (No space left on device)
hash later --frames 2 --record full/a.demo|full/a.demo: cannot be written (No space left on device)
unpack g full/u|full/u/lumps/gfx/dart: cannot be written (No space left on device)
END
    check 'full disk: the ROM that was there is whole' cmp -s g.rom full/a.rom
    check 'full disk: the demo that was there is whole' cmp -s a.demo full/a.demo
    check 'full disk: the pictures that were there are whole' cmp -s picture full/000001.png
    check 'full disk: and the sheet' cmp -s picture full/a.png
    rm -rf full/u
    same 'full disk: nothing half made is left' '000001.png a.demo a.png a.rom filler' "$(cd full && echo *)"
    # Room for one page: the disk is full in the middle of a recording.
    truncate -s -4096 full/filler
    system_error 'disk full while recording' 'full/long.demo: cannot be written (No space left on device)' \
        hash g --frames 3000 --record full/long.demo
    line=$("$curtain" verify g full/long.demo 2>&1)
    check "what was recorded stays readable ($line)" grep -Eq \
        '^curtain: full/long.demo: truncated: [1-9][0-9]+ frames and no end mark$' <<<"$line"
    "$curtain" hash g --demo full/long.demo --frames 60 >one 2>/dev/null
    "$curtain" hash g --frames 60 >two
    same 'and plays' "$(cat two)" "$(cat one)"
fi
finish
