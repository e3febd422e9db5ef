# SPDX-License-Identifier: Apache-2.0
"""Videos and y4m streams: through pipes, whole or not at all, cut-off inputs, readers that leave."""
import subprocess
import unittest

from burin_cli import PROGRAM, BurinTest, gradient, grey_frames, identity, read_png, read_y4m, write_png, write_y4m


class Y4m(BurinTest):
    def setUp(self):
        super().setUp()
        self.write("copy.fx", identity())
        self.frames = grey_frames(8, 16, 10)
        self.stream = write_y4m(self.frames, 16, 10, "30000:1001")

    def test_a_stream_goes_through_unchanged_but_for_rounding(self):
        result = self.burin("render", "copy.fx", "-", "-o", "-", stdin=self.stream)
        fields, frames = read_y4m(result.stdout)
        self.assertEqual((fields["W"], fields["H"], fields["F"]), ("16", "10", "30000:1001"))
        self.assertEqual(len(frames), len(self.frames))
        for got, expected in zip(frames, self.frames):
            self.assertLessEqual(max(abs(a - b) for a, b in zip(got, expected)), 1)

    def test_an_intensity_alone_is_the_luma_of_the_picture(self):
        # Alone, an 8-bit intensity is computed before the upload; from the colour, the effect computes it on the device.
        effect = ("texture {0}; sampler s = sampler_state {{ Texture = <{0}>; AddressU = CLAMP; AddressV = CLAMP; }};\n"
                  "float4 P(float2 uv : TEXCOORD0) : COLOR {{ return float4({1}, 1); }}\n"
                  "technique T {{ pass P0 {{ PixelShader = compile ps_2_0 P(); }} }}\n")
        self.write("alone.fx", effect.format("GBAintensity_L8", "tex2D(s, uv).rgb"))
        self.write("dot.fx", effect.format(
            "GBAcolor_X8R8G8B8", "dot(tex2D(s, uv).rgb, float3(0.2126, 0.7152, 0.0722)).xxx"))
        planes = [bytes(40 + (x * step + y * 7) % 160 for y in range(10) for x in range(16)) for step in (3, 5, 11)]
        stream = write_y4m([b"".join(planes)], 16, 10)
        for name in ("alone", "dot"):
            self.burin("render", f"{name}.fx", "-", "-o", f"{name}.png", "--frames", "1", stdin=stream)
        alone, dot = (read_png(self.folder / f"{name}.png")[0] for name in ("alone", "dot"))
        differences = [abs(a - b) for left, right in zip(alone, dot) for a, b in zip(left, right)]
        self.assertLessEqual(max(differences), 1)
        self.assertGreater(len({value for row in alone for value in row}), 20)

    def test_chroma_is_the_sources_unless_asked_for(self):
        stream = write_y4m([bytes([90]) * 160 + bytes([128]) * 80] * 2, 16, 10, chroma="420jpeg")
        fields, frames = read_y4m(self.burin("render", "copy.fx", "-", "-o", "-", stdin=stream).stdout)
        self.assertTrue(fields["C"].startswith("420"), fields)
        self.assertEqual(len(frames), 2)
        fields, _ = read_y4m(self.burin("render", "copy.fx", "-", "-o", "-", "--chroma", "444", stdin=stream).stdout)
        self.assertTrue(fields["C"].startswith("444"), fields)

    def test_stdout_holds_data_only(self):
        result = self.burin("render", "copy.fx", "-", "-o", "-", "-v", "--progress", "json", stdin=self.stream)
        self.assertTrue(result.stdout.startswith(b"YUV4MPEG2 "))
        self.assertIn('"event":"end"', result.stderr)
        self.burin("render", "copy.fx", "-", "-o", "-", "--progress-fd", "1", stdin=self.stream, status=2)

    def test_chosen_frames_of_a_stream(self):
        self.burin("render", "copy.fx", "-", "-o", "f.#.png", "--frames", "2,5", stdin=self.stream)
        self.assertEqual([n for n in self.names() if n.endswith(".png")], ["f.2.png", "f.5.png"])
        result = self.burin("render", "copy.fx", "-", "-o", "g.##.png", "--frames", "7-9", stdin=self.stream, status=3)
        self.assertIn("the source ends before frame 9", result.stderr)

    def test_files_and_back(self):
        (self.folder / "in.y4m").write_bytes(self.stream)
        self.burin("render", "copy.fx", "in.y4m", "-o", "out.y4m")
        self.assertEqual(len(read_y4m((self.folder / "out.y4m").read_bytes())[1]), 8)
        self.burin("render", "copy.fx", "in.y4m", "-o", "f.####.png")
        self.burin("render", "copy.fx", "f.####.png", "-o", "again.y4m", "--fps", "30000/1001")
        self.assertEqual(read_y4m((self.folder / "again.y4m").read_bytes())[1],
                         read_y4m((self.folder / "out.y4m").read_bytes())[1])

    def test_lossless_video_has_the_bits_of_the_images(self):
        for frame in range(1, 5):
            write_png(self.folder / f"in.{frame}.png", gradient(32, 18, 3, seed=frame), 3)
        self.burin("render", "copy.fx", "in.#.png", "-o", "v.mkv")
        self.burin("render", "copy.fx", "v.mkv", "-o", "out.#.png")
        for frame in range(1, 5):
            self.assertEqual(read_png(self.folder / f"out.{frame}.png")[0], gradient(32, 18, 3, seed=frame))
        self.burin("render", "copy.fx", "v.mkv", "-o", "one.png", "--frames", "3")
        self.assertEqual((self.folder / "one.png").read_bytes(), (self.folder / "out.3.png").read_bytes())

    def test_rubbish_and_cut_off_streams_have_status_3(self):
        result = self.burin("render", "copy.fx", "-", "-o", "out.mkv", stdin=b"RIFF nonsense", status=3)
        self.assertIn("stdin", result.stderr)
        result = self.burin("render", "copy.fx", "-", "-o", "out.mkv", stdin=self.stream[:-50], status=3)
        self.assertIn("stdin", result.stderr)
        result = self.burin("render", "copy.fx", "-", "-o", "out.mkv", stdin=b"", status=3)
        self.assertEqual(self.names(), ["copy.fx"])

    def test_a_cut_off_video_has_status_3_and_leaves_nothing(self):
        clip = self.shared("video/rabbit320.mp4").read_bytes()
        (self.folder / "cut.mp4").write_bytes(clip[:len(clip) // 2])
        self.burin("render", "copy.fx", "cut.mp4", "-o", "out.mkv", status=3)
        self.assertEqual(self.names(), ["copy.fx", "cut.mp4"])

    def test_a_real_video(self):
        clip = self.shared("video/rabbit320.mp4")
        self.burin("render", "edges/sobel", clip, "-o", "e.mkv", "--frames", "1-10")
        self.assertIn("frames    10", self.burin("info", "e.mkv").stdout.decode())

    def test_a_reader_that_leaves_ends_the_program_as_sigpipe_does(self):
        with subprocess.Popen([PROGRAM, "render", "copy.fx", "-", "-o", "-"], cwd=self.folder, stdin=subprocess.PIPE,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            process.stdin.write(self.stream[:self.stream.index(b"\n") + 1])
            frame = b"FRAME\n" + self.frames[0]
            process.stdin.write(frame * 4)
            process.stdin.flush()
            process.stdout.read(20)
            process.stdout.close()
            try:
                for _ in range(200000):
                    process.stdin.write(frame)
            except BrokenPipeError:
                pass
            try:
                process.stdin.close()
            except BrokenPipeError:
                pass
            self.assertEqual(process.wait(timeout=60), 141, process.stderr.read())


if __name__ == "__main__":
    unittest.main()
