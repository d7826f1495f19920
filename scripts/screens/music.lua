-- screens/music.lua - the music room: what is played where, by its title. It plays what is chosen once there is sound.
local sys = ... -- functions that only the standard library gets; src/board/api/api_sys.c explains each
local page = sys.read("menu/page")

-- list: { name, title?, text? } each. Over with bomb, or when nobody does anything.
return function(list)
  local items, playing, notes = {}, nil, page.low and 2 or 5
  for i, m in ipairs(list) do items[i] = menu.label(m.title or m.name) end
  repeat
    playing = page.ask("MUSIC", {
      items = items, chosen = playing or 1, notes = notes, gap = #items * 2 + notes + 12 > page.rows and 1 or 2,
      note = function(i, row)
        if list[i].text then page.centre(row, list[i].text, hud.banks.plain) end
      end,
    })
    local sound = rawget(sys, "music")
    if playing and sound then sound.play(list[playing].name) end
  until not playing
end
