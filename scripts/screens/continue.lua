-- screens/continue.lua - shall player p go on? Ten seconds, shorter by one with each bomb.
local SECONDS = 9

-- left: how many continues there are. Returns true for yes.
return function(p, left)
  local row, frame = hud.rows // 2 - 3, 0
  hud.centre(row, text.lang("PLAYER %d"):format(p), hud.banks.faint)
  hud.centre(row + 1, "CONTINUE?", hud.banks.bright)
  hud.centre(row + 5, text.lang("START: %d LEFT"):format(left))
  while frame < (SECONDS + 1) * 60 do
    hud.centre(row + 3, tostring(SECONDS - frame // 60), hud.banks.bright)
    wait(1)
    frame = frame + 1
    if pad.take("bomb", 0, p) then frame = (frame // 60 + 1) * 60 end
    if pad.take("start", 0, p) then break end
  end
  text.clear { col = 0, row = row, w = hud.cols, h = 6 }
  return frame < (SECONDS + 1) * 60
end
