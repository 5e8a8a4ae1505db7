// The page without a run, as it was built: where the build says, or in dist/.

import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

export const address = process.env.ANIMADO_PAGE
  ? pathToFileURL(process.env.ANIMADO_PAGE).href
  : new URL("../dist/page.html", import.meta.url).href;
export const template = () => readFileSync(new URL(address), "utf8");
