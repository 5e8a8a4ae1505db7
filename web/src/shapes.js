// Shapes as geometry for instanced drawing: bodies whose shapes differ only in size share one geometry and are scaled.

import {
  BoxGeometry, BufferGeometry, CapsuleGeometry, ConeGeometry, CylinderGeometry, Float32BufferAttribute,
  SphereGeometry,
} from "three";

/**
 * @param {{around: number, along: number}} fineness into how many facets curved shapes are cut
 * @returns {{key: string, scale: number[], curved: boolean, geometry: () => BufferGeometry}} bodies of one key are
 * drawn together
 */
export function solid(shape, { around, along }) {
  const { kind, radius_m: radius, height_m: height } = shape;
  switch (kind) {
    case "sphere":
      return { key: kind, scale: [radius, radius, radius], curved: true,
               geometry: () => new SphereGeometry(1, around, along) };
    case "box":
      return { key: kind, scale: shape.size_m, curved: false, geometry: () => new BoxGeometry(1, 1, 1) };
    case "cylinder":
      return { key: kind, scale: [radius, height, radius], curved: true,
               geometry: () => new CylinderGeometry(1, 1, 1, around) };
    case "cone":  // the base a quarter of the height below the origin, which is its centre of mass
      return { key: kind, scale: [radius, height, radius], curved: true,
               geometry: () => new ConeGeometry(1, 1, around).translate(0, 0.25, 0) };
    case "capsule": {  // its caps stay round only when it is scaled alike in all directions
      const slimness = height / radius;
      return { key: `capsule ${slimness.toPrecision(6)}`, scale: [radius, radius, radius], curved: true,
               geometry: () => new CapsuleGeometry(1, slimness, Math.ceil(along / 2), around) };
    }
    case "hull":
      return { key: JSON.stringify(shape), scale: [1, 1, 1], curved: false, geometry: () => hull(shape) };
    default:
      throw new Error(`a shape of an unknown kind: ${kind}`);
  }
}

// Every face as a fan of triangles with corners of its own, so that its edges stay sharp.
function hull({ vertices_m: vertices, faces }) {
  const corners = [];
  for (const face of faces) {
    for (let i = 2; i < face.length; ++i) {
      for (const corner of [face[0], face[i - 1], face[i]]) corners.push(...vertices[corner]);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(corners, 3));
  geometry.computeVertexNormals();
  return geometry;
}
