-- pages.lua - every page opens and plays for a second, by turning through the book; four of them look as they did.
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
