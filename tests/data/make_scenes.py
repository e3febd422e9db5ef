#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the small glTF files of tests/data/scene, the same bytes on every machine. Python 3 standard library only.

    tests/data/make_scenes.py             writes them
    tests/data/make_scenes.py --check     exits with 1 when a file differs from what it would write
"""

import math
import pathlib
import sys

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "examples"))
from gltf_builder import I16, U8, U16, Builder, flat, png, rotation  # noqa: E402

SQUARE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
SQUARE_INDICES = [0, 1, 2, 0, 2, 3]
SQUARE_UV = [(0, 1), (1, 1), (1, 0), (0, 0)]


def modes():
    """One mesh with a primitive in each of the seven modes, over five points of a fan; unlit."""
    b = Builder("burin tests")
    points = [(0, 0, 0), (2, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0)]
    position = b.accessor(points, bounds=True)
    primitives = [{"attributes": {"POSITION": position}, "mode": mode} for mode in range(7)]
    primitives[5]["indices"] = b.indices([0, 1, 4, 2, 3])
    mesh = b.add("meshes", name="modes", primitives=primitives)
    b.root(b.add("nodes", name="modes", mesh=mesh))
    return {"modes.glb": b.glb()}


def everything():
    """Materials, textures, lights, cameras, hierarchy, quantised and sparse data in one file with a .bin beside it."""
    b = Builder("burin tests")
    for name in ("KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_materials_ior", "KHR_materials_unlit",
                 "KHR_texture_transform", "EXT_made_up"):
        b.use(name)
    b.use("KHR_mesh_quantization", required=True)
    chequers = png(4, 4, [(255, 0, 0), (0, 255, 0)], [[(x + y) % 2 for x in range(4)] for y in range(4)])
    used, bumps = b.image(chequers, "used"), b.image(chequers, "bumps")
    unused = b.image(b"this is no picture", "unused")
    samplers = [b.add("samplers", magFilter=9728, minFilter=9984, wrapS=33071, wrapT=33648), b.add("samplers", minFilter=9729)]
    textures = [b.add("textures", sampler=samplers[0], source=used), b.add("textures", sampler=samplers[1], source=bumps),
                b.add("textures", source=unused)]
    b.add("materials", name="full", alphaMode="MASK", alphaCutoff=0.25, doubleSided=True,
          emissiveFactor=[0.5, 0.25, 1.0],
          pbrMetallicRoughness={"baseColorFactor": [0.5, 0.6, 0.7, 0.8], "metallicFactor": 0.25, "roughnessFactor": 0.75,
                                "baseColorTexture": {"index": textures[0], "texCoord": 0, "extensions": {
                                    "KHR_texture_transform": {"offset": [0.5, 0.25], "rotation": math.radians(90),
                                                              "scale": [2, 3], "texCoord": 1}}},
                                "metallicRoughnessTexture": {"index": textures[1]}},
          normalTexture={"index": textures[1], "scale": 0.5, "texCoord": 1},
          occlusionTexture={"index": textures[1], "strength": 0.75},
          emissiveTexture={"index": textures[0]},
          extensions={"KHR_materials_emissive_strength": {"emissiveStrength": 4}, "KHR_materials_ior": {"ior": 1.25}})
    b.add("materials", name="flat", alphaMode="BLEND", extensions={"KHR_materials_unlit": {}})

    square = {"attributes": {"POSITION": b.accessor(SQUARE, bounds=True),
                             "NORMAL": b.accessor([(0, 0, 1)] * 4),
                             "TEXCOORD_0": b.accessor(flat([(u * 255, v * 255) for u, v in SQUARE_UV]), "VEC2", U8,
                                                      normalized=True),
                             "TEXCOORD_1": b.accessor(SQUARE_UV, "VEC2"),
                             "COLOR_0": b.accessor([(0, 0, 0), (65535, 0, 0), (0, 65535, 0), (0, 0, 65535)], "VEC3", U16,
                                                   normalized=True)},
              "indices": b.indices(SQUARE_INDICES), "material": 0}
    # U8 VEC2 elements must lie four bytes apart in a vertex buffer view.
    quantised = {"attributes": {"POSITION": b.add(
        "accessors", bufferView=b.view(b.pack([(-32767, 0, 0, 0), (32767, 0, 0, 0), (0, 32767, 0, 0), (9, 9, 9, 9)], I16),
                                       byteStride=8),
        componentType=I16, count=3, type="VEC3", normalized=True, min=[-32767, 0, 0], max=[32767, 32767, 0])}, "material": 1}
    grid = [(x, 0, z) for z in range(3) for x in range(3)]
    sparse = b.add("accessors", bufferView=b.view(b.pack(grid, 5126)), componentType=5126, count=9, type="VEC3",
                   min=[0, 0, 0], max=[2, 5, 2],
                   sparse={"count": 2, "indices": {"bufferView": b.view(b.pack([4, 8], U8)), "componentType": U8},
                           "values": {"bufferView": b.view(b.pack([(1, 5, 1), (2, 3, 2)], 5126))}})
    hill = {"attributes": {"POSITION": sparse},
            "indices": b.indices(flat([(i, i + 3, i + 1, i + 1, i + 3, i + 4) for i in (0, 1, 3, 4)]))}
    meshes = [b.add("meshes", name="square", primitives=[square]), b.add("meshes", name="quantised", primitives=[quantised]),
              b.add("meshes", name="hill", primitives=[hill])]

    child = b.add("nodes", name="mirrored", mesh=meshes[0], scale=[-1, 1, 1], translation=[0, 2, 0])
    parent = b.add("nodes", name="parent", children=[child], mesh=meshes[1],
                   matrix=[0, 0, -2, 0, 0, 2, 0, 0, 2, 0, 0, 0, 10, 20, 30, 1])
    b.root(parent)
    b.root(b.add("nodes", name="hill", mesh=meshes[2]))
    b.add("nodes", name="hidden", mesh=meshes[2], translation=[100, 0, 0])
    cameras = [b.add("cameras", name="infinite", type="perspective", perspective={"yfov": 1.0, "znear": 0.5}),
               b.add("cameras", name="finite", type="perspective",
                     perspective={"yfov": 0.5, "aspectRatio": 2.0, "znear": 1.0, "zfar": 11.0}),
               b.add("cameras", type="orthographic", orthographic={"xmag": 4, "ymag": 3, "znear": 0.0, "zfar": 10.0})]
    for i, camera in enumerate(cameras):
        b.root(b.add("nodes", name=f"camera node {i}", camera=camera, translation=[i, 0, 5], scale=[3, 3, 3]))
    b.doc["extensions"] = {"KHR_lights_punctual": {"lights": [
        {"name": "sun", "type": "directional", "intensity": 3.0},
        {"name": "bulb", "type": "point", "color": [1, 0.5, 0.25], "range": 7.5},
        {"name": "spot", "type": "spot", "spot": {"innerConeAngle": 0.25}}]}}
    for i in range(3):
        b.root(b.add("nodes", extensions={"KHR_lights_punctual": {"light": i}}))
    text, data = b.gltf("every%20thing.bin")
    return {"everything.gltf": text, "every thing.bin": data}


def rig():
    """A strip of five rungs bent by a chain of five joints, eight weights a vertex at its foot, with two morph targets."""
    b = Builder("burin tests")
    positions, joints, weights = [], [[], []], [[], []]
    for row in range(5):
        for x in (-0.5, 0.5):
            positions.append((x, row, 0))
            joints[0].append((row, max(row - 1, 0), 99 if row == 4 else 0, 0))   # 99 has no weight: not named
            weights[0].append((0.75, 0.25, 0, 0) if row else (0.5, 0, 0, 0))
            joints[1].append((0, 1, 0, 0) if row == 0 else (0, 0, 0, 0))
            weights[1].append((0.25, 0.25, 0, 0) if row == 0 else (0, 0, 0, 0))
    triangles = flat([(2 * r, 2 * r + 1, 2 * r + 3, 2 * r, 2 * r + 3, 2 * r + 2) for r in range(4)])
    primitive = {"attributes": {"POSITION": b.accessor(positions, bounds=True), "NORMAL": b.accessor([(0, 0, 1)] * 10),
                                "JOINTS_0": b.accessor(joints[0], "VEC4", U8), "WEIGHTS_0": b.accessor(weights[0], "VEC4"),
                                "JOINTS_1": b.accessor(joints[1], "VEC4", U16), "WEIGHTS_1": b.accessor(weights[1], "VEC4")},
                 "indices": b.indices(triangles),
                 "targets": [{"POSITION": b.sparse(10, {8: (0, 1, 0), 9: (0, 2, 0)})},
                             {"POSITION": b.accessor([(0, 0, 1)] * 10), "NORMAL": b.accessor([(1, 0, -1)] * 10)}]}
    mesh = b.add("meshes", name="strip", primitives=[primitive], weights=[0.5, 0.0])
    chain = []
    for i in range(5):
        chain.append(b.add("nodes", name=f"joint {i}", translation=[0, 1 if i else 0, 0]))
        if i:
            b.doc["nodes"][chain[i - 1]]["children"] = [chain[i]]
    inverse = [[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -i, 0, 1] for i in range(5)]
    skin = b.add("skins", joints=chain, inverseBindMatrices=b.accessor(inverse, "MAT4"))
    b.root(chain[0])
    strip = b.root(b.add("nodes", name="strip", mesh=mesh, skin=skin, translation=[50, 0, 0]))
    morphed = b.root(b.add("nodes", name="morphed only", mesh=mesh, translation=[0, 0, 7], weights=[0.0, 1.0]))

    times = b.accessor([0.5, 1.0, 2.0], "SCALAR", bounds=True)
    turns = b.accessor([rotation((0, 0, 1), a) for a in (0, 90, -30)], "VEC4")
    moves = b.accessor([(0, 1, 0), (1, 1, 0), (1, 2, 0)])
    sizes = b.accessor(flat([[(0, 0, 0), (1, 1, 1), (1, 0, 0)], [(-1, 0, 0), (2, 1, 1), (0, 3, 0)], [(0, 0, 0), (1, 1, 1), (0, 0, 0)]]))
    weigh = b.accessor([0, 0, 0.5, 1, 1, 0], "SCALAR")

    def animation(name, *targets):
        samplers = [{"input": times, "output": o, "interpolation": i} for _, _, o, i in targets]
        b.add("animations", name=name, samplers=samplers, channels=[
            {"sampler": i, "target": {"node": n, "path": p}} for i, (n, p, _, _) in enumerate(targets)])

    animation("bend", (chain[2], "rotation", turns, "LINEAR"), (strip, "weights", weigh, "LINEAR"))
    animation("jump", (chain[1], "translation", moves, "STEP"), (chain[1], "scale", sizes, "CUBICSPLINE"))
    animation("bend again", (chain[2], "rotation", turns, "STEP"), (morphed, "weights", weigh, "STEP"))
    return {"rig.glb": b.glb()}


def main(arguments):
    files = {}
    for make in (modes, everything, rig):
        files.update(make())
    folder = HERE / "scene"
    if arguments == ["--check"]:
        stale = [name for name, data in files.items() if (folder / name).read_bytes() != data]
        for name in stale:
            print(f"{folder / name}: differs from what make_scenes.py makes", file=sys.stderr)
        return 1 if stale else 0
    folder.mkdir(exist_ok=True)
    for name, data in files.items():
        (folder / name).write_bytes(data)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
