// The list of keys, in a dialogue that Escape closes.
const OTHERS = [
  ["space", "play, pause"], ["← →", "a hundredth back, on"], [", .", "a sample back, on"],
  ["Home End", "start, end"], ["< >", "slower, faster"], ["Esc", "select nothing"],
  ["← → ↑ ↓ + −", "turn, zoom (in the picture)"]];

// Show the list: the keys of the clock and of the picture, and those of the tools.
export function listKeys(tools) {
  const dialog = document.getElementById("keys");
  dialog.querySelector("dl").replaceChildren(...[...OTHERS, ...tools].flatMap(
    pair => pair.map((text, i) => Object.assign(
      document.createElement(i ? "dd" : "dt"), { textContent: text }))));
  dialog.showModal();
}
