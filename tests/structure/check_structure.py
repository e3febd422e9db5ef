#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Holds the sources against the layer rule of CONTRIBUTING.md.

Checks which room includes which, that no header includes a third party, that GL headers stay under core, that
every source file carries its licence line and that main() stays a driver. Prints one line a fault; exits 1 on any.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]

# A room may include itself and these. Nothing points back up.
ALLOWED = {
    "fx_parser": set(),
    "core/base": set(),
    "core/image": {"core/base"},
    "core/video": {"core/base", "core/image"},
    "core/gl": {"core/base", "core/image"},
    "core/geometry": {"core/base"},
    "core/tessellation": {"core/base", "core/geometry"},
    "core/scene": {"core/base", "core/image", "core/geometry", "core/tessellation"},
    "core/gbuffer": {"core/base", "core/image", "core/gl", "core/scene", "core/geometry", "core/tessellation"},
    "core/effect": {"core/base", "core/image", "core/gl", "fx_parser"},
    "core/overdraw": {"core/base", "core/image", "core/gl", "core/scene", "core/geometry", "core/tessellation",
                      "core/gbuffer"},
    "core/translucency": {"core/base", "core/image", "core/gl", "core/scene", "core/geometry", "core/tessellation",
                          "core/gbuffer"},
    "core/render": {"core/base", "core/image", "core/video", "core/gl", "core/scene", "core/geometry", "core/tessellation",
                    "core/gbuffer", "core/overdraw", "core/translucency", "core/effect", "fx_parser"},
    "cli": {"core/render", "core/base", "fx_parser"},   # fx_parser: diagnostics as JSON, near names
}
# Only these rooms may name these libraries, and only in .cpp files.
THIRD_PARTY_HOMES = {
    "OpenImageIO/": {"core/image"}, "OpenEXR/": {"core/image"}, "Imath/": {"core/image"}, "OpenColorIO/": {"core/image"},
    "opencv2/": {"core/video"}, "tiny_gltf.h": {"core/scene"}, "opensubdiv/": {"core/geometry"}, "CLI/": {"cli"},
    "epoxy/": {"core/gl", "core/gbuffer", "core/overdraw", "core/translucency", "core/effect", "core/render"},
}
HEADER_THIRD_PARTIES = ("glm/",)   # the one vector type, allowed in headers
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.M)
STANDARD = re.compile(r"^[a-z_0-9]+(\.h)?$|^(sys|arpa|linux|experimental|netinet)/")


def room_of(path):
    parts = path.split("/")
    return "/".join(parts[:2]) if parts[0] == "core" else parts[0]


def check_include(name, room, is_header, bracket, target):
    if bracket == '"':
        other = room_of(target)
        if other not in ALLOWED:
            return f'{name}: includes "{target}", which is no room'
        if other != room and other not in ALLOWED[room]:
            return f"{name}: room {room} may not include {other} ({target})"
        return None
    if STANDARD.match(target):
        return None
    if is_header and not target.startswith(HEADER_THIRD_PARTIES):
        return f"{name}: a header includes the third party <{target}>"
    if room == "fx_parser":
        return f"{name}: fx_parser includes the third party <{target}>"
    for prefix, homes in THIRD_PARTY_HOMES.items():
        if target.startswith(prefix) and room not in homes:
            return f"{name}: <{target}> belongs to {', '.join(sorted(homes))}"
    return None


def main():
    faults = []
    files = [f for top in ("cli", "core", "fx_parser", "tests") for f in sorted((ROOT / top).rglob("*"))
             if f.suffix in (".cpp", ".h")]
    for file in files:
        name = file.relative_to(ROOT).as_posix()
        text = file.read_text(encoding="utf-8")
        if not text.startswith("// SPDX-License-Identifier: Apache-2.0\n"):
            faults.append(f"{name}: the first line is not its SPDX licence line")
        if name.startswith("tests/"):
            continue
        room = room_of(name)
        if room not in ALLOWED:
            faults.append(f"{name}: {room} is no room")
            continue
        if file.suffix == ".h" and "#pragma once" not in text:
            faults.append(f"{name}: no #pragma once")
        for bracket, target in INCLUDE.findall(text):
            fault = check_include(name, room, file.suffix == ".h", bracket, target)
            if fault:
                faults.append(fault)
    main_lines = len((ROOT / "cli/main.cpp").read_text().splitlines())
    if main_lines > 40:
        faults.append(f"cli/main.cpp: {main_lines} lines, 40 are allowed")
    for fault in faults:
        print(fault)
    print(f"{len(files)} files checked, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
