// firefox.mjs - a Firefox without a window, for test.sh: the hashes of a page after so many frames, then keys that are
// pressed while it runs by its own clock; the recording of that, and a picture. It is spoken to by Marionette, its own
// protocol: lines of JSON, each after its length.
//
//     node firefox.mjs URL RECORDING PICTURE FRAMES...

import { spawn } from 'node:child_process'
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { connect } from 'node:net'
import { resolve } from 'node:path'

const [url, recording, picture, ...frames] = process.argv.slice(2)
const sleep = (ms) => new Promise((done) => setTimeout(done, ms))
const profile = resolve('firefox')
mkdirSync(profile, { recursive: true })
writeFileSync(profile + '/user.js', ['marionette.port", 0', 'media.autoplay.default", 0',
  'browser.shell.checkDefaultBrowser", false', 'datareporting.policy.dataSubmissionEnabled", false',
  'app.update.enabled", false'].map((line) => `user_pref("${line});\n`).join(''))
const program = spawn(process.env.FIREFOX || 'firefox-esr', ['--headless', '--marionette', '--profile', profile,
  '--width', '1280', '--height', '800'], { stdio: 'ignore', env: { ...process.env, HOME: profile } })
let gone = false
program.on('exit', () => { gone = true })

let socket, rest = Buffer.alloc(0), n = 0, hello
const waiting = new Map()
function hear(data) {
  rest = Buffer.concat([rest, data])
  for (;;) {
    const colon = rest.indexOf(':'), size = colon < 0 ? 0 : +rest.subarray(0, colon).toString()
    if (colon < 0 || rest.length < colon + 1 + size) return
    const said = JSON.parse(rest.subarray(colon + 1, colon + 1 + size).toString())
    rest = rest.subarray(colon + 1 + size)
    if (!Array.isArray(said)) {
      hello()
      continue
    }
    const { done, fail } = waiting.get(said[1])
    if (said[2]) fail(new Error(said[2].message))
    else done(said[3] && 'value' in said[3] ? said[3].value : said[3])
  }
}
const send = (name, params = {}) => new Promise((done, fail) => {
  waiting.set(++n, { done, fail })
  const line = JSON.stringify([0, n, name, params])
  socket.write(`${Buffer.byteLength(line)}:${line}`)
})
const js = (script) => send('WebDriver:ExecuteScript', { script: `return (async () => ${script})()`, args: [] })
async function keys(list) { // [KEY, ms]...
  const actions = []
  for (const [value, duration] of list)
    actions.push({ type: 'keyDown', value }, { type: 'pause', duration }, { type: 'keyUp', value },
      { type: 'pause', duration: 60 })
  await send('WebDriver:PerformActions', { actions: [{ type: 'key', id: 'keys', actions }] })
}

try {
  const port = profile + '/MarionetteActivePort'
  while (!existsSync(port) && !gone) await sleep(100)
  if (gone) throw new Error('Firefox does not start')
  await sleep(100)
  const greeted = new Promise((done) => { hello = done })
  socket = connect(+readFileSync(port, 'utf8'), '127.0.0.1')
  socket.on('data', hear)
  await greeted
  await send('WebDriver:NewSession', {})
  console.log('# Firefox', (await js('navigator.userAgent')).replace(/.*\//, ''))
  await send('WebDriver:Navigate', { url })
  await js('curtain.ready')
  for (const at of frames) {
    await js(`curtain.step(${at} - curtain.frames())`)
    console.log(at, await js('curtain.hash()'))
  }
  await js('curtain.power(null, null)')
  const enter = '\uE007', left = '\uE012', right = '\uE014', up = '\uE013'
  await keys([[enter, 60], [enter, 60], ['z', 60], ['z', 60], ['z', 60], [left, 400], ['z', 500], [right, 300], [up, 7],
    ['x', 60]])
  const from = await js('[curtain.frames(), performance.now()]')
  await sleep(2000)
  const to = await js('[curtain.frames(), performance.now()]')
  console.log('rate', Math.round((to[0] - from[0]) * 1000 / (to[1] - from[1])))
  console.log('heard', JSON.stringify((await js('curtain.state')).heard))
  writeFileSync(picture, Buffer.from(await send('WebDriver:TakeScreenshot', { full: false, hash: false }), 'base64'))
  const bytes = await js('[...curtain.recording()]')
  writeFileSync(recording, Buffer.from(bytes))
  console.log(await js(`(() => { const from = performance.now(); for (let i = 0; i < 600; i++) curtain.step(1, 16);
    return '# ' + ((performance.now() - from) / 600).toFixed(2) + ' ms a frame with its picture and sound' })()`))
} catch (e) {
  console.error('firefox: ' + e.message)
  process.exitCode = 1
} finally {
  if (socket) {
    await Promise.race([send('Marionette:Quit', { flags: ['eForceQuit'] }).catch(() => {}), sleep(3000)])
    socket.destroy()
  }
  program.kill()
}
