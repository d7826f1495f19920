#!/usr/bin/env bash
# misuse.sh - the commands that make, show and hand over games, given what they cannot use or must not write over: the
# right exit code and one line, nothing half made, and what was there stays as it was.
. "$(dirname "$0")/../tap.sh"
sandbox

"$curtain" new g --from first >/dev/null
"$curtain" pack g -o g.rom
"$curtain" hash g --frames 60 --record a.demo >/dev/null 2>&1
cp -r g kept
cp g.rom kept.rom
cp a.demo kept.demo

# ---- what is read is not written over ----

ln -s g.rom also.rom
usage_errors 2 <<'END'
art g.rom --atlas g.rom|--atlas: g.rom is the game being read; choose another file
art g.rom --atlas also.rom|--atlas: also.rom is the game being read; choose another file
survive g.rom -o g.rom|-o: g.rom is the game being read; choose another file
hash g.rom --frames 2 --record g.rom|--record: g.rom is the game being read; choose another file
hash g.rom --demo a.demo --frames 2 --record ./a.demo|--record: ./a.demo is the demo being played; choose another file
art g --atlas g/art/bullets.png|--atlas: g/art/bullets.png is one of the game's files; choose another one
survive g --map ./g/../g/art/heron.png|--map: ./g/../g/art/heron.png is one of the game's files; choose another one
test g --junit g/tests/first.lua|--junit: g/tests/first.lua is one of the game's files; choose another one
survive g -o g/art/bullets.demo|-o: g/art/bullets.png is one of the game's files; choose another one
survive g --map x -o x|--map: x is also written by -o; choose another file
survive g --map map.png -o ./map.demo|-o: ./map.png is also written by --map; choose another file
END
mkdir pattern && printf 'fire = 1\n' >pattern/list.gpl
input_error 'a palette into what it is read from' \
    '-o: pattern/../pattern/list.gpl is the game being read; choose another file' palette pattern/list.gpl \
    --bank 1 -o pattern/../pattern/list.gpl
ln -s . here
input_error 'two files by a folder that is a link' '--map: here/r.x is also written by -o; choose another file' \
    survive g -o r.x --map here/r.x
check 'all of them are as they were' eval 'diff -r g kept && cmp g.rom kept.rom && cmp a.demo kept.demo'

# ---- what nobody named is not written over, either ----

report() { "$curtain" test g --junit "$1" >/dev/null 2>&1 && "$curtain" test g --junit "$1" >/dev/null 2>&1; }
check 'a JUnit file is written again' report results.xml
echo mine >run.png
cp g/art/bullets.png bullets.kept
input_error 'survive: its picture beside the demo' \
    'run.png: already exists; remove it, or choose another file with -o' \
    survive g -o run.demo
cp -r g h
mv h/art/bullets.png h/art/000001.png
sed -i 's|art/bullets.png|art/000001.png|' h/rom.lua
input_error 'render: a frame in place of a picture of the game' \
    "-o: h/art/000001.png is one of the game's files; choose another folder" \
    render h --frames 1 -o h/art
check 'it is as it was' cmp bullets.kept h/art/000001.png
rm -r h
mkdir film
echo mine >film/000001.png
input_error 'render: a frame in place of somebody'"'"'s file' \
    'film/000001.png: already exists; remove it, or choose another folder with -o' render g --frames 0,1 -o film
check '... but in place of an older frame' "$curtain" render g --frames 0 -o film
same 'it is as it was' mine "$(cat film/000001.png)"
input_error 'render: a sheet in place of a frame' \
    '--sheet: ./000001.png is also the name of a frame file; choose another name' \
    render g --frames 1 -o . --sheet ./000001.png
echo mine >g.rom
input_error 'pack: the default name' 'g.rom: already exists; remove it, or choose another file with -o' pack g
same 'all are as they were' 'mine mine' "$(cat run.png g.rom | xargs)"
check 'and so is the picture' cmp bullets.kept g/art/bullets.png
cp kept.rom g.rom
check 'pack: its own file again' "$curtain" pack g
rm run.png

# ---- exit codes come from what happened, not from the words of a path ----

"$curtain" unpack g.rom /proc/nothing >out 2>err
same 'unpack where nothing can be written: the host, 3' 3 $?


# ---- a demo that names no game, and register ----

mkdir -p far/off
cp a.demo far/off/a.demo
checksum=$("$curtain" verify g a.demo --json | jq -r .recorded.game)
input_error 'a demo without its game' \
    "far/off/a.demo: recorded with the game \"g\" (checksum $checksum), which was not found; \
put the game next to the replay, or name it: curtain play GAME --demo \"far/off/a.demo\"" far/off/a.demo
cp -r g far/g
echo '-- changed' >>far/g/main.lua
input_error 'a demo with another version of its game' "far/off/a.demo: recorded with another version of \
$(sed -n 's/.*title = "\([^"]*\)".*/\1/p' g/rom.lua) (checksum $checksum; $scratch/far/g has \
$("$curtain" hash far/g --frames 1 --record new.demo >/dev/null; "$curtain" verify far/g new.demo --json |
    jq -r .recorded.game)); to play it anyway: curtain play \"$scratch/far/g\" --demo \"far/off/a.demo\"" far/off/a.demo
for option in --seed=1 --resume; do
    input_error "a demo with $option" "${option%%=*} cannot be combined with a.demo: the demo sets it" a.demo $option
done
printf 'CDEM' >bad.demo
usage_errors 2 <<'END'
play bad.demo|bad.demo: not a demo
register --remove|register: this program has no window; use curtain
END
rm -r far new.demo bad.demo

# ---- links, devices, disks ----

ln -s loop loop
system_error 'new in a link to itself' 'loop/README.md: cannot be written (Too many levels of symbolic links)' new loop

mkdir bin film.mp4
cat >bin/ffmpeg <<'SH'
#!/bin/sh
cat >/dev/null
for last; do :; done
[ ! -e broken ] || { echo half >"${last#file:}"; exit 1; }
echo film >"${last#file:}"
SH
chmod +x bin/ffmpeg
PATH=$scratch/bin:$PATH
system_error 'a film in place of a folder' \
    'film.mp4: cannot be written (Is a directory)' capture g --frames 1:2 -o film.mp4
ln -s real.mp4 link.mp4
"$curtain" capture g --frames 1:2 -o link.mp4
same 'a film goes where a link leads' 'real.mp4 film' "$(readlink link.mp4) $(cat real.mp4)"
echo mine | tee song.mp4.part >song.mp4.part.wav
"$curtain" capture g --frames 1:2 -o song.mp4
same "files with the names of a film's temporary ones stay" 'film mine mine 3' \
    "$(cat song.mp4 song.mp4.part song.mp4.part.wav | xargs) $(ls song.mp4* | wc -l)"
ln -s /dev/full full.mp4
system_error 'a film on a full disk' \
    'full.mp4: cannot be written (No space left on device)' capture g --frames 1:2 -o full.mp4
touch broken
system_error 'ffmpeg fails in the middle' 'real.mp4: ffmpeg failed' capture g --frames 1:2 -o real.mp4
same 'the film of before is there, and no half one' 'film real.mp4' "$(cat real.mp4) $(ls real.mp4*)"

if small_disk locked size=64k; then
    mount -o remount,ro locked
    usage_errors 3 <<'END'
new locked/n|locked/n/README.md: cannot be written (Read-only file system)
test g --junit locked/j|locked/j: cannot be written (Read-only file system)
art g --atlas locked/a.png|locked/a.png: cannot be written (Read-only file system)
survive g --frames 200 --effort 1 -o locked/s.demo|locked/s.demo: cannot be written (Read-only file system)
capture g --frames 1:3 -o locked/x.gif|locked/x.gif: cannot be written (Read-only file system)
capture g --frames 1:3 -o locked/x.mp4|locked/x.mp4.part: cannot be written (Read-only file system)
END
fi

# ---- broken off ----

cp -r g heavy
echo 'task.go(function() while true do for i = 1, 300000 do local x = i * i end wait(1) end end)' >heavy/main.lua
# Ctrl+C, once the line is there: the last that the terminal gets takes it away. Three things that depend on how busy
# the machine is and on who runs this are set: a job in the background ignores Ctrl+C, and what it starts does too; the
# terminal echoes ^C, before or after the line is taken away; and it discards output that nobody has read yet.
broken_off() (
    trap '' INT
    python3 - "$curtain" capture heavy -o broken.gif --frames 1:200000 <<'PY'
import os, pty, signal, sys, termios
pid, terminal = pty.fork()
if pid == 0:
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    modes = termios.tcgetattr(0)
    modes[3] = modes[3] & ~termios.ECHO | termios.NOFLSH
    termios.tcsetattr(0, termios.TCSANOW, modes)
    os.execv(sys.argv[1], sys.argv[1:])
seen, pressed = b"", False
while True:
    try:
        got = os.read(terminal, 4096)
    except OSError:
        break
    if not got:
        break
    seen += got
    if not pressed and b" left" in seen:
        os.write(terminal, b"\x03")
        pressed = True
status = os.waitpid(pid, 0)[1]
assert os.WIFSIGNALED(status) and os.WTERMSIG(status) == 2, status
assert seen.endswith(b"\r\033[K"), seen[-80:]
PY
)
check 'Ctrl+C takes the line of progress away' broken_off
same 'and leaves no half film' '' "$(ls | grep broken.gif)"
finish
