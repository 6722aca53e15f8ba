// Pictures and films of the canvas, on the page's background, as files.

const RATE = 8e6;  // bits of a film in a second

// Save a canvas as PNG.
export function save(canvas, name) {
  const sheet = sheetOf(canvas);
  draw(canvas, sheet);
  download(sheet.toDataURL("image/png"), `${name}.png`);
}

// A mark that films a canvas while the run plays from its start; `add` takes what has been drawn
// last.  The file is WebM, or MP4 where the browser makes no WebM.
export function film(canvas, clock, name) {
  let sheet, recorder;
  const start = () => {
    const parts = [];
    sheet = sheetOf(canvas);
    recorder = new MediaRecorder(sheet.captureStream(), { videoBitsPerSecond: RATE });
    recorder.addEventListener("dataavailable", ({ data }) => parts.push(data));
    recorder.addEventListener("stop", () => {
      const type = recorder.mimeType, ending = type.includes("mp4") ? "mp4" : "webm";
      download(URL.createObjectURL(new Blob(parts, { type })), `${name}.${ending}`);
    });
    recorder.start();
    clock.seek(clock.begin);
  };
  const show = on => {
    if (on) start(); else recorder.stop();
    clock.play(on);
  };
  return { show, add: () => draw(canvas, sheet) };
}

function sheetOf({ width, height }) {
  return Object.assign(document.createElement("canvas"), { width, height });
}

function draw(canvas, sheet) {
  const context = sheet.getContext("2d"), { width, height } = sheet;
  context.fillStyle = getComputedStyle(document.documentElement).getPropertyValue("--near");
  context.fillRect(0, 0, width, height);
  context.drawImage(canvas, 0, 0, width, height);
}

function download(href, name) {
  Object.assign(document.createElement("a"), { href, download: name }).click();
}
