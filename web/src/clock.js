// Time: what plays, pauses and seeks it, by buttons and keys.

const $ = id => document.getElementById(id);
const STEPS = 100;  // steps of the arrow keys in a run
const PLAY = "M8 5v14l11-7z", PAUSE = "M6 5h4v14H6zm8 0h4v14h-4z";

export class Clock {
  // `samples` are the recorded times; `changed` is called whenever the time, or whether it runs,
  // has changed.
  constructor(begin, end, samples, changed) {
    Object.assign(this, { begin, end, samples, changed, time: begin, playing: false, last: null,
                          loops: false, part: null });  // of the time, which is repeated
    this.speed = Number($("speed").value);
    this.digits = Math.min(6, Math.max(2, Math.ceil(2 - Math.log10(end - begin || 1))));
    $("time").min = begin;
    $("time").max = end;
    $("play").addEventListener("click", () => this.play(!this.playing));
    $("start").addEventListener("click", () => {
      this.play(false);
      this.seek(begin);
    });
    $("time").addEventListener("input", () => {
      const time = Number($("time").value);  // before the page shows the old one again
      this.play(false);
      this.seek(time);
    });
    $("speed").addEventListener("change", () => { this.speed = Number($("speed").value); });
    this.show();
  }

  play(on) {
    if (on && this.time >= this.end) this.time = this.begin;
    this.playing = on;
    this.last = null;
    this.show();
    this.changed();
  }

  seek(time) {
    this.time = Math.min(Math.max(time, this.begin), this.end);
    this.show();
    this.changed();
  }

  step(count) {
    this.play(false);
    this.seek(this.time + count * (this.end - this.begin) / STEPS);
  }

  // Play at the next speed of the list, or the one before.
  hurry(by) {
    const { options, selectedIndex } = $("speed");
    $("speed").selectedIndex = Math.min(Math.max(selectedIndex + by, 0), options.length - 1);
    this.speed = Number($("speed").value);
  }

  // Go to the next recorded time, or the one before.
  sample(next) {
    const near = 1e-9 * (this.end - this.begin);
    this.play(false);
    this.seek((next ? this.samples.find(x => x > this.time + near)
      : this.samples.findLast(x => x < this.time - near)) ?? this.time);
  }

  // Let the time run until `now`, in ms.
  tick(now) {
    if (!this.playing) return;
    if (this.last !== null) this.time += this.speed * (now - this.last) / 1000;
    this.last = now;
    if (this.loops) {
      const { min, max } = this.part ?? { min: this.begin, max: this.end };
      if (this.time >= Math.min(max, this.end) || this.time < min) {
        this.time = Math.max(min, this.begin);
      }
    }
    if (this.time < this.end) {
      this.show();
      return;
    }
    this.time = this.end;
    this.play(false);
  }

  show() {
    $("time").value = this.time;
    $("time").setAttribute("aria-valuetext", `${this.time.toFixed(this.digits)} seconds`);
    const end = Number(this.end.toPrecision(5));
    $("clock").textContent = `${this.time.toFixed(this.digits)} / ${end} s`;
    $("play").setAttribute("aria-label", this.playing ? "Pause" : "Play");
    $("play").querySelector("path").setAttribute("d", this.playing ? PAUSE : PLAY);
  }

  // Keys of the page, where no control takes them itself.
  key(event) {
    const action = {
      " ": () => this.play(!this.playing), ArrowLeft: () => this.step(-1),
      ArrowRight: () => this.step(1), Home: () => this.seek(this.begin),
      End: () => this.seek(this.end), ",": () => this.sample(false),
      ".": () => this.sample(true), "<": () => this.hurry(-1),
      ">": () => this.hurry(1) }[event.key];
    if (action) action();
    return Boolean(action);
  }
}
