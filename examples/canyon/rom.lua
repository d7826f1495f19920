-- rom.lua - the manifest. The field is twice as wide as the screen shows: `view` is the part that is seen.
return {
  id = "canyon", title = "Canyon Run", author = "You", version = 1,
  field = { w = 480, h = 320, view = { w = 240 } },
  board = { bullets = 2048, shots = 256, enemies = 64, sparks = 2048, sprites = 64, motions = 64, tasks = 256,
            lua_kib = 1024, transforms = true }, -- the gun of a turret turns
  palette = "art/palette.png", font = "art/font.png", icon = "kite",
  sheets = {
    bullets = { file = "art/bullets.png", bank = 0 },
    shots   = { file = "art/shots.png",   bank = 0 },
    sparks  = { file = "art/sparks.png",  bank = 0 },
    kite    = { file = "art/kite.png",    bank = 8 },
    foes    = { file = "art/foes.png",    bank = 11 },
  },
  sprites = {
    orb  = { sheet = "bullets", x = 16, y = 0,  w = 12, h = 12 },
    rice = { sheet = "bullets", x = 48, y = 0,  w = 12, h = 12, rotations = 32 },
    star = { sheet = "bullets", x = 0,  y = 16, w = 16, h = 16, frames = 4, every = 4 },
    mist = { sheet = "bullets", x = 0,  y = 64, w = 24, h = 24, frames = 4 },
    dart = { sheet = "shots",   x = 0,  y = 0,  w = 16, h = 16, rotations = 32 },
    kite    = { sheet = "kite", x = 0,  y = 0,   w = 28, h = 36, frames = 4, every = 5, origin = { 14, 19 } },
    drone   = { sheet = "foes", x = 0,  y = 0,   w = 28, h = 28, frames = 4, every = 2 },
    airship = { sheet = "foes", x = 0,  y = 28,  w = 52, h = 76, frames = 2, every = 6 },
    turret  = { sheet = "foes", x = 0,  y = 104, w = 30, h = 30, frames = 4, every = 9 },
    barrel  = { sheet = "foes", x = 120, y = 104, w = 30, h = 30, rotations = 32 },
    glint = { sheet = "sparks", x = 0,  y = 0,  w = 12, h = 12, frames = 4, every = 4 },
    crumb = { sheet = "sparks", x = 48, y = 0,  w = 8,  h = 8,  frames = 4, every = 3 },
    hoop  = { sheet = "sparks", x = 80, y = 0,  w = 12, h = 12, frames = 4, every = 3 },
    shock = { sheet = "sparks", x = 0,  y = 64, w = 48, h = 48, frames = 8, every = 2 },
  },
  maps = { -- drawn by tools/canyon.py, with the enemies
    sea    = { tiles = "art/sea.png",    bank = 13, file = "maps/sea.csv" },
    clouds = { tiles = "art/clouds.png", bank = 14, file = "maps/clouds.csv" },
    cliffs = { tiles = "art/cliffs.png", bank = 15, file = "maps/cliffs.csv" }, -- as wide as the field
  },
  sounds = {
    shot  = { mml = "t300 @pulse E0,14,0,6 o6 V70 {c<a}32", priority = 0, limit = 1 },
    graze = { mml = "t300 @fm E0,25,0,10 o7 V60 e32", priority = 1 },
    chip  = { mml = "t300 @fm E0,11,0,6 o6 V80 a64", priority = 0, limit = 1 },
    kill  = { mml = "t240 @noise E0,60,0,20 o5 V104 {c<c}8", priority = 3 },
    hit   = { mml = "t200 @saw E0,220,0,60 o5 V96 {a<<<a}2", priority = 7, limit = 1 },
    burst = { mml = "t150 @noise E0,500,0,200 o3 V116 {g<<c}1", priority = 7, limit = 1 },
    menu   = { mml = "t300 @sine E0,40,0,20 o5 V90 e32 a16", priority = 5 },
    select = { mml = "t300 @fm E0,90,0,60 o5 V88 l32 a >e a8", priority = 5, limit = 1 },
  },
  extends = { 100000, 300000 },
}
