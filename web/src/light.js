// What shines on the stage: a sun, and a sky whose lower half is the light that comes back from the ground.

import { Color, Vector3 } from "three";

export const SUN = { towards: new Vector3(0.45, 1, 0.35).normalize(), color: new Color(0xffffff), intensity: 2.2 };
export const SKY = { above: new Color(0xffffff), below: new Color(0x777770), intensity: 1.5 };
