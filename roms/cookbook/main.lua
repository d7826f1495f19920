-- main.lua - the cookbook: small patterns and effects, one per file in recipes/. A file returns a task f(e, p) for an
-- enemy, or a table: run, the task; ship, the player's ship; alone = true to run without an enemy, as run(nil, p);
-- hud = true to show the score. std/boot.lua turns the pages. `make cookbook` writes book.txt, their titles and
-- descriptions.
require "kinds"

local pages = {
  -- Bullets
  "spiral", "counter", "flower", "polygons", "atom", "butterfly", "whips", "arrows", "heart", "odd_even",
  "crossfire", "rain", "snow", "wall", "corridor", "sines", "bounce", "stop_and_aim", "amulets", "mines", "split",
  "trails", "fireworks", "pinwheel", "familiars", "implosion", "grid", "star_drawing", "knives", "time_stop",
  "clouds", "mirror", "gravity", "slow_field", "red_blue", "lanterns", "glow", "fountain", "wind",
  -- Lasers
  "sweep", "curve_laser", "bolts", "cage", "clock",
  -- Enemies and bosses
  "formation", "escorts", "turret", "surfacing", "revenge", "fortress", "hit_stop", "survive", "two_bosses", "entrance", "talk",
  "difficulty",
  -- Players
  "spread_shot", "homing_shot", "pierce", "laser_shot", "charge_shot", "reflect", "shield", "options",
  "trail_options", "orbit_options", "bomb", "deathbomb", "rank", "gauge", "chain", "shower", "cancel",
  -- Screen effects
  "floor", "parallax", "blast", "impact", "palette_cycle", "echoes", "spell_name",
}
for i, name in ipairs(pages) do pages[i] = { name = name, recipe = require("recipes/" .. name) } end

boot.run(pages, rom.text("book.txt"))
