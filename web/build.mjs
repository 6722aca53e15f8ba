// Writes the page's player and the licences of what it contains: node build.mjs [FOLDER]
import { build } from "esbuild";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

const here = fileURLToPath(new URL(".", import.meta.url));
const folder = process.argv[2] ?? join(here, "../templates/view");

await build({
  entryPoints: [join(here, "src/player.js")], outfile: join(folder, "player.min.js"), bundle: true,
  minify: true, format: "iife", globalName: "coscrewPlayer", target: "es2022",
  loader: { ".css": "text" },
  legalComments: "none",  // the licences stand in one file, and in each page
});
const { dependencies } = JSON.parse(readFileSync(join(here, "package.json"), "utf8"));
const texts = Object.entries(dependencies).map(([name, version]) => {
  const text = readFileSync(join(here, "node_modules", name, "LICENSE"), "utf8").trim();
  return `${name} ${version}\n\n${text}\n`;
});
writeFileSync(join(folder, "LICENSES.txt"), texts.join("\n"));
