#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Holds every #include to the arrows of docs/architecture.md.

    tools/check_layers.py [ROOT]       check the tree at ROOT (default: the one this file is in)
    tools/check_layers.py --self-test  plant faults in a temporary tree and see each one reported

Two rules. A module includes itself and what its arrows reach, directly or through other modules.
A third-party header is included from a .cpp file, never from a .h. Each breach is one line,
file:line: reason, and the exit status is 1.
"""

import re
import sys
import tempfile
from pathlib import Path

HEADER_SUFFIXES = {".h", ".hpp", ".inl"}
SOURCE_SUFFIXES = HEADER_SUFFIXES | {".cpp"}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')

# C++20, and the C headers and compiler intrinsics that every supported compiler brings.
STANDARD_HEADERS = set("""
algorithm any array atomic barrier bit bitset charconv chrono codecvt compare complex concepts
condition_variable coroutine deque exception execution filesystem format forward_list fstream
functional future initializer_list iomanip ios iosfwd iostream istream iterator latch limits list
locale map memory memory_resource mutex new numbers numeric optional ostream queue random ranges
ratio regex scoped_allocator semaphore set shared_mutex source_location span sstream stack stdexcept
stop_token streambuf string string_view strstream syncstream system_error thread tuple type_traits
typeindex typeinfo unordered_map unordered_set utility valarray variant vector version
cassert cctype cerrno cfenv cfloat cinttypes climits clocale cmath csetjmp csignal cstdarg cstddef
cstdint cstdio cstdlib cstring ctime cuchar cwchar cwctype
assert.h ctype.h errno.h fenv.h float.h inttypes.h limits.h math.h signal.h stdarg.h stddef.h
stdint.h stdio.h stdlib.h string.h time.h
immintrin.h emmintrin.h xmmintrin.h arm_neon.h
""".split())


class ArrowError(Exception):
    """docs/architecture.md does not describe layers."""


def read_arrows(text):
    """The fenced block ```arrows as {module: set of modules it names}; "*" names all of them."""
    block = re.search(r"^```arrows\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    if not block:
        raise ArrowError("there is no ```arrows block")
    arrows = {}
    for line in block.group(1).splitlines():
        if not line.strip():
            continue
        match = re.fullmatch(r"\s*(\w+)\s*->\s*(\*|\w+(?:\s*,\s*\w+)*)\s*", line)
        if not match:
            raise ArrowError(f"cannot read the arrow '{line}'")
        targets = {name.strip() for name in match.group(2).split(",")}
        arrows.setdefault(match.group(1), set()).update(targets)
        for name in targets - {"*"}:
            arrows.setdefault(name, set())
    return arrows


def reach(arrows):
    """{module: all modules it may include}, itself among them. A cycle is an ArrowError."""
    reached = {}

    def visit(module, trail):
        if module in trail:
            raise ArrowError("the arrows turn back: " + " -> ".join([*trail, module]))
        if module not in reached:
            targets = arrows[module]
            if "*" in targets:
                targets = {name for name, named in arrows.items() if "*" not in named}
            allowed = {module}
            for name in targets:
                allowed |= visit(name, [*trail, module])
            reached[module] = allowed
        return reached[module]

    for module in arrows:
        visit(module, [])
    return reached


def module_of(path, root):
    """The module that a path of the tree belongs to, or None."""
    parts = path.relative_to(root).parts
    if parts[:2] == ("src", "dewbow") and len(parts) > 3:
        return parts[2]
    if parts[0] in ("apps", "python"):
        return parts[0]
    return None


def included_module(bracket, name, source, root):
    """The module that an #include reaches into, or None when it is not one of ours."""
    parts = name.split("/")
    if parts[0] == "dewbow" and len(parts) > 2 and ".." not in parts:
        return parts[1]
    local = (source.parent / name).resolve()
    if bracket == '"' and local.is_file() and local.is_relative_to(root):
        return module_of(local, root) or "a file outside every module"
    return None


def check_file(path, root, allowed):
    """Yields a line for each #include of the file that breaks a rule."""
    shown = path.relative_to(root)
    module = module_of(path, root)
    if module not in allowed:
        yield f"{shown}:1: module '{module}' has no arrow in docs/architecture.md"
        return
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        bracket, name = match.groups()
        target = included_module(bracket, name, path, root)
        if target is None:
            if path.suffix in HEADER_SUFFIXES and name not in STANDARD_HEADERS:
                yield f"{shown}:{number}: third-party header {name} in a header; move it to a .cpp"
        elif target not in allowed[module]:
            yield f"{shown}:{number}: {module} may not include {target} ({name})"


def check_tree(root):
    """All breaches of the tree at root, in the order of the files, and how many files were read."""
    allowed = reach(read_arrows((root / "docs/architecture.md").read_text(encoding="utf-8")))
    files = sorted(
        path
        for folder in ("src/dewbow", "apps", "python")
        for path in (root / folder).rglob("*")
        if path.suffix in SOURCE_SUFFIXES and module_of(path, root)
    )
    return [line for path in files for line in check_file(path, root, allowed)], len(files)


def self_test():
    good = {
        "docs/architecture.md": "x\n```arrows\nmath -> base\nrender -> math\nimage -> base\napps -> *\n```\n",
        "src/dewbow/base/a.h": "#include <vector>\n#include <cmath>\n",
        "src/dewbow/base/a.cpp": '#include "dewbow/base/a.h"\n\n#include <tbb/parallel_for.h>\n',
        "src/dewbow/math/deep/b.h": '#include "dewbow/base/a.h"\n',
        "src/dewbow/render/c.h": '#include "dewbow/base/a.h"\n#include "dewbow/math/deep/b.h"\n',
        "apps/dewbow/main.cpp": '#include "dewbow/render/c.h"\n#include "local.h"\n',
        "apps/dewbow/local.h": "#pragma once\n",
    }
    arrows = good["docs/architecture.md"]
    planted = [
        ("an include that turns back", "src/dewbow/base/a.h",
         '#pragma once\n#include "dewbow/math/deep/b.h"\n', "base/a.h:2: base may not include math"),
        ("a neighbour without an arrow", "src/dewbow/image/d.cpp",
         '#include "dewbow/math/deep/b.h"\n', "image/d.cpp:1: image may not include math"),
        ("the same in angle brackets", "src/dewbow/image/d.cpp",
         "#  include <dewbow/math/deep/b.h>\n", "image/d.cpp:1: image may not include math"),
        ("the same by a relative path", "src/dewbow/image/d.cpp",
         '#include "../math/deep/b.h"\n', "image/d.cpp:1: image may not include math"),
        ("a module that includes an app", "src/dewbow/render/e.cpp",
         '#include "../../../apps/dewbow/local.h"\n', "render/e.cpp:1: render may not include apps"),
        ("a third-party header in a header", "src/dewbow/base/f.h",
         "#include <tbb/tbb.h>\n", "base/f.h:1: third-party header tbb/tbb.h"),
        ("a third-party header in an app's header", "apps/dewbow/local.h",
         "#include <CLI/CLI.hpp>\n", "local.h:1: third-party header CLI/CLI.hpp"),
        ("a module without an arrow", "src/dewbow/stray/g.cpp", "\n", "module 'stray' has no arrow"),
        ("arrows in a circle", "docs/architecture.md",
         arrows.replace("apps", "base -> render\napps"), "the arrows turn back"),
        ("no arrows", "docs/architecture.md", "nothing\n", "no ```arrows block"),
    ]

    def report(tree):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder).resolve()
            for name, text in tree.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text, encoding="utf-8")
            try:
                return check_tree(root)[0]
            except ArrowError as error:
                return [str(error)]

    failures = 0
    if report(good):
        failures += 1
        print("a good tree is refused:", *report(good), sep="\n  ")
    for what, name, text, expected in planted:
        found = report({**good, name: text})
        if len(found) != 1 or expected not in found[0]:
            failures += 1
            print(f"{what}: expected '{expected}', got {found}")
    print(f"{len(planted)} planted faults, {failures} failures")
    return 1 if failures else 0


def main(arguments):
    if arguments == ["--self-test"]:
        return self_test()
    root = Path(arguments[0] if arguments else Path(__file__).parent.parent).resolve()
    try:
        breaches, count = check_tree(root)
    except (OSError, ArrowError) as error:
        print(f"docs/architecture.md: {error}")
        return 1
    print(*breaches, f"{count} files, {len(breaches)} breaches", sep="\n")
    return 1 if breaches else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
