# SPDX-License-Identifier: Apache-2.0
"""Scenes: frames, cameras, attributes as layers, refused files."""
import json
import unittest

from burin_cli import SCENES, SOURCE, BurinTest, gradient, identity, read_exr_channels, read_png, write_png

SIZE = ("--size", "48x32")


class Scenes(BurinTest):
    def setUp(self):
        super().setUp()
        self.scene = SOURCE / "examples" / "walk.glb"
        if not self.scene.exists():
            self.skipTest(f"{self.scene} is not there")

    def test_one_file_gets_frame_1_and_several_the_animation(self):
        self.burin("render", self.scene, "-o", "a.png", *SIZE)
        self.burin("render", self.scene, "-o", "a.####.png", "--fps", "4", *SIZE)
        frames = [name for name in self.names() if name != "a.png"]
        self.assertGreater(len(frames), 1)
        self.assertEqual(frames[0], "a.0001.png")
        self.assertEqual((self.folder / "a.png").read_bytes(), (self.folder / "a.0001.png").read_bytes())

    def test_one_frame_has_the_bits_of_the_full_run(self):
        self.burin("render", "edges/dilated_edges", self.scene, "-o", "all.##.png", "--frames", "1-5", *SIZE)
        self.burin("render", "edges/dilated_edges", self.scene, "-o", "one.png", "--frames", "4", *SIZE)
        self.assertEqual((self.folder / "all.04.png").read_bytes(), (self.folder / "one.png").read_bytes())

    def test_the_animation_moves(self):
        self.burin("render", self.scene, "-o", "a.##.png", "--frames", "1,9", *SIZE)
        self.assertNotEqual((self.folder / "a.01.png").read_bytes(), (self.folder / "a.09.png").read_bytes())
        self.burin("render", self.scene, "-o", "s.##.png", "--frames", "1,9", "--animation", "none", *SIZE)
        self.assertEqual((self.folder / "s.01.png").read_bytes(), (self.folder / "s.09.png").read_bytes())

    def test_a_turntable_closes(self):
        still = ["--animation", "none", "--camera", "auto", *SIZE]
        self.burin("render", self.scene, "-o", "t.##.png", "--turntable", "4", *still)
        self.assertEqual([n for n in self.names() if n.startswith("t.")], [f"t.{n:02}.png" for n in range(1, 5)])
        self.burin("render", self.scene, "-o", "u.##.png", "--turntable", "4", "--frames", "5,6", *still)
        self.assertEqual((self.folder / "u.05.png").read_bytes(), (self.folder / "t.01.png").read_bytes())
        self.assertNotEqual((self.folder / "u.06.png").read_bytes(), (self.folder / "t.01.png").read_bytes())
        self.burin("render", self.scene, "-o", "o.png", "--orbit", "90", *still)
        self.assertEqual((self.folder / "o.png").read_bytes(), (self.folder / "u.06.png").read_bytes())

    def test_attributes_are_layers_under_the_fields_names(self):
        self.burin("render", self.scene, "--attributes", "color,normal,depth,position,objectid,velocity", "-o", "g.exr", *SIZE)
        channels = read_exr_channels(self.folder / "g.exr")
        for name in ("R", "G", "B", "A", "N.X", "N.Y", "N.Z", "P.X", "P.Y", "P.Z", "Z"):
            self.assertIn(name, channels)
        self.assertEqual(channels["Z"], 2)
        self.assertEqual(channels["R"], 1)
        self.assertEqual([kind for name, kind in channels.items() if kind == 0], [0], channels)

    def test_attributes_beside_an_effects_frame(self):
        self.write("copy.fx", identity("A16B16G16R16F"))
        self.burin("render", "copy.fx", self.scene, "--attributes", "color,depth", "-o", "g.exr", *SIZE)
        channels = read_exr_channels(self.folder / "g.exr")
        for name in ("R", "G", "B", "A", "color.R", "Z"):
            self.assertIn(name, channels)

    def test_one_attribute_as_a_picture(self):
        self.burin("render", self.scene, "--attributes", "normal", "-o", "n.png", *SIZE)
        rows, _, _ = read_png(self.folder / "n.png")
        self.assertTrue(any(value not in (0, 128) for row in rows for value in row))

    def test_backgrounds(self):
        self.burin("render", self.scene, "-o", "t.png", *SIZE)
        rows, channels, _ = read_png(self.folder / "t.png")
        self.assertEqual(channels, 4)
        self.assertEqual(rows[0][:4], [0, 0, 0, 0])
        self.burin("render", self.scene, "-o", "c.png", "--background", "#336699", *SIZE)
        self.assertEqual(read_png(self.folder / "c.png")[0][0][:4], [0x33, 0x66, 0x99, 255])

    def test_samples_smooth_edges_and_leave_ids_alone(self):
        still = ("--background", "white", "--edges", "off", *SIZE)
        self.burin("render", self.scene, "-o", "default.png", *still)
        for samples in ("1", "4", "16"):
            self.burin("render", self.scene, "-o", f"s{samples}.png", "--samples", samples, *still)
            self.burin("render", self.scene, "-o", f"id{samples}.png", "--attributes", "objectid", "--samples", samples, *SIZE)
        self.assertEqual((self.folder / "default.png").read_bytes(), (self.folder / "s1.png").read_bytes())
        self.assertEqual((self.folder / "id1.png").read_bytes(), (self.folder / "id16.png").read_bytes())
        colors = [len({tuple(row[i:i + 3]) for row in read_png(self.folder / f"s{n}.png")[0] for i in range(0, len(row), 4)})
                  for n in (1, 4, 16)]
        self.assertLess(colors[0], colors[1])
        self.assertNotEqual((self.folder / "s4.png").read_bytes(), (self.folder / "s16.png").read_bytes())

    def test_samples_reach_effects(self):
        self.write("copy.fx", identity())
        self.burin("render", "copy.fx", self.scene, "-o", "e.png", "--samples", "4", *SIZE)
        self.burin("render", self.scene, "-o", "p.png", "--samples", "4", *SIZE)
        self.assertEqual(read_png(self.folder / "e.png"), read_png(self.folder / "p.png"))
        self.burin("render", "filter/supersample", self.scene, "-o", "s.png", "--samples", "4", *SIZE)
        self.burin("render", "filter/supersample", self.scene, "-o", "n.png", *SIZE)
        self.assertNotEqual((self.folder / "s.png").read_bytes(), (self.folder / "n.png").read_bytes())

    def test_samples_over_the_devices_limit_are_refused(self):
        result = self.burin("render", self.scene, "-o", "a.png", "--samples", "16", "--size", "10000x8", status=1)
        self.assertIn("the frame is 10000x8, with --samples 16 rendered at 40000x32, over this device's limit", result.stderr)
        self.assertEqual(self.names(), [])

    def test_samples_of_a_picture_are_ignored_with_a_warning(self):
        write_png(self.folder / "a.png", gradient(5, 3, 3), 3)
        result = self.burin("render", "a.png", "-o", "b.png", "--samples", "4")
        self.assertIn("--samples 4: the source is no scene, so there is nothing to sample", result.stderr)
        self.assertEqual(read_png(self.folder / "a.png"), read_png(self.folder / "b.png"))

    def test_unknown_cameras_and_animations_are_refused(self):
        self.burin("render", self.scene, "-o", "a.png", "--camera", "Nobody", status=2)
        self.burin("render", self.scene, "-o", "a.png", "--animation", "Nothing", status=2)
        self.assertEqual(self.names(), [])

    def test_info(self):
        report = json.loads(self.burin("info", self.scene, "--json").stdout)
        self.assertTrue(report)

    def test_every_test_scene_renders(self):
        for scene in sorted(SCENES.glob("*.gl*")):
            self.burin("render", scene, "-o", scene.stem + ".png", *SIZE)


class Refused(BurinTest):
    def test_broken_scenes_have_status_3(self):
        cases = {"empty.gltf": "", "text.gltf": "not json", "list.gltf": "[]", "version.gltf": '{"asset":{"version":"1.0"}}',
                 "outside.gltf": json.dumps({"asset": {"version": "2.0"}, "buffers": [{"uri": "../secret.bin", "byteLength": 4}]}),
                 "cycle.gltf": json.dumps({"asset": {"version": "2.0"}, "nodes": [{"children": [1]}, {"children": [0]}],
                                           "scenes": [{"nodes": [0]}]}),
                 "short.glb": "glTF\x02\x00\x00\x00",
                 "required.gltf": json.dumps({"asset": {"version": "2.0"}, "extensionsUsed": ["EXT_made_up"],
                                              "extensionsRequired": ["EXT_made_up"]})}
        for name, text in cases.items():
            self.write(name, text)
            result = self.burin("render", name, "-o", "out.png", *SIZE, status=3)
            self.assertIn(name, result.stderr)
            self.burin("info", name, status=3)
        self.assertNotIn("out.png", self.names())

    def test_the_shared_negative_files(self):
        folder = self.shared("gltf/negative")
        for scene in sorted(folder.rglob("*.gl*")):
            result = self.burin("render", scene, "-o", "out.png", *SIZE, status=3)
            self.assertIn(scene.name, result.stderr, scene)


if __name__ == "__main__":
    unittest.main()
