// Pictures as files.

// Save a canvas as PNG, on the page's background.
export function save(canvas, name) {
  const sheet = document.createElement("canvas"), context = sheet.getContext("2d");
  Object.assign(sheet, { width: canvas.width, height: canvas.height });
  context.fillStyle = getComputedStyle(document.documentElement).getPropertyValue("--near");
  context.fillRect(0, 0, sheet.width, sheet.height);
  context.drawImage(canvas, 0, 0);
  const link = document.createElement("a");
  Object.assign(link, { download: name, href: sheet.toDataURL("image/png") }).click();
}
