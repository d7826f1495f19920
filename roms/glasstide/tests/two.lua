-- two.lua - the works: every phase of both bosses begins and fires on each difficulty, there is room for all of it, and
-- what flies, in the stage as well, keeps to the colours that creatures and shots leave to bullets.
local DIFFICULTIES <const> = { "easy", "normal", "hard", "abyss" }
local ALLOWED <const> = { [0] = true, [5] = true, [6] = true, [7] = true }
local phases = {
  bellows = { "breath", "draught", "wheels" },
  eels = { "both", "furnace", "panes", "crossing", "press" },
}

-- The banks of all that flies, each as a letter.
local BANKS <const> = [[(function()
  local seen, list = {}, {}
  bullet.each(nil, function(b) seen[b.bank] = true end)
  laser.each(nil, function(l) if not l.by then seen[l.bank] = true end end)
  for bank = 0, 15 do if seen[bank] then list[#list + 1] = ("%x"):format(bank) end end
  return table.concat(list)
end)()]]

local function colours(run, what)
  for digit in run:eval(BANKS):gmatch "." do
    local bank = tonumber(digit, 16)
    test.expect(ALLOWED[bank], what .. ": a bullet in bank " .. bank)
  end
end

local function watch(boss, phase, difficulty)
  local run = test.run { stage = boss .. "/" .. phase, difficulty = difficulty, seed = 1,
                         invincible = true, frames = 240 }
  local what = ("%s/%s, %s"):format(boss, phase, difficulty)
  local began = run:moment("phase", phase)
  test.expect(began and began.of == boss, what .. ": the phase has begun")
  local most = 0
  for _ = 1, 6 do
    most = math.max(most, run:live("bullets") + run:live("lasers"))
    colours(run, what)
    run:step(70)
  end
  test.expect(most > 0, what .. ": something flies")
  test.equal(run:refused("bullets") + run:refused("lasers") + run:refused("laser_points"), 0,
             what .. ": there was room")

end

for boss, list in pairs(phases) do
  for _, phase in ipairs(list) do
    for _, difficulty in ipairs(DIFFICULTIES) do watch(boss, phase, difficulty) end
  end
end

-- The whole of it, with fire held, on the hardest.
local run = test.run { stage = "two", difficulty = "abyss", seed = 1, invincible = true, pads = "fire" }
while run.frame < 24000 and not run:moment("clear", "two") do
  run:step(120)
  colours(run, "the stage, frame " .. run.frame)
end
test.expect(run:moment("phase", "breath"), "the Bellows has come")
test.expect(run:moment("phase", "press"), "the eels have come")
test.equal(run:refused("bullets") + run:refused("enemies"), 0, "the stage has room")

-- One eel is down, and the fight goes on; both, and it is over.
local duel = test.run { stage = "eels/both", seed = 1, invincible = true, frames = 200 }
duel:exec "enemy.each(nil, function(e) if e.kind == 'cinder' then e:hurt(4000) end end)"
duel:step(5)
test.equal(duel:moment("won"), nil, "the other one goes on")
duel:exec "enemy.each(nil, function(e) if e.kind == 'quench' then e:hurt(4000) end end)"
duel:step(5)
test.expect(duel:moment("won", "both"), "the phase is beaten")

-- A pane breaks into shards where shots hit it.
local cast = test.run { stage = "eels/panes", seed = 1, invincible = true, frames = 260 }
local panes = cast:eval "bullet.group('pane').count"
test.expect(panes > 3, "panes hang in a row")
cast:exec "bullet.each('pane', function(b) b.hp = 1 end)"
cast:press("fire")
cast:step(90)
test.expect(cast:eval "query.box { what = 'bullet', x = 120, y = 160, w = 240, h = 320 }[1] ~= nil", "shards fly")
