# SPDX-License-Identifier: Apache-2.0
"""A figure that walks on the spot, in a loop of two seconds: a skin of 14 joints, two morph targets (breath, smile), keys of
all three interpolations."""

import math

from gltf_builder import U8, Builder, Surface, add, cross, dot, looking, rotation, scaled, sub, turned, unit

TAU = 2 * math.pi
LOOP_S = 2.0

# name: (parent, place of the joint in the world at rest)
JOINTS = {
    "hips": (None, (0.0, 0.98, 0.0)),
    "spine": ("hips", (0.0, 1.14, 0.0)),
    "head": ("spine", (0.0, 1.52, 0.0)),
    "left arm": ("spine", (0.21, 1.42, 0.0)),
    "left forearm": ("left arm", (0.25, 1.15, 0.0)),
    "right arm": ("spine", (-0.21, 1.42, 0.0)),
    "right forearm": ("right arm", (-0.25, 1.15, 0.0)),
    "left thigh": ("hips", (0.1, 0.94, 0.0)),
    "left shin": ("left thigh", (0.1, 0.52, 0.0)),
    "left foot": ("left shin", (0.1, 0.1, 0.0)),
    "right thigh": ("hips", (-0.1, 0.94, 0.0)),
    "right shin": ("right thigh", (-0.1, 0.52, 0.0)),
    "right foot": ("right shin", (-0.1, 0.1, 0.0)),
    "tassel": ("head", (0.0, 1.86, -0.02)),
}
NAMES = list(JOINTS)

SKIN, SHIRT, TROUSERS, SHOES, HAT = (224, 172, 130), (52, 110, 158), (70, 62, 60), (40, 30, 28), (176, 48, 44)


class Body(Surface):
    def __init__(self):
        super().__init__()
        self.joints, self.weights = [], []

    def tube(self, path, radii, colour, weigh, sides=11):
        """A closed tube of ellipses (rx, rz) round a path; weigh(position, t) -> [(joint, weight), ...], t along the path."""
        first = len(self.positions)
        rows = len(path) - 1

        def frame(j):
            forward = unit(sub(path[min(j + 1, rows)], path[max(j - 1, 0)]))
            side = (1.0, 0.0, 0.0) if abs(forward[0]) < 0.9 else (0.0, 0.0, 1.0)
            z = unit(cross(side, forward))
            return cross(forward, z), z

        def point(u, v):
            j = round(v * rows)
            x, z = frame(j)
            rx, rz = radii[j]
            c, s = math.cos(TAU * u), math.sin(TAU * u)
            across = unit(add(scaled(x, c / max(rx, 1e-3)), scaled(z, s / max(rz, 1e-3))))
            before, after = radii[max(j - 1, 0)], radii[min(j + 1, rows)]
            run = sub(path[min(j + 1, rows)], path[max(j - 1, 0)])
            slope = ((after[0] - before[0]) + (after[1] - before[1])) / (2 * max(math.sqrt(dot(run, run)), 1e-6))
            normal = unit(sub(across, scaled(unit(run), slope)))
            return add(path[j], add(scaled(x, rx * c), scaled(z, rz * s))), normal

        self.grid(sides, rows, point)
        for i in range(first, len(self.positions)):
            row = (i - first) // (sides + 1)
            self.colors.append(tuple(colour) + (255,))
            pairs = (weigh(self.positions[i], row / rows) + [(0, 0.0)] * 4)[:4]
            self.joints.append([joint for joint, _ in pairs])
            self.weights.append([weight for _, weight in pairs])


def capsule(a, b, ra, rb, rows=6):
    """Path and radii of a tube from a to b with round ends."""
    path, radii = [], []
    along = unit(sub(b, a))
    for i in range(4):
        angle = math.pi / 2 * i / 4
        path.append(sub(a, scaled(along, ra * math.cos(angle))))
        radii.append((ra * math.sin(angle),) * 2)
    for i in range(rows + 1):
        t = i / rows
        path.append(add(scaled(a, 1 - t), scaled(b, t)))
        radii.append((ra + (rb - ra) * t,) * 2)
    for i in range(1, 5):
        angle = math.pi / 2 * i / 4
        path.append(add(b, scaled(along, rb * math.sin(angle))))
        radii.append((rb * math.cos(angle),) * 2)
    return path, radii


def bend(lower, upper, height, width=0.09):
    """Weights that pass from one joint to the other about a height: `upper` above it."""
    low, high = NAMES.index(lower), NAMES.index(upper)

    def weigh(position, _):
        t = min(max((position[1] - height) / width + 0.5, 0.0), 1.0)
        t = t * t * (3 - 2 * t)
        return [(high, t), (low, 1 - t)]

    return weigh


def only(joint):
    return lambda position, t: [(NAMES.index(joint), 1.0)]


def body():
    figure = Body()
    for side, x in (("left", 1.0), ("right", -1.0)):
        hip, knee, ankle = (0.1 * x, 0.92, 0.0), (0.1 * x, 0.52, 0.0), (0.1 * x, 0.12, 0.0)
        path, radii = capsule(hip, ankle, 0.1, 0.062, 10)
        figure.tube(path, radii, TROUSERS, bend(side + " shin", side + " thigh", knee[1]))
        path, radii = capsule((0.1 * x, 0.055, -0.04), (0.1 * x, 0.05, 0.13), 0.055, 0.048, 3)
        figure.tube(path, radii, SHOES, only(side + " foot"), 10)
        shoulder, elbow, wrist = (0.21 * x, 1.42, 0.0), (0.25 * x, 1.15, 0.0), (0.28 * x, 0.9, 0.02)
        path, radii = capsule(shoulder, wrist, 0.066, 0.042, 10)
        figure.tube(path, radii, SHIRT, bend(side + " forearm", side + " arm", elbow[1]), 10)
        path, radii = capsule((0.285 * x, 0.86, 0.02), (0.29 * x, 0.82, 0.03), 0.046, 0.04, 1)
        figure.tube(path, radii, SKIN, only(side + " forearm"), 10)
    torso = [(0.86, 0.02, 0.02), (0.88, 0.11, 0.09), (0.94, 0.155, 0.115), (1.02, 0.155, 0.115), (1.12, 0.145, 0.11),
             (1.24, 0.175, 0.125), (1.36, 0.2, 0.13), (1.44, 0.185, 0.115), (1.48, 0.11, 0.085), (1.5, 0.055, 0.055)]
    figure.tube([(0, y, 0) for y, _, _ in torso], [(rx, rz) for _, rx, rz in torso], SHIRT,
                bend("hips", "spine", 1.1, 0.2), 18)
    path, radii = capsule((0, 1.46, 0), (0, 1.54, 0), 0.055, 0.05, 2)
    figure.tube(path, radii, SKIN, bend("spine", "head", 1.51, 0.06), 12)
    face = len(figure.positions)
    skull = [(math.sin(math.pi * i / 12), -math.cos(math.pi * i / 12)) for i in range(13)]
    figure.tube([(0, 1.66 + 0.13 * y, 0.01) for _, y in skull], [(0.105 * r, 0.115 * r) for r, _ in skull], SKIN, only("head"), 18)
    faces = (face, len(figure.positions))
    cap = [(1.7, 0.118, 0.13), (1.72, 0.125, 0.137), (1.75, 0.118, 0.13), (1.79, 0.1, 0.108), (1.83, 0.06, 0.064), (1.85, 0.0, 0.0)]
    figure.tube([(0, y, 0.0) for y, _, _ in cap], [(rx, rz) for _, rx, rz in cap], HAT, only("head"), 18)
    path, radii = capsule((0, 1.86, -0.02), (0, 1.9, -0.02), 0.03, 0.03, 1)
    figure.tube(path, radii, (236, 226, 200), only("tassel"), 10)
    return figure, faces


def in_bytes(weights):
    """Two weights as bytes that add up to 255."""
    first = int(weights[0] * 255 + 0.5)
    return [first, 255 - first, 0, 0]


def breath(figure):
    """Displacements of the chest, sparse: most vertices stay."""
    changes = {}
    for i, (x, y, z) in enumerate(figure.positions):
        amount = math.exp(-((y - 1.33) / 0.1) ** 2)
        if abs(x) < 0.205 and 1.1 < y < 1.49 and amount > 0.05:
            changes[i] = (0.02 * amount * x / 0.2, 0.006 * amount, 0.035 * amount * (1 if z > 0 else 0.3) * z / 0.13)
    return changes


def smile(figure, faces):
    changes = {}
    for i in range(*faces):
        x, y, z = figure.positions[i]
        amount = math.exp(-((y - 1.6) / 0.03) ** 2) * min(abs(x) / 0.06, 1.0)
        if z > 0.02 and amount > 0.05:
            changes[i] = (0.012 * amount * (1 if x > 0 else -1), 0.014 * amount, 0.008 * amount)
    return changes


def skeleton(b):
    nodes = {}
    for name, (parent, place) in JOINTS.items():
        origin = JOINTS[parent][1] if parent else (0.0, 0.0, 0.0)
        nodes[name] = b.add("nodes", name=name, translation=[round(c, 6) for c in sub(place, origin)])
    for name, (parent, _) in JOINTS.items():
        if parent:
            b.doc["nodes"][nodes[parent]].setdefault("children", []).append(nodes[name])
    matrices = [[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -x, -y, -z, 1] for _, (x, y, z) in JOINTS.values()]
    skin = b.add("skins", name="figure", joints=[nodes[n] for n in NAMES], skeleton=nodes["hips"],
                 inverseBindMatrices=b.accessor(matrices, "MAT4"))
    return nodes, skin


def gait(phase):
    """Joint angles in degrees about x at a phase of the stride, in turns; positive bends a limb back."""
    swing = math.sin(TAU * phase)
    lift = max(0.0, math.sin(TAU * phase + 1.9))
    return {"thigh": -24 * swing - 4, "shin": 10 + 46 * lift * lift, "foot": 6 * swing - 8 * lift,
            "arm": 24 * swing, "forearm": -16 - 12 * max(0.0, -swing)}


def animate(b, nodes, mesh_node, eyes):
    steps = 32   # two strides of 1 s
    times = [LOOP_S * i / steps for i in range(steps + 1)]
    clock = b.accessor(times, "SCALAR", bounds=True)
    samplers, channels = [], []

    def channel(node, path, output, interpolation="LINEAR", keys=clock):
        samplers.append({"input": keys, "interpolation": interpolation, "output": output})
        channels.append({"sampler": len(samplers) - 1, "target": {"node": node, "path": path}})

    for side, phase in (("left", 0.0), ("right", 0.5)):
        for part in ("thigh", "shin", "foot", "arm", "forearm"):
            keys = [rotation((1, 0, 0), gait((t + phase) % 1.0)[part]) for t in times]
            channel(nodes[f"{side} {part}"], "rotation", b.accessor(keys, "VEC4"))
    sway = [turned(rotation((0, 1, 0), 7 * math.sin(TAU * t)), rotation((0, 0, 1), 3 * math.cos(TAU * t))) for t in times]
    channel(nodes["hips"], "rotation", b.accessor(sway, "VEC4"))
    counter = [turned(rotation((0, 1, 0), -11 * math.sin(TAU * t)), rotation((1, 0, 0), 4)) for t in times]
    channel(nodes["spine"], "rotation", b.accessor(counter, "VEC4"))

    # The hips rise and fall twice a stride: keys at the turning points, flat tangents.
    quarters = b.accessor([i / 4 for i in range(9)], "SCALAR", bounds=True)
    bob = []
    for i in range(9):
        bob += [(0, 0, 0), (0, 0.975 if i % 2 else 0.945, 0), (0, 0, 0)]
    channel(nodes["hips"], "translation", b.accessor(bob), "CUBICSPLINE", quarters)
    halves = b.accessor([0.0, 0.5, 1.0, 1.5, 2.0], "SCALAR", bounds=True)
    look = []
    for angle in (0, 16, 0, -16, 0):
        look += [(0, 0, 0, 0), rotation((0, 1, 0), angle), (0, 0, 0, 0)]
    channel(nodes["head"], "rotation", b.accessor(look, "VEC4"), "CUBICSPLINE", halves)
    flop = [rotation((1, 0, 0), 14 * math.sin(2 * TAU * t)) for t in times]
    channel(nodes["tassel"], "rotation", b.accessor(flop, "VEC4"))
    channel(mesh_node, "weights", b.accessor([0, 0, 1, 0.5, 0, 1, 1, 0.5, 0, 0], "SCALAR"), "LINEAR", halves)
    blink = b.accessor([0.0, 0.9, 1.05, 1.2, 1.28], "SCALAR", bounds=True)
    channel(eyes, "scale", b.accessor([(1, 1, 1), (1, 0.1, 1), (1, 1, 1), (1, 0.1, 1), (1, 1, 1)]), "STEP", blink)
    b.add("animations", name="walk", samplers=samplers, channels=channels)


def ground(b):
    """A disc of paving in two tones, by vertex colours."""
    surface = Surface()
    rings, sectors = 5, 20
    for j in range(rings):
        for i in range(sectors):
            tone = (150, 150, 142) if (i + j) % 2 else (112, 116, 116)
            first = len(surface.positions)
            for r, a in ((j, i), (j + 1, i), (j + 1, i + 1), (j, i + 1)):
                radius, angle = 1.4 * r / rings, TAU * a / sectors
                surface.positions.append((radius * math.sin(angle), 0.0, radius * math.cos(angle)))
                surface.normals.append((0.0, 1.0, 0.0))
                surface.colors.append(tone + (255,))
            surface.triangles.append((first, first + 1, first + 2))
            if j > 0:
                surface.triangles.append((first, first + 2, first + 3))
    return surface


def eye_pair():
    surface = Surface()
    for x in (-0.042, 0.042):
        def point(u, v):
            a, p = TAU * u, math.pi * v
            n = (math.sin(p) * math.cos(a), math.cos(p), math.sin(p) * math.sin(a))
            return (x + 0.016 * n[0], 0.02 * n[1], 0.115 + 0.012 * n[2]), n
        surface.grid(8, 5, lambda u, v: point(1 - u, v))
    return surface


def make():
    b = Builder()
    b.use("KHR_lights_punctual")
    cloth = b.add("materials", name="figure", pbrMetallicRoughness={"metallicFactor": 0.0, "roughnessFactor": 0.7})
    black = b.add("materials", name="eyes", pbrMetallicRoughness={
        "baseColorFactor": [0.02, 0.02, 0.03, 1.0], "metallicFactor": 0.0, "roughnessFactor": 0.15})
    stone = b.add("materials", name="paving", pbrMetallicRoughness={"metallicFactor": 0.0, "roughnessFactor": 0.9})
    nodes, skin = skeleton(b)
    b.root(nodes["hips"])

    figure, faces = body()
    primitive = figure.primitive(b, cloth, JOINTS_0=b.accessor(figure.joints, "VEC4", U8),
                                 WEIGHTS_0=b.bytes4([in_bytes(w) for w in figure.weights]))
    count = len(figure.positions)
    primitive["targets"] = [{"POSITION": b.sparse(count, breath(figure))}, {"POSITION": b.sparse(count, smile(figure, faces))}]
    mesh = b.add("meshes", name="figure", primitives=[primitive], weights=[0.0, 0.0],
                 extras={"targetNames": ["breath", "smile"]})
    mesh_node = b.root(b.add("nodes", name="figure", mesh=mesh, skin=skin))
    eyes = b.add("nodes", name="eyes", mesh=b.add("meshes", name="eyes", primitives=[eye_pair().primitive(b, black)]),
                 translation=[0.0, 0.16, 0.01])
    b.doc["nodes"][nodes["head"]].setdefault("children", []).append(eyes)
    b.root(b.add("nodes", name="ground", mesh=b.add("meshes", name="ground", primitives=[ground(b).primitive(b, stone)])))
    animate(b, nodes, mesh_node, eyes)

    b.doc["extensions"] = {"KHR_lights_punctual": {"lights": [
        {"name": "sun", "type": "directional", "color": [1.0, 0.95, 0.88], "intensity": 3.0}]}}
    sun = (-2.0, 4.0, 3.0)
    b.root(b.add("nodes", name="sun", rotation=[round(c, 6) for c in looking(sun, (0, 0, 0))],
                 extensions={"KHR_lights_punctual": {"light": 0}}))
    eye = (2.2, 1.6, 3.4)
    camera = b.add("cameras", name="street", type="perspective", perspective={"yfov": 0.6, "znear": 0.1, "zfar": 30.0})
    b.root(b.add("nodes", name="camera", camera=camera, translation=list(eye),
                 rotation=[round(c, 6) for c in looking(eye, (0.0, 0.93, 0.0))]))
    return b.glb()
