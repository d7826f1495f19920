-- screens/page.lua - one of the game's own pages in the main menu: draws heading and footer, and removes what the
-- page's function spawned.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page = sys.read("menu/page")

-- p: { name, show }; show(row, rows) runs in a task and may draw in `rows` rows from `row` on. Ends with a press, or
-- after page.IDLE frames.
return function(p)
  page.begin()
  local row = page.head(menu.label(p.name), page.cols)
  local rows = page.bottom - row
  page.frame()
  local scene = sys.scene(sys.task()) -- removes what is spawned in it
  local tidy <close> = setmetatable({}, { __close = function() task.stop(scene) end })
  task.own(scene, function() p.show(row, rows) end)
  for age = 0, page.IDLE do
    if page.opening(age, 0) then
      page.head(menu.label(p.name), age)
      page.foot(page.BACK)
    end
    page.tell(page.BACK)
    wait(1)
    if page.accepted() or page.pressed("bomb") then
      sys.cue("back")
      break
    end
  end
  page.done()
end
