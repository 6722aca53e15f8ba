// Writes the page's player and the licences of what it contains: node build.mjs [FOLDER]
//
// The player's first line has the hash of its sources, by which a test without npm recognizes a
// player that was not built from them.
import { build } from "esbuild";
import { createHash } from "node:crypto";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

const here = fileURLToPath(new URL(".", import.meta.url));
const folder = process.argv[2] ?? join(here, "../templates/view");
const modules = readdirSync(join(here, "src")).sort().map(name => join("src", name));
const hash = createHash("sha256");
for (const path of ["build.mjs", "package-lock.json", ...modules]) {
  hash.update(readFileSync(join(here, path)));
}

await build({
  entryPoints: [join(here, "src/player.js")], outfile: join(folder, "player.min.js"),
  bundle: true, minify: true, format: "iife", globalName: "coscrewPlayer", target: "es2022",
  loader: { ".css": "text" },
  legalComments: "none",  // the licences stand in one file, and in each page
  banner: { js: `// sources ${hash.digest("hex")}` },
});
const { dependencies } = JSON.parse(readFileSync(join(here, "package.json"), "utf8"));
const texts = Object.entries(dependencies).map(([name, version]) => {
  const text = readFileSync(join(here, "node_modules", name, "LICENSE"), "utf8").trim();
  return `${name} ${version}\n\n${text}\n`;
});
writeFileSync(join(folder, "LICENSES.txt"), texts.join("\n"));
