-- items.lua - n items near the top of the field. DIP price selects their movement: `straight`, they fall, so slowly that none
-- leaves; `home`, they fly to the player, whose pull is so weak that none arrives.
item.def("coin", { sprite = "d12", radius = 0, gravity = 0.00005, top = 0.001 })

return function(n)
  return function()
    for i = 1, n do item.drop { kind = "coin", x = i % 64 * 4, y = i // 64 * 2, speed = 0 } end
    if board.dip("price") == "home" then
      wait_until(function() return player.get(1).alive end)
      item.group():pull(1)
    end
  end
end
