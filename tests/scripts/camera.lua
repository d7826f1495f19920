-- The properties of the camera, and the errors that scripts get.
player.def('ship', { sprite = 'dot', hit = { circle = 2 }, speed = 4, focus = 1, lives = 2 })
--load: without a view there is no camera
print(camera)
--! camera: the view shows the whole field; add `view = { w = 240, h = 320 }` to `field` in rom.lua
print(rom.view == rom.field, rom.view.w)
--> true 240
--board: backgrounds
--load: ... and layers don't follow it
bg.layer(2).follow = 0.5
--! layer: follow is disabled; add `view = { w = 240, h = 320 }` to `field` in rom.lua
--board: field_w=500 field_h=400 view_w=200 view_h=160
--load: at the start it shows the middle of the field's lower edge
print(camera.x, camera.y, camera.w, camera.h, camera.follow)
local l = camera.limits
print(l.x, l.y, l.w, l.h)
print(rom.field.w, rom.field.h, rom.view.x, rom.view.y, rom.view.w, rom.view.h, bg.layer(1).follow)
--> 150.0 240.0 200 160 1.0
--> 0.0 0.0 500.0 400.0
--> 500 400 0 0 200 160 1.0

--case: it goes to the ship, no further than the field
string.sys.join(1, 'ship')
local p = player.get(1)
p.x, p.y = 300.25, 200
wait(1)
print(camera.x, camera.y)
p.x, p.y = 490, 9
wait(1)
print(camera.x, camera.y)
--> 200.25 120.0
--> 300.0 0.0

--case: a share of the way each frame, to the nearest place inside its limits
string.sys.join(1, 'ship')
local p = player.get(1)
p.x, p.y = 350, 320
camera.follow = 0.5
wait(1)
print(camera.x, camera.y)
wait(1)
print(camera.x)
camera.limits = { x = 30, y = 20, w = 250, h = 200.5 }
wait(60)
print(camera.x, camera.y, camera.limits.h)
camera.limits = nil
wait(60)
print(camera.x, camera.y, camera.limits.h)
--> 200.0 240.0
--> 225.0
--> 80.0 60.5 200.5
--> 250.0 240.0 400.0

--case: with follow = 0, scripts move it inside its limits
string.sys.join(1, 'ship')
camera.follow = 0
camera.x, camera.y = 12.5, -40
wait(5)
print(camera.x, camera.y)
camera.limits = { x = 100, y = 100, w = 300, h = 200 }
print(camera.x)
camera.x, camera.y = 0, 1000
print(camera.x, camera.y)
--> 12.5 0.0
--> 12.5
--> 100.0 140.0

--case: a hit-stop holds it
string.sys.join(1, 'ship')
player.get(1).x = 400
board.stop(3)
wait(1)
print(camera.x)
--> 300.0

--case: positions of the screen and the field
camera.follow = 0
camera.x, camera.y = 12.75, 30
print(string.sys.to_field(5, 7.5))
print(string.sys.to_screen(17, 30.5))
--> 17 37.5
--> 5 0.5

--each: arguments
camera.x = 3
--! camera: x: the camera follows the players; set camera.follow = 0 first
camera.y = 3
--! camera: y: the camera follows the players; set camera.follow = 0 first
camera.follow = 1.5
--! camera: follow: expected a number from 0 to 1, got 1.5
camera.follow = 0 camera.x = 'left'
--! camera: x: expected a number from -16383 to 16383 px, got "left"
camera.w = 3
--! camera: w is read-only
camera.zoom = 2
--! the camera has no property "zoom"
camera.follw = 2
--! the camera has no property "follw" (did you mean "follow"?)
camera.limits = 3
--! camera: limits: expected a table, got 3
camera.limits = { x = 0, y = 0, w = 100, h = 400 }
--! camera: limits: expected a part of the 500x400 field that holds the 200x160 view
camera.limits = { x = 0, y = 300, w = 400, h = 160 }
--! camera: limits: expected a part of the 500x400 field that holds the 200x160 view
camera.limits = { x = -1, y = 0, w = 300, h = 200 }
--! camera: limits: x: expected a number from 0 to 1024 px, got -1
camera.limits = { x = 0, y = 0, w = 300 }
--! camera: limits: h: expected a number from 16 to 1024 px, got nil
camera.limits = { x = 0, y = 0, w = 300, hh = 3 }
--! camera: limits: unknown argument "hh" (did you mean "h"?)
bg.layer(1).follow = -1
--! layer: follow: expected a number from 0 to 4, got -1
bg.plane().follow = 1
--! a plane has no property "follow"
