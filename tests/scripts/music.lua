-- Arguments of music and sound, and what music says of itself. tests/machine/test_music.c hears when pieces play.
--board: sound
player.def('ship', { sprite = 'dot', hit = { circle = 1 } })
stage.def('s', print)

--load: any number of calls
for i = 1, 2000 do sound.play('boom', { pitch = i % 97 - 48, pan = i % 3 - 1, volume = i % 2 }) end
for i = 1, 500 do
  music.play(i % 2 == 0 and 'tide' or 'deep', { back = i % 3 == 0, again = i % 5 == 0, fade = i % 7 })
end
music.stop { fade = 3600 }
music.stop()
music.stop()
sound.stop()
sound.stop('bell')
print(music.volume(0, 3600), music.volume(1), music.frames(65536))
--> 1.0 1.0 1966080

--case: results
music.play('tide')
print(music.wait(), music.name(), music.marker(), music.bar())
music.volume(0.5)
print(music.volume(0))
--> 1 tide nil 0
--> 0.50001525925474

--load: arguments
music.play('tied', { back = true })
--! music.play: unknown music "tied" (did you mean "tide"?)
music.play('boom')
--! music.play: unknown music "boom" (rom.lua declares it in `sounds`)
music.play('tide', { at = 'bear' })
--! music.play: at: expected "beat" or "bar", got "bear"
music.play('tide', { at = 'bar', fade = 9 })
--! music.play: expected either `at` or `fade`, got both
music.play('tide', { fade = 3601 })
--! music.play: fade: expected a whole number from 0 to 3600 frames, got 3601
music.volume(0.5, 0.5)
--! music.volume: over: expected a whole number from 0 to 3600 frames, got 0.5
music.frames(0/0)
--! music.frames: beats: expected a number from 0 to 65536, got nan
sound.play('boom', { pitch = 1e9 })
--! sound.play: pitch: expected a number from -48 to 48 semitones, got 1000000000.0
sound.stop('tide')
--! sound.stop: unknown sound "tide" (rom.lua declares it in `music`)
stage.def('t', print, { music = 'dep' })
--! stage.def: unknown music "dep" (did you mean "deep"?)
boss.def('b', { title = 'B', music = 3, phases = {} })
--! boss.def: music: expected a music name, got 3
talk.def('iri', { name = 'IRI', voice = 'hut' })
--! talk.def: unknown sound "hut" (did you mean "hit"?)
unlock.def('u', { when = { heard = 'tides' } })
--! unlock.def when: unknown music "tides" (did you mean "tide"?)

--each: in a task
music.wait(1 << 40)
--! music.wait: n: expected a whole number from 1 to 65536 beats, got 1099511627776
say(nil, 'A', { voice = 'bel' })
--! say: unknown sound "bel" (did you mean "bell"?)

--load: music of boot.run
boot.run { stages = { 's' }, players = { 'ship' }, music = { titel = 'tide' } }
--! boot.run: unknown music screen "titel" (did you mean "title"?)
boot.run { stages = { 's' }, players = { 'ship' }, music = { title = 'tidy' } }
--! boot.run music: unknown music "tidy" (did you mean "tide"?)
boot.run { stages = { 's' }, players = { 'ship' }, music = { 'tide' } }
--! boot.run: music: entry 1: expected a table such as { name = "tide" }, got a string
boot.run { stages = { 's' }, players = { 'ship' }, music = { { nam = 'deep' } } }
--! boot.run music: unknown argument "nam" (did you mean "name"?)
boot.run { stages = { 's' }, players = { 'ship' }, music = { { name = 'deep' }, room = true } }
--! boot.run: music: expected `room = true` or a list of pieces, got both
boot.run { stages = { 's' }, players = { 'ship' }, music = { { name = 'deep', needs = 'all' } } }
--! boot.run: unknown unlock "all" (known: none)
