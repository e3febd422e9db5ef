# SPDX-License-Identifier: Apache-2.0
"""--edges and its options: every mode, what is refused, and what stays as it is."""
import unittest

from burin_cli import SOURCE, BurinTest, gradient, identity, read_png, write_png

SIZE = ("--size", "96x64")
MODES = ("off", "unsorted", "sorted", "resolve")


class Edges(BurinTest):
    def setUp(self):
        super().setUp()
        self.scene = SOURCE / "examples" / "still_life.glb"
        if not self.scene.exists():
            self.skipTest(f"{self.scene} is not there")

    def render(self, *options, name="a.png", source=None):
        """The file's bytes."""
        self.burin("render", source or self.scene, "-o", name, *SIZE, *options)
        return (self.folder / name).read_bytes()

    def test_every_mode_makes_a_picture_of_its_own(self):
        pictures = {mode: self.render("--edges", mode) for mode in MODES}
        self.assertEqual(len(set(pictures.values())), len(MODES))
        for mode, picture in pictures.items():
            self.assertEqual(self.render("--edges", mode), picture, f"{mode}: a second run")

    def test_resolve_is_the_default(self):
        self.assertEqual(self.render(), self.render("--edges", "resolve"))

    def test_edges_get_colours_in_between(self):
        def greys(mode):
            self.render("--edges", mode, "--background", "white")
            rows, _, _ = read_png(self.folder / "a.png")
            return len({tuple(row[i:i + 3]) for row in rows for i in range(0, len(row), 4)})

        off = greys("off")
        for mode in MODES[1:]:
            self.assertGreater(greys(mode), off, mode)

    def test_data_has_the_same_bits_in_every_mode(self):
        data = ("--attributes", "objectid,materialid,primitiveid,depth,normal,albedo")
        first = self.render("--edges", "off", *data, name="a.exr")
        for mode in MODES[1:]:
            self.assertEqual(self.render("--edges", mode, *data, name="a.exr"), first, mode)

    def test_the_options_reach_the_picture(self):
        for mode, options in (("sorted", ("--edge-tau", "0")), ("sorted", ("--edge-order", "object")),
                              ("sorted", ("--crease-angle", "5")), ("resolve", ("--crease-angle", "1"))):
            self.assertNotEqual(self.render("--edges", mode), self.render("--edges", mode, *options), options)
        for mode, options in (("sorted", ("--edge-tau", "0.9")), ("sorted", ("--edge-order", "scene")),
                              ("sorted", ("--crease-angle", "60")), ("resolve", ("--edge-tau", "0")),
                              ("resolve", ("--edge-order", "object")), ("off", ("--crease-angle", "5"))):
            self.assertEqual(self.render("--edges", mode), self.render("--edges", mode, *options), options)

    def test_the_ends_of_the_ranges_are_in_them(self):
        for option, values in (("--crease-angle", ("0", "180")), ("--edge-tau", ("0", "1", "1e-3"))):
            for value in values:
                self.render("--edges", "sorted", option, value)

    def test_wrong_values_are_refused(self):
        for options, message in (
                (("--edges", "on"), "--edges on: expected one of off|unsorted|sorted|resolve"),
                (("--edges", ""), "--edges : expected one of off|unsorted|sorted|resolve"),
                (("--edge-order", "none"), "--edge-order none: expected one of scene|object"),
                (("--crease-angle", "181"), "--crease-angle: 181 is not between 0 and 180"),
                (("--crease-angle", "-1"), "--crease-angle: -1 is not between 0 and 180"),
                (("--crease-angle", "steep"), "--crease-angle steep: expected a number"),
                (("--edge-tau", "1.5"), "--edge-tau: 1.5 is not between 0 and 1"),
                (("--edge-tau", "nan"), "--edge-tau nan: expected a number"),
                (("--edge-tau",), "--edge-tau needs a value: --edge-tau T")):
            result = self.burin("render", self.scene, "-o", "a.png", *options, status=2)
            self.assertIn(f"{message}\n", result.stderr)
        self.assertEqual(self.names(), [])

    def test_a_picture_has_no_edges_of_a_scene(self):
        write_png(self.folder / "in.png", gradient(5, 3, 3), 3)
        for mode in MODES:
            result = self.burin("render", "in.png", "-o", "out.png", "--edges", mode, "--progress", "none")
            self.assertEqual(result.stderr, "")
            self.assertEqual(read_png(self.folder / "out.png"), read_png(self.folder / "in.png"))

    def test_edges_and_samples_go_together(self):
        pictures = {(mode, n): self.render("--edges", mode, "--samples", n) for mode in MODES for n in ("1", "4")}
        self.assertEqual(len(set(pictures.values())), len(pictures))

    def test_effects_see_the_smooth_colour_and_the_exact_data(self):
        self.write("copy.fx", identity())
        for mode in MODES:
            self.render("--edges", mode, name="plain.png")
            self.burin("render", "copy.fx", self.scene, "-o", "copy.png", "--edges", mode, *SIZE)
            self.assertEqual(read_png(self.folder / "copy.png"), read_png(self.folder / "plain.png"), mode)
        self.write("normal.fx", identity().replace("GBAcolor", "GBAnormal"))
        pictures = set()
        for mode in MODES:
            self.burin("render", "normal.fx", self.scene, "-o", "n.png", "--edges", mode, *SIZE)
            pictures.add((self.folder / "n.png").read_bytes())
        self.assertEqual(len(pictures), 1)

    def test_an_animation_has_the_bits_of_single_frames(self):
        walk = SOURCE / "examples" / "walk.glb"  # a skin, morph targets, rigid parts
        for mode in MODES[1:]:
            self.burin("render", walk, "-o", f"{mode}.##.png", "--frames", "1-5", "--edges", mode, *SIZE)
            self.burin("render", walk, "-o", "one.png", "--frames", "4", "--edges", mode, *SIZE)
            self.assertEqual((self.folder / f"{mode}.04.png").read_bytes(), (self.folder / "one.png").read_bytes(), mode)


if __name__ == "__main__":
    unittest.main()
