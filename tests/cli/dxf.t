#!/usr/bin/env bash
# The sheets of the desk model, read back by programs that know nothing of this one: DXF by ezdxf, SVG and CSV by Python's own
# readers. Both drawings hold the same lines; the tables agree with the sheets.
program=${LAMELLA:-build/lamella}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

python=
for candidate in python3 /usr/bin/python3; do
  "$candidate" -c 'import ezdxf' 2>/dev/null && { python=$candidate; break; }
done
if [ -z "$python" ]; then
  echo "1..1"
  echo "ok 1 # SKIP ezdxf is not installed"
  exit 0
fi

design=templates/designs/enneper-model.yaml
formats=dxf,svg,bom,nodes,assembly
build() { "$program" build "$design" -o "$work/$1" --only "$formats" --quiet "${@:2}" >"$work/$1.log" 2>&1 || sed 's/^/# /' "$work/$1.log"; }
build plain
build again
build kerf --set 'sheets.kerf=0.2 mm'
build small --set 'sheets.stock=[400 mm, 300 mm]'
diff -r "$work/plain" "$work/again" >"$work/diff" 2>&1
same=$?

"$python" - "$work" "$same" <<'PYTHON'
import csv, glob, os, re, sys
import xml.etree.ElementTree as tree
import ezdxf
from collections import Counter

work, same = sys.argv[1], sys.argv[2]
number = 0

def check(name, wrong):
    """wrong: a list of what is wrong, empty when all is well."""
    global number
    number += 1
    for line in wrong[:10]:
        print("#", line)
    print("ok" if not wrong else "not ok", number, "-", name)

LAYERS = {"CUT": 1, "ENGRAVE": 5, "LABEL": 3, "DEFPOINTS": 8}

# The rightmost, highest, leftmost and lowest point of a circle.
def circle(x, y, r):
    return [(round(x + r * u, 4), round(y + r * v, 4)) for u, v in ((1, 0), (0, 1), (-1, 0), (0, -1))]

def read_dxf(path):
    document = ezdxf.readfile(path)
    lines = []
    for entity in document.modelspace():
        if entity.dxftype() == "CIRCLE":
            lines.append((entity.dxf.layer, True, circle(entity.dxf.center.x, entity.dxf.center.y, entity.dxf.radius)))
            continue
        points = [(round(v.dxf.location.x, 4), round(v.dxf.location.y, 4)) for v in entity.vertices]
        lines.append((entity.dxf.layer, entity.is_closed, points))
    return document, lines

def read_svg(path):
    root = tree.parse(path).getroot()
    name = "{http://www.w3.org/2000/svg}"
    height = float(root.get("viewBox").split()[3])
    def shapes(node):
        found = []
        for shape in node.iter():
            layer = shape.get("class").replace("SHEET", "DEFPOINTS") if shape.get("class") else None
            if shape.tag == name + "circle":
                x, y, r = (float(shape.get(key)) for key in ("cx", "cy", "r"))
                found.append((layer, True, circle(x, height - y, r)))
            for data in shape.get("d").split("M")[1:] if shape.tag == name + "path" else []:
                points = [(float(x), round(height - float(y), 4)) for x, y in re.findall(r"(-?[\d.]+),(-?[\d.]+)", data)]
                found.append((layer, data.rstrip().endswith("Z"), points))
        return found
    groups = {group.get("id"): shapes(group) for group in root.iter(name + "g")
              if group.get("class") == "part" and not re.search("-(engrave|label|holes)$", group.get("id"))}
    return root, shapes(root), groups

def bounds(lines):
    points = [p for line in lines for p in line[2]]
    return tuple(f(p[i] for p in points) for f in (min, max) for i in (0, 1))

def files(run, ending):
    return sorted(glob.glob(os.path.join(work, run, "sheets", "*." + ending)))

def table(run, name):
    with open(os.path.join(work, run, name), newline="") as file:
        return list(csv.DictReader(file))

runs = ["plain", "kerf", "small"]
drawings = {path: read_dxf(path) for run in runs for path in files(run, "dxf")}
pictures = {path: read_svg(path) for run in runs for path in files(run, "svg")}
pairs = [(path, path[:-3] + "svg") for path in drawings]

check("the design gives sheets, each as DXF and SVG",
      [run for run in runs if not files(run, "dxf") or len(files(run, "dxf")) != len(files(run, "svg"))])

if not pairs:
    print("Bail out! nothing was built")
    sys.exit(1)

wrong = []
for path, (document, lines) in drawings.items():
    audit = document.audit()
    if audit.errors or audit.fixes:
        wrong.append(f"{path}: {len(audit.errors)} errors, {len(audit.fixes)} fixes")
check("ezdxf finds no errors and repairs nothing", wrong)

wrong = []
for path, (document, lines) in drawings.items():
    header = document.header
    if (document.dxfversion, header["$INSUNITS"], header["$MEASUREMENT"]) != ("AC1009", 4, 1):
        wrong.append(f"{path}: {document.dxfversion}, units {header['$INSUNITS']}, {header['$MEASUREMENT']}")
check("release 12, millimeters, metric", wrong)

wrong = []
for path, (document, lines) in drawings.items():
    for name, color in LAYERS.items():
        if document.layers.get(name).dxf.color != color:
            wrong.append(f"{path}: layer {name}")
    strange = {line[0] for line in lines} - set(LAYERS)
    kinds = {entity.dxftype() for entity in document.modelspace()} - {"POLYLINE", "CIRCLE"}
    if strange or kinds:
        wrong.append(f"{path}: {strange} {kinds}")
check("layers CUT (red), ENGRAVE (blue), LABEL (green), DEFPOINTS (gray), and nothing else", wrong)

wrong = []
for path, (document, lines) in drawings.items():
    for layer, closed, points in lines:
        ring = points + points[:1] if closed else points
        if any(a == b for a, b in zip(ring, ring[1:])):
            wrong.append(f"{path}: repeated point at {points[0]} on {layer}")
        if layer == "CUT" and (not closed or len(points) < 3):
            wrong.append(f"{path}: open cut at {points[0]}")
check("every cut is closed, and no point is repeated", wrong)

wrong = []
for dxf, svg in pairs:
    a, b = drawings[dxf][1], pictures[svg][1]
    if bounds(a) != bounds(b):
        wrong.append(f"{dxf}: {bounds(a)}, SVG {bounds(b)}")
    if Counter((l, c) for l, c, p in a) != Counter((l, c) for l, c, p in b):
        wrong.append(f"{dxf}: other lines in the SVG")
    for layer in LAYERS:
        one, two = ([line for line in lines if line[0] == layer] for lines in (a, b))
        if one and max(abs(u - v) for u, v in zip(bounds(one), bounds(two))) > 1e-3:
            wrong.append(f"{dxf}: layer {layer}: {bounds(one)}, SVG {bounds(two)}")
    header = drawings[dxf][0].header
    extents = tuple(header["$EXTMIN"][:2]) + tuple(header["$EXTMAX"][:2])
    if bounds(a) != extents:
        wrong.append(f"{dxf}: header says {extents}, lines {bounds(a)}")
check("DXF and SVG hold the same lines within the same extents, and the header says so", wrong)

wrong = []
for svg, (root, shapes, groups) in pictures.items():
    box = [float(v) for v in root.get("viewBox").split()]
    if box[:2] != [0, 0] or root.get("width") != f"{box[2]:g}mm" or root.get("height") != f"{box[3]:g}mm":
        wrong.append(f"{svg}: {root.get('width')} x {root.get('height')}, viewBox {box}")
    ids = [node.get("id") for node in root.iter() if node.get("id")]
    if len(ids) != len(set(ids)):
        wrong.append(f"{svg}: repeated ids")
check("SVG is true to size, with one group per part", wrong)

inkscape = "{http://www.inkscape.org/namespaces/inkscape}"
wrong = []
for svg, (root, shapes, groups) in pictures.items():
    layers = [g.get(inkscape + "label") for g in root if g.get(inkscape + "groupmode") == "layer"]
    if layers[0] != "SHEET" or layers[-1] != "CUT" or len(layers) != len(set(layers)):
        wrong.append(f"{svg}: {layers}")
check("SVG has Inkscape's layers, the cuts last", wrong)

# Machines make lines in the order of the file. Round holes are circles here, and all others are outlines.
wrong = []
for path, (document, lines) in drawings.items():
    rank = {"DEFPOINTS": 0, "ENGRAVE": 1, "LABEL": 2}
    order = [3 if e.dxftype() == "CIRCLE" else rank.get(e.dxf.layer, 4) for e in document.modelspace()]
    if order != sorted(order):
        wrong.append(path)
    def area(ring):
        return abs(sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(ring, ring[1:] + ring[:1]))) / 2
    sizes = [area(points) for (layer, closed, points), step in zip(lines, order) if step == 4]
    if any(b < a * (1 - 1e-6) for a, b in zip(sizes, sizes[1:])):
        wrong.append(f"{path}: {sizes}")
check("marks before holes before outlines, small parts before large ones", wrong)

wrong = []
for svg, (root, shapes, groups) in pictures.items():
    box = [float(v) for v in root.get("viewBox").split()]
    boxes = {name: bounds(lines) for name, lines in groups.items()}
    for name, b in boxes.items():
        if min(b[0], b[1], box[2] - b[2], box[3] - b[3]) < 9.999:  # the default margin
            wrong.append(f"{svg}: {name} at {b}")
        for other, c in boxes.items():
            if name < other and max(b[0] - c[2], c[0] - b[2], b[1] - c[3], c[1] - b[3]) < 0:
                wrong.append(f"{svg}: {name} overlaps {other}")
check("parts lie inside the margin and do not overlap", wrong)

# The kerf is 0.2 mm: every outline grows by 0.2 mm. (Pieces of split parts may be cut elsewhere: less length fits on the sheet.)
def outlines(run):
    found = {}
    for svg in files(run, "svg"):
        for name, lines in pictures[svg][2].items():
            b = bounds([line for line in lines if line[0] == "CUT"])
            found[name] = (b[2] - b[0], b[3] - b[1])
    return found
plain, kerf = outlines("plain"), outlines("kerf")
grown = {name: [k - p for k, p in zip(kerf[name], plain[name])] for name in plain if name in kerf and "." not in name}
check("a kerf of 0.2 mm makes every whole part larger by 0.2 mm",
      [f"{name}: {g}" for name, g in grown.items() if max(abs(v - 0.2) for v in g) > 2e-3] or ([] if grown else ["nothing to compare"]))

wrong = []
for run in runs:
    for row in table(run, "bom.csv"):
        if row["kind"] == "splice-plate" or not row["sheets"]:
            continue
        placed = sum(1 for svg in files(run, "svg") for name in pictures[svg][2]
                     if re.fullmatch(re.escape(row["part"]) + r"(\.\d+|-copy-\d+)?", name))
        if placed != int(row["pieces"]):
            wrong.append(f"{run}: {row['part']}: {row['pieces']} pieces, {placed} on the sheets")
        if len(row["sheets"].split()) > int(row["pieces"]):
            wrong.append(f"{run}: {row['part']}: {row['sheets']}")
check("bom.csv counts the pieces that lie on the sheets", wrong)

plates = [row for row in table("small", "bom.csv") if row["kind"] == "splice-plate"]
strips = [row for row in table("small", "bom.csv") if row["kind"] == "lamella"]
cuts = sum(int(row["pieces"]) - int(row["quantity"]) for row in strips)
check("small stock: a splice plate for every cut, and there are cuts",
      [] if cuts > 0 and sum(int(row["quantity"]) for row in plates) == cuts else [f"{cuts} cuts, plates {plates}"])

nodes, steps, bom = table("plain", "nodes.csv"), table("plain", "assembly.csv"), table("plain", "bom.csv")
slots = sum(int(row["slots"]) for row in bom)
wrong = [] if slots == 2 * len(nodes) else [f"{slots} slots at {len(nodes)} nodes"]
names = {row["part"]: row for row in bom}
for row in nodes:
    for side in "ab":
        part = names[row[side + "_parts"].split()[0]]
        if not 0 < float(row[side + "_along_mm"]) < float(part["length_mm"]):
            wrong.append(f"node {row['node']}: {row[side + '_along_mm']} on {part['part']}")
check("nodes.csv: two slots per node, positions on the parts", wrong)

families = [row["family"] for row in steps]
wrong = [] if [row["step"] for row in steps] == [str(i + 1) for i in range(len(steps))] else ["steps are not in order"]
if families != sorted(families, key=["A", "B", ""].index):
    wrong.append(f"families {families}")
if sorted(sum((row["parts"].split() for row in steps), [])) != sorted(r["part"] for r in bom if r["kind"] != "splice-plate"):
    wrong.append("not every part once")
check("assembly.csv: numbered steps, family A before family B, every part", wrong)

wrong = []
for run in runs:
    for name in ("bom.csv", "nodes.csv", "assembly.csv"):
        data = open(os.path.join(work, run, name), "rb").read()
        rows = list(csv.reader(data.decode("ascii").splitlines()))
        if len({len(row) for row in rows}) != 1 or len(set(rows[0])) != len(rows[0]):
            wrong.append(f"{run}/{name}: uneven rows or repeated names")
        if data.count(b"\r\n") != data.count(b"\n") or not data.endswith(b"\r\n"):
            wrong.append(f"{run}/{name}: rows must end with CR LF")
check("tables are rectangular, as RFC 4180 says", wrong)

check("built twice, the files are the same bytes", [] if same == "0" else open(os.path.join(work, "diff")).read().splitlines())
print(f"1..{number}")
PYTHON
