#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""bench/sphere_array.py [--out DIR] [--coronet FILE] [--finest N] [--keep]

Drag on a cubic array of spheres at two volume fractions and several resolutions, and with the sphere read from an STL file; prints
the table of docs/validation.md. The STL is an icosahedron whose triangles are cut in four several times, corners on the sphere, and
then made as large as the sphere in volume. With --keep runs that have ended are not run again.
"""
import argparse
import json
import math
import struct
import subprocess
from pathlib import Path


def icosphere(cuts):
    """Triangles of unit radius, seen from outside counter-clockwise."""
    g = (1 + math.sqrt(5)) / 2
    corners = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g), (0, 1, -g), (g, 0, -1),
               (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8),
             (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]

    def unit(p):
        r = math.sqrt(sum(x * x for x in p))
        return tuple(x / r for x in p)

    triangles = [tuple(unit(corners[k]) for k in face) for face in faces]
    for _ in range(cuts):
        finer = []
        for a, b, c in triangles:
            ab, bc, ca = (unit(tuple(x + y for x, y in zip(p, q))) for p, q in ((a, b), (b, c), (c, a)))
            finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        triangles = finer
    return triangles


def write_stl(path, radius, cuts=4):
    """Binary STL of a sphere of that volume."""
    triangles = icosphere(cuts)
    volume = sum(a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
                 for a, b, c in triangles) / 6
    scale = radius * (4 * math.pi / 3 / volume) ** (1 / 3)
    with open(path, "wb") as file:
        file.write(bytes(80) + struct.pack("<I", len(triangles)))
        for triangle in triangles:
            file.write(struct.pack("<12fH", 0, 0, 0, *(scale * x for p in triangle for x in p), 0))


def has_ended(run):
    summary = run / "summary.json"
    return summary.exists() and json.loads(summary.read_text())["status"] == "done"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    here = Path(__file__).resolve().parents[1]
    parser.add_argument("--out", type=Path, default=Path("runs/sphere-array-study"))
    parser.add_argument("--coronet", default=str(here / "build/release/coronet"))
    parser.add_argument("--finest", type=int, default=32, help="particles along an edge of the cube, at most")
    parser.add_argument("--keep", action="store_true", help="runs that have ended are not run again")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)

    print("| volume fraction | sphere from | particles along the edge | liquid particles | K | theory | error |")
    print("|---|---|---|---|---|---|---|")
    for fraction in (0.125, 0.343):
        radius = (3 * fraction / (4 * math.pi)) ** (1 / 3)
        stl = options.out / f"sphere_{fraction}.stl"
        write_stl(stl, radius)
        mesh = (here / "cases/sphere-array.toml").read_text().replace(
            'kind = "ball"', 'kind = "mesh"').replace("radius = 0.37221\n\n[domain]", f'file = "{stl.name}"\n\n[domain]')
        mesh_case = options.out / f"mesh_{fraction}.toml"
        mesh_case.write_text(mesh)
        for form, case, own in (("shape", "sphere-array", ["--set", f"walls.0.radius={radius!r}"]), ("STL", mesh_case, [])):
            for edge in (12, 16, 24, 32):
                if edge > options.finest or (form == "STL" and edge > 16):
                    continue
                run = options.out / f"{form}_{fraction}_{edge}"
                if not (options.keep and has_ended(run)):
                    subprocess.run([options.coronet, "run", str(case), "--quiet", "--overwrite", "--out", str(run), *own, "--set",
                                    f"parameters.radius={radius!r}", "--set", f"particles.spacing={1 / edge!r}"], check=True, stdout=subprocess.DEVNULL)
                summary = json.loads((run / "summary.json").read_text())
                measure = summary["measures"]
                drag = measure["drag_coefficient"]
                print(f"| {fraction} | {form} | {edge} | {summary['particles']} | {drag['value']:.3f} | {drag['reference']:.3f} | "
                      f"{100 * measure['drag_error']['value']:+.2f} % |", flush=True)


if __name__ == "__main__":
    main()
