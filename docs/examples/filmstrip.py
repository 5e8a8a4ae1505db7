"""Draws the frames of the paper's example side by side, seen along z, as SVG on stdout. Its argument is a states.csv."""
import csv
import itertools
import sys
from math import cos, pi, sin

EDGE_M, RADIUS_M = 1.0, 1.0  # cubo, esfera
FRAME_WIDTH_M, MARGIN_M = 2.3, 1.2
PIXELS_PER_M = 32


def rotated(q, v):
    """The vector v turned by the unit quaternion q = (w, x, y, z): v + 2 u × (u × v + w v)."""
    w, u = q[0], q[1:]
    cross = lambda a, b: (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
    inner = [c + w * x for c, x in zip(cross(u, v), v)]
    return [x + 2 * c for x, c in zip(v, cross(u, inner))]


def segments(body):
    """The lines to draw, body frame: the edges of the cube; two great circles of the sphere, which show how it turns."""
    if body == "cubo":
        corners = list(itertools.product((-EDGE_M / 2, EDGE_M / 2), repeat=3))
        return [(a, b) for a, b in itertools.combinations(corners, 2) if sum(x != y for x, y in zip(a, b)) == 1]
    circle = [(RADIUS_M * cos(k * pi / 16), RADIUS_M * sin(k * pi / 16)) for k in range(33)]
    pairs = list(zip(circle, circle[1:]))
    return [((a[0], a[1], 0), (b[0], b[1], 0)) for a, b in pairs] + [((0, a[0], a[1]), (0, b[0], b[1])) for a, b in pairs]


def main():
    rows = list(csv.DictReader(open(sys.argv[1], encoding="utf-8")))
    frames = 1 + max(int(row["frame"]) for row in rows)
    heights_m = [float(row["py_m"]) for row in rows]
    top_m, bottom_m = max(heights_m) + MARGIN_M, min(heights_m) - MARGIN_M
    width, height = frames * FRAME_WIDTH_M * PIXELS_PER_M, (top_m - bottom_m) * PIXELS_PER_M
    print(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height + 24:.0f}" font-family="sans-serif">')
    print(f'<rect width="{width:.0f}" height="{height + 24:.0f}" fill="white"/>')
    for row in rows:
        center_m = (int(row["frame"]) + 0.5) * FRAME_WIDTH_M
        position = [float(row[key]) for key in ("px_m", "py_m", "pz_m")]
        q = [float(row[key]) for key in ("qw", "qx", "qy", "qz")]
        to_page = lambda p: f"{(center_m + position[0] + p[0]) * PIXELS_PER_M:.1f} {(top_m - position[1] - p[1]) * PIXELS_PER_M:.1f}"
        path = " ".join(f"M{to_page(rotated(q, a))}L{to_page(rotated(q, b))}" for a, b in segments(row["body"]))
        color = "#b3382c" if row["body"] == "cubo" else "#24579e"
        if row["body"] == "esfera":
            x, y = to_page((0, 0, 0)).split()
            print(f'<circle cx="{x}" cy="{y}" r="{RADIUS_M * PIXELS_PER_M:.1f}" fill="#24579e" fill-opacity="0.08" stroke="#24579e"/>')
        print(f'<path d="{path}" stroke="{color}" fill="none"/>')
        if row["body"] == rows[0]["body"]:
            print(f'<text x="{center_m * PIXELS_PER_M:.1f}" y="{height + 14:.0f}" font-size="13" text-anchor="middle">t = {float(row["time_s"]):.1f} s</text>')
    print("</svg>")


main()
