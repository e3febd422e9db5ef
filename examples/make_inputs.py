#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the example scenes beside it: still_life.glb, walk.glb, candle.glb and head.glb. The same bytes on every machine.

    examples/make_inputs.py [FOLDER]      writes into FOLDER (default: its own)
    examples/make_inputs.py --check       exits with 1 when the files in its folder differ from what it would write
"""

import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import candle
import still_life
import walk

MAKERS = {"still_life.glb": still_life.make, "walk.glb": walk.make, "candle.glb": candle.make_candle,
          "head.glb": candle.make_head}


def main(arguments):
    here = pathlib.Path(__file__).resolve().parent
    if arguments == ["--check"]:
        stale = [name for name, make in MAKERS.items() if (here / name).read_bytes() != make()]
        for name in stale:
            print(f"{here / name}: differs from what make_inputs.py makes", file=sys.stderr)
        return 1 if stale else 0
    folder = pathlib.Path(arguments[0]) if arguments else here
    for name, make in MAKERS.items():
        (folder / name).write_bytes(make())
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
