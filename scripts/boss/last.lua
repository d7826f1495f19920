-- boss/last.lua - a last phase: a hit ends it, and costs no life.
local SAFE <const> = 90 -- frames a player is safe then

on.hit(function(p)
  local fight = boss.status()
  if not (fight and fight.phase and fight.phase.last) then return end
  fight.missed, fight.hit = true, true
  p.safe = SAFE
end)

return true
