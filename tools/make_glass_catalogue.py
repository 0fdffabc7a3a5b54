#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes data/glasses/*.csv.

    tools/make_glass_catalogue.py MATERIALS.json DATABASE

MATERIALS.json is a selection of 117 materials of the refractiveindex.info database with three closed
formulas, DATABASE a checkout of that database (github.com/polyanskiy/refractiveindex.info-database,
CC0-1.0). Both are read here only: the tables that come out are part of the repository. Needs
python3-yaml.
"""
import csv
import glob
import json
import os
import re
import sys

import yaml

HEADER = ("name,aliases,description,form,coefficients,reference,n_d,V_d,accuracy,lambda_min_nm,"
          "lambda_max_nm,ray,source,licence").split(",")
EXTINCTION_HEADER = ["name", "lambda_nm_and_k", "source"]
EXTINCTION_FROM_UM, EXTINCTION_TO_UM = 0.3, 1.1
LEAST_STEP_UM = 0.004  # of extinction: measurements of plates are not finer

# What the letters that a name begins with stand for, longest first. [SCHOTT TIE-29; the others
# follow it.]
FAMILIES = [
    ("LASFN", "dense lanthanum flint"), ("LASF", "dense lanthanum flint"),
    ("LAFN", "lanthanum flint"), ("LAF", "lanthanum flint"), ("LAK", "lanthanum crown"),
    ("BASF", "dense barium flint"), ("BAF", "barium flint"), ("BALF", "light barium flint"),
    ("BAK", "barium crown"), ("BK", "borosilicate crown"), ("KZFS", "short flint"),
    ("KF", "crown flint"), ("PSK", "dense phosphate crown"), ("PK", "phosphate crown"),
    ("FK", "fluor crown"), ("SSK", "very dense crown"), ("SK", "dense crown"),
    ("ZK", "zinc crown"), ("LLF", "very light flint"), ("LF", "light flint"),
    ("SF", "dense flint"), ("K", "crown"), ("F", "flint"),
]

# key of MATERIALS.json: name, aliases, description, accuracy of n (None: 1e-5, as makers state for
# their formulas), ray
CURATED = {
    "b270": ("schott/B270", "", "crown sheet glass; eight lines to four decimals", 5e-5, ""),
    "borofloat33": ("schott/BOROFLOAT33", "borosilicate-3.3", "borosilicate float glass; its formula "
                    "is a fit to a figure and misses the data sheet's n_d by 5e-4", 5e-4, ""),
    "zerodur": ("schott/ZERODUR", "", "glass ceramic of next to no expansion", 1e-4, ""),
    "soda-lime": ("glass/soda-lime", "window-glass;float-glass", "clear window glass", 1e-3, ""),
    "fused-silica": ("glass/fused-silica", "silica-glass", "fused silica, 20 °C", 1e-5, ""),
    "zr-sio2-lithosil": ("schott/LITHOSIL-Q", "", "fused silica", None, ""),
    "quartz-o": ("gem/quartz", "rock-crystal;amethyst;citrine", "rock crystal, ordinary ray", 1e-4, "o"),
    "quartz-e": ("gem/quartz-e", "", "rock crystal, extraordinary ray", 1e-4, "e"),
    "water-20c": ("fluid/water", "", "distilled water, 20 °C", 6e-6, ""),
    "water-24c": ("fluid/water-24C", "", "distilled water, 24 °C", 6e-6, ""),
    "ethanol": ("fluid/ethanol", "alcohol", "ethanol, 20 °C", 1e-3, ""),
    "cs2": ("fluid/carbon-disulfide", "CS2", "carbon disulfide, 20 °C", 5e-3, ""),
    "diamond": ("gem/diamond", "", "diamond", 5e-4, ""),
    "sapphire-o": ("gem/sapphire", "corundum", "corundum, ordinary ray, 20 °C", 1e-4, "o"),
    "sapphire-e": ("gem/sapphire-e", "", "corundum, extraordinary ray, 20 °C", 1e-4, "e"),
    "cubic-zirconia": ("gem/cubic-zirconia", "CZ;zirconia", "zirconia with 12 mol % Y2O3, 25 °C",
                       1e-4, ""),
    "moissanite-o": ("gem/moissanite", "SiC-6H", "6H silicon carbide, ordinary ray", 2e-3, "o"),
    "moissanite-e": ("gem/moissanite-e", "", "6H silicon carbide, extraordinary ray", 3e-3, "e"),
    "sic-singh-o": ("crystal/SiC-Singh", "", "hexagonal silicon carbide, ordinary ray", 2e-3, "o"),
    "sic-singh-e": ("crystal/SiC-Singh-e", "", "hexagonal silicon carbide, extraordinary ray", 5e-3,
                    "e"),
    "rutile-o": ("gem/rutile", "", "titanium dioxide, ordinary ray", 3e-3, "o"),
    "rutile-e": ("gem/rutile-e", "", "titanium dioxide, extraordinary ray", 7e-3, "e"),
    "calcite-o": ("mineral/calcite", "iceland-spar", "calcite, ordinary ray", 2e-4, "o"),
    "calcite-e": ("mineral/calcite-e", "iceland-spar-e", "calcite, extraordinary ray", 3e-4, "e"),
    "caf2": ("crystal/CaF2", "fluorspar;calcium-fluoride", "calcium fluoride, 24 °C", 1e-5, ""),
    "caf2-schott": ("gem/fluorite", "schott/LITHOTEC-CaF2", "calcium fluoride, SCHOTT LITHOTEC-CaF2",
                    None, ""),
    "baf2": ("crystal/BaF2", "barium-fluoride", "barium fluoride, 25 °C", 1e-4, ""),
    "mgf2-o": ("crystal/MgF2", "magnesium-fluoride", "magnesium fluoride, ordinary ray, 19 °C", 1e-5,
               "o"),
    "mgf2-e": ("crystal/MgF2-e", "", "magnesium fluoride, extraordinary ray, 19 °C", 1e-5, "e"),
    "lif": ("crystal/LiF", "lithium-fluoride", "lithium fluoride, 24 °C", 1e-4, ""),
    "nacl": ("crystal/NaCl", "halite;rock-salt;sodium-chloride", "sodium chloride, 24 °C", 2e-4, ""),
    "kcl": ("crystal/KCl", "sylvite;potassium-chloride", "potassium chloride, 24 °C", 2e-4, ""),
    "kbr": ("crystal/KBr", "potassium-bromide", "potassium bromide, 24 °C", 2e-4, ""),
    "spinel": ("gem/spinel", "", "magnesium aluminium spinel", 3e-3, ""),
    "yag": ("gem/YAG", "yttrium-aluminium-garnet", "yttrium aluminium garnet", 1e-3, ""),
    "strontium-titanate": ("gem/strontium-titanate", "SrTiO3", "strontium titanate", 1e-3, ""),
    "lithium-niobate-o": ("crystal/LiNbO3", "lithium-niobate",
                          "lithium niobate, ordinary ray, 21 °C", 1e-3, "o"),
    "lithium-niobate-e": ("crystal/LiNbO3-e", "", "lithium niobate, extraordinary ray, 21 °C", 3e-3,
                          "e"),
    "zns": ("crystal/ZnS", "zinc-sulfide;sphalerite", "cubic zinc sulfide, 20 °C", 1e-3, ""),
    "znse": ("crystal/ZnSe", "zinc-selenide", "zinc selenide, 23 °C", 1e-3, ""),
    "pmma-beadie": ("plastic/PMMA", "acrylic;plexiglass;perspex",
                    "polymethyl methacrylate (acrylic glass), 20 °C", 2e-3, ""),
    "pmma": ("plastic/PMMA-Sultanova", "", "polymethyl methacrylate, 20 °C; one resonance", 2e-3, ""),
    "polycarbonate": ("plastic/polycarbonate", "PC", "polycarbonate, 20 °C; one resonance", 2e-3, ""),
    "polystyrene": ("plastic/polystyrene", "PS", "polystyrene, 20 °C; one resonance", 2e-3, ""),
    "air-ciddor": ("fluid/air-15C", "", "dry air, 15 °C, 101325 Pa, 450 ppm CO2", 1e-8, ""),
    "air-peck": ("fluid/air-Peck-Reeder", "", "dry air, 15 °C, 101325 Pa", 3e-8, ""),
    "air-edlen-1966": ("fluid/air-Edlen-1966", "fluid/air-Edlen", "dry air, 15 °C, 101325 Pa", 5e-8,
                       ""),
    "air-edlen-1953": ("fluid/air-Edlen-1953", "", "dry air, 15 °C, 101325 Pa", 5e-8, ""),
    "co2": ("fluid/carbon-dioxide", "CO2", "carbon dioxide, 0 °C, 101325 Pa", 1e-6, ""),
}
LEFT_OUT = {"water-hale", "water-segelstein", "ice", "water-iapws-20c"}  # see extinction and below
SUMITA_ACCURACY = 4e-5  # how far its formulas are from the n_d that it states
VACUUM = {"water-20c", "water-24c", "air-ciddor", "air-peck", "air-edlen-1966", "air-edlen-1953", "co2"}
DESCRIBED = {
    "n-bk7": "borosilicate crown, the standard glass of lenses and prisms",
    "n-bk7ht": "N-BK7 of higher transmittance",
    "f2": "flint with lead, the classic prism glass",
    "s-bsl7": "borosilicate crown",
    "s-tih6": "dense flint without lead",
    "s-fpl53": "phosphate crown of extremely low dispersion",
    "h-k9l": "borosilicate crown",
}
ALIASES = {"n-bk7": "BK7;schott/BK7"}

# Rows that no database has in this form.
ICE = ("0.3 1.3339 0.35 1.3249 0.4 1.3194 0.44 1.3163 0.48 1.314 0.52 1.3121 0.56 1.3106 0.6 1.3094 "
       "0.65 1.308 0.7 1.3069 0.75 1.3059 0.8 1.3049 0.85 1.304 0.9 1.3032")
AIR_20C = "0.0569302414131 238.0185 0.00165044579602 57.362"


def number(value):
    text = f"{float(value):.12g}"
    return text


def database(path):
    return f"refractiveindex.info database at ff11b5897ef0, {path}"


def cited(text):
    """A citation without its second references and remarks."""
    text = re.sub(r"<[^>]*>", "", text).replace("\n", " ")
    text = re.sub(r"\s+", " ", text).strip()
    text = re.sub(r"^1\) ", "", text)
    text = re.split(r" 2\) | See also|See also| \(fit of| \(obtained|Note:| \* ", text)[0]
    return text.replace(" catalog ", " catalogue ").strip(" .")


def family(name, maker):
    base = re.sub(r"^(N|P|H|S|E|J|K|Q|M|D|L)-", "", name.upper())
    kind = next((words for start, words in FAMILIES if re.match(start + r"\d|" + start + r"[A-Z]?\d",
                                                                base)), "optical glass")
    if maker == "schott" and name.upper().startswith("N-") and "flint" in kind:
        kind += " without lead"
    if maker == "schott" and name.upper().startswith("P-"):
        kind += " for moulding"
    return kind


def form_of(kind, c):
    """A form of ours that takes the database's coefficients, shortest first."""
    if kind == "formula 1" or kind == "formula 2":
        squares = [v * v if kind == "formula 1" else v for v in c[2::2]]
        if c[0] == 0 and all(squares):
            return "sellmeier", [v for pair in zip(c[1::2], squares) for v in pair]
    if kind == "formula 3":
        terms = dict(zip(c[2::2], c[1::2]))
        powers = [2, 4, -2, -4, -6, -8, -10, -12]
        if set(terms) <= set(powers):
            all_terms = [c[0]] + [terms.get(p, 0.0) for p in powers]
            if 4 not in terms:
                name, all_terms = "schott", all_terms[:2] + all_terms[3:]
            else:
                name = "extended_3"
            while all_terms[-1] == 0.0:
                all_terms.pop()
            return name, all_terms
    return "rii_" + kind.split()[1], c


def row(name, aliases, description, form, coefficients, reference, n_d, v_d, accuracy, low_um,
        high_um, ray, source, licence):
    return [name, aliases, description, form, " ".join(number(v) for v in coefficients), reference,
            n_d, v_d, number(accuracy), number(1e3 * low_um), number(1e3 * high_um), ray, source,
            licence]


def curated_row(m):
    key = m["key"]
    maker, _, rest = m["name"].partition(" ")
    vendor = (m.get("cat_source") or "").startswith("manufacturer")
    if key in CURATED:
        name, aliases, description, accuracy, ray = CURATED[key]
    else:
        name = f"{maker.lower()}/{rest}"
        aliases = ALIASES.get(key, "")
        description = DESCRIBED.get(key) or family(rest, maker.lower())
        accuracy, ray = None, ""
    if m["formula"] == "tabulated":
        form, c = "table", [v for pair in m["n_table"] for v in pair]
    elif m["formula"].startswith("edlen"):
        form, c = "rii_6", m["coefficients"]
    else:
        form, c = form_of("formula " + m["formula"].split("-")[1], m["coefficients"])
    published = vendor or key in ("zerodur", "b270")
    n_d = number(m["cat_nd"]) if published and m["cat_nd"] else ""
    v_d = number(m["cat_Vd"]) if published and m["cat_Vd"] else ""
    if key == "fused-silica":
        n_d = "1.45846"
    if key == "b270":
        n_d = "1.523"
    if v_d and len(v_d) > 6:  # recomputed to more figures than anyone states
        v_d = f"{float(v_d):.2f}"
    closed = key.startswith("air-edlen")
    source = cited(m["citation"]).split("; as coded")[0].split("; n-1 =")[0]
    if not closed:
        source += "; " + database(m["path"])
    return row(name, aliases, description, form, c, "vacuum" if key in VACUUM else "air", n_d, v_d,
               accuracy or 1e-5, m["range_um"][0], m["range_um"][1], ray, source,
               "published formula" if closed else "CC0-1.0")


def extra_rows(by_key):
    ruby = curated_row(by_key["sapphire-o"])
    ruby[0:3] = ["gem/ruby", "", "corundum as for sapphire: the colour is absorption"]
    ice = by_key["ice"]
    yield ruby
    yield row("mineral/ice", "", "ice Ih, -7 °C; four decimals, both rays as one", "table",
              [float(v) for v in ICE.split()], "vacuum", "", "", 5e-4, 0.3, 0.9, "",
              cited(ice["citation"]).split(". Optical")[0] + "; " + database(ice["path"]), "CC0-1.0")
    yield row("fluid/air", "", "dry air, 20 °C, 101325 Pa, 450 ppm CO2", "gas",
              [float(v) for v in AIR_20C.split()], "vacuum", "", "", 1e-8, 0.23, 1.69, "",
              "P. E. Ciddor, Appl. Opt. 35, 1566 (1996), eqs. 1 and 5: the dispersion of 15 °C times "
              "0.982894 for the density at 20 °C; "
              + database(by_key["air-ciddor"]["path"]), "CC0-1.0")
    yield row("fluid/vacuum", "", "nothing", "constant", [1.0], "vacuum", "1", "", 0.0, 0.1, 10, "",
              "definition", "CC0-1.0")


def maker_rows(folder, taken):
    for path in sorted(glob.glob(os.path.join(folder, "database/data/specs/*/optical/*.yml"))):
        maker = path.split("/")[-3]
        name = f"{maker}/{os.path.basename(path)[:-4]}"
        with open(path, encoding="utf-8") as file:
            page = yaml.safe_load(file)
        properties = page.get("PROPERTIES") or {}
        formulas = [d for d in page.get("DATA", []) if d["type"].startswith("formula")]
        if name.lower() in taken or not formulas or "nd" not in properties:
            continue
        c = [float(v) for v in str(formulas[0]["coefficients"]).split()]
        low, high = (float(v) for v in str(formulas[0]["wavelength_range"]).split())
        form, c = form_of(formulas[0]["type"], c)
        relative = path[path.index("database/data"):]
        v_d = float(properties["Vd"])
        accuracy = SUMITA_ACCURACY if maker == "sumita" else 1e-5
        yield row(name, "", family(name.split("/")[1], maker), form, c, "air",
                  number(properties["nd"]), f"{v_d:.2f}" if v_d != round(v_d, 2) else number(v_d),
                  accuracy, low, high, "", cited(page["REFERENCES"]) + "; " + database(relative),
                  "CC0-1.0")


def extinction(name, table, source):
    pairs, last = [], 0.0
    for wavelength, k in table:
        if EXTINCTION_FROM_UM <= wavelength <= EXTINCTION_TO_UM and wavelength - last > LEAST_STEP_UM:
            pairs += [f"{1e3 * wavelength:.6g}", f"{k:.5g}"]
            last = wavelength
    return [name, " ".join(pairs), source]


def extinction_rows(by_key, curated):
    for m in by_key.values():
        name = curated.get(m["key"])
        if name and m.get("k_table"):
            yield extinction(name, m["k_table"], "")
    for key, name in (("water-segelstein", "fluid/water"), ("ice", "mineral/ice")):
        m = by_key[key]
        yield extinction(name, m["k_table"], cited(m["citation"]).split(". Optical")[0] + "; "
                         + database(m["path"]))


def write(path, header, rows):
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        by_key = {m["key"]: m for m in json.load(file)["materials"]}
    folder = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "data/glasses")
    keys = [key for key in by_key if key not in LEFT_OUT]
    rows = [curated_row(by_key[key]) for key in keys]
    names = dict(zip(keys, (r[0] for r in rows)))
    rows += list(extra_rows(by_key))
    write(os.path.join(folder, "catalogue.csv"), HEADER, rows)
    taken = {r[0].lower() for r in rows}
    write(os.path.join(folder, "makers.csv"), HEADER, maker_rows(sys.argv[2], taken))
    write(os.path.join(folder, "extinction.csv"), EXTINCTION_HEADER, extinction_rows(by_key, names))


if __name__ == "__main__":
    main()
