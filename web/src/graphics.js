// How much the graphics of this machine can draw. A processor that draws by itself (a virtual machine, a test) gets
// fewer triangles and plainer edges, so that a thousand bodies still move smoothly.

const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;
const MANY = 300;  // bodies; they are small on the screen, and few triangles each are enough

/**
 * @param {number} bodies
 * @returns {{antialias: boolean, sharpest: number, soft: boolean, shadow_px: number, shadow_every: number,
 *   around: number, along: number}} sharpest: screen pixels a CSS pixel; soft: shadows have soft edges, and fall on
 *   bodies too; shadow_every: pictures from shadow to shadow while bodies move; around, along: facets of curved shapes
 */
export function graphics(bodies) {
  const many = bodies > MANY;
  if (isSoftware()) {
    return many
      ? { antialias: false, sharpest: 0.75, soft: false, shadow_px: 512, shadow_every: 6, around: 8, along: 4 }
      : { antialias: false, sharpest: 1, soft: true, shadow_px: 512, shadow_every: 1, around: 32, along: 20 };
  }
  return { antialias: true, sharpest: 1.5, soft: true, shadow_px: 2048, shadow_every: 1,
           ...(many ? { around: 20, along: 12 } : { around: 48, along: 32 }) };
}

function isSoftware() {
  const gl = document.createElement("canvas").getContext("webgl2");
  const names = gl?.getExtension("WEBGL_debug_renderer_info");
  const software = Boolean(names) && SOFTWARE.test(gl.getParameter(names.UNMASKED_RENDERER_WEBGL));
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return software;
}
