// Shapes as triangles.

import {
  BoxGeometry, BufferGeometry, CapsuleGeometry, ConeGeometry, CylinderGeometry, Float32BufferAttribute,
  SphereGeometry,
} from "three";

/**
 * @param {{around: number, along: number}} fineness into how many facets curved shapes are cut
 * @returns {BufferGeometry | null} null for a plane: it has no end
 */
export function triangles(shape, { around, along }) {
  const { kind, radius_m: radius, height_m: height } = shape;
  switch (kind) {
    case "sphere":
      return new SphereGeometry(radius, around, along);
    case "box":
      return new BoxGeometry(...shape.size_m);
    case "cylinder":
      return new CylinderGeometry(radius, radius, height, around);
    case "cone":  // the base a quarter of the height below the origin, which is its centre of mass
      return new ConeGeometry(radius, height, around).translate(0, height / 4, 0);
    case "capsule":
      return new CapsuleGeometry(radius, height, Math.ceil(along / 2), around);
    case "hull":
      return hull(shape);
    case "plane":
      return null;
    default:
      throw new Error(`a shape of an unknown kind: ${kind}`);
  }
}

/** Whether it looks the same when it turns about its axis: then it is marked, to show that it does. */
export const isCurved = ({ kind }) => ["sphere", "cylinder", "cone", "capsule"].includes(kind);

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
  geometry.setIndex(Array.from({ length: corners.length / 3 }, (_, i) => i));
  geometry.computeVertexNormals();
  return geometry;
}
