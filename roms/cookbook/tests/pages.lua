-- pages.lua - turns through the book. Every page runs for a second without a fault; four match their pictures.
local shots = { [1] = "spiral", [9] = "heart", [38] = "sweep", [69] = "floor" }
local PAGES <const> = 75
local book = test.run { seed = 1, frames = 1 }

for page = 1, PAGES do
  book:step(60)
  test.equal(book.fault, nil, "page " .. page)
  if shots[page] then
    book:step(260)
    test.shot(shots[page])
  end
  book:press("right@" .. book.frame)
  book:step(2)
end
