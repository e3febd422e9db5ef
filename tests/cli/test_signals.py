# SPDX-License-Identifier: Apache-2.0
"""SIGTERM and SIGINT in the middle of a job: 128 + n, soon, and nothing half-written is left."""
import signal
import subprocess
import time
import unittest

from burin_cli import PROGRAM, BurinTest, gradient, grey_frames, identity, write_png, write_y4m


class Signals(BurinTest):
    def interrupted(self, arguments, number, stdin=None):
        """Starts a long job, waits until it writes frames, sends the signal."""
        process = subprocess.Popen([PROGRAM, "render", *arguments, "--progress", "json"], cwd=self.folder,
                                   stdin=subprocess.PIPE if stdin else subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, text=False)
        try:
            if stdin:
                process.stdin.write(stdin)
                process.stdin.flush()
            lines = []
            while True:
                line = process.stderr.readline().decode()
                self.assertTrue(line, f"ended before it was interrupted: {lines}")
                lines.append(line)
                if '"event":"frame"' in line:
                    break
            process.send_signal(number)
            start = time.monotonic()
            rest = process.stderr.read().decode()
            status = process.wait(timeout=30)
            self.assertLess(time.monotonic() - start, 20)
            return status, "".join(lines) + rest
        finally:
            process.kill()
            process.wait()
            process.stderr.close()
            if process.stdin:
                try:
                    process.stdin.close()
                except BrokenPipeError:
                    pass

    def test_an_unfinished_video_goes(self):
        self.write("copy.fx", identity())
        write_png(self.folder / "in.png", gradient(64, 64, 3), 3)
        for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
            status, events = self.interrupted(["copy.fx", "in.png", "-o", "out.mkv", "--frames", "1-1000000"], number)
            self.assertEqual(status, 128 + number)
            self.assertEqual(self.names(), ["copy.fx", "in.png"])
            self.assertEqual(events.count('"event":"end"'), 1)
            self.assertIn("interrupted", events)

    def test_finished_images_stay_and_are_whole(self):
        self.write("copy.fx", identity())
        write_png(self.folder / "in.png", gradient(64, 64, 3), 3)
        status, _ = self.interrupted(["copy.fx", "in.png", "-o", "out.#######.png", "--frames", "1-1000000"], signal.SIGTERM)
        self.assertEqual(status, 143)
        written = [name for name in self.names() if name not in ("copy.fx", "in.png")]
        self.assertTrue(written)
        for name in written:
            self.assertRegex(name, r"\Aout\.\d{7}\.png\Z")
            self.assertTrue((self.folder / name).read_bytes().endswith(b"IEND\xaeB`\x82"), name)

    def test_a_wait_for_input_ends_too(self):
        self.write("copy.fx", identity())
        stream = write_y4m(grey_frames(6, 64, 48), 64, 48)
        status, _ = self.interrupted(["copy.fx", "-", "-o", "out.mkv"], signal.SIGTERM, stdin=stream)
        self.assertEqual(status, 143)
        self.assertEqual(self.names(), ["copy.fx"])


if __name__ == "__main__":
    unittest.main()
