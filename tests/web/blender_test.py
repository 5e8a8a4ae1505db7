#!/usr/bin/python3
"""Runs a scene, imports its animation.glb in Blender, and compares where Blender has the bodies with states.csv.

  tests/web/blender_test.py build/release/bin/animado scenes/colisao.animado

Exit codes: 0 the matrices agree, 1 they do not, 77 Blender, or the numpy that its importer needs, is not installed.
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
HERE = pathlib.Path(__file__).resolve().parent


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(SKIPPED)


def main():
    animado, scene = sys.argv[1:]
    blender = shutil.which("blender") or skip("blender is not installed; apt-get install blender brings it")
    probe = [blender, "-b", "--python-exit-code", "1", "--python-expr", "import numpy"]
    if subprocess.run(probe, capture_output=True).returncode != 0:
        skip("Blender has no numpy, which its importer needs; apt-get install python3-numpy brings it")
    with tempfile.TemporaryDirectory() as directory:
        out = pathlib.Path(directory) / "run"
        subprocess.run([animado, "run", scene, "--in-process", "--quiet", "--no-pictures", "--out", out], check=True)
        compare = [blender, "-b", "--factory-startup", "--python-exit-code", "1", "--python", HERE / "blender_compare.py", "--", out]
        return subprocess.run(compare).returncode


if __name__ == "__main__":
    sys.exit(main())
