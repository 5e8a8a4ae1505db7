// Runs scenes and has Khronos' validator read their animation.glb: no error, no warning, no info, no hint.
//
//   node tests/web/validate_glb.mjs build/release/bin/animado scenes
//
// Each scene is run with --extensions, too: of those the validator may say that it does not know them, and nothing else.
// Exit codes: 0 all are valid, 1 one is not, 77 the validator is not installed (npm install --prefix web).
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';

const kSkipped = 77;
const kSeverities = ['error', 'warning', 'info', 'hint'];

function validatorOfThePage() {
  try {
    return createRequire(new URL('../../web/package.json', import.meta.url))('gltf-validator');
  } catch (error) {
    if (error.code !== 'MODULE_NOT_FOUND') throw error;
    console.log('skipped: gltf-validator is not installed; npm install --prefix web brings it');
    process.exit(kSkipped);
  }
}

function glbOf(animado, scene, options, directory) {
  const out = join(directory, 'run');
  execFileSync(animado, ['run', scene, '--in-process', '--quiet', '--no-pictures', '--out', out, ...options], { stdio: 'inherit' });
  return readFileSync(join(out, 'animation.glb'));
}

// What the validator found, a line each.
async function complaints(validator, glb, expected) {
  const report = await validator.validateBytes(new Uint8Array(glb), { maxIssues: 100 });
  return report.issues.messages
    .filter((issue) => issue.code !== expected)
    .map((issue) => `${kSeverities[issue.severity]} ${issue.code} ${issue.pointer ?? ''}: ${issue.message}`);
}

const [animado, folder] = process.argv.slice(2);
const scenes = readdirSync(folder).filter((name) => name.endsWith('.animado')).map((name) => join(folder, name));
const validator = validatorOfThePage();
const directory = mkdtempSync(join(tmpdir(), 'animado-glb-'));
let invalid = 0;
try {
  for (const scene of scenes) {
    for (const [options, expected] of [[[], null], [['--extensions'], 'UNSUPPORTED_EXTENSION']]) {
      const found = await complaints(validator, glbOf(animado, scene, options, directory), expected);
      if (found.length > 0) invalid += 1;
      for (const line of found) console.log(`${basename(scene)} ${options.join(' ')}: ${line}`);
    }
  }
} finally {
  rmSync(directory, { recursive: true, force: true });
}
console.log(`${scenes.length} scenes, ${invalid} invalid files (validator ${validator.version()})`);
process.exit(invalid > 0 || scenes.length === 0 ? 1 : 0);
