-- stages/two/duel.lua - helpers for two bosses with separate bars. The one that is left alone gets
-- angry, visibly and audibly.

local pair_of = {} -- the two bosses by name, while a phase runs

local function other(e) return e == pair_of.cinder and pair_of.quench or pair_of.cinder end

-- Is the other boss down? Then rest() is shorter.
local function angry(e)
  local o = other(e)
  return o and (not o.alive or o.hp == 0)
end

local CRIES <const> = { cinder = "cinder_cry", quench = "quench_cry" }

local ABOVE <const> = -48 -- y where a boss that dropped out waits for the next phase

-- A boss whose bar is empty breaks and sinks behind the fight; its body is out of the way at once.
local function drop_out(e, name)
  local image = { x = e.x, y = e.y, sprite = name, bank = e.bank, layer = "back" }
  fx.explode { from = e, size = "large" }
  sound.play("shatter", { from = e })
  e.x, e.y, e.picture = e.x, ABOVE, nil
  local body = sprite.put(image)
  image.sprite = name .. "_broken"
  local wounds = sprite.put(image)
  task.own(body, function()
    for k = 1, forever do
      body.x, body.y = body.x + 0.5 * angle.sin(6 * k), body.y + math.min(k / 24, 3)
      wounds.x, wounds.y = body.x, body.y
      if k % 4 == 0 then spark.burst { kind = "bubbles", from = body, n = 2, radius = 16, speed = 0.6 } end
      if body.y > rom.view.h + 64 then body:remove() end
      wait(1)
    end
  end)
end

-- A boss that is left alone cries out and glows.
local function mourn(e)
  wait(2)
  wait_until(function() return angry(e) end)
  local gone = other(e)
  if gone.alive then drop_out(gone, gone == pair_of.cinder and "cinder" or "quench") end
  sound.play(CRIES[e == pair_of.cinder and "cinder" or "quench"], { from = e })
  screen.shake { size = 2, over = 20 }
  spark.burst { kind = "shock", from = e, speed = 0 }
  while true do
    spark.burst { kind = "ember", from = e, n = 3, dir = 270, spread = 150, speed = 1.4 }
    wait(5)
  end
end

local function rest(e, n) wait(angry(e) and n * 2 // 3 or n) end

-- The run functions for a phase with two bars.
local function pair(cinder, quench)
  local function alone(name, run)
    return function(e)
      pair_of[name] = e
      sound.play(CRIES[name], { from = e })
      task.go(mourn, e)
      run(e)
    end
  end
  return { cinder = alone("cinder", cinder), quench = alone("quench", quench) }
end

return { angry = angry, rest = rest, pair = pair }
