-- Dialogue: speakers, lines and choices, and where they can be used.
--board: sprites=32
talk.def('iri', { name = 'I', faces = { calm = 'dot' } })
bullet.def('b', { sprite = 'dot', hit = { circle = 3 } })
local start
local function def_stage(name, options)
    stage.def(name, function()
        start = board.frame()
        bullet.fire { kind = 'b', x = 100, y = 100, speed = 0 }
        talk.run(function() wait(30) end, options)
        local left = bullet.group().count
        stage.at(40)
        print(left, board.frame() - start)
    end)
end
def_stage 'still'
def_stage('moving', { clock = true, clear = false })
stage.def('marked', function()
    talk.run(function() print 'called' end)
    say('iri', 'A')
    print('chosen', choose({ 'A', 'B' }, { chosen = 2 }))
    stage.mark 'm'
    print(board.frame() - start)
end)

--each: lines
say('irl', 'A')
--! say: unknown speaker "irl" (did you mean "iri"?)
say('iri', 'A', { face = 'calmer' })
--! say: "iri": unknown face "calmer" (did you mean "calm"?)
say('iri')
--! say: text: expected a string, got nil
say('iri', 'A', { side = 'center' })
--! say: side: expected left or right, got "center"

--each: choices
choose {}
--! choose: list: expected at least one string
choose { 'A', title = 'T' }
--! choose: list: expected strings, got the key "title"; options go in a second table
choose { 'A', 2 }
--! choose: list: entry 2: expected a string, got a number
choose({ 'A' }, { chosen = 2 })
--! choose: chosen: expected a number from 1 to 1, got 2

--case: a talk in a talk
talk.run(function() talk.run(print) end)
--! talk.run: a talk is already running; call `say` and `choose` in it (a phase { talk = f } runs f as a talk)

--case: two tasks speak in one box
task.go(say, nil, 'A')
task.go(say, nil, 'B')
wait(3)

--load: speakers
talk.def('a', {})
--! talk.def: name: expected a string, got nil
talk.def('a', { name = 'A', faces = { calm = 'dto' } })
--! talk.def face: unknown sprite "dto" (did you mean "dot"?)
talk.def('iri', { name = 'A' })
--! talk.def: "iri" is declared twice
talk.def('a', { name = 'A', faces = { 'dot' } })
--! talk.def: faces: expected names as keys, as in { calm = SPRITE }
say(nil, 'A')
--! talk.run: only a task can talk; start one with task.go

--case: a stage's clock stops during a talk, and bullets are cleared
stage.play('still', string.sys.scope())
wait(90)
--> 0 70

--case: or not
stage.play('moving', string.sys.scope())
wait(90)
--> 1 40

--case: on the way to a mark no talk is run, a line takes no time, a choice is what it would start with
start = board.frame()
stage.play('marked', string.sys.scope(), 'm')
wait(9)
--> chosen 2
--> 0
