// A floor of lines, drawn by the graphics processor: one square, lines as thin as a pixel at any distance, gone
// where they would run together.

import { Color, Mesh, PlaneGeometry, ShaderMaterial } from "three";

const VERTEX = `
  varying vec2 vCell;
  varying vec2 vOut;
  uniform float step_m, extent_m;
  void main() {
    vCell = position.xz / step_m;
    vOut = 2.0 * position.xz / extent_m;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }`;

const FRAGMENT = `
  varying vec2 vCell;
  varying vec2 vOut;
  uniform vec3 color;
  void main() {
    vec2 width = fwidth(vCell);
    vec2 near = 1.0 - clamp(abs(fract(vCell - 0.5) - 0.5) / width, 0.0, 1.0);
    vec2 seen = 1.0 - clamp(3.0 * width, 0.0, 1.0);
    float alpha = max(near.x * seen.x, near.y * seen.y) * (1.0 - smoothstep(0.15, 0.6, length(vOut)));
    if (alpha < 0.01) discard;
    gl_FragColor = vec4(color, alpha);
    #include <colorspace_fragment>
  }`;

/** Level, around its origin; lines 1, 2 or 5 × 10^n apart, about three to a radius. */
export class Grid extends Mesh {
  constructor(extent_m, radius_m) {
    const uniforms = { step_m: { value: niceStep(radius_m / 3) }, extent_m: { value: extent_m },
                       color: { value: new Color() } };
    super(new PlaneGeometry(extent_m, extent_m).rotateX(-Math.PI / 2),
      new ShaderMaterial({ uniforms, vertexShader: VERTEX, fragmentShader: FRAGMENT, transparent: true,
                           depthWrite: false }));
    this.renderOrder = 1;
  }

  paint(color) {
    this.material.uniforms.color.value.copy(color);
  }
}

/** The largest of 1, 2, 5 × 10^n that is not above a length. */
export function niceStep(length_m) {
  const power = 10 ** Math.floor(Math.log10(length_m));
  const lead = length_m / power;
  return (lead >= 5 ? 5 : lead >= 2 ? 2 : 1) * power;
}
