// Bundles src/ and page.html into one file that needs nothing else: dist/page.html. Scripts and styles are named by
// their hash in the page's Content-Security-Policy, so that nothing else in it can run, whatever a scene's text says.

import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const read = (path) => readFileSync(join(here, path), "utf8");

// MIT licenses ask for their text in every copy.
const licenses = ["three", "uplot"]
  .map((name) => `/*! ${name}\n\n${read(`node_modules/${name}/LICENSE`).trim()} */\n`)
  .join("");

const bundle = await build({
  absWorkingDir: here,
  entryPoints: ["src/main.js"],
  outdir: "dist",
  bundle: true,
  minify: true,
  write: false,
  format: "iife",
  target: ["es2022", "chrome123", "firefox120", "safari17.5"],
  legalComments: "eof",
  banner: { js: licenses, css: licenses.slice(licenses.indexOf("/*! uplot")) },
  logLevel: "warning",
});
const script = output(".js");
const style = output(".css");

const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
const policy = [
  "default-src 'none'",
  `script-src ${hash(script)}`,
  `style-src ${hash(style)}`,
  "img-src data: blob:",
  "connect-src 'self' ws://127.0.0.1:* ws://localhost:*",  // the live run; older browsers do not count ws as 'self'
  "base-uri 'none'",
  "form-action 'none'",
].join("; ");

const page = read("page.html")
  .replace("POLICY", () => policy)
  .replace("<style>STYLE<", () => `<style>${style}<`)
  .replace("<script>SCRIPT<", () => `<script>${script}<`);
const file = process.argv[2] ?? join(here, "dist/page.html");
mkdirSync(dirname(file), { recursive: true });
writeFileSync(file, page);
console.error(`${file}: ${Math.round(page.length / 1024)} KiB`);

function output(extension) {
  const text = bundle.outputFiles.find(({ path }) => path.endsWith(extension)).text;
  // Inside an element these would end it, or begin a comment in it.
  const trap = /<\/(script|style)|<!--/i.exec(text);
  if (trap) throw new Error(`the bundle contains ${trap[0]}, which cannot stand inside the page`);
  return text;
}
