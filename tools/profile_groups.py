#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Where the time of a render goes, by what is done: a table in Markdown.

    tools/profile_groups.py callgrind.out.1 [callgrind.out.2 …]     instructions
    perf report -i perf.data --no-children --stdio --sort dso,sym | tools/profile_groups.py -

docs/profile.md says how to make such files. Several are columns side by side. What a function costs
itself falls on the first group whose pattern its name or its library matches.
"""
import collections
import re
import sys

GROUPS = [
    ("Embree's search of its tree", r"libembree"),
    ("leaving a stone", r"ConvexSolid::|nearest_facet|distances_to_facet|leave_undisturbed"),
    ("what Embree asks, and its answers", r"embree_callbacks|Accelerator|AnalyticShape|Affine::"),
    ("open lanes at boundaries",
     r"PacketWalk::(trace_open|open_|facing|has_true|material_at|tint_open|indices|lane_of|collapse)"
     r"|refract_or_reflect|PacketMedia::entry|LightSet::emits|MediaStack|boundary_at|mirror_normal"),
    ("random numbers", r"SampleKey"),
    ("wavelengths of a sample", r"sample_wavelengths|PiecewiseLinearDensity|visual_density"),
    ("camera rays", r"CameraRays|FilterSampler|Distribution1D"),
    ("spectra and indices", r"eval_lanes|dispersion::|PacketMedia|RgbLight|RgbReflectance"),
    ("lights", r"Light|Glow|Beam|CameraWalk::|power_heuristic"),
    ("film", r"FilmSums|xyz_from_lanes|dewbow::table\b"),
    ("allocation", r"\b(malloc|free|operator (new|delete)|_int_(malloc|free)|calloc|realloc)\b"),
    ("shared rays and surfaces", r"PacketWalk::|vertex_at|fresnel|cos2_|Surface|trace_"),
    ("mathematics library", r"libm\.so|ieee754|sincos|\bexp\b|\blog\b"),
]
REST = "the rest"


def group_of(function, library):
    # Without its arguments, whose types are named in other patterns.
    name = function.replace("(anonymous namespace)::", "").partition("(")[0] + " " + library
    return next((group for group, pattern in GROUPS if re.search(pattern, name)), REST)


def from_callgrind(lines):
    """Self cost by (function, library); callgrind names a thing once and then gives its number."""
    names, cost = {}, collections.Counter()
    function, library, after_call = "", "", False

    def named(kind, text):
        number, _, name = text.partition(" ")
        if name:
            names[kind, number] = name
        return names[kind, number]

    for line in map(str.rstrip, lines):
        key, _, value = line.partition("=")
        if key == "fn":
            function = named("fn", value)
        elif key == "ob":
            library = named("ob", value)
        elif key in ("cfn", "cob"):
            named(key[1:], value)
        elif key == "calls":
            after_call = True
        elif re.match(r"[+\-*\d]\S* \d+$", line):
            if not after_call:  # else the cost of the callee
                cost[function, library] += int(line.split()[1])
            after_call = False
    return cost


def from_perf(lines):
    cost = collections.Counter()
    for line in lines:
        found = re.match(r"\s*([\d.]+)%\s+(\S+)\s+\[.\] (.*)", line)
        if found:
            cost[found[3].strip(), found[2]] += float(found[1])
    return cost


def main(paths):
    columns = []
    for path in paths:
        cost = from_perf(sys.stdin) if path == "-" else from_callgrind(open(path))
        column = collections.Counter()
        for name, value in cost.items():
            column[group_of(*name)] += value
        columns.append(column)
    print("| what | " + " | ".join(paths) + " |\n|---" + "|---" * len(paths) + "|")
    for group in [g for g, _ in GROUPS] + [REST]:
        cells = [f"{c[group]:.4g} ({100 * c[group] / sum(c.values()):.1f} %)" for c in columns]
        print(f"| {group} | " + " | ".join(cells) + " |")
    print("| all | " + " | ".join(f"{sum(c.values()):.4g}" for c in columns) + " |")


if __name__ == "__main__":
    main(sys.argv[1:])
