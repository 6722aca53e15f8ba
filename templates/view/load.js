"use strict";
// Inflates the numbers and the player that the page holds, and starts it; says so if that fails.

function inflated(id) {
  const text = document.getElementById(id).textContent;
  const bytes = Uint8Array.from(atob(text), c => c.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate")));
}

async function load() {
  const [code, block] = await Promise.all([inflated("player").text(),
                                           inflated("block").arrayBuffer()]);
  const script = document.createElement("script");
  script.textContent = code;
  document.body.append(script);
  const data = JSON.parse(document.getElementById("data").textContent);
  window.player = coscrewPlayer.start(data, new Uint8Array(block));
}

load().catch(error => {
  const failed = document.getElementById("failed");
  failed.hidden = false;
  failed.textContent = typeof DecompressionStream === "undefined"
    ? "This browser is too old for the playback; wanted one of 2023 or later."
    : `The playback fails: ${error.message}`;
  throw error;
});
