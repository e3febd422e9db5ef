# SPDX-License-Identifier: Apache-2.0
"""Effects in the dialects of other hosts, on scenes and on pictures."""
import unittest

from burin_cli import SOURCE, BurinTest, gradient, read_png, write_png

EFFECTS = SOURCE / "tests/data/fx/dialects"
SCENE = SOURCE / "examples/still_life.glb"


class Dialects(BurinTest):
    def pixels(self, name):
        """Red, green and blue of every pixel."""
        rows, channels, _ = read_png(self.folder / name)
        return [tuple(row[at:at + 3]) for row in rows for at in range(0, len(row), channels)]

    def test_a_postprocess_script_works_on_a_picture(self):
        write_png(self.folder / "a.png", gradient(7, 5, 3), 3)
        self.burin("render", EFFECTS / "sas_invert.fx", "a.png", "-o", "b.png")
        expected = [tuple(255 - value for value in pixel) for pixel in self.pixels("a.png")]
        # Direct3D 9's half pixel is given 63/64 of its length, so that a linear filter blends 1/128 of a neighbour in.
        for actual, wanted in zip(self.pixels("b.png"), expected, strict=True):
            for a, b in zip(actual, wanted):
                self.assertLessEqual(abs(a - b), 3, (actual, wanted))

    def test_an_object_script_needs_a_scene(self):
        write_png(self.folder / "a.png", gradient(7, 5, 3), 3)
        result = self.burin("render", EFFECTS / "sas_plastic.fx", "a.png", "-o", "b.png", status=3)
        self.assertIn("it draws the geometry of a scene, but the source is none", result.stderr)

    def test_effects_of_every_dialect_draw_a_scene(self):
        if not SCENE.exists():
            self.skipTest(f"{SCENE} is not there")
        for name in ("d3d9_lambert.fx", "sas_plastic.fx", "cg_phong.cgfx"):
            self.burin("render", EFFECTS / name, SCENE, "-o", "a.png", "--size", "48x32")
            self.assertGreater(len(set(self.pixels("a.png"))), 30, name)

    def test_values_outside_the_effects_limits_are_said(self):
        write_png(self.folder / "a.png", gradient(7, 5, 3), 3)
        result = self.burin("render", EFFECTS / "sas_bloom.fx", "a.png", "-o", "b.png", "--param", "Glow=9")
        self.assertIn("parameter 'Glow' is 9, above its greatest 2", result.stderr)

    def test_a_texture_takes_a_picture(self):
        write_png(self.folder / "a.png", gradient(7, 5, 3), 3)
        effect = EFFECTS / "d3d9_macros.fx"
        self.burin("render", effect, "-o", "b.png", "--size", "8x8")
        self.burin("render", effect, "-o", "c.png", "--size", "8x8", "--texture", "FirstTex=a.png")
        self.assertNotEqual(self.pixels("b.png"), self.pixels("c.png"))


if __name__ == "__main__":
    unittest.main()
