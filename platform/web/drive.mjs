// drive.mjs - a Chromium without a window, for test.sh: opens pages, presses, drags, drops, and writes what came of it
// into the folder it is started in. It is spoken to over its own DevTools protocol.
//
//     node drive.mjs STEP URL [ARGUMENT...]

import { spawn } from 'node:child_process'
import { existsSync, writeFileSync } from 'node:fs'
import { resolve } from 'node:path'

const [step, url, ...args] = process.argv.slice(2)
const SESSION = 'session' + 'Id' // of the protocol: which page a call is for
const sleep = (ms) => new Promise((done) => setTimeout(done, ms))

const program = spawn(process.env.CHROMIUM || 'chromium', ['--headless=new', '--no-sandbox', '--disable-gpu',
  '--disable-dev-shm-usage', '--no-first-run', '--hide-scrollbars', '--touch-events=enabled', '--remote-debugging-pipe',
  `--user-data-dir=${resolve('profile')}`, 'about:blank'], { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] })
const [to, from] = [program.stdio[3], program.stdio[4]]
const waiting = new Map()
let n = 0, rest = Buffer.alloc(0), session, loaded = () => {}
from.on('data', (data) => {
  rest = Buffer.concat([rest, data])
  for (let end; (end = rest.indexOf(0)) >= 0; rest = rest.subarray(end + 1)) {
    const said = JSON.parse(rest.subarray(0, end).toString())
    if (said.method === 'Page.loadEventFired') loaded()
    if (said.method === 'Runtime.exceptionThrown') console.error(JSON.stringify(said.params.exceptionDetails.exception))
    if (!waiting.has(said.id)) continue
    const { done, fail } = waiting.get(said.id)
    waiting.delete(said.id)
    if (said.error) fail(new Error(said.error.message))
    else done(said.result)
  }
})
const send = (method, params = {}, on = session) => new Promise((done, fail) => {
  waiting.set(++n, { done, fail })
  to.write(JSON.stringify({ id: n, method, params, [SESSION]: on }) + '\0')
})

async function js(expression) {
  const said = await send('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true,
    userGesture: true })
  if (said.exceptionDetails) throw new Error(said.exceptionDetails.exception.description)
  return said.result.value
}
async function open(address, size = [1280, 800, 1, false]) {
  const [width, height, deviceScaleFactor, mobile] = size
  await send('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor, mobile })
  await send('Emulation.setTouchEmulationEnabled', { enabled: mobile })
  const there = new Promise((done) => { loaded = done })
  await send('Page.navigate', { url: 'about:blank' })
  await there
  const again = new Promise((done) => { loaded = done })
  await send('Page.navigate', { url: address })
  await again
  await js('curtain.ready')
}
const picture = async (name) => writeFileSync(name,
  Buffer.from((await send('Page.captureScreenshot', { format: 'png' })).data, 'base64'))
const canvas = async (name) => writeFileSync(name, Buffer.from((await js(`(() => {
  const c = document.createElement('canvas'), p = curtain.pixels()
  c.width = p.width
  c.height = p.height
  c.getContext('2d').putImageData(p, 0, 0)
  return c.toDataURL('image/png').split(',')[1] })()`)), 'base64'))

const CODES = { Enter: 13, KeyZ: 90, ArrowLeft: 37, ArrowRight: 39, ArrowUp: 38, KeyX: 88 }
async function key(code, ms) {
  const what = { code, key: code.replace('Key', '').toLowerCase(), windowsVirtualKeyCode: CODES[code] }
  await send('Input.dispatchKeyEvent', { type: 'rawKeyDown', ...what })
  await sleep(ms)
  await send('Input.dispatchKeyEvent', { type: 'keyUp', ...what })
  await sleep(60)
}
const touch = (type, x, y) =>
  send('Input.dispatchTouchEvent', { type, touchPoints: type === 'touchEnd' ? [] : [{ x, y, id: 1 }] })
async function tap(id) {
  const { x, y } = await js(`(() => { const r = document.getElementById('${id}').getBoundingClientRect();
    return { x: r.x + r.width / 2, y: r.y + r.height / 2 } })()`)
  await touch('touchStart', x, y)
  await sleep(80)
  await touch('touchEnd')
  await sleep(120)
}
async function saved(name) { // by the page's own button, as a file
  await js(`document.getElementById('more').click(), document.getElementById('keep').click()`)
  for (let i = 0; i < 100 && !existsSync(name); i++) await sleep(50)
}
const toast = () => js(`document.getElementById('toast').textContent`)
async function drop(file) {
  for (const type of ['dragEnter', 'dragOver', 'drop'])
    await send('Input.dispatchDragEvent', { type, x: 600, y: 400,
      data: { items: [], files: [resolve(file)], dragOperationsMask: 1 } })
  await sleep(500)
}

const steps = {
  // The hash after so many frames, and the canvas as FRAME.png.
  async frames() {
    await open(url)
    for (const at of args.map(Number)) {
      await js(`curtain.step(${at} - curtain.frames())`)
      console.log(at, await js('curtain.hash()'))
      await canvas(String(at).padStart(6, '0') + '.png')
    }
  },
  async sound() {
    await open(url)
    const all = await js(`(() => { const all = []; curtain.listen((lr) => all.push(...lr)); curtain.step(${args[0]});
      return all })()`)
    writeFileSync('heard', Buffer.from(Int16Array.from(all).buffer))
  },
  async keys() {
    await open(url)
    await key('Enter', 50) // begins
    for (const [code, ms] of [['Enter', 60], ['KeyZ', 60], ['KeyZ', 60], ['KeyZ', 60], ['ArrowLeft', 400],
      ['KeyZ', 500], ['ArrowRight', 300], ['ArrowUp', 7], ['KeyX', 60]])
      await key(code, ms)
    const at = await js('curtain.frames()')
    await sleep(1000)
    console.log('rate', await js('curtain.frames()') - at)
    console.log('heard', JSON.stringify((await js('curtain.state')).heard))
    await saved(args[0])
  },
  async touch() {
    await open(url, [390, 844, 3, true])
    await picture('phone-begin.png')
    await tap('cover')
    await sleep(500)
    const before = await js('curtain.ship()')
    await touch('touchStart', 195, 500)
    for (let i = 1; i <= 30; i++) {
      await touch('touchMove', 195 - 3 * i, 500 - 2 * i)
      await sleep(16)
    }
    await sleep(400)
    const after = await js('curtain.ship()')
    await picture('phone.png')
    await touch('touchEnd')
    await tap('bomb')
    console.log('moved', (after.x - before.x) / 256, (after.y - before.y) / 256)
    const scale = await js(`parseFloat(document.getElementById('screen').style.width) / curtain.pixels().width`)
    console.log('led', -90 / scale, -60 / scale)
    await saved(args[0])
  },
  // From the title into a game by taps alone; a swipe in a menu chooses.
  async menus() {
    await open(url, [390, 844, 3, true])
    await tap('cover')
    let taps = 0
    for (; taps < 60 && !(await js('curtain.ship()')); taps++) {
      if (taps === 6) await picture('phone-menu.png')
      await tap('screen')
      await sleep(250)
    }
    await picture('phone-game.png')
    console.log(taps < 60 ? 'a game' : 'no game')
  },
  // A controller, of the browser's making; and the link to what was played.
  async pad() {
    await open(url)
    await key('Enter', 50)
    const from = await js('curtain.ship()')
    await js(`(() => {
      const pad = { connected: true, axes: [-1, 0], buttons: [...Array(17)].map((_, i) => ({ pressed: i === 0 })) }
      navigator.getGamepads = () => [pad, null] })()`)
    await sleep(400)
    console.log('left', (await js('curtain.ship()')).x < from.x - 5000)
    await js(`(() => { curtain.pause(); navigator.clipboard.writeText = async (text) => { window.copied = text } })()`)
    const at = `${await js('curtain.frames()')} ${await js('curtain.hash()')}`
    await js(`document.getElementById('link').click()`)
    for (let i = 0; i < 40 && !(await js('window.copied')); i++) await sleep(50)
    await open(await js('window.copied'))
    await js(`curtain.step(${at.split(' ')[0]})`)
    console.log('link', at === `${await js('curtain.frames()')} ${await js('curtain.hash()')}`)
  },
  async kept() {
    for (let i = 0; i < 3; i++) {
      await open(url)
      await js('curtain.step(10)')
      console.log(await js('curtain.hash()'))
    }
  },
  async drop() {
    await open(url)
    for (const file of args) {
      await js(`document.getElementById('toast').textContent = ''`)
      await drop(file)
      console.log(`${file.split('/').pop()}: ${await toast()} | ${(await js('curtain.state')).title}, ` +
        await js(`document.getElementById('what').textContent`))
    }
    await js('curtain.step(600)')
    console.log('600', await js('curtain.hash()'))
  },
  // A link with a recording: played to its end by the clock.
  async link() {
    await open(url)
    await picture('link.png')
    await js('curtain.step(600)')
    console.log('600', await js('curtain.hash()'))
  },
  async state() {
    await open(url)
    console.log(await js(`(() => { curtain.step(100, 16); const s = curtain.save(); curtain.step(200, 1);
      const far = curtain.hash(); curtain.load(s); const at = curtain.frames(); curtain.step(200, 1);
      return at + ' ' + (far === curtain.hash()) + ' ' + s.length })()`))
  },
  async time() {
    await open(url)
    await send('Emulation.setCPUThrottlingRate', { rate: +args[0] || 1 })
    console.log(await js(`(() => { let most = 0; const from = performance.now();
      for (let i = 0; i < 600; i++) {
        const a = performance.now()
        curtain.step(1, 16)
        most = Math.max(most, performance.now() - a)
      }
      return ((performance.now() - from) / 600).toFixed(2) + ' ms a frame with its picture and sound, at most ' +
        most.toFixed(1) + ' ms, ' + (curtain.state.bytes >> 20) + ' MiB' })()`))
  },
  // Nobody plays: the game asks for a demo, which is shown; a key ends it, and counts as none in the game.
  async attract() {
    await open(url)
    const asked = await js(`(() => { for (let f = 0; f < 7200 && !curtain.state.attracts; f++) curtain.step(1);
      return curtain.state.attracts && curtain.frames() })()`)
    await js('curtain.step(600)')
    console.log('shown', asked !== false && await js('curtain.state.attracts'), await js('curtain.frames()'))
    await picture('attract.png')
    await js('curtain.step(1, 16)')
    console.log('ended', !(await js('curtain.state.attracts')))
    await js('curtain.step(20, 16), curtain.step(5)')
    const frames = await js('curtain.frames()')
    writeFileSync('attract.demo', Buffer.from(await js('[...curtain.recording()]')))
    console.log(frames, await js('curtain.hash()'))
  },
  async look() {
    await open(url)
    await picture('desktop-begin.png')
    await key('Enter', 50)
    await sleep(+args[0] || 1500)
    await picture('desktop.png')
    await js(`document.getElementById('more').click()`)
    await picture('desktop-more.png')
    await open(url, [1366, 600, 1, false]) // what a browser leaves of a small laptop's screen
    await key('Enter', 50)
    await sleep(1500)
    await picture('laptop.png')
    console.log('laptop', await js(`parseFloat(document.getElementById('screen').style.height)`))
    await open(url, [844, 390, 3, true])
    await picture('phone-flat.png')
  },
}

try {
  const { targetInfos } = await send('Target.getTargets', {}, undefined)
  const { targetId } = targetInfos.find((t) => t.type === 'page')
  session = (await send('Target.attachToTarget', { targetId, flatten: true }, undefined))[SESSION]
  await send('Browser.setDownloadBehavior', { behavior: 'allow', downloadPath: resolve('.') }, undefined)
  await send('Page.enable')
  await send('Runtime.enable')
  await send('Emulation.setFocusEmulationEnabled', { enabled: true })
  await steps[step]()
} catch (e) {
  console.error(e.message)
  process.exitCode = 1
} finally {
  await send('Browser.close', {}, undefined).catch(() => {})
  program.kill()
}
