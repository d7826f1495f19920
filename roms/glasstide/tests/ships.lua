-- ships.lua - every form of every craft hits enemies ahead, has its beads, fires only in green, and
-- clears bullets with its bomb.
local FORMS <const> = { "heron", "heron_lens", "petrel", "petrel_swarm", "tern", "tern_hooks" }
local GREEN <const> = 4
local BANKS <const> = "(function() local t = {} " ..
                      "shot.each(nil, function(s) t[s.bank] = true end) " ..
                      "laser.each(nil, function(l) t[l.bank] = true end) local n = {} " ..
                      "for b in pairs(t) do n[#n + 1] = b end return n end)()"

local function target(run)
  run:exec "bullet.clear() enemy.each(nil, function(e) e:remove() end)"
  run:exec "enemy.spawn { kind = 'float', x = 120, y = 90, hp = 100000, tag = 'foe' }"
end

local function lost(run)
  return 100000 - run:eval "query.near { what = 'enemy', x = 120, y = 90, radius = 40 }[1].hp"
end

for _, form in ipairs(FORMS) do
  local run = test.run { stage = "one@" .. form, invincible = true, frames = 5 }
  test.equal(run:eval "player.get(1).kind", form, "the requested ship")
  target(run)
  run:press("fire,focus")
  run:step(60)
  test.equal(run:eval(BANKS), { GREEN }, form .. ": its shots are green")
  run:step(120)
  test.expect(lost(run) >= 60, form .. ": damage " .. lost(run))
  test.expect(lost(run) <= 400, form .. ": damage not too high, " .. lost(run))

  local bombs = run:eval "player.get(1).bombs"
  run:exec [[for i = 1, 40 do
    bullet.fire { kind = 'orb', x = player.get(1).x, y = player.get(1).y - 20 - i,
                  dir = 9 * i, speed = 0.1 }
  end]]
  local flying = run:live("bullets")
  run:press("bomb@" .. run.frame .. ":" .. run.frame + 2)
  run:step(130)
  test.equal(run:eval "player.get(1).bombs", bombs - 1, form .. ": one bomb is used")
  test.expect(run:live("bullets") < flying // 2, form .. ": and most bullets are cleared")
  test.equal(run.fault, nil, form)
end

-- Two players on the same craft have different colours, on the page that asks for it and in play.
local run = test.run { frames = 5 }
run:press("start@10:11,down@40:41,fire@60:61")
run:step(160)
test.equal(run:eval "{ player.get(1).kind, player.get(2).kind }", { "heron", "heron" }, "same craft")
test.equal(run:eval "player.get(1).picture", nil, "player 1 has the craft's own colour")
test.equal(run:eval "player.get(2).picture", "ember", "player 2 has another")

-- A craft banks a little at first, hard after some frames, and levels out the same way; in focus it never banks hard.
local function pictures(buttons)
  local flight, seen = test.run { stage = "one@heron", invincible = true, frames = 5 }, {}
  flight:press(buttons)
  for _ = 1, 40 do
    flight:step(1)
    local name = flight:eval "player.get(1).picture" or "level"
    if seen[#seen] ~= name then seen[#seen + 1] = name end
  end
  return seen
end
test.equal(pictures "left@10:24", { "level", "left", "hard_left", "left", "level" }, "it banks in steps")
test.equal(pictures "focus,right@10:24", { "level", "right", "level" }, "and gently in focus")
