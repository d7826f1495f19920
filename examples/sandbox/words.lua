-- words.lua - a demo stage for text: lines in two fonts, boxes, text that appears letter by letter, lines that follow a
-- thing; Latin-1 letters, and the box for a character missing from every font.
enemy.def("reader", { sprite = "jelly", hit = "none", touch = false, hp = 10 })

stage.def("words", function()
  text.put { col = 1, row = 3, text = "Latin-1: Àéîõü ñ ß æøå ¿Qué?" }
  text.put { col = 1, row = 5, text = "Cells: 8 px a letter", bank = 1 }
  text.put { col = 1, row = 6, text = "No glyph: " .. utf8.char(0x5f3e, 0x5e55), bank = 2 }
  text.line { x = 8, y = 60, text = "Lines: as wide as the letters", font = "slim", bank = 3 }
  text.line { x = 120, y = 76, text = "centred, and wrapped at 150 of the screen's 240 px", width = 150, align = "center",
    font = "slim", bank = 4 }
  text.line { x = 232, y = 108, text = "to the right\nof both rows", align = "right", bank = 5 }
  text.line { x = 16, y = 140, text = "A box is as wide as `width` says, and as high as its text needs.", width = 120,
    font = "slim", box = true, bank = 6 }
  local talk = text.line { x = 16, y = 260, text = "Letter by letter: each word appears in its final place.", letter = 2,
    width = 200, font = "slim", box = true, screen = true }
  local e = enemy.spawn { kind = "reader", x = 60, y = 226 }
  text.line { follow = e, dx = 0, dy = -30, text = "follows", align = "center", bank = 1 }
  e:move { x = 180, y = 236, over = 240, ease = "both" }
  wait_until(function() return talk.done end)
  wait(120)
  talk.text = "And again, élève."
  wait(forever)
end)
