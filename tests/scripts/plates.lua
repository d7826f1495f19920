-- Plates, which lie under text, and screen.dim: what they refuse.
local function plate() return sprite.plate { x = 0, y = 0, w = 60, h = 20 } end

--case: a plate has a size and no picture, until it is removed
local p = plate()
print(p.sprite, p.blend, p.w, p.h)
p:remove()
print(p.w)
--> nil nil 60 20
--> nil

--each: arguments
screen.dim(0.5)
--! screen.dim: expected a table of named arguments, got 0.5
sprite.plate { x = 0, y = 0, w = 60, h = 20, layer = 'over' }
--! sprite.plate: unknown argument "layer" (arguments: x, y, w, h, bank, hidden, front, stay)
plate().sprite = 'dot'
--! sprite: sprite: a plate has no picture
plate().blend = nil
--! sprite: blend: a plate has no picture
plate().dx = 2
--! sprite: dx: the sprite follows nothing; set `x` and `y` instead
sprite.put({ sprite = 'dot', x = 0, y = 0 }).w = 9
--! sprite: w: can only be written on a plate; a sprite's size comes from rom.lua
