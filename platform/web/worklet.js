// worklet.js - sound: a ring of what the board has made, played at the card's own rate.
//
// The page posts 800 frames of 48 kHz each tick (Int16, left first), or null: silence from here. It plays a little
// faster or slower than 48 kHz, inaudibly, so that the ring stays half full whatever the two clocks do.

const ROOM = 16384, WANT = 2400 // frames

class Ring extends AudioWorkletProcessor {
  constructor() {
    super()
    this.lr = new Float32Array(2 * ROOM)
    this.from = 0 // where it reads, in frames and parts of them
    this.to = 0 // where it writes
    this.running = false
    this.played = 0
    this.gaps = 0
    this.port.onmessage = (e) => this.take(e.data)
  }

  take(lr) {
    if (!lr) {
      this.from = this.to
      this.running = false
      return
    }
    for (let i = 0; i < lr.length; i += 2) {
      const at = 2 * (this.to % ROOM)
      this.lr[at] = lr[i] / 32768
      this.lr[at + 1] = lr[i + 1] / 32768
      this.to++
    }
    if (this.to - this.from > 3 * WANT) this.from = this.to - WANT
  }

  process(inputs, outputs) {
    const [left, right] = outputs[0], have = this.to - this.from
    if (!this.running && have >= WANT) this.running = true
    if (!this.running) return true
    const step = (48000 / sampleRate) * (1 + Math.max(-0.004, Math.min(0.004, (have - WANT) / 200000)))
    for (let i = 0; i < left.length; i++) {
      const n = Math.floor(this.from), part = this.from - n
      if (n + 1 >= this.to) {
        this.running = false
        this.gaps++
        break
      }
      const a = 2 * (n % ROOM), b = 2 * ((n + 1) % ROOM)
      left[i] = this.lr[a] + (this.lr[b] - this.lr[a]) * part
      if (right) right[i] = this.lr[a + 1] + (this.lr[b + 1] - this.lr[a + 1]) * part
      this.from += step
    }
    this.played += left.length
    if (this.played % 12800 < 128) this.port.postMessage({ played: this.played, gaps: this.gaps })
    return true
  }
}

registerProcessor('ring', Ring)
