#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Hindsight authors
# SPDX-License-Identifier: BSD-2-Clause
"""check_architecture.py SOURCE-DIR: holds every #include and every linked target to floors.toml.

Prints one line a violation; exit status 1 if there is any.
"""

import pathlib
import re
import sys
import tomllib

RULES = tomllib.loads((pathlib.Path(__file__).parent / "floors.toml").read_text())
FLOORS = RULES["floor"]
LIBRARIES = RULES["library"]
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')
LINKING = re.compile(r"\b(?:hindsight_library|target_link_libraries)\s*\(([^)]*)\)")
LINK_WORDS = {"PUBLIC", "PRIVATE", "INTERFACE"}


def library_violations(floor, name, kind):
    for library, rule in LIBRARIES.items():
        if name.startswith(tuple(rule[kind])) and floor not in rule["floors"]:
            yield f"{library} may be used in {', '.join(rule['floors'])} only"


def include_violations(floor, header):
    yield from library_violations(floor, header, "headers")
    if ".." in pathlib.PurePath(header).parts:
        yield "include from the top of the source tree"
    owner = header.split("/")[0]
    allowed = header in FLOORS[floor]["headers"] or owner in [floor, *FLOORS[floor]["includes"]]
    if "/" in header and owner in FLOORS and not allowed:
        yield f"{floor} may not include this header of {owner}"


def link_violations(floor, name):
    yield from library_violations(floor, name, "links")
    target = name.removeprefix("hindsight_")
    allowed = [floor, "options", *FLOORS[floor]["links"]]
    if name.startswith("hindsight_") and target not in allowed:
        yield f"{floor} may not link this"


def uses(folder):
    """Each include and link below a folder: (file, line, name, check)."""
    for path in sorted(folder.rglob("*")):
        if path.suffix in (".h", ".cpp"):
            for number, line in enumerate(path.read_text().splitlines(), 1):
                if match := INCLUDE.match(line):
                    yield path, number, match[1], include_violations
        elif path.name == "CMakeLists.txt":
            text = path.read_text()
            for match in LINKING.finditer(text):
                number = text.count("\n", 0, match.start()) + 1
                for name in set(match[1].split()[1:]) - LINK_WORDS:
                    yield path, number, name, link_violations


def violations(source):
    for folder in sorted(p for p in source.iterdir() if p.is_dir()):
        holds_code = folder.name not in ("tests", "docs") and not folder.name.startswith(("build", "."))
        if folder.name not in FLOORS and holds_code and any(folder.rglob("*.cpp")):
            yield f"{folder.name}: a folder of code without a floor"
    for floor in FLOORS:
        for path, number, name, check in uses(source / floor):
            for reason in check(floor, name):
                yield f"{path.relative_to(source)}:{number}: {name}: {reason}"


def main():
    found = list(violations(pathlib.Path(sys.argv[1])))
    print("\n".join(found) if found else "every include and link keeps to its floor")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
