// How much the graphics of this machine can draw. A processor that draws by itself (a virtual machine, a test) gets
// fewer triangles and plainer edges, so that a thousand bodies still move smoothly.

const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;
const MANY = 300;  // bodies; they are small on the screen, and few triangles each are enough

/**
 * @param {number} bodies
 * @returns {{antialias: boolean, sharpest: number, moving: number, soft: boolean, shadow_px: number, hurries: boolean,
 *   around: number, along: number, impulses: number, sparing: boolean}} sharpest: screen pixels a CSS pixel; moving: the
 *   same while it plays, and less where that is slow; soft: shadows have soft edges, and fall on bodies too; hurries:
 *   while it plays there are no shadows, and only corners are lit; around, along: facets of curved shapes; impulses: how
 *   many are shown at once; sparing: what stands beside the picture moves less often
 */
export function graphics(bodies) {
  const many = bodies > MANY;
  if (isSoftware()) return many ? COARSE : PLAIN;
  return many ? { ...FINE, around: 20, along: 12 } : FINE;
}

const FINE = { antialias: true, sharpest: 1.5, moving: 1.5, soft: true, shadow_px: 2048, hurries: false,
               around: 48, along: 32, impulses: 64, sparing: false };
const PLAIN = { antialias: false, sharpest: 1, moving: 1, soft: true, shadow_px: 512, hurries: false,
                around: 32, along: 20, impulses: 64, sparing: false };
const COARSE = { antialias: false, sharpest: 1, moving: 0.5, soft: false, shadow_px: 512, hurries: true,
                 around: 6, along: 4, impulses: 12, sparing: true };

function isSoftware() {
  const gl = document.createElement("canvas").getContext("webgl2");
  const names = gl?.getExtension("WEBGL_debug_renderer_info");
  const software = Boolean(names) && SOFTWARE.test(gl.getParameter(names.UNMASKED_RENDERER_WEBGL));
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return software;
}
