// player.js - a page that plays a packed game: core.wasm (web.c) decides, this shows, sounds, and asks for switches.
//
// The same ROM, seed and pads give the same run here as everywhere, so all that this does ends in pads, and a recording
// of it holds in `curtain verify`. In the address after #: seed=, lang=, section=, difficulty=, switches=, demo=
// (base64 of a recording, or of its gzip).
'use strict'

const UP = 1, DOWN = 2, LEFT = 4, RIGHT = 8, FIRE = 16, BOMB = 32, FOCUS = 64, SPECIAL = 128, START = 256, SELECT = 512
const QUIT = 1, ATTRACT = 2, ASK = 4, SAVED = 16, FAULT = 64, ENDED = 128, RUN = [256, 512] // events of a frame
const KEYS = [ // as the program's own, by place on the keyboard
  { ArrowUp: UP, ArrowDown: DOWN, ArrowLeft: LEFT, ArrowRight: RIGHT, KeyZ: FIRE, KeyX: BOMB, ShiftLeft: FOCUS,
    KeyC: SPECIAL, Enter: START, Digit1: START, Tab: SELECT },
  { KeyW: UP, Numpad8: UP, KeyS: DOWN, Numpad5: DOWN, Numpad2: DOWN, KeyA: LEFT, Numpad4: LEFT, KeyD: RIGHT,
    Numpad6: RIGHT, KeyJ: FIRE, Numpad0: FIRE, KeyK: BOMB, NumpadDecimal: BOMB, KeyI: FOCUS, NumpadEnter: FOCUS,
    KeyL: SPECIAL, NumpadAdd: SPECIAL, Digit2: START, NumpadMultiply: START, Digit3: SELECT, NumpadSubtract: SELECT },
]
const PAD = { 0: FIRE, 1: BOMB, 2: SPECIAL, 4: SPECIAL, 5: FOCUS, 7: FOCUS, 8: SELECT, 9: START, 12: UP, 13: DOWN,
  14: LEFT, 15: RIGHT }
const TICK = 1000 / 60, LINK = 64 << 10 // letters of a link at most
const WORDS = ['difficulty', 'lang', 'switches', 'section']

const at = (id) => document.getElementById(id)
const screen_ = at('screen'), stage = at('stage')
const small = document.createElement('canvas') // the picture as it is
let core, image, stackTop
let game // { bytes, at, id, title, players, w, h, plays: a recording's frames, over }
let running = false

// ---- bytes and texts ----

function unbase64(text) {
  return Uint8Array.from(atob(text.trim().replace(/-/g, '+').replace(/_/g, '/')), (c) => c.charCodeAt(0))
}
function base64(bytes) {
  let text = ''
  for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192))
  return btoa(text)
}
async function through(bytes, stream) {
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer())
}
async function unzipped(bytes) {
  return bytes[0] === 31 && bytes[1] === 139 ? through(bytes, new DecompressionStream('gzip')) : bytes
}
function inside(id) { // what is embedded in the page; null: nothing
  const text = at(id).textContent
  return text && text[0] !== '@' ? unzipped(unbase64(text)) : null
}
const heap = (from, size) => new Uint8Array(core.memory.buffer, from, size)
function text(from) {
  const all = new Uint8Array(core.memory.buffer)
  return new TextDecoder().decode(all.slice(from, all.indexOf(0, from)))
}
function put(bytes) {
  const to = core.web_alloc(bytes.length)
  heap(to, bytes.length).set(bytes)
  return to
}
function recall(key) {
  try { return localStorage.getItem('curtain.' + key) } catch { return null }
}
function keep(key, value) {
  try { localStorage.setItem('curtain.' + key, value) } catch { say('This browser cannot save settings here.') }
}
let toast
function say(sentence) {
  at('toast').textContent = sentence
  at('toast').classList.add('on')
  clearTimeout(toast)
  toast = setTimeout(() => at('toast').classList.remove('on'), 4000)
}

// ---- the core ----

const thrown = Symbol('a Lua error')

async function loadCore() {
  const module = await WebAssembly.compile(await inside('core')), wasi = {}
  for (const { module: from, name } of WebAssembly.Module.imports(module))
    if (from === 'wasi_snapshot_preview1') wasi[name] = () => 8 // there are no files, and no clock
  wasi.proc_exit = () => { throw new Error('the core has exited') }
  const lua = { // tools/lab/cross/wasi/lua_try.h
    host_throw() { throw thrown },
    host_try(f, L, ud) {
      const stack = core.__stack_pointer.value
      try {
        core.__indirect_function_table.get(f)(L, ud)
        return 0
      } catch (e) {
        if (e !== thrown) throw e
        core.__stack_pointer.value = stack
        return 1
      }
    },
  }
  core = (await WebAssembly.instantiate(module, { wasi_snapshot_preview1: wasi, lua })).exports
  stackTop = core.__stack_pointer.value
  core._initialize()
}

// ---- a game ----

const asked = () => new URLSearchParams(location.hash.slice(1))

function openCore(rom, nvram, demo, how) {
  WORDS.forEach((name, i) => {
    const to = core.web_option(i), bytes = new TextEncoder().encode(demo ? '' : how[name] || '').subarray(0, 255)
    heap(to, 256).fill(0)
    heap(to, 256).set(bytes)
  })
  attracts = false
  const saved = put(nvram), recording = put(demo || new Uint8Array())
  const good = core.web_open(rom.at, rom.size, BigInt.asUintN(64, BigInt(how.seed)), saved, nvram.length, recording,
    demo ? demo.length : 0)
  core.web_free(saved)
  core.web_free(recording)
  if (!good) throw new Error(text(core.web_error()))
}

function seedOf(words) {
  if (/^\d{1,20}$/.test(words.get('seed') || '')) return words.get('seed')
  return String(crypto.getRandomValues(new Uint32Array(1))[0])
}

function takeRom(bytes) { // plain, in the core's memory
  const at = core.web_unpack_rom(put(bytes), bytes.length)
  if (!at) throw new Error(text(core.web_error()))
  return { at, size: core.web_result_size() }
}

// Powers a game up; bytes null: the one that is in. When that fails the one before is powered up again.
function power(bytes, demo) {
  const before = game, words = asked(), how = { seed: seedOf(words) }
  const rom = bytes ? takeRom(bytes) : before && before.rom
  if (!rom) throw new Error('no game')
  for (const name of WORDS) how[name] = words.get(name)
  const again = (id) => {
    const saved = recall('nvram.' + id)
    openCore(rom, saved ? unbase64(saved) : new Uint8Array(), demo, how)
  }
  try {
    openCore(rom, new Uint8Array(), null, { seed: 1 }) // to learn whose saves are to be handed in
    const id = text(core.web_id())
    again(id)
    game = { rom, id, again, title: text(core.web_title()), players: core.web_players(), w: core.web_width(),
      h: core.web_height(), plays: demo ? core.web_demo_frames() : 0, over: false }
    if (bytes && before) core.web_free(before.rom.at)
  } catch (e) {
    if (before) before.again(before.id)
    if (bytes) core.web_free(rom.at)
    throw e
  }
  document.title = at('title').textContent = game.title
  small.width = game.w
  small.height = game.h
  image = null
  silence()
  fit()
  show()
}

// Covers a game that has just been powered up; behind the words is what a run of nobody's comes to, its title mostly.
function offer() {
  const what = game.plays ? 'Recording' : 'Play', to = game.plays ? 'watch' : 'start'
  if (!game.plays) {
    openCore(game.rom, new Uint8Array(), null, { seed: 1 })
    for (let f = 0; f < 240; f++) core.web_frame(f === 30 || f === 31 ? START : 0, 0)
    show()
    game.again(game.id)
  }
  const then = game.plays ? '' : '\nthen drag anywhere to move'
  cover(what, touching ? `tap to ${to}${then}` : `click or press a key to ${to}`)
}

function broken(e) { // the core itself; a fault of the game is an event
  game.over = true
  core.__stack_pointer.value = stackTop
  cover('The game stopped', String(e && e.message || e))
}

// The demo that a game asks for while nobody plays has a board of its own, and the game's stands still. What ends it is
// no button of the game's until it has been let go.
let attracts = false
const stale = [0, 0]
function endAttract(one, two) {
  if (!attracts) return
  core.web_attract_end()
  attracts = false
  stale[0] = one
  stale[1] = two
}

let listener // of what is heard, for tests and films
let events = 0 // of the last frame

function tick(one, two) {
  if (attracts && one | two) endAttract(one, two)
  events = game.plays || attracts ? core.web_play_demo_frame() : core.web_frame(one & ~stale[0], two & ~stale[1])
  const from = core.web_sound(), n = core.web_result_size()
  hear(new Int16Array(core.memory.buffer, from, 2 * n))
  if (attracts) {
    if (events & (ENDED | FAULT)) endAttract(0, 0)
    return events
  }
  stale[0] &= one
  stale[1] &= two
  if (events & SAVED && !game.plays) store()
  if (events & ATTRACT && !game.plays) {
    attracts = core.web_attract() !== 0
    if (!attracts) console.warn('attract: ' + text(core.web_error()))
  }
  if (events & FAULT) {
    game.over = true
    cover('Script error', text(core.web_fault()).split('\n')[0])
  }
  if (events & ENDED && game.plays) {
    game.over = true
    cover('End of recording', touching ? 'tap to play' : 'click or press a key to play')
  }
  if (events & QUIT) {
    game.over = true
    cover('Goodbye', touching ? 'tap to restart' : 'click or press a key to restart')
  }
  if (events & ASK) panel(true)
  return events
}

function store() {
  const from = core.web_nvram()
  keep('nvram.' + game.id, base64(heap(from, core.web_result_size())))
}

function show() {
  const from = core.web_picture()
  if (!image || image.data.buffer !== core.memory.buffer)
    image = new ImageData(new Uint8ClampedArray(core.memory.buffer, from, 4 * game.w * game.h), game.w, game.h)
  small.getContext('2d').putImageData(image, 0, 0)
  const to = screen_.getContext('2d', { alpha: false })
  to.imageSmoothingEnabled = false
  to.drawImage(small, 0, 0, screen_.width, screen_.height)
}

// ---- time ----

let last = 0, due = 0

// How many ticks until this refresh of the screen: as many as time asks for, in the long run to the tick. Where a
// refresh is about a tick each has one, as long as time is less than three quarters of a tick ahead or behind.
function ticksOf(now) {
  const passed = Math.min(now - last, 100) / TICK
  last = now
  due += passed
  const n = Math.abs(passed - 1) < 0.3 && Math.abs(due - 1) < 0.75 ? 1 : Math.max(0, Math.floor(due))
  due -= n
  return n
}

// START of a player who flies in a run pauses; the game has no use for it. Returns the buttons for the game, or null.
const lastPads = [0, 0]
function takeStart(buttons) {
  const mine = buttons.map((bits, i) => (!game.plays && !attracts && events & RUN[i] ? bits & START : 0))
  const pressed = mine.some((bits, i) => bits & ~lastPads[i])
  buttons.forEach((bits, i) => { lastPads[i] = bits })
  return pressed ? null : buttons.map((bits, i) => bits & ~mine[i])
}

function refresh(now) {
  requestAnimationFrame(refresh)
  pollPads()
  if (!running) {
    last = now
    return
  }
  const n = Math.min(ticksOf(now), 4)
  try {
    for (let i = 0; i < n && running; i++) {
      fly()
      const buttons = takeStart([pads(0), pads(1)])
      if (buttons) tick(...buttons)
      else pause()
    }
    if (n > 0) show()
  } catch (e) {
    broken(e)
  }
}

// ---- waiting ----

function cover(what, how) {
  running = false
  at('what').textContent = what
  at('how').textContent = how
  at('cover').hidden = false
  at('pause').textContent = game && core.web_frames() > 0 ? 'Resume' : 'Play'
  if (audio) audio.context.suspend()
}
function pause() {
  if (running) cover('Paused', touching ? 'tap to resume' : 'click or press a key to resume')
}
function go() {
  if (!game) return at('file').click()
  if (game.over) restart()
  wake()
  at('cover').hidden = true
  at('pause').textContent = 'Pause'
  held.forEach((set) => set.clear())
  running = true
}
function restart() {
  try {
    power(null, null)
  } catch (e) {
    say(e.message)
  }
}

// ---- sound ----

let audio, loud = recall('sound') !== 'off', volume = Number(recall('volume') || 0.8)

async function wake() { // by a gesture, for browsers allow it then alone
  if (audio) return audio.context.resume()
  if (!window.AudioContext) return
  const context = new AudioContext({ sampleRate: 48000, latencyHint: 'interactive' })
  audio = { context, said: {} }
  try {
    await context.audioWorklet.addModule('data:text/javascript;base64,' + at('worklet').textContent.trim())
    const ring = new AudioWorkletNode(context, 'ring', { numberOfInputs: 0, outputChannelCount: [2] })
    audio.gain = context.createGain()
    ring.connect(audio.gain).connect(context.destination)
    ring.port.onmessage = (e) => { audio.said = e.data }
    audio.ring = ring
    setVolume()
    context.resume()
  } catch {
    say('This browser cannot play sound here.')
  }
}
function hear(lr) {
  if (listener) listener(lr.slice())
  if (audio && audio.ring && loud && running) audio.ring.port.postMessage(lr.slice())
}
function silence() {
  if (audio && audio.ring) audio.ring.port.postMessage(null)
}
function setVolume() {
  if (audio && audio.gain) audio.gain.gain.value = volume
  at('sound').classList.toggle('off', !loud)
}
function toggleSound() {
  loud = !loud
  keep('sound', loud ? 'on' : 'off')
  if (!loud) silence()
  setVolume()
}
function louder(by) {
  volume = Math.round(10 * Math.max(0, Math.min(1, volume + by))) / 10
  keep('volume', volume)
  setVolume()
  say(`Volume ${Math.round(100 * volume)}%`)
}

// ---- switches: keys, controllers, buttons on the screen ----

const held = [new Map(), new Map()] // of each player: what is down, with its button
const tapped = [0, 0] // went down since the last tick: counts even if it is up again
const stick = [0, 0] // of controllers
const pulses = [] // of swipes in menus: { bits, ticks }

function press(player, what, bit) {
  held[player].set(what, bit)
  tapped[player] |= bit
}
function release(what) {
  held.forEach((set) => set.delete(what))
}
function pads(player) {
  let bits = tapped[player] | stick[player]
  tapped[player] = 0
  for (const bit of held[player].values()) bits |= bit
  if (player === 0 && pulses.length) {
    bits |= pulses[0].bits
    if (--pulses[0].ticks === 0) pulses.shift()
  }
  return player === 0 ? bits | finger.bits : bits
}

function pollPads() {
  const found = [...(navigator.getGamepads ? navigator.getGamepads() : [])].filter((p) => p && p.connected)
  stick[0] = stick[1] = 0
  found.slice(0, 2).forEach((pad, i) => {
    for (const n in PAD) if (pad.buttons[n] && pad.buttons[n].pressed) stick[i] |= PAD[n]
    const [x, y] = pad.axes
    stick[i] |= (x < -0.4 ? LEFT : 0) | (x > 0.4 ? RIGHT : 0) | (y < -0.4 ? UP : 0) | (y > 0.4 ? DOWN : 0)
  })
  if (!running && at('panel').hidden && game && document.hasFocus() && stick[0] & (FIRE | START)) go()
}

function onKey(e) {
  if (!at('panel').hidden) {
    if (e.code === 'Escape' || e.code === 'F1') panel(false)
    return
  }
  if (e.ctrlKey || e.metaKey || (e.altKey && e.code !== 'Enter')) return
  if (e.repeat) return e.preventDefault()
  const does = { KeyP: pause, Pause: pause, KeyM: toggleSound, Minus: () => louder(-0.1), Equal: () => louder(0.1),
    F1: () => panel(true), Escape: () => panel(true), KeyR: () => { restart(); go() }, F11: full }
  const player = KEYS.findIndex((map) => map[e.code])
  if (e.altKey) full()
  else if (!running && !(e.code in does && e.code !== 'KeyP') && !/^F\d|Tab/.test(e.code)) go()
  else if (does[e.code]) does[e.code]()
  else if (player >= 0 && running) press(player, e.code, KEYS[player][e.code])
  else return
  e.preventDefault()
}

// ---- a finger: in play the ship follows it, in menus it chooses ----

const finger = { id: null, bits: 0, x: 0, y: 0, movedX: 0, movedY: 0, flew: false, far: 0, target: null }
let touching = matchMedia('(pointer: coarse)').matches, scale = 1

function ship() {
  const from = core.web_ship(0)
  if (!from) return null
  const [steers, x, y, speed, slow, left, top, right, bottom] = new Int32Array(core.memory.buffer, from, 9)
  return { steers: steers & 1, x, y, speed, slow, left, top, right, bottom }
}
const between = (lo, n, hi) => Math.max(lo, Math.min(hi, n))

// Once a tick: what to press so that the ship goes where the finger has led it.
function fly() {
  finger.bits = 0
  if (finger.id === null || game.plays) return
  if (attracts) return void (finger.bits = FIRE)
  const s = ship()
  if (!s) return void (finger.target = null)
  finger.flew = true
  finger.bits = FIRE
  if (!s.steers || !finger.target) finger.target = { x: s.x, y: s.y }
  const to = finger.target
  to.x = between(s.left, to.x + (finger.movedX * 256) / scale, s.right)
  to.y = between(s.top, to.y + (finger.movedY * 256) / scale, s.bottom)
  finger.movedX = finger.movedY = 0
  if (!s.steers) return
  const near = s.speed / 2
  if (to.x < s.x - near) finger.bits |= LEFT
  if (to.x > s.x + near) finger.bits |= RIGHT
  if (to.y < s.y - near) finger.bits |= UP
  if (to.y > s.y + near) finger.bits |= DOWN
}

function down(e) {
  if (e.pointerType === 'mouse' || !running || finger.id !== null) return
  Object.assign(finger, { id: e.pointerId, x: e.clientX, y: e.clientY, movedX: 0, movedY: 0, flew: false, far: 0,
    target: null })
  e.preventDefault()
}
function move(e) {
  if (e.pointerId !== finger.id) return
  finger.movedX += e.clientX - finger.x
  finger.movedY += e.clientY - finger.y
  finger.far += Math.abs(e.clientX - finger.x) + Math.abs(e.clientY - finger.y)
  finger.x = e.clientX
  finger.y = e.clientY
  if (!finger.flew && game && !core.web_ship(0)) swipe()
}
function swipe() {
  const x = Math.abs(finger.movedX), y = Math.abs(finger.movedY)
  if (Math.max(x, y) < 28) return
  const bits = x > y ? (finger.movedX < 0 ? LEFT : RIGHT) : finger.movedY < 0 ? UP : DOWN
  if (pulses.length < 4) pulses.push({ bits, ticks: 3 }, { bits: 0, ticks: 3 })
  finger.movedX = finger.movedY = 0
}
function up(e) {
  if (e.pointerId !== finger.id) return
  if (!finger.flew && finger.far < 14) pulses.push({ bits: FIRE, ticks: 3 }, { bits: 0, ticks: 3 })
  finger.id = null
}

function thumb(id, bit) {
  const button = at(id)
  button.addEventListener('pointerdown', (e) => {
    e.preventDefault()
    if (!running) return go()
    press(0, 'thumb' + e.pointerId, bit)
    button.classList.add('held')
  })
  for (const type of ['pointerup', 'pointercancel'])
    button.addEventListener(type, (e) => {
      release('thumb' + e.pointerId)
      button.classList.remove('held')
    })
}

// ---- the picture's place ----

// Whole pixels where they fill most of the place that there is, unless somebody chose: else a picture of half the size
// would stand in a window that is a little too low for the next one.
const MOST_OF = 0.8
let chosen = recall('smooth'), smooth = false

function fit() {
  document.body.classList.toggle('touch', touching)
  if (!game) return
  const dots = window.devicePixelRatio || 1
  const most = Math.min(stage.clientWidth / game.w, (stage.clientHeight - 4) / game.h)
  const whole = Math.floor(most * dots) / dots
  smooth = chosen ? chosen === 'yes' : touching || whole < MOST_OF * most
  scale = !smooth && whole > 0 ? whole : most
  const times = smooth ? Math.min(6, Math.max(1, Math.ceil(scale * dots))) : 1
  screen_.width = game.w * times
  screen_.height = game.h * times
  screen_.style.width = game.w * scale + 'px'
  screen_.style.height = game.h * scale + 'px'
  screen_.classList.toggle('smooth', smooth)
  at('smooth').textContent = smooth ? 'Scaling: Smooth' : 'Scaling: Integer'
  show()
}
function full() {
  if (document.fullscreenElement) document.exitFullscreen()
  else if (document.documentElement.requestFullscreen) document.documentElement.requestFullscreen().catch(() => {})
}
function panel(open) {
  if (open) pause()
  at('panel').hidden = !open
  at('keep').disabled = at('link').disabled = at('restart').disabled = !game
}

// ---- recordings, files ----

function recording() {
  endAttract(0, 0)
  const from = core.web_demo()
  if (!from) throw new Error(text(core.web_error()))
  const bytes = heap(from, core.web_result_size()).slice()
  core.web_free(from)
  return bytes
}
function download() {
  const link = document.createElement('a'), bytes = recording()
  link.href = URL.createObjectURL(new Blob([bytes], { type: 'application/octet-stream' }))
  link.download = game.id + '.demo'
  link.click()
  setTimeout(() => URL.revokeObjectURL(link.href), 60000)
  say('Saved: ' + link.download)
}
async function copyLink() {
  const packed = await through(recording(), new CompressionStream('gzip'))
  const link = location.href.split('#')[0] + '#demo=' +
    base64(packed).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '')
  if (link.length > LINK) return say('This run is too long for a link. Save the recording instead.')
  await navigator.clipboard.writeText(link)
  say('Link copied.')
}
async function take(file) {
  const bytes = new Uint8Array(await file.arrayBuffer())
  const demo = /\.demo$/i.test(file.name)
  try {
    if (!demo && !/\.rom$/i.test(file.name)) throw new Error('expected a .rom or a .demo')
    power(demo ? null : bytes, demo ? bytes : null)
    panel(false)
    offer()
  } catch (e) {
    if (game) fit()
    say(`${file.name}: ${e.message}.`.replace('..', '.'))
  }
}
async function fromLink() {
  const words = asked().get('demo')
  if (!words || !game) return
  try {
    power(null, await unzipped(unbase64(words.replace(/ /g, '+'))))
    offer()
  } catch (e) {
    say(`Bad link: ${e.message}.`)
    power(null, null)
  }
}

// ---- all of it ----

function listen() {
  const click = (id, f) => at(id).addEventListener('click', async () => {
    at(id).blur()
    try { await f() } catch (e) { say(e.message) }
  })
  click('cover', go)
  click('pause', () => (running ? pause() : go()))
  click('sound', toggleSound)
  click('more', () => panel(true))
  click('full', full)
  click('keep', download)
  click('link', copyLink)
  click('restart', () => { restart(); panel(false); go() })
  click('smooth', () => { chosen = smooth ? 'no' : 'yes'; keep('smooth', chosen); fit() })
  click('open', () => at('file').click())
  click('close', () => { panel(false); if (game) go() })
  at('file').addEventListener('change', (e) => { if (e.target.files[0]) take(e.target.files[0]); e.target.value = '' })
  addEventListener('keydown', onKey)
  addEventListener('keyup', (e) => release(e.code))
  addEventListener('resize', fit)
  addEventListener('hashchange', fromLink)
  addEventListener('blur', () => { if (!touching) pause() })
  document.addEventListener('visibilitychange', () => { if (document.hidden) pause() })
  addEventListener('dragover', (e) => e.preventDefault())
  addEventListener('drop', (e) => {
    e.preventDefault()
    if (e.dataTransfer.files[0]) take(e.dataTransfer.files[0])
  })
  addEventListener('pointerdown', (e) => {
    if (e.pointerType !== 'touch' || touching) return
    touching = true
    fit()
  }, true)
  stage.addEventListener('pointerdown', down)
  stage.addEventListener('pointermove', move)
  for (const type of ['pointerup', 'pointercancel']) stage.addEventListener(type, up)
  document.addEventListener('contextmenu', (e) => { if (touching) e.preventDefault() })
  thumb('bomb', BOMB)
  thumb('special', SPECIAL)
  thumb('start', START)
}

// For pages around this one, and tests: frames by hand, while the clock stands.
window.curtain = {
  ready: (async () => {
    try {
      await loadCore()
      listen()
      touching = touching || navigator.maxTouchPoints > 0 && innerWidth < 600
      const rom = await inside('rom')
      setVolume()
      at('full').hidden = !document.fullscreenEnabled
      fit()
      if (rom) {
        power(rom, null)
        await fromLink()
        if (!game.plays) offer()
      } else cover('No game yet', 'drop a .rom here or click to choose one')
    } catch (e) {
      cover('The game cannot run here', e.message)
    }
    requestAnimationFrame(refresh)
  })(),
  step(n, one = 0, two = 0) {
    for (let i = 0; i < n; i++) tick(one, two)
    show()
  },
  power, take, go, pause, ship, recording, download,
  hash: () => BigInt.asUintN(64, core.web_hash()).toString(16).padStart(16, '0'),
  frames: () => core.web_frames(),
  pixels: () => small.getContext('2d').getImageData(0, 0, game.w, game.h),
  listen(f) { listener = f },
  save() {
    endAttract(0, 0)
    const from = core.web_save()
    if (!from) throw new Error(text(core.web_error()))
    const bytes = heap(from, core.web_result_size()).slice()
    core.web_free(from)
    return bytes
  },
  load(bytes) {
    endAttract(0, 0)
    const from = put(bytes), good = core.web_load(from, bytes.length)
    core.web_free(from)
    if (!good) throw new Error(text(core.web_error()))
    show()
  },
  get state() {
    return { running, attracts, title: game && game.title, heard: audio && audio.said, bytes: core.memory.buffer.byteLength }
  },
}
