# SPDX-License-Identifier: Apache-2.0
"""--translucency and what goes with it: every way of gathering, what is said, what is refused."""
import struct
import unittest

from burin_cli import SOURCE, BurinTest, read_png

SIZE = ("--size", "64x64")


class Translucency(BurinTest):
    def setUp(self):
        super().setUp()
        self.head = SOURCE / "examples" / "head.glb"
        self.candle = SOURCE / "examples" / "candle.glb"

    def render(self, *options, name="a.png", source=None):
        """The file's bytes."""
        self.burin("render", source or self.head, "-o", name, *SIZE, *options)
        return (self.folder / name).read_bytes()

    def brightness(self):
        rows, channels, _ = read_png(self.folder / "a.png")
        return sum(sum(row[i:i + 3]) for row in rows for i in range(0, len(row), channels))

    def test_every_way_makes_a_picture_of_its_own_and_the_same_twice(self):
        pictures = {way: self.render("--translucency", "head=marble", "--scattering", way)
                    for way in ("paper", "fast", "full", "high")}
        pictures["opaque"] = self.render()
        self.assertEqual(len(set(pictures.values())), len(pictures))
        self.assertEqual(self.render("--translucency", "he*=MARBLE"), pictures["full"])
        self.assertEqual(self.render("--translucency", "*=marble", "--translucency", "head=none"), pictures["opaque"])

    def test_media_differ_in_how_much_comes_out(self):
        brightness = []
        for medium in ("wholemilk", "skin1", "ketchup"):
            self.render("--background", "black", "--translucency", f"head={medium}", "--scattering", "fast")
            brightness.append(self.brightness())
        self.assertEqual(brightness, sorted(brightness, reverse=True))

    def test_it_goes_with_edges_and_samples(self):
        pictures = set()
        for mode in ("off", "unsorted", "sorted", "resolve"):
            for samples in ("1", "4"):
                pictures.add(self.render("--translucency", "head=skin1", "--scattering", "fast", "--edges", mode,
                                         "--samples", samples))
        self.assertEqual(len(pictures), 8)

    def test_the_file_says_what_it_is_made_of(self):
        result = self.burin("render", self.candle, "-o", "a.png", *SIZE, "-v")
        self.assertIn('translucency: node "candle", 72.8 mm of ', result.stderr)
        self.assertIn("mean free path 0.623 0.84 0.962 mm", result.stderr)

    def test_frames_of_a_deforming_object_have_the_bits_of_single_frames(self):
        walk = SOURCE / "examples" / "walk.glb"
        options = ("--translucency", "*=skin1", "--unit-mm", "30", "--scattering", "fast", *SIZE)
        self.burin("render", walk, "-o", "all.##.png", "--frames", "1-3", *options)
        self.burin("render", walk, "-o", "one.png", "--frames", "3", *options)
        self.assertEqual((self.folder / "all.03.png").read_bytes(), (self.folder / "one.png").read_bytes())

    def test_morph_to_sphere_reaches_the_picture(self):
        self.assertEqual(len({self.render("--morph-to-sphere", t) for t in ("0", "0.5", "1")}), 3)
        self.assertEqual(self.render("--morph-to-sphere", "0"), self.render())

    def test_patches_scatter_and_swell_into_a_sphere_too(self):
        jug = SOURCE / "examples" / "jug.bpt"
        options = ("--translucency", "*=marble", "--unit-mm", "10", "--scattering", "fast")
        opaque = self.render(source=jug)
        translucent = self.render(*options, source=jug)
        self.assertNotEqual(opaque, translucent)
        swollen = {self.render(*options, "--morph-to-sphere", t, source=jug) for t in ("0", "0.5", "1")}
        self.assertEqual(len(swollen), 3)
        self.assertIn(translucent, swollen)
        # A sphere's outline is as wide as it is high.
        self.burin("render", jug, "-o", "a.png", *SIZE, "--morph-to-sphere", "1", "--edges", "off")
        rows, channels, _ = read_png(self.folder / "a.png")
        covered = [[row[i + 3] > 0 for i in range(0, len(row), channels)] for row in rows]
        height = sum(any(row) for row in covered)
        width = sum(any(row[x] for row in covered) for x in range(len(covered[0])))
        self.assertAlmostEqual(width, height, delta=2)
        self.assertGreater(width, 32)

    def test_values_of_an_environment_that_are_no_light_are_counted(self):
        values = [1.0] * (3 * 8 * 4)
        values[5], values[20], values[21], values[30] = float("inf"), float("nan"), float("nan"), -5.0
        (self.folder / "odd.pfm").write_bytes(b"PF\n8 4\n-1.0\n" + struct.pack(f"<{len(values)}f", *values))
        result = self.burin("render", self.head, "-o", "a.png", *SIZE, "--environment", "odd.pfm")
        self.assertIn("warning: odd.pfm: of its values 2 not a number (taken as 0), 1 infinite (taken as 65504), "
                      "1 negative (taken as 0)", result.stderr)

    def test_what_is_likely_to_be_wrong_is_said(self):
        for options, message in (
                (("--translucency", "Skin*=skin1"),
                 f'--translucency "Skin*": no material has such a name; {self.head} has "head"'),
                (("--translucency", "head=scattering:0.001;absorption:2"), "were the two exchanged?"),
                (("--translucency", "head=marble", "--unit-mm", "1"), "is --unit-mm 1 right?"),
                (("--translucency", "head=marble", "--unit-mm", "1e6"), "so it looks opaque; is --unit-mm 1e+06 right?")):
            result = self.burin("render", self.head, "-o", "a.png", *SIZE, "--scattering", "fast", *options)
            self.assertIn(message, result.stderr)

    def test_wrong_values_are_refused(self):
        for options, message in (
                (("--translucency", "head=jade"), '--translucency: "jade" is no medium; expected a measured material'),
                (("--translucency", "head"), '--translucency: "head": expected GLOB=MEDIUM'),
                (("--translucency", "head=scattering:-1;absorption:1"),
                 "--translucency: scattering: -1,-1,-1 is out of range; expected 0 to 1000000 per millimetre"),
                (("--scattering", "slow"), "--scattering slow: expected one of paper|fast|full|high"),
                (("--unit-mm", "0"), "--unit-mm: 0 is not between 1e-09 and 1000000000"),
                (("--paper-kernel", "0"), "--paper-kernel"),
                (("--morph-to-sphere", "2"), "--morph-to-sphere: 2 is not between 0 and 1")):
            result = self.burin("render", self.head, "-o", "a.png", *options, status=2)
            self.assertIn(message, result.stderr)
        self.assertEqual(self.names(), [])

    def test_extras_that_cannot_be_read_are_an_error_of_the_file(self):
        self.write("bad.gltf", '{"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{}], "materials": [{"name": "wax", "extras": {"translucency": 3}}]}')
        result = self.burin("render", "bad.gltf", "-o", "a.png", *SIZE, status=3)
        self.assertIn('bad.gltf: materials[0] "wax".extras.translucency: ', result.stderr)


if __name__ == "__main__":
    unittest.main()
