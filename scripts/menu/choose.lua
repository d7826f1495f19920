-- menu/choose.lua - menu.choose: shows a title and a list below it, then removes both.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page = sys.read("menu/page")

return function(a)
  if type(a) ~= "table" or type(a.items) ~= "table" or #a.items == 0 then
    sys.fail("menu.choose", 'items: expected a list of strings, as in { items = { "Yes", "No" }, row = 12 }')
  elseif not math.tointeger(a.row) then
    sys.fail("menu.choose", ("row: expected a whole number, got %s"):format(tostring(a.row)))
  end
  local items, top = {}, a.row
  for i, item in ipairs(a.items) do items[i] = text.lang(item) end
  if a.title then top = page.centre(a.row, a.title, hud.banks.bright) + 1 end
  local answer = page.list {
    items = items, row = top, chosen = a.chosen, p = a.p, limit = a.limit, back = a.back,
  }
  if a.title then page.clear(a.row, top - a.row) end
  return answer
end
