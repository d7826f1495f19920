-- A game from its title to its scores with screens of its own, and what boot.run and mission.def refuse.
player.def('heron', { sprite = 'dot', hit = { circle = 2 }, registers = { bombs = 3, chain = 0 } })
player.def('tern', { sprite = 'wink', hit = { circle = 2 } })
enemy.def('crab', { sprite = 'dot', hit = { circle = 6 } })
boss.def('king', {
  title = 'King', kind = 'crab', x = 9, y = 9,
  phases = { { id = 'bow', hp = 9, time = 9, run = print } },
})
stage.def('one', function()
  wait(20)
  score.add(500)
end)
stage.def('two', function() wait(20) end)
local function nothing() end
local function start()
  wait(1)
  return 'start', 1
end

--case: what a game's own screens are called with, and that their answers are taken
local rounds = 0
local own = {}
function own.title(limit, list, last)
  rounds = rounds + 1
  wait(1)
  print('title', limit, #list, list[1], last)
  if rounds > 2 then wait(forever) end
  if rounds == 2 then return 'start', 2 end
end
function own.start(n, lists, last)
  print('start', n, lists.modes[1].name, lists.modes[1].text, lists.difficulties, last.difficulty, last.ships[1])
  print('ships', #lists.ships, lists.ships[2].name, lists.ships[2].text)
  return { mode = 'story', ships = { 'tern', 'heron' } }
end
function own.results(title, players, stopped) print('results', title, players, stopped()) end
function own.ending(run) print('ending', run.mode, run.ship, run.players, run.scores[1], run.clear) end
function own.staff(parts)
  for _, part in ipairs(parts) do print('staff', part[1]) end
end
function own.name(list)
  print('name', #list, list[1].p, list[1].points, list[1].rank)
  return { 'KIT', 'LOU' }
end
function own.scores(name, over, mark)
  print('scores', name, over, mark)
  wait(1)
end
function own.again(run) print('again', run.clear) end
boot.run {
  players = { 'heron', 'tern' },
  modes = { { name = 'story', stages = { 'one' }, text = 'All.' }, { name = 'other', stages = { 'two' } } },
  ships = { tern = { text = 'T' } },
  staff = {
    { 'A' },
    { 'B', when = { ship = 'heron' } },
    { 'C', when = { continues = 0 } },
    { 'D', when = function(run) return not run.clear end },
  },
  screens = own,
}
wait(300)
--> title 600 7 start nil
--> scores normal 360 nil
--> title 600 7 start nil
--> start 2 story All. nil normal nil
--> ships 2 tern T
--> results Stage One Clear 2 nil
--> ending story tern 2 500 true
--> staff A
--> staff C
--> name 1 1 500 1
--> scores normal 360 1
--> again true
--> title 600 7 start start

--case: an opening comes before the title and again where nobody came; the first ending that holds is shown
local rounds = 0
local function title()
  rounds = rounds + 1
  print('title')
  if rounds > 2 then wait(forever) end
  wait(1)
  if rounds == 2 then return 'start' end
end
local function say(word, answer)
  return function(run)
    print(word, run.ship)
    return answer
  end
end
boot.run {
  stages = { 'one' },
  players = { 'heron' },
  staff = { { 'X' } },
  opening = function()
    print('opening')
    wait(10)
  end,
  screens = {
    title = title,
    results = nothing,
    staff = say('staff'),
    name = function() return { 'A' } end,
    scores = nothing,
    again = nothing,
  },
  ending = {
    { when = { difficulty = 'none' }, show = say('wrong') },
    { when = { players = 2 }, show = say('wrong') },
    { when = function(run) return run.ship == 'tern' end, show = say('wrong') },
    { when = { ship = 'heron', continues = 0 }, show = say('right', false) }, -- false: no staff follows
    { show = say('late') },
  },
}
wait(320)
--> opening
--> title
--> opening
--> title
--> right heron
--> title

--case: an answer of a game's own screen that is none
boot.run {
  stages = { 'one' },
  players = { 'heron', 'tern' },
  screens = { title = start, start = function() return { ships = { 'hreon' } } end },
}
wait(20)
--! main.lua:124: sys.join: unknown player kind "hreon" (did you mean "heron"?)

--load: arguments of boot.run
boot.run { stages = { 'oen' }, players = { 'heron' } }
--! boot.run: unknown stage "oen" (did you mean "one"?)
boot.run { stages = { 'one' }, players = { 'heron' }, screen = {} }
--! boot.run: unknown argument "screen" (did you mean "screens"?)
boot.run { stages = { 'one' }, players = { 'heron' }, screens = { titel = print } }
--! boot.run: unknown screen "titel" (did you mean "title"?)
boot.run { stages = { 'one' }, players = { 'heron' }, screens = { title = 'mine' } }
--! boot.run: screen title: expected a function, got string
boot.run { stages = { 'one' }, players = { 'heron' }, screens = { ship = print } }
--! boot.run: the screen "ship" was replaced by "start", which chooses mode, difficulty and ships
boot.run { stages = { 'one' }, players = { 'heron' }, how_to_play = { 'mvoe' } }
--! boot.run: unknown page of how_to_play: "mvoe" (did you mean "move"?)
boot.run { stages = { 'one' }, players = { 'heron' }, how_to_play = { { title = 'GO' } } }
--! boot.run: how_to_play: page 1: text: expected a string, got nil
boot.run { stages = { 'one' }, players = { 'heron' }, how_to_play = { { title = 'GO', text = 'Go.', button = 'fre' } } }
--! boot.run: unknown button of how_to_play: "fre" (did you mean "fire"?)
boot.run { players = { 'heron' }, modes = {} }
--! boot.run: modes: expected a list of at least one mode, got none
boot.run { players = { 'heron' }, modes = { { stages = { 'one' } } } }
--! boot.run: mode 1: name: expected a string, got nil
boot.run { players = { 'heron' }, modes = { { name = 'a', stage = 'one' } } }
--! boot.run: unknown argument of a mode: "stage" (did you mean "stages"?)
boot.run { stages = { 'one' }, players = { 'heron' }, difficulties = { nromal = 'x' } }
--! boot.run: unknown difficulty "nromal" (did you mean "normal"?)
boot.run { stages = { 'one' }, players = { 'heron' }, difficulties = { normal = 1 } }
--! boot.run: difficulty normal: expected a string, got number
boot.run { stages = { 'one' }, players = { 'heron' }, ships = { heran = {} } }
--! boot.run: unknown ship "heran" (did you mean "heron"?)
boot.run { stages = { 'one' }, players = { 'heron' }, ships = { heron = { figures = { { 'RANGE', 9 } } } } }
--! boot.run: ship heron: figures: expected a list of { "Range", 0 to 5 }, got another
boot.run { stages = { 'one' }, players = { 'heron' }, ships = { heron = { forms = {} } } }
--! boot.run: ship heron: forms: expected a list of at least one form, got none
boot.run { stages = { 'one' }, players = { 'heron' }, ships = { heron = { forms = { 'heron' } } } }
--! boot.run: ship heron: form 1: expected a table, got string
boot.run { stages = { 'one' }, players = { 'heron' }, ships = { heron = { forms = { { kind = 'hreon' } } } } }
--! boot.run: ship heron: form 1: unknown player "hreon" (did you mean "heron"?)
boot.run { stages = { 'one' }, players = { 'heron' }, ending = 5 }
--! boot.run: ending: expected a function or a list, got number
boot.run { stages = { 'one' }, players = { 'heron' }, ending = { { when = { shpi = 'heron' }, show = print } } }
--! boot.run: unknown condition of an ending: "shpi" (did you mean "ship"?)
boot.run { stages = { 'one' }, players = { 'heron' }, opening = 5 }
--! boot.run: opening: expected a function, got 5
boot.run { stages = { 'one' }, players = { 'heron' }, staff = { 'me' } }
--! boot.run: staff 1: expected a list of strings such as { "Art", "A. Name" }, got string
boot.run { stages = { 'one' }, players = { 'heron' }, staff = { { 'me', when = 5 } } }
--! boot.run: staff 1: when: expected a table, got number
boot.run { stages = { 'one' }, players = { 'heron' }, demos = { 5 } }
--! boot.run: demos: 1: expected a string, got number
boot.run { stages = { 'one' }, players = { 'heron' }, pages = { 3 } }
--! boot.run: page 1: expected a table such as { name = "how to score", show = f }, got number
boot.run { stages = { 'one' }, players = { 'heron' }, pages = { { show = print } } }
--! boot.run: page 1: name: expected a string, got nil
boot.run { stages = { 'one' }, players = { 'heron' }, pages = { { name = 'music', show = print } } }
--! boot.run: page 1: "music" is used twice
boot.run { stages = { 'one' }, players = { 'heron' }, pages = { { name = 'a', shows = print } } }
--! boot.run: unknown argument of a page: "shows" (did you mean "show"?)
boot.run { stages = { 'one' }, players = { 'heron' }, pause = { 3 } }
--! boot.run: pause 1: expected a table such as { "Map", show_map }, got number
boot.run { stages = { 'one' }, players = { 'heron' }, pause = { { print } } }
--! boot.run: pause 1: label: expected a string, got function
boot.run { stages = { 'one' }, players = { 'heron' }, pause = { { 'MAP', 5 } } }
--! boot.run: pause "MAP": expected a function, got number
boot.run { stages = { 'one' }, players = { 'heron' }, pause = { 1, 2, 3, 4, 5, 6, 7, 8, 9 } }
--! boot.run: pause: expected at most 8 entries, got 9
boot.run { stages = { 'one' }, players = { 'heron' }, grades = 3 }
--! boot.run: grades: expected a function, got 3

--load: arguments of mission.def
mission.def('a', { title = 'A', clear = true })
--! mission.def: expected either stage (and mark, to) or boss (and phase)
mission.def('a', { title = 'A', stage = 'one', boss = 'king', clear = true })
--! mission.def: expected either stage (and mark, to) or boss (and phase)
mission.def('a', { title = 'A', stage = 'one', phase = 'bow', clear = true })
--! mission.def: phase: only with boss
mission.def('a', { title = 'A', boss = 'king', to = 'bow', clear = true })
--! mission.def: to: only with stage
mission.def('a', { title = 'A', stage = 'one' })
--! mission.def: expected a goal, or clear = true
mission.def('a', { title = 'A', stage = 'one', goal = {} })
--! mission.def: goal: expected { NAME = n, .. }, got none
mission.def('a', { title = 'A', stage = 'one', goal = 5 })
--! mission.def: goal: expected { NAME = n, .. } or a function, got integer
mission.def('a', { title = 'A', stage = 'one', goal = { chain = 1.5 } })
--! mission.def: goal: expected { NAME = n, .. } with whole numbers
mission.def('a', { title = 'A', stage = 'one', clear = true, medals = { 5 } })
--! mission.def: medals: expected 2 values, got 1

--load: what boot.run finds in missions
mission.def('a', { title = 'A', stage = 'one', goal = { chian = 5 } })
boot.run { stages = { 'one' }, players = { 'heron' } }
--! main.lua:221: mission.def: unknown count "chian" (did you mean "chain"?)
mission.def('a', { title = 'A', stage = 'oen', clear = true })
boot.run { stages = { 'one' }, players = { 'heron' } }
--! main.lua:224: mission.def: unknown stage "oen" (did you mean "one"?)
mission.def('a', { title = 'A', boss = 'king', phase = 'bew', clear = true })
boot.run { stages = { 'one' }, players = { 'heron' } }
--! main.lua:227: mission.def: unknown phase "bew" (did you mean "bow"?)
mission.def('a', { title = 'A', stage = 'one', clear = true, ship = 'tern' })
boot.run { stages = { 'one' }, players = { 'heron' } }
--! main.lua:230: mission.def: unknown ship "tern" (did you mean "heron"?)
mission.def('a', { title = 'A', stage = 'one', clear = true, registers = { bmobs = 1 } })
boot.run { stages = { 'one' }, players = { 'heron' } }
--! main.lua:233: mission.def: unknown register "bmobs" (did you mean "bombs"?)
