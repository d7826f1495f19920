-- screens/page.lua - a page of the game's own, which the title's list leads to: the library puts its head and its foot,
-- darkens what is behind it, and takes away what the game put there.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page = sys.read("menu/page")

-- p: { name, show }; show(row, rows) runs in a task and has so many rows from that one on. Ends when somebody presses,
-- or nobody does for long.
return function(p)
  page.begin()
  local row = page.head(menu.label(p.name), page.cols)
  local rows = page.row + page.rows - (page.low and 3 or 6) - row
  if not page.low then page.frame(row - 1, rows + 1) end
  local scene = sys.scene(sys.task()) -- takes along what is put
  local tidy <close> = setmetatable({}, { __close = function() task.stop(scene) end })
  task.own(scene, function() p.show(row, rows) end)
  for age = 0, page.IDLE do
    if page.opening(age, 0) then
      page.head(menu.label(p.name), age)
      page.foot("FIRE: BACK", age)
    end
    sys.tell_keys()
    wait(1)
    if page.accepted() or page.pressed("bomb") then
      sys.cue("back")
      break
    end
  end
  page.done()
end
