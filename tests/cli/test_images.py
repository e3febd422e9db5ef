# SPDX-License-Identifier: Apache-2.0
"""Images and image sequences through effects: exact pixels, names, frames, whole files."""
import json
import subprocess
import unittest

from burin_cli import IDENTITY, INVERT, NUMBERS, PROGRAM, SOURCE, BurinTest, gradient, identity, read_exr_channels, read_png, write_png


class Exact(BurinTest):
    def copied(self, width, height, channels, bits=8, effect=None, seed=1):
        rows = gradient(width, height, channels, 255 if bits == 8 else 65535, seed)
        write_png(self.folder / "in.png", rows, channels, bits)
        arguments = ["render", *([effect] if effect else []), "in.png", "-o", "out.png"]
        self.burin(*arguments)
        return rows, read_png(self.folder / "out.png")

    def test_an_identity_effect_copies_every_bit_at_any_size(self):
        self.write("copy.fx", identity())
        for width, height in ((1, 1), (2, 3), (7, 5), (64, 64), (101, 33), (33, 101), (257, 3)):
            for channels in (3, 4):
                rows, (result, got, bits) = self.copied(width, height, channels, effect="copy.fx", seed=width)
                self.assertEqual((got, bits), (channels, 8))
                self.assertEqual(result, rows, f"{width}x{height}x{channels}")

    def test_16_bits_stay_16_bits(self):
        self.write("copy.fx", identity("A16B16G16R16"))
        rows, (result, channels, bits) = self.copied(13, 9, 3, 16, "copy.fx")
        self.assertEqual((channels, bits), (3, 16))
        self.assertEqual(result, rows)

    def test_grey_becomes_rgb(self):
        self.write("copy.fx", identity())
        rows, (result, channels, _) = self.copied(9, 4, 1, effect="copy.fx")
        self.assertEqual(channels, 3)
        self.assertEqual(result, [[value for value in row for _ in range(3)] for row in rows])

    def test_no_effect_copies_too(self):
        rows, (result, _, _) = self.copied(31, 17, 4)
        self.assertEqual(result, rows)

    def test_effects_chain(self):
        self.write("invert.fx", INVERT)
        rows = gradient(11, 6, 3)
        write_png(self.folder / "in.png", rows, 3)
        self.burin("render", "invert.fx", "in.png", "-o", "once.png")
        self.assertEqual(read_png(self.folder / "once.png")[0], [[255 - v for v in row] for row in rows])
        self.burin("render", "invert.fx", "invert.fx", "in.png", "-o", "twice.png")
        self.assertEqual(read_png(self.folder / "twice.png")[0], rows)

    def test_alpha_is_kept_or_dropped(self):
        rows = gradient(6, 5, 4)
        write_png(self.folder / "in.png", rows, 4)
        self.burin("render", "in.png", "-o", "out.png", "--alpha", "drop")
        result, channels, _ = read_png(self.folder / "out.png")
        self.assertEqual(channels, 3)
        self.assertEqual(result, [[v for i, v in enumerate(row) if i % 4 != 3] for row in rows])

    def test_two_runs_write_the_same_bytes(self):
        write_png(self.folder / "in.png", gradient(40, 30, 3), 3)
        for name in ("png", "exr", "jpg", "tif", "mkv", "y4m"):
            for run in ("a", "b"):
                self.burin("render", "edges/sobel", "in.png", "-o", f"{run}.{name}")
            self.assertEqual((self.folder / f"a.{name}").read_bytes(), (self.folder / f"b.{name}").read_bytes(), name)

    def test_size_resizes_pictures(self):
        write_png(self.folder / "in.png", [[10, 200, 30] * 8] * 8, 3)
        self.burin("render", "in.png", "-o", "out.png", "--size", "5x3")
        result, _, _ = read_png(self.folder / "out.png")
        self.assertEqual(result, [[10, 200, 30] * 5] * 3)

    def test_a_parameter_changes_the_result(self):
        self.write("scale.fx", "float Gain = 1;\n" + identity().replace("tex2D(Source, uv)", "tex2D(Source, uv) * Gain"))
        write_png(self.folder / "in.png", [[100, 50, 20] * 4] * 4, 3)
        self.burin("render", "scale.fx", "in.png", "-o", "out.png", "--param", "Gain=2")
        self.assertEqual(read_png(self.folder / "out.png")[0], [[200, 100, 40] * 4] * 4)

    def test_an_effect_alone_needs_no_source(self):
        self.write("fill.fx", "float4 F(float2 uv : TEXCOORD0) : COLOR { return float4(0, 1, 0.2, 1); }\n"
                              "technique T { pass P { PixelShader = compile ps_2_0 F(); } }\n")
        self.burin("render", "fill.fx", "-o", "out.png", "--size", "3x2", "--alpha", "drop")
        self.assertEqual(read_png(self.folder / "out.png")[0], [[0, 255, 51] * 3] * 2)

    def test_exr_is_half_and_scene_linear(self):
        write_png(self.folder / "in.png", [[255, 0, 188] * 3] * 3, 3)
        self.burin("render", "in.png", "-o", "out.exr")
        self.assertEqual(read_exr_channels(self.folder / "out.exr"), {"R": 1, "G": 1, "B": 1})
        self.burin("render", "in.png", "-o", "out32.exr", "--depth", "32")
        self.assertEqual(read_exr_channels(self.folder / "out32.exr"), {"R": 2, "G": 2, "B": 2})
        # There and back: display to linear half to display.
        self.burin("render", "out.exr", "-o", "back.png")
        self.assertEqual(read_png(self.folder / "back.png")[0], [[255, 0, 188] * 3] * 3)


class Colour(BurinTest):
    """A constant of scene-linear light through display transforms; the numbers are worked out here."""

    def setUp(self):
        super().setUp()
        self.config = SOURCE / "tests" / "data" / "ocio" / "gamma22.ocio"
        self.write("quarter.fx", "float4 F(float2 uv : TEXCOORD0) : COLOR { return float4(0.25, 0.5, 0, 1); }\n"
                                 'technique T < string ColorSpace = "linear"; > '
                                 "{ pass P { PixelShader = compile ps_2_0 F(); } }\n")

    def pixel(self, *arguments, env=None):
        self.burin("render", "quarter.fx", "-o", "out.png", "--size", "2x2", "--alpha", "drop", *arguments, env=env or {})
        return read_png(self.folder / "out.png")[0][0][:3]

    def near(self, pixel, values):
        for got, expected in zip(pixel, values):
            self.assertAlmostEqual(got, 255 * expected, delta=0.51)

    def test_the_built_in_transform_is_srgb(self):
        self.near(self.pixel(), [1.055 * value ** (1 / 2.4) - 0.055 for value in (0.25, 0.5)] + [0])

    def test_a_configuration_by_option_and_by_environment(self):
        gamma = [value ** (1 / 2.2) for value in (0.25, 0.5, 0)]
        self.near(self.pixel("--ocio", self.config), gamma)
        self.near(self.pixel(env={"OCIO": str(self.config)}), gamma)
        self.near(self.pixel("--ocio", self.config, "--view", "Half Gamma"), [(v / 2) ** (1 / 2.2) for v in (0.25, 0.5, 0)])

    def test_exr_stays_scene_linear(self):
        self.burin("render", "quarter.fx", "-o", "out.exr", "--size", "2x2", "--ocio", self.config)
        self.burin("render", "out.exr", "-o", "back.png", "--ocio", self.config, "--alpha", "drop")
        self.near(read_png(self.folder / "back.png")[0][0], [value ** (1 / 2.2) for value in (0.25, 0.5, 0)])

    def test_display_pixels_through_a_display_effect_are_not_converted(self):
        self.write("copy.fx", identity())
        rows = gradient(9, 5, 3)
        write_png(self.folder / "in.png", rows, 3)
        self.burin("render", "copy.fx", "in.png", "-o", "same.png", "--ocio", self.config)
        self.assertEqual(read_png(self.folder / "same.png")[0], rows)

    def test_what_is_not_there_is_an_error(self):
        for arguments, name in ((["--ocio", "none.ocio"], "none.ocio"), (["--ocio", self.config, "--display", "Cinema"], "Cinema"),
                                (["--ocio", self.config, "--view", "Film"], "Film"), (["--view", "Film"], "--ocio")):
            command = ["render", "quarter.fx", "-o", "out.png", "--size", "2x2", *arguments]
            environment = self.environment()
            result = subprocess.run([PROGRAM, *map(str, command)], cwd=self.folder, env=environment, capture_output=True)
            self.assertIn(result.returncode, (2, 3), result.stderr)
            self.assertIn(name, result.stderr.decode())
        self.assertNotIn("out.png", self.names())


class Sequences(BurinTest):
    def setUp(self):
        super().setUp()
        self.frames = (3, 4, 7)
        for frame in self.frames:
            write_png(self.folder / f"in.{frame:04}.png", gradient(8, 6, 3, seed=frame), 3)
        self.write("copy.fx", identity())

    def test_the_frames_on_disk_keep_their_numbers(self):
        self.burin("render", "copy.fx", "in.####.png", "-o", "out/%05d.png", "--mkdir")
        self.assertEqual([name for name in self.names() if name.startswith("out")],
                         [f"out/{frame:05}.png" for frame in self.frames])
        for frame in self.frames:
            self.assertEqual(read_png(self.folder / f"out/{frame:05}.png")[0], gradient(8, 6, 3, seed=frame))

    def test_one_frame_has_the_bits_of_the_full_run(self):
        self.burin("render", "edges/sobel", "in.####.png", "-o", "all.####.png")
        self.burin("render", "edges/sobel", "in.####.png", "-o", "one.####.png", "--frames", "4")
        self.assertEqual((self.folder / "all.0004.png").read_bytes(), (self.folder / "one.0004.png").read_bytes())
        self.assertNotIn("one.0003.png", self.names())

    def test_a_missing_frame_is_an_error_that_names_what_there_is(self):
        result = self.burin("render", "copy.fx", "in.####.png", "-o", "out.####.png", "--frames", "3-5", status=3)
        self.assertIn("in.0005.png: no such file; the sequence has the frames 3,4,7", result.stderr)

    def test_keep_going_does_the_rest_and_has_status_1(self):
        result = self.burin("render", "copy.fx", "in.####.png", "-o", "out.####.png", "--frames", "3-7", "--keep-going",
                            status=1)
        self.assertIn("2 frames failed", result.stderr)
        self.assertEqual([n for n in self.names() if n.startswith("out")], ["out.0003.png", "out.0004.png", "out.0007.png"])

    def test_another_size_in_between_is_an_error(self):
        write_png(self.folder / "in.0005.png", gradient(9, 6, 3), 3)
        result = self.burin("render", "copy.fx", "in.####.png", "-o", "out.####.png", status=3)
        self.assertIn("in.0005.png: 9x6, but the sequence began with 8x6; --size WxH makes them one size", result.stderr)
        self.burin("render", "copy.fx", "in.####.png", "-o", "out.####.png", "--size", "8x6")

    def test_a_truncated_image_has_status_3_and_leaves_no_file(self):
        data = (self.folder / "in.0003.png").read_bytes()
        (self.folder / "cut.png").write_bytes(data[:len(data) // 2])
        result = self.burin("render", "copy.fx", "cut.png", "-o", "out.png", status=3)
        self.assertIn("cut.png", result.stderr)
        self.assertNotIn("out.png", self.names())

    def test_a_sequence_of_another_depth_is_refused_by_name(self):
        result = self.burin("render", "in.####.png", "-o", "out.png", status=2)
        self.assertIn("3 frames need a name with a place for the number", result.stderr)

    def test_negative_frames_of_an_effect(self):
        self.write("n.fx", NUMBERS)
        self.burin("render", "n.fx", "-o", "n.##.png", "--frames", "-2-1", "--size", "2x2", "--alpha", "drop")
        self.assertEqual([n for n in self.names() if n.endswith(".png") and n.startswith("n.")],
                         ["n.-01.png", "n.-02.png", "n.00.png", "n.01.png"])
        self.assertEqual(read_png(self.folder / "n.01.png")[0][0][0], 1)

    def test_frames_know_their_number(self):
        self.write("n.fx", NUMBERS)
        self.burin("render", "n.fx", "-o", "n.##.png", "--frames", "5-9x2", "--size", "2x2", "--alpha", "drop")
        for frame in (5, 7, 9):
            self.assertEqual(read_png(self.folder / f"n.{frame:02}.png")[0][0][0], frame)


class Progress(BurinTest):
    def setUp(self):
        super().setUp()
        for frame in (1, 2, 3):
            write_png(self.folder / f"in.{frame}.png", gradient(4, 4, 3), 3)

    def events(self, *arguments, status=0):
        result = self.burin("render", "in.#.png", "-o", "out.#.png", "--progress", "json", *arguments, status=status)
        return [json.loads(line) for line in result.stderr.splitlines() if line.startswith("{")]

    def test_json_has_a_line_a_frame_and_one_last_event(self):
        events = self.events()
        self.assertEqual([event["event"] for event in events], ["device", "start", "frame", "frame", "frame", "end"])
        self.assertEqual(events[1]["frames"], 3)
        self.assertEqual({event["path"] for event in events[2:5]}, {"out.1.png", "out.2.png", "out.3.png"})
        self.assertEqual((events[5]["status"], events[5]["frames"]), ("done", 3))
        self.assertTrue(events[0]["renderer"])

    def test_json_ends_once_on_failure_too(self):
        events = self.events("--frames", "1-5", status=3)
        self.assertEqual([event["event"] for event in events].count("end"), 1)
        self.assertEqual((events[-1]["event"], events[-1]["status"], events[-1]["exit_status"]), ("end", "failed", 3))

    def test_plain_lines_have_no_carriage_return(self):
        stderr = self.burin("render", "in.#.png", "-o", "out.#.png").stderr
        self.assertNotIn("\r", stderr)
        self.assertEqual(len([line for line in stderr.splitlines() if line.startswith("frame ")]), 3)

    def test_quiet_says_nothing(self):
        self.assertEqual(self.burin("render", "in.#.png", "-o", "out.#.png", "-q").stderr, "")

    def test_openjd_ends_at_100_percent(self):
        stderr = self.burin("render", "in.#.png", "-o", "out.#.png", "--progress", "openjd").stderr
        self.assertIn("openjd_progress: 100.00\n", stderr)

    def test_progress_can_go_to_another_descriptor(self):
        with open(self.folder / "log", "wb") as log:
            result = self.burin("render", "in.#.png", "-o", "out.#.png", "--progress", "json", "--progress-fd",
                                log.fileno(), pass_fds=[log.fileno()])
        self.assertEqual(result.stderr, "")
        self.assertEqual(len((self.folder / "log").read_text().splitlines()), 6)

    def test_verbose_names_the_device_and_the_technique(self):
        self.write("copy.fx", IDENTITY % {"format": "A8R8G8B8"})
        stderr = self.burin("render", "copy.fx", "in.1.png", "-o", "out.png", "-v").stderr
        self.assertIn("burin: device: ", stderr)
        self.assertIn("copy.fx: technique 'Identity'", stderr)


class Device(BurinTest):
    def test_a_device_that_is_not_there_has_status_4(self):
        write_png(self.folder / "in.png", gradient(4, 4, 3), 3)
        result = self.burin("render", "in.png", "-o", "out.png", "--device", "No Such Card 9000", status=4)
        self.assertIn("No Such Card 9000", result.stderr)
        self.assertEqual(self.names(), ["in.png"])

    def test_a_size_over_the_limit_is_refused(self):
        write_png(self.folder / "in.png", gradient(4, 4, 3), 3)
        result = self.burin("render", "in.png", "-o", "out.png", "--size", "1000000x4", status=1)
        self.assertIn("the frame is 1000000x4, over this device's limit of ", result.stderr)
        self.assertEqual(self.names(), ["in.png"])


if __name__ == "__main__":
    unittest.main()
