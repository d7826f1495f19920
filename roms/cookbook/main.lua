-- main.lua - the cookbook: small patterns and effects, one a file in recipes/. A file returns a task for an enemy,
-- f(e, p); or a table: run, that task; ship, the player's; alone = true, if no enemy is wanted (run(nil, p));
-- hud = true, if the score shall be seen. std/boot.lua turns the pages; book.txt, which `make cookbook` writes, has
-- their titles and words.
require "kinds"

local pages = {
  -- Bullets
  "spiral", "counter", "flower", "polygons", "atom", "butterfly", "whips", "arrows", "heart", "odd_even",
  "crossfire", "rain", "snow", "wall", "corridor", "sines", "bounce", "stop_and_aim", "amulets", "mines", "split",
  "trails", "fireworks", "pinwheel", "familiars", "implosion", "grid", "star_drawing", "knives", "time_stop",
  "clouds", "mirror", "gravity", "slow_field", "red_blue", "lanterns", "glow",
  -- Lasers
  "sweep", "curve_laser", "bolts", "cage", "clock",
  -- Enemies and bosses
  "formation", "escorts", "revenge", "fortress", "hit_stop", "survive", "two_bosses", "entrance", "talk",
  "difficulty",
  -- Players
  "spread_shot", "homing_shot", "pierce", "laser_shot", "charge_shot", "reflect", "shield", "options",
  "trail_options", "orbit_options", "bomb", "deathbomb", "rank", "gauge", "chain", "shower", "cancel",
  -- The picture
  "floor", "parallax", "blast", "palette_cycle", "echoes", "spell_name",
}
for i, name in ipairs(pages) do pages[i] = { name = name, recipe = require("recipes/" .. name) } end

boot.run(pages, rom.text("book.txt"))
