#!/usr/bin/env bash
# record.sh - games whose sound is recordings: what packs, what curtain sound says of it, that it sounds the same
# everywhere, what is refused with which place, and a program without the libraries.
. "$(dirname "$0")/../tap.sh"
sandbox

seeds=$repo/tests/fuzz/seeds/fuzz_recording
check "the example packs" "$curtain" pack "$repo/examples/tape" -o tape.rom
same "the list, with the bytes of a stream's samples" "sound hit: 0.32 s, 14 KB, recording, tracks 1, limit 2
sound kill: 0.82 s, 10 KB, recording, tracks 1, limit 3
music reel: 16.00 s, loop 12.00 s, 390 KB, recording, tracks 2, markers 2, The Reel" \
    "$("$curtain" sound tape.rom | sed 's/peak .* LUFS, //; s/\([0-9]*\)[0-9]\{3\} bytes/\1 KB/')"

mkdir -p g/music
cp "$seeds"/* g/music
echo 'music.play("a")' >g/main.lua
rom() { echo "return { id = \"g\", title = \"g\", music = { $1 } }" >g/rom.lua; }
packs() { rom "$1"; "$curtain" pack g -o g.rom && "$curtain" sound g.rom; }

for f in stereo.wav loop.ogg loop.flac mono.opus tiny.mod tiny.xm; do
    check "$f packs" packs "a = { file = 'music/$f' }"
done

# Of FLAC, which is lossless, every machine packs the same bytes.
wave_of() { # ENTRY
    rom "a = { file = 'music/loop.flac', tempo = 240$1 }"
    "$curtain" pack g -o g.rom >/dev/null
    "$curtain" list g.rom | grep wave/
}
same "as ADPCM" "wave/a 2592 9eb7e709" "$(wave_of '')"
same "as 16 bits" "wave/a 9632 bc89c73c" "$(wave_of ', exact = true')"

# What a tick can read: the beat, not the samples.
rom "a = { file = 'music/loop.flac', loop = { start = 0, length = 2400 } }"
"$curtain" pack g -o one.rom
rom "a = { file = 'music/loop.ogg', loop = { start = 0, length = 2400 } }"
"$curtain" pack g -o two.rom
hash_of() { "$curtain" list "$1" | grep "^game"; }
check "other samples of the same length are the same game" cmp <(hash_of one.rom) <(hash_of two.rom)
rom "a = { file = 'music/loop.flac', loop = { start = 0, length = 2400 }, tempo = 100 }"
"$curtain" pack g -o two.rom
refuse "another tempo is another" differ cmp <(hash_of one.rom) <(hash_of two.rom)

bad() { # NAME WORDS MUSIC
    rom "$3"
    refuse "$1" "$2" "$curtain" pack g -o g.rom
}
head -c 2000 "$seeds/loop.ogg" >g/music/cut.ogg
bad "a file that was cut off" 'music/cut.ogg: the page at byte ' "a = { file = 'music/cut.ogg' }"
echo hello >g/music/text.xm
bad "no module" 'music/text.xm: libopenmpt does not recognise this file, or the file is damaged' \
    "a = { file = 'music/text.xm' }"
bad "a loop that is not in it" "music/loop.flac: the loop from frame 100 to 3100 is not inside its 2400 frames" \
    "a = { file = 'music/loop.flac', loop = { start = 100, length = 3000 } }"
bad "a marker behind the end" 'music/loop.flac: marker "drop", at beat 4, is after the end, at beat 0.40' \
    "a = { file = 'music/loop.flac', tempo = 120, markers = { drop = 4 } }"

# What check measures: three seconds at 8,000 frames of a sine of 250 Hz, with one thing wrong each.
wav() { # PYTHON: an expression of t, in seconds; a WAV file of 16 bits
    python3 -c "
import math, struct, sys
x = [max(-32768, min(32767, round(32767 * ($1)))) for i in range(24000) for t in [i / 8000]]
sys.stdout.buffer.write(b'RIFF' + struct.pack('<I', 36 + 2 * len(x)) + b'WAVEfmt ' +
                        struct.pack('<IHHIIHH', 16, 1, 1, 8000, 16000, 2, 16) +
                        b'data' + struct.pack('<I', 2 * len(x)) + struct.pack('<%dh' % len(x), *x))"
}
sine='math.sin(2 * math.pi * 250 * t)'
finds() { # NAME WORDS WAV ENTRY
    rm -f g/music/*
    wav "$3" >g/music/x.wav
    rom "a = { file = 'music/x.wav'$4 }"
    refuse "check: $1" "$2" "$curtain" check g
}
finds "clipping" 'music/x.wav: 750 samples clip, the first at 1.001 s: the recording itself is too loud' \
    "(1.06 if 1 <= t < 1.5 else 0.5) * $sine" ''
finds "an offset" 'music/x.wav: its mean is 5.0 % of full scale (DC offset)' "0.05 + 0.5 * $sine" ''
finds "a click at the loop" \
    "music/x.wav: its loop clicks: from the loop's end (3.000 s) to its start (1.001 s), the signal jumps by" \
    "0.5 * $sine" ', loop = { start = 8008 }'
finds "a loop that is no whole number of beats" \
    'music/x.wav: its loop is 2.97 beats long at tempo 89, so music.beat drifts away' \
    "0.5 * $sine" ', loop = { start = 1, unit = "seconds" }, tempo = 89'
wav "0.5 * $sine" >g/music/x.wav
cp "$seeds/mono.flac" g/music/
rom "a = { file = 'music/x.wav', loop = { start = 8000 }, tempo = 90 }, b = { file = 'music/x.wav' }"
refuse "check: and a file" 'music/mono.flac: not listed in rom.lua' "$curtain" check g
rm g/music/mono.flac
rom "a = { file = 'music/x.wav', loop = { start = 8000 }, tempo = 90 }"
check "check: and nothing of what is right" "$curtain" check g
cp "$seeds"/* g/music

# A build without shared libraries.
cd "$repo" || exit 2
${CC:-cc} -std=c11 -fwrapv -ffp-contract=off -O1 -w -D_DEFAULT_SOURCE -DWITHOUT_LIBRARIES -o "$scratch/plain" \
    platform/posix_process.c $(find "$OUT/src" -name '*.o') "$OUT"/fb/*.o "$OUT"/gen/std.o \
    "$OUT"/gen/no_rom.o "$OUT"/platform/{null,stdio,posix}.o $(pkg-config --libs lua5.4) -lm -pthread -ldl
cd "$scratch" || exit 2
curtain=$scratch/plain
check "without the libraries WAV packs" packs "a = { file = 'music/loop.wav' }"
without='this build cannot load shared libraries'
bad "OGG is refused" "music/loop.ogg: $without such as libsndfile, which reads OGG and FLAC" \
    "a = { file = 'music/loop.ogg' }"
check "what was packed elsewhere sounds" "$curtain" sound tape.rom reel

# A machine without the libraries: files that are none are in their place.
mkdir none
touch none/libsndfile.so.1 none/libopenmpt.so.0
curtain=$OUT/curtain-null
export LD_LIBRARY_PATH=$scratch/none
bad "a library that is missing is named, with its package" \
    'music/loop.ogg: libsndfile, which reads OGG and FLAC, is not installed (Debian package: libsndfile1)' \
    "a = { file = 'music/loop.ogg' }"
finish
