// Plots of recorded signals, a plot for each quantity and unit, with one cursor.
import uPlot from "uplot";
import sheet from "uplot/dist/uPlot.min.css";

const LINES = ["#2f6fed", "#e5484d", "#2a9d5c", "#c2720c", "#8e4ec6", "#0f97a8", "#d6409f",
               "#7a8a2b", "#64748b", "#b45309", "#0891b2", "#9333ea"];
const HEIGHT = 168, DASHES = [[7, 3, 2, 3], [5, 4], [2, 3]], CLICK = 4;  // px
const MANY = 12;  // signals, among which one searches

export const written = x => !Number.isFinite(x) ? "not finite"
  : Math.abs(x) >= 1e5 || x !== 0 && Math.abs(x) < 1e-3 ? x.toExponential(3)
    : String(Number(x.toPrecision(5)));

const theme = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

// One plot: its figure, a button for each signal with its value, and the curves.
class Chart {
  // `zoomed` is called with the part of the time that is shown, or with null for all of it.
  constructor(group, recording, seek, now, zoomed) {
    Object.assign(this, { group, recording, seek, now, zoomed, buttons: new Map() });
    this.figure = document.createElement("figure");
    this.figure.className = "signals";
    this.caption = document.createElement("figcaption");
    const title = document.createElement("strong");
    title.textContent = group.heading;
    this.caption.append(title);
    this.figure.append(this.caption);
    const labels = [...new Set(group.signals.map(signal => signal.label))];
    this.colour = signal => LINES[labels.indexOf(signal.label) % LINES.length];
    const others = [...new Set(group.signals.map(signal => signal.run))].filter(run => run);
    if (others.length) title.append(...others.map(run => this.ghost(run)));
    this.values = new Map();
    for (const label of labels) this.button(label);
  }

  // The key of a further run.
  ghost(run) {
    const words = document.createElement("small");
    words.textContent = `${run % DASHES.length === 2 ? "dotted" : "dashed"}: `
      + this.recording.runs[run].label;
    return words;
  }

  // Add a label's button, with the value of each run, which shows and hides its curves.
  button(label) {
    const button = document.createElement("button"), key = document.createElement("i");
    const places = this.group.signals.flatMap((signal, i) => signal.label === label ? [i] : []);
    const signals = places.map(i => this.group.signals[i]);
    button.type = "button";
    button.style.setProperty("--line", this.colour(signals[0]));
    button.setAttribute("aria-pressed", "true");
    button.title = `${signals[0].name}: show or hide`;
    button.append(key, label);
    for (const signal of signals) {
      const value = document.createElement("output");
      value.className = signal.run ? "ghost" : "";
      this.values.set(signal, value);
      button.append(value);
    }
    button.addEventListener("click", () => {
      const shown = button.getAttribute("aria-pressed") !== "true";
      for (const i of places) this.plot.setSeries(i + 1, { show: shown });
      button.setAttribute("aria-pressed", String(shown));
    });
    this.caption.append(button);
    this.buttons.set(button, [label, ...signals.map(signal => signal.name)]);
  }

  // Show the signals alone that are wanted, by their names and labels.
  find(wanted) {
    for (const [button, names] of this.buttons) {
      const hidden = !names.some(wanted), { group } = this;
      if (button.hidden === hidden) continue;
      button.hidden = hidden;
      const shown = !hidden && button.getAttribute("aria-pressed") === "true";
      group.signals.forEach(({ label }, i) => {
        if (label === names[0]) this.plot.setSeries(i + 1, { show: shown });
      });
    }
  }

  // Draw the curves in a part of the time, or, by null, all; the figure is in the page.
  draw(part) {
    const { recording, group } = this;
    const axis = { stroke: theme("--quiet"), font: "11px system-ui", pxAlign: 0,
                   grid: { stroke: theme("--rule"), width: 1 },
                   ticks: { stroke: theme("--rule"), size: 4 } };
    this.plot = new uPlot({
      width: this.width(), height: HEIGHT, padding: [6, 8, 0, 0], pxAlign: 0,
      cursor: { sync: { key: "time", setSeries: false }, drag: { x: true, y: false },
                focus: { prox: 24 }, points: { size: 5 } },
      focus: { alpha: .25 }, scales: { x: { time: false } }, legend: { show: false },
      series: [{}, ...group.signals.map(signal => ({
        stroke: this.colour(signal), width: 1.6, label: signal.name, points: { show: false },
        pxAlign: 0, dash: signal.run ? DASHES[signal.run % DASHES.length] : [] }))],
      axes: [{ ...axis, size: 26 }, { ...axis, size: 52 }],
      hooks: { draw: [plot => this.cursor(plot)],
               setScale: [(plot, key) => key === "x" && this.zoomed(partOf(plot))] },
    }, columns(recording, group), this.figure);
    if (part) this.plot.setScale("x", part);
    const over = this.plot.over;
    let pressed = 0;
    over.addEventListener("pointerdown", event => { pressed = event.clientX; });
    over.addEventListener("pointerup", event => {
      if (Math.abs(event.clientX - pressed) >= CLICK) return;
      this.seek(this.plot.posToVal(event.clientX - over.getBoundingClientRect().left, "x"));
    });
  }

  width() { return Math.max(180, this.figure.clientWidth - 24); }

  resize() { this.plot.setSize({ width: this.width(), height: HEIGHT }); }

  // The line at the time that is shown.
  cursor(plot) {
    const x = plot.valToPos(this.now(), "x", true), { left, top, width, height } = plot.bbox;
    if (x < left - 1 || x > left + width + 1) return;
    const context = plot.ctx;
    context.save();
    context.strokeStyle = theme("--accent");
    context.lineWidth = 1.5 * devicePixelRatio;
    context.setLineDash([]);
    context.beginPath();
    context.moveTo(x, top);
    context.lineTo(x, top + height);
    context.stroke();
    context.restore();
  }

  // Bring cursor and values to the located time.
  update() {
    for (const [signal, value] of this.values) {
      value.textContent = written(this.recording.runs[signal.run].value(signal.numbers));
    }
    this.plot.redraw(false, false);
  }

  remove() {
    this.plot.destroy();
    this.figure.remove();
  }
}

// The part of the time that a plot shows; null if that is all.
function partOf({ data: [times], scales: { x: { min, max } } }) {
  return min <= times[0] && max >= times[times.length - 1] ? null : { min, max };
}

// Times of all runs, and each signal at them.
function columns(recording, group) {
  const runs = [...new Set(group.signals.map(signal => signal.run))];
  const tables = runs.map(run => {
    const own = group.signals.filter(signal => signal.run === run);
    return [recording.runs[run].times, ...own.map(signal => signal.numbers)];
  });
  return tables.length > 1 ? uPlot.join(tables) : tables[0];
}

// The plots of the page, chosen by buttons; the first ones are there from the start.
export class Plots {
  // `zoomed` is called with the part of the time that all plots show, or with null for all of it.
  constructor(recording, seek, now, zoomed) {
    const style = document.createElement("style");
    style.textContent = sheet;
    document.head.prepend(style);
    this.charts = new Map();
    this.part = null;
    this.make = group => new Chart(group, recording, seek, now, part => {
      this.part = part;
      zoomed(part);
    });
    this.wanted = () => true;
    this.buttons = new Map();
    this.place = document.getElementById("plots");
    const choice = document.getElementById("groups");
    const signals = recording.groups.flatMap(group => group.signals.filter(x => !x.run));
    if (signals.length > MANY) choice.append(this.search());
    recording.groups.forEach(group => {
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = group.heading;
      button.addEventListener("click", () => this.toggle(group, button));
      choice.append(button);
      this.buttons.set(group, button);
      button.setAttribute("aria-pressed", "false");
      if (group.shown) this.toggle(group, button);
    });
  }

  toggle(group, button) {
    const chart = this.charts.get(group);
    button.setAttribute("aria-pressed", String(!chart));
    if (chart) {
      chart.remove();
      this.charts.delete(group);
    } else {
      const made = this.make(group);
      this.charts.set(group, made);
      this.place.append(made.figure);
      made.draw(this.part);
      made.update();
      this.find(group);
    }
    this.resize();
  }

  // The field for a part of the names of the signals to be shown.
  search() {
    const field = document.createElement("input");
    Object.assign(field, { type: "search", placeholder: "Find", id: "find" });
    field.setAttribute("aria-label", "find signals");
    field.addEventListener("input", () => {
      const text = field.value.trim().toLowerCase();
      this.wanted = name => name.toLowerCase().includes(text);
      for (const group of this.buttons.keys()) this.find(group);
    });
    return field;
  }

  // Show the group if its heading or a signal is wanted, and in its plot the wanted signals.
  find(group) {
    const { wanted } = this, whole = wanted(group.heading), chart = this.charts.get(group);
    const some = group.signals.some(({ name, label }) => wanted(name) || wanted(label));
    this.buttons.get(group).hidden = !whole && !some;
    if (!chart) return;
    chart.figure.hidden = !whole && !some;
    chart.find(whole ? () => true : wanted);
  }

  resize() { for (const chart of this.charts.values()) chart.resize(); }

  update() { for (const chart of this.charts.values()) chart.update(); }

  // Draw again in other colours.
  restyle() {
    for (const chart of this.charts.values()) {
      const { part } = this;
      chart.plot.destroy();
      chart.draw(part);
      chart.update();
    }
  }
}
