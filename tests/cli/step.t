#!/usr/bin/env bash
# Smooth surfaces there and back: STEP and IGES are read by OpenCASCADE, which knows nothing of this program, and what
# OpenCASCADE writes is read by this program. Areas and lengths are compared with closed forms (torus, sphere, cylinder)
# and with integrals over surface.json, evaluated here by the recursion of Cox and de Boor. Skins have to be one shell of
# shared edges; lines of nets and axes of lamellas have to arrive as curves with their names, lengths and ends.
set -u
cd "$(dirname "$0")/../.." || exit 1
program=$(realpath -m "${LAMELLA:-build/lamella}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

include=/usr/include/opencascade
reader=none
if [ -f $include/STEPControl_Reader.hxx ] && [ -f $include/IGESControl_Reader.hxx ]; then
  reader=$work/cad_reader
  "${CXX:-g++}" -std=c++17 -O0 -isystem $include tests/cli/cad_reader.cc -o "$reader" -lTKSTEP -lTKSTEPAttr -lTKSTEPBase -lTKIGES -lTKXSBase \
    -lTKShHealing -lTKTopAlgo -lTKBRep -lTKGeomBase -lTKG3d -lTKMath -lTKernel >"$work/log" 2>&1 ||
    { reader=broken; sed 's/^/# /' "$work/log" | head -20; }
fi

python3 - "$program" "$reader" "$work" <<'PYTHON'
import json, math, os, subprocess, sys
program, reader, work = sys.argv[1:]
number = 0

def check(name, wrong):
    """wrong: a list of what is wrong, empty when all is well."""
    global number
    number += 1
    for line in wrong[:10]:
        print("#", line)
    print("ok" if not wrong else "not ok", number, "-", name)

def skip(name, why):
    global number
    number += 1
    print("ok", number, "-", name, "# SKIP", why)

# ---- evaluation ----

def basis(i, p, t, k, last):
    if p == 0:
        return 1.0 if k[i] <= t < k[i + 1] or (last and k[i] < t == k[i + 1]) else 0.0
    a, b = k[i + p] - k[i], k[i + p + 1] - k[i + 1]
    return ((t - k[i]) / a * basis(i, p - 1, t, k, last) if a else 0) + \
           ((k[i + p + 1] - t) / b * basis(i + 1, p - 1, t, k, last) if b else 0)

def slope(i, p, t, k, last):
    a, b = k[i + p] - k[i], k[i + p + 1] - k[i + 1]
    return p * ((basis(i, p - 1, t, k, last) / a if a else 0) - (basis(i + 1, p - 1, t, k, last) / b if b else 0))

class Surface:
    def __init__(self, path):
        s = json.load(open(path))["surfaces"][0]
        self.p, self.n, self.k = s["degree"], s["count"], [s["knots_u"], s["knots_v"]]
        self.x, self.w = s["points"], s.get("weights") or [1] * len(s["points"])
        self.domain = [(self.k[d][self.p[d]], self.k[d][self.n[d]]) for d in (0, 1)]
        self.table = {}

    def values(self, d, t):  # functions and slopes of one direction: (index, value, slope)
        t = min(max(t, self.domain[d][0]), self.domain[d][1])  # against rounding
        if (d, t) not in self.table:
            last = t == self.domain[d][1]
            rows = [(i, basis(i, self.p[d], t, self.k[d], last), slope(i, self.p[d], t, self.k[d], last))
                    for i in range(self.n[d])]
            self.table[d, t] = [r for r in rows if r[1] or r[2]]
        return self.table[d, t]

    def jet(self, u, v):
        a, au, av = [0.0] * 4, [0.0] * 4, [0.0] * 4
        for i, b, db in self.values(0, u):
            for j, c, dc in self.values(1, v):
                at = i * self.n[1] + j
                q = [self.w[at] * z for z in self.x[at]] + [self.w[at]]
                for m in range(4):
                    a[m] += b * c * q[m]
                    au[m] += db * c * q[m]
                    av[m] += b * dc * q[m]
        x = [a[m] / a[3] for m in range(3)]
        return x, [(au[m] - au[3] * x[m]) / a[3] for m in range(3)], [(av[m] - av[3] * x[m]) / a[3] for m in range(3)]

    def spans(self, d):
        inside = sorted(set(t for t in self.k[d] if self.domain[d][0] <= t <= self.domain[d][1]))
        return list(zip(inside, inside[1:]))

    def area(self):
        total = 0
        for a, b in self.spans(0):
            for c, d in self.spans(1):
                for s, ws in gauss:
                    for t, wt in gauss:
                        _, xu, xv = self.jet(a + (b - a) * s, c + (d - c) * t)
                        normal = [xu[i - 2] * xv[i - 1] - xu[i - 1] * xv[i - 2] for i in range(3)]
                        total += ws * wt * (b - a) * (d - c) * math.hypot(*normal)
        return total

    def length(self, d, at):  # of the line along direction d
        total = 0
        for a, b in self.spans(d):
            for half in (0, 1):
                for s, ws in gauss:
                    t = a + (b - a) * (half + s) / 2
                    total += ws * (b - a) / 2 * math.hypot(*(self.jet(t, at)[1] if d == 0 else self.jet(at, t)[2]))
        return total

    def boundary(self):
        return sum(self.length(d, at) for d in (0, 1) for at in self.domain[1 - d])

class Curve:
    def __init__(self, c):
        self.name, self.family, self.p, self.n, self.k = c["name"], c["family"], c["degree"], c["count"], c["knots"]
        self.x = c["points"]

    def speed(self, t):
        d = [slope(i, self.p, t, self.k, False) for i in range(self.n)]
        return math.hypot(*(sum(d[i] * self.x[i][m] for i in range(self.n)) for m in range(3)))

    def length(self):
        inside = sorted(set(self.k))
        return sum(w * (b - a) / 4 * self.speed(a + (b - a) * (s + half) / 4) for a, b in zip(inside, inside[1:])
                   for half in range(4) for s, w in gauss)

def gauss_rule(n):  # on [0, 1], by Newton's method on the Legendre polynomial
    rule = []
    for i in range(n):
        x = math.cos(math.pi * (i + 0.75) / (n + 0.5))
        for _ in range(50):
            p0, p1 = 1.0, x
            for k in range(2, n + 1):
                p0, p1 = p1, ((2 * k - 1) * x * p1 - (k - 1) * p0) / k
            d = n * (x * p1 - p0) / (x * x - 1)
            x -= p1 / d
        rule.append(((1 + x) / 2, 1 / ((1 - x * x) * d * d)))
    return rule
gauss = gauss_rule(16)

# ---- designs ----

h = math.sqrt(0.5)
circle = [(1, 0, 1), (1, 1, h), (0, 1, 1), (-1, 1, h), (-1, 0, 1), (-1, -1, h), (0, -1, 1), (1, -1, h), (1, 0, 1)]
knots = [0, 0, 0, .25, .25, .5, .5, .75, .75, 1, 1, 1]
meridian = [(0, -1, 1), (1, -1, h), (1, 0, 1), (1, 1, h), (0, 1, 1)]  # half a circle, from pole to pole
def revolve(arc, profile): # profile: r, z, w
    return [(a * r, b * r, z) for a, b, _ in arc for r, z, _ in profile], [w * v for _, _, w in arc for _, _, v in profile]

def design(name, text):
    with open(f"{work}/{name}.yaml", "w") as file:
        file.write(f"lamella: 1\nname: {name}\nsurface: {text}\n")

def nurbs(name, degree, count, net, ku, kv):
    points, weights = net
    numbers = [[float(c) for p in points for c in p], [float(w) for w in weights], ku, kv]
    names = ["points", "weights", "knots_u", "knots_v"]
    lists = ", ".join(f"{n}: {json.dumps(l)}" for n, l in zip(names, numbers))
    design(name, f"{{kind: nurbs, degree: {degree}, count: {count}, ground: no, {lists}}}")

design("saddle", "{kind: bspline, ground: no}")
nurbs("torus", [2, 2], [9, 9], revolve(circle, [(5 + 2 * c, 2 * d, w) for c, d, w in circle]), knots, knots)
nurbs("sphere", [2, 2], [9, 5], revolve(circle, [(3 * r, 3 * z, w) for r, z, w in meridian]), knots, [0, 0, 0, .5, .5, 1, 1, 1])
nurbs("octant", [2, 2], [3, 3], revolve(circle[:3], [(3 * r, 3 * z, w) for r, z, w in meridian[2:]]), [0, 0, 0, 1, 1, 1], [0, 0, 0, 1, 1, 1])
nurbs("cylinder", [2, 1], [9, 2], revolve(circle, [(2, 0, 1), (2, 4, 1)]), knots, [0, 0, 1, 1])
nurbs("unclamped", [3, 3], [6, 5], ([(i, j, .3 * math.sin(i + .5 * j)) for i in range(6) for j in range(5)],
      [1 + .1 * ((i * 7) % 5) for i in range(30)]), list(range(10)), list(range(9)))

with open(f"{work}/lines.yaml", "w") as file:
    file.write("lamella: 1\nname: lines\nsurface: {kind: enneper, size: 4 m}\nnet: {kind: asymptotic, grid: [6, 4]}\n")
with open(f"{work}/rings.yaml", "w") as file: # pairs of sheets on closed lines: a curve for each pair
    file.write("lamella: 1\nname: rings\nsurface: {kind: catenoid, size: 3 m}\nnet: {kind: free, grid: [12, 5]}\n"
               "parts: [{kind: lamella, height: 60 mm, thickness: 1 mm, pair: 20 mm, families: [0]}]\n"
               "sheets: {stock: [12 m, 6 m]}\n")
with open(f"{work}/skin.yaml", "w") as file:
    file.write("lamella: 1\nname: skin\nsurface: {kind: enneper, size: 4 m}\n"
               "net: {kind: asymptotic, grid: [4, 4], orthogonal: yes}\nparts: [{kind: skin, thickness: 10 mm}]\n")

for kind in ("asymptotic-quad", "developable"):
    design(kind, f"{{kind: {kind}, ground: no}}")

# edges, edges of one face only, area, length of the boundary; None: by integration over all four sides. An octant of a
# sphere has a pole, the sphere two and a seam, the torus two seams, the cylinder one.
expected = {
    "saddle": (4, 4, None, None),
    "torus": (2, 0, 40 * math.pi ** 2, 0),
    "sphere": (1, 0, 36 * math.pi, 0),
    "octant": (3, 3, 4.5 * math.pi, 4.5 * math.pi),
    "cylinder": (3, 2, 16 * math.pi, 8 * math.pi),
    "unclamped": (4, 4, None, None),
    "asymptotic-quad": (4, 4, None, None),
    "developable": (4, 4, None, None),
}
names = list(expected)

def build(name, out, *more):
    return subprocess.run([program, "build", f"{work}/{name}.yaml", "-o", f"{work}/{out}", "--only",
                           "surface,step,iges,surface_obj", *more], capture_output=True, text=True)

made = {name: build(name, name) for name in names}
check("surfaces are written as surface.json, STEP and IGES",
      [f"{n}: {made[n].stderr}" for n in names
       if made[n].returncode or sorted(f for f in os.listdir(f"{work}/{n}") if f[0] != ".") != sorted(["surface.json", "surface.obj", n + ".step", n + ".igs"])])
surfaces = {name: Surface(f"{work}/{name}/surface.json") for name in names}
areas = {name: surfaces[name].area() for name in names}
bounds = {name: surfaces[name].boundary() for name in names}
lined = ["lines", "rings", "skin"]
made.update({name: build(name, name) for name in lined})
curves = {name: [Curve(c) for c in json.load(open(f"{work}/{name}/surface.json"))["curves"]] for name in lined}
off = lambda a, b: abs(a - b) / max(abs(b), 1e-3)
check("the integrals over surface.json are the closed forms",
      [f"{n}: area {areas[n]!r}, expected {e[2]!r}" for n, e in expected.items() if e[2] and off(areas[n], e[2]) > 1e-10])

# ---- OpenCASCADE reads ----

def read(path, *copies):
    run = subprocess.run([reader, path, *copies], capture_output=True, text=True)
    facts = {"points": [], "curves": [], "names": [], "error": run.stderr.strip()}
    for line in run.stdout.splitlines():
        word, *rest = line.split()
        if word in ("point", "curve"):
            facts[word + "s"].append([float(v) for v in rest])
        elif word == "name":
            facts["names"].append((rest[0], rest[-1]))
        elif word == "box":
            facts[word] = [float(v) for v in rest]
        else:
            facts[word] = float(rest[0])
    return facts

texts = ["OpenCASCADE finds one valid face with its edges, in STEP", "and in IGES, with the sides as curves",
         "areas and boundaries agree to 1e-7", "points agree to 1e-9 at the same parameters",
         "what OpenCASCADE writes as STEP and as IGES is read: areas agree to 1e-9",
         "a skin of 16 patches is one open shell of shared edges",
         "lines and axes arrive with their names and families, lengths to 1e-7 and ends to 1e-9",
         "a trimmed face that OpenCASCADE writes has the boundary of its edges, and the report says that it is trimmed"]
if reader == "none":
    for text in texts:
        skip(text, "OpenCASCADE is not installed: libocct-data-exchange-dev")
elif reader == "broken":
    check("tests/cli/cad_reader.cc compiles", ["see above"])
else:
    copies = {(n, e): f"{work}/{n}-copy.{e}" for n in names for e in ("step", "igs")}
    found = {(n, "step"): read(f"{work}/{n}/{n}.step", copies[n, "step"], copies[n, "igs"],
                                f"{work}/{n}-part.step", f"{work}/{n}-part.igs") for n in names}
    found.update({(n, "igs"): read(f"{work}/{n}/{n}.igs") for n in names})
    def structure(ending, loose):
        wrong = []
        for n, (edges, free, _, _) in expected.items():
            f = found[n, ending]
            given = [f.get(k) for k in ("faces", "valid", "free_edges")] + [f.get("edges", 0) - f.get("loose_edges", 0)]
            if given != [1, 1, free, edges] or loose != (f["loose_edges"] > 0):
                wrong.append(f"{n}: faces, valid, free edges, edges: {given}, loose {f.get('loose_edges')} {f['error']}")
        return wrong
    check(texts[0], structure("step", False))
    check(texts[1], structure("igs", True))
    wrong = []
    for (n, ending), f in found.items():
        area = expected[n][2] or areas[n]
        bound = bounds[n] if expected[n][3] is None else expected[n][3]
        if off(f.get("area", 0), area) > 1e-7 or off(f.get("boundary", -1), bound) > 1e-7:
            wrong.append(f"{n}.{ending}: area {f.get('area')}, expected {area}; boundary {f.get('boundary')}, expected {bound}")
    check(texts[2], wrong)
    wrong = []
    for (n, ending), f in found.items():
        size = max(max(abs(c) for c in p) for p in surfaces[n].x)
        worst = max([math.dist(p[3:], surfaces[n].jet(p[1], p[2])[0]) / size for p in f["points"]], default=1)
        if worst > 1e-9:
            wrong.append(f"{n}.{ending}: {worst}")
    check(texts[3], wrong)
    wrong = []
    for (n, ending), path in copies.items():
        design("copy", f"{{kind: file, file: {os.path.basename(path)}, ground: no}}")
        run = build("copy", f"{n}-{ending}")
        if "trimmed" in run.stdout:
            wrong.append(f"{n}.{ending}: its natural boundary is taken for a trimming")
        if run.returncode:
            wrong.append(f"{n}.{ending}: {run.stderr}")
        elif off(Surface(f"{work}/{n}-{ending}/surface.json").area(), areas[n]) > 1e-9:
            wrong.append(f"{n}.{ending}: another area")
    check(texts[4], wrong)
    wrong = []
    for n in ("saddle", "unclamped", "developable"):
        for part in (f"{n}-part.step", f"{n}-part.igs"):
            design("part", f"{{kind: coons, file: {part}, ground: no}}")
            run = build("part", "part")
            given = run.returncode or off(Surface(f"{work}/part/surface.json").boundary(), found[n, "step"]["part"])
            if run.returncode or given > 1e-9:
                wrong.append(f"{part}: the boundary is another one, by {given} {run.stderr}")
            design("part", f"{{kind: file, file: {part}, ground: no}}")
            if "trimmed" not in build("part", "part").stdout:
                wrong.append(f"{part}: nothing says that the face is trimmed")
    check(texts[7], wrong)
    found = {(n, e): read(f"{work}/{n}/{n}.{e}") for n in lined for e in ("step", "igs")}
    # 4 x 4 cells: 25 vertices, 40 edges, 16 of them on the border; 10 lines of the net besides
    given = [found["skin", "step"].get(k) for k in
             ("shells", "closed_shells", "valid", "faces", "vertices", "edges", "free_edges", "loose_edges")]
    check(texts[5], [] if given == [1, 0, 1, 16, 25, 50, 16, 10] else [f"{given} {found['skin', 'step']['error']}"])
    wrong = []
    for (n, ending), f in found.items():
        level = lambda c: f"{c.family}" if ending == "step" else f"{c.family + 1}"
        named = [(c.name, level(c)) for c in curves[n]]
        if [(a, b) for a, b in f["names"]] != named:
            wrong.append(f"{n}.{ending}: names {f['names'][:5]}..., expected {named[:5]}...")
        if len(f["curves"]) != len(curves[n]) + (64 if (n, ending) == ("skin", "igs") else 0): # with the sides of patches
            wrong.append(f"{n}.{ending}: {len(f['curves'])} curves")
            continue
        for c, (length, *ends) in zip(curves[n], f["curves"][-len(curves[n]):]):
            if off(length, c.length()) > 1e-7 or math.dist(ends, c.x[0] + c.x[-1]) > 1e-9:
                wrong.append(f"{n}.{ending}: {c.name}: {length}, expected {c.length()}; {ends}")
    check(texts[6], wrong)

# ---- boundaries ----

# A Coons patch over the four curves of a file has the boundary of the surface whose edges they are.
wrong = []
framed = ["saddle", "unclamped", "asymptotic-quad", "developable"]
for n in framed:
    sources = [f"{n}/{n}.step", f"{n}/{n}.igs"] + ([f"{n}-copy.step", f"{n}-copy.igs"] if os.path.exists(reader) else [])
    for source in sources:
        design("frame", f"{{kind: coons, file: {source}, ground: no}}")
        run = build("frame", f"{n}/frame", "--deps", f"{work}/deps")
        if run.returncode or source not in open(f"{work}/deps").read():
            wrong.append(f"{source}: {run.stderr} not among the files that the result depends on")
        elif off(Surface(f"{work}/{n}/frame/surface.json").boundary(), bounds[n]) > 1e-9:
            wrong.append(f"{source}: another boundary")
design("film", "{kind: least-area, file: lines/lines.step, pick: [6, 1, 12, 5], ground: no}")
border = sum(c.length() for c in curves["lines"] if c.name in ("A01", "A05", "B01", "B07"))
run = build("film", "film")
if run.returncode or off(Surface(f"{work}/film/surface.json").boundary(), border) > 1e-9:
    wrong.append(f"film over the border lines of a net: {run.stderr}")
check("four curves of a file bound a surface, also those that OpenCASCADE writes", wrong)

# ---- lines ----

wrong = [f"{n}: {made[n].stderr}" for n in lined if made[n].returncode]
if [c.name for c in curves["lines"]] != [f"A{i:02}" for i in range(1, 6)] + [f"B{i:02}" for i in range(1, 8)]:
    wrong.append(f"lines: {[c.name for c in curves['lines']]}")
for c in curves["rings"]:
    if math.dist(c.x[0], c.x[-1]) > 1e-12 or max(z for x, y, z in c.x) - min(z for x, y, z in c.x) > 1e-9 or c.n != 12 + 3:
        wrong.append(f"rings: {c.name} is no closed curve through twelve vertices at one height")
    if abs(c.length() / (2 * math.pi * math.hypot(*c.x[0][:2])) - 1) > 5e-4: # a cubic spline through a circle of 12 points
        wrong.append(f"rings: {c.name} has length {c.length()}")
if len(curves["rings"]) != 6:
    wrong.append(f"rings: {len(curves['rings'])} curves")
check("lines of a net and axes of lamellas are curves, one for a pair; closed lines close", wrong)

# ---- this program reads ----

wrong = []
for n in names:
    for source in ("surface.json", n + ".step", n + ".igs", "surface.obj"):
        design("back", f"{{kind: file, file: {n}/{source}, ground: no}}")
        run = build("back", f"{n}/back", "--deps", f"{work}/deps")
        if run.returncode or f"{n}/{source}" not in open(f"{work}/deps").read():
            wrong.append(f"{n}/{source}: {run.stderr} not among the files that the result depends on")
            continue
        area = Surface(f"{work}/{n}/back/surface.json").area()
        if off(area, areas[n]) > 1e-12:
            wrong.append(f"{n}/{source}: area {area}, expected {areas[n]}")
check("each of the four files is read: areas agree to 1e-12, and --deps names the file", wrong)

with open(f"{work}/assembly.step", "w") as file:
    file.write(open(f"{work}/saddle/saddle.step").read().replace("ENDSEC;\nEND", "#99999=MAPPED_ITEM('',#1,#2);\nENDSEC;\nEND"))
design("placed", "{kind: file, file: assembly.step}")
run = subprocess.run([program, "build", f"{work}/placed.yaml", "-o", f"{work}/placed", "--only", "report"], capture_output=True, text=True)
check("the report says that an assembly places its components",
      [] if "in the file components are placed in an assembly" in run.stdout + open(f"{work}/placed/report.json").read()
      else [run.stdout + run.stderr])

wrong = []
for text, message in (("missing.step", "surface.file: given missing.step; expected a file that can be read"),
                      ("saddle.yaml", "saddle.yaml: not a file of surfaces; expected .obj, .json, .step, .stp, .igs or .iges"),
                      ("saddle/saddle.step, face: 2", "saddle.step: face 2 asked for, but the file has 1 B-spline surface"),
                      ("cut.step", "cut.step:9: is cut off: END-ISO-10303-21 expected"),
                      ("lines/lines.igs, kind: coons", "file: lines/lines.igs has 12 curves; expected four, or pick: with the numbers of four"),
                      ("lines/lines.igs, pick: [1, 2, 3, 4], kind: coons", "m from the "),
                      ("missing.igs, kind: coons", "surface.file: given missing.igs; expected a file that can be read"),
                      ("cut.step, kind: coons", "cut.step:9: is cut off: END-ISO-10303-21 expected")):
    with open(f"{work}/cut.step", "w") as file:
        file.writelines(open(f"{work}/saddle/saddle.step").readlines()[:8])
    design("bad", f"{{file: {text}}}" if "kind" in text else f"{{kind: file, file: {text}}}")
    for verb in ("check", "build"):
        run = subprocess.run([program, verb, f"{work}/bad.yaml"], capture_output=True, text=True, cwd=work)
        if run.returncode != 2 or message not in run.stderr or run.stderr.count("\n") != 1:
            wrong.append(f"{verb}, {text}: {run.returncode} {run.stderr}")
check("files that are no surfaces are refused in one line, by check and by build", wrong)
print(f"1..{number}")
PYTHON
