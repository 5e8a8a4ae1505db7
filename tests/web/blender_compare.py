"""Inside Blender: imports RUN/animation.glb and compares the bodies' world matrices at three frames with RUN/states.csv.

Blender has z up where ANIMADO and glTF have y: its importer turns (x, y, z) into (x, -z, y). It counts time in frames of
its own: at t seconds it shows frame t*fps, which need not be whole.
"""
import csv
import pathlib
import sys

import bpy
import mathutils
import numpy

# Debian 12's Blender 3.4 asks for a name that Debian 12's numpy no longer has.
if "bool" not in vars(numpy):
    numpy.bool = bool

TOLERANCE = 1e-5  # glTF holds single precision
FPS = 24
Z_UP = mathutils.Matrix(((1, 0, 0, 0), (0, 0, -1, 0), (0, 1, 0, 0), (0, 0, 0, 1)))


def rows_of(file):
    """Of each frame the time and the bodies' rows."""
    frames = []
    with open(file, encoding="utf-8") as text:
        for row in csv.DictReader(text):
            if int(row["frame"]) == len(frames):
                frames.append((float(row["time_s"]), []))
            frames[-1][1].append(row)
    return frames


def expected_matrix(row):
    place = mathutils.Matrix.Translation([float(row[f"p{axis}_m"]) for axis in "xyz"])
    turn = mathutils.Quaternion([float(row[f"q{part}"]) for part in "wxyz"]).to_matrix().to_4x4()
    return Z_UP @ place @ turn @ Z_UP.inverted()


def show(time_s):
    frame = time_s * FPS
    bpy.context.scene.frame_set(int(frame), subframe=frame - int(frame))


def difference(a, b):
    return max(abs(a[i][k] - b[i][k]) for i in range(4) for k in range(4))


def main():
    run = pathlib.Path(sys.argv[sys.argv.index("--") + 1])
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.scene.render.fps = FPS
    bpy.context.scene.render.fps_base = 1
    bpy.ops.import_scene.gltf(filepath=str(run / "animation.glb"))
    frames = rows_of(run / "states.csv")
    start_s = frames[0][0]
    worst = 0
    for number in (0, len(frames) // 2, len(frames) - 1):
        time_s, rows = frames[number]
        show(time_s - start_s)
        for row in rows:
            off = difference(bpy.data.objects[row["body"]].matrix_world, expected_matrix(row))
            print(f"frame {number} {row['body']}: {off:.2e}")
            worst = max(worst, off)
    if not worst <= TOLERANCE:
        raise SystemExit(f"Blender has a body elsewhere than states.csv: {worst:.2e}, more than {TOLERANCE:.0e}")
    print(f"Blender {bpy.app.version_string} agrees with states.csv to {worst:.2e}")


main()
