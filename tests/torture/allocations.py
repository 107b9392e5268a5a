#!/usr/bin/python3
"""Memory that runs out at one place of the whole program, for every verb and a dozen designs: allocation
after allocation fails, whichever library asks for it (preload/fail_allocation.c). Each time the program says so in
one line and ends with its status, or makes the same bytes as ever. Called by tests/cli/memory.t:

  allocations.py LIBRARY PROGRAM [SHARE [WORD]]

A sample of the places, SHARE at most of every task (0: all of them, which takes minutes), of the tasks
with WORD in their name. Prints TAP."""
import concurrent.futures, hashlib, os, random, shutil, subprocess, sys, tempfile

library, program = map(os.path.abspath, sys.argv[1:3])
share = int(sys.argv[3]) if len(sys.argv) > 3 else 12
word = sys.argv[4] if len(sys.argv) > 4 else ""

DESIGNS = {
    "lamellas": """surface: {kind: enneper, size: 4 m}
net: {kind: asymptotic, grid: [4, 4], orthogonal: yes}
parts: [{kind: lamella, height: 60 mm, thickness: 1 mm}]
sheets: {stock: [3 m, 1.5 m], kerf: 0.2 mm}""",
    "panels": """surface: {kind: monge, x2: -0.34, y2: -0.16, u: [-1.3, 1.3], v: [-1.6, 1.6], size: 16 m}
net: {kind: conical, grid: [4, 4], from: {lines: natural}}
parts:
  - {kind: support, height: 200 mm, thickness: 16 mm, gap: 4 mm, along: axes, edges: inner}
  - {kind: panels, thickness: 16 mm, gap: 16 mm, offset: 206 mm}""",
    "circles": """surface: {kind: catenoid, v: [-1.257, 1.257], size: 360 mm}
net: {kind: s-isothermic, grid: [12, 4]}
parts: [{kind: circles, circles: incircles, width: 5 mm, thickness: 2 mm, gap: 0.6 mm}]""",
    "bars": """surface: {kind: helicoid, u: [-1.5, 1.5], v: [-1.2, 1.2], size: 12 m}
net: {kind: asymptotic, grid: [4, 4]}
parts: [{kind: bars, diameter: 90 mm, rim: 160 mm}]""",
    "skin": """surface: {kind: bezier}
net: {kind: free, grid: [4, 4]}
parts:
  - {kind: skin, from: surface, thickness: 60 mm, subdivisions: 6}
  - {kind: frames, count: 3, size: 400 mm, gap: 120 mm, thickness: 20 mm}""",
    "least area": """surface: {kind: least-area, file: first.step}
net: {kind: free, grid: [4, 4]}""",
    "curves": """surface: {kind: file, file: first.json}
net: {kind: free, grid: [4, 4]}
parts: [{kind: flat-pattern}]""",
    "planes": """surface: {kind: monge, x2: -0.9, x3: 0.15, u: [-1.1, 1.2], v: [-1.5, 1.5], size: 14 m}
net: {kind: dog, grid: [4, 4], constraints: [{kind: planar-face}], measures: [face_planarity, gauss_image_area]}""",
    "mesh": """net: {kind: free, from: {file: roof.obj}, reference: {file: tetrahedron.stl}}""",
    "voss": """surface: {kind: torus, ring: 2, tube: 1, v: [2.2, 4.08], u: [-0.9, 0.9], size: 600 mm}
net: {kind: voss, grid: [4, 4]}
parts: [{kind: panels, faces: checker, thickness: 3 mm, gap: 2 mm, side: centered}]""",
    "traced": """surface: {kind: unduloid, neck: 0.3, u: [-3, 3], v: [2.2, 4.6], size: 14 m}
net: {kind: asymptotic, grid: [4, 4], from: {lines: asymptotic, at: [0, 3.4]}}""",
    "points": """surface: {kind: approximation, points: cloud.csv, grid: [6, 6]}
net: {kind: free, grid: [4, 4]}""",
    "wrong": """surface: {kind: enneperr, size: 4 m}
net: {kind: asymptotic, grid: [4, 4], orthogonal: 7}""",
}
ROOF = open(os.path.join(os.path.dirname(__file__), "..", "cases", "meshes", "roof.obj")).read()
SIDES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]


def stl(corners):
    """A tetrahedron as text."""
    text = "solid t\n"
    for side in SIDES:
        text += "facet normal 0 0 0\nouter loop\n"
        text += "".join("vertex %.17g %.17g %.17g\n" % corners[k] for k in side) + "endloop\nendfacet\n"
    return text + "endsolid t\n"


def write_inputs():
    for name, text in DESIGNS.items():
        with open(name.replace(" ", "-") + ".yaml", "w") as file:
            file.write("lamella: 1\nname: small\n" + text + "\n")
    open("roof.obj", "w").write(ROOF)
    # two that overlap, in planes that meet in general position: exact numbers are needed
    open("tetrahedron.stl", "w").write(stl([(0, 0, 0), (1000, 0, 0), (0, 1000, 0), (0, 0, 1000)]))
    open("flat.stl", "w").write(stl([(0, 0, 0), (3, 0, 0), (0, 3, 0), (1, 1, 1e-17)]))
    open("other.stl", "w").write(stl([(0, 0, 0), (1001, 1, 3), (7, 1003, 0), (1, 5, 999)]))
    open("cloud.csv", "w").write("".join(f"{x},{y},{x * y / 20}\n" for x in range(7) for y in range(7)))
    for size, name in ((4, "a.ppm"), (4, "b.ppm")):
        pixels = bytes((k * (7 if name == "a.ppm" else 9)) % 256 for k in range(3 * size * size))
        open(name, "wb").write(b"P6 %d %d 255\n" % (size, size) + pixels)
    subprocess.run([program, "build", "skin.yaml", "-o", "first", "--skip", "png"], stdout=subprocess.DEVNULL)
    shutil.copy("first/small.step", "first.step")
    shutil.copy("first/surface.json", "first.json")
    subprocess.run([program, "measure", "roof.obj", "--map", "edge_ratio", "-o", "a.png"], stdout=subprocess.DEVNULL)
    subprocess.run([program, "measure", "roof.obj", "--map", "edge_length", "-o", "b.png"], stdout=subprocess.DEVNULL)


def tasks():
    for name in DESIGNS:
        file = name.replace(" ", "-") + ".yaml"
        yield "build " + name, ["build", file, "-o", "OUT", "--skip", "png", "--deps", "OUT.d"]
    for name in ("lamellas", "skin", "mesh", "points", "wrong"):
        yield "check " + name, ["check", name + ".yaml"]
    for end in ("svg", "png", "glb"):
        yield "measure --map x." + end, ["measure", "roof.obj", "--map", "edge_ratio", "-o", "OUT." + end]
    yield "measure --json", ["measure", "roof.obj", "--json"]
    yield "measure --reference", ["measure", "roof.obj", "--as", "asymptotic", "--reference", "other.stl"]
    for mesh in ("tetrahedron.stl", "flat.stl", "roof.obj"):
        yield "inspect " + mesh, ["inspect", mesh]
        yield "inspect --json " + mesh, ["inspect", mesh, "--json"]
    yield "diff meshes", ["diff", "tetrahedron.stl", "other.stl"]
    yield "diff --json meshes", ["diff", "tetrahedron.stl", "other.stl", "--json"]
    yield "diff pictures", ["diff", "a.png", "b.png", "--mask", "OUT.png"]
    yield "diff --json pictures", ["diff", "a.png", "b.png", "--json"]
    for what in ([], ["surfaces"], ["designs"], ["formats"], ["measures"]):
        yield "list " + " ".join(what), ["list"] + what
    for what in ("enneper", "asymptotic", "lamella", "hypar-roof", "stl"):
        yield "show " + what, ["show", what]
    yield "new", ["new", "hypar-roof", "-o", "OUT.yaml"]
    yield "--help", ["--help"]
    yield "--version", ["--version"]
    yield "an unknown verb", ["biuld"]


def contents(out):
    """What was written, without the seconds that a report tells; names of folders are taken out."""
    found = {}
    base = os.path.dirname(out)
    for folder, _, files in os.walk(base):
        for file in files:
            path = os.path.join(folder, file)
            data = open(path, "rb").read().replace(base.encode(), b"DIR")
            if file == "report.json":
                data = b"\n".join(l for l in data.split(b"\n") if b'"seconds"' not in l)
            found[path.replace(folder, "DIR")] = hashlib.sha1(data).hexdigest()
    return found


def seconds_out(text):
    """The table of a build without its column of seconds."""
    return "\n".join(" ".join(w for w in l.split() if not w.replace(".", "").isdigit()) if " s" in l else l
                     for l in text.split("\n"))


def run(arguments, variables):
    folder = tempfile.mkdtemp(dir=os.getcwd())
    out = folder + "/made"  # and what stands beside it
    command = [program] + [a.replace("OUT", out) for a in arguments]
    environment = dict(os.environ, LD_PRELOAD=library, **variables)
    try:
        done = subprocess.run(command, env=environment, capture_output=True, timeout=100)
        code, err = done.returncode, done.stderr.decode("utf8", "replace")
        output = seconds_out(done.stdout.decode("utf8", "replace").replace(folder, "DIR"))
    except subprocess.TimeoutExpired:
        code, err, output = -99, "does not end", ""
    made = contents(out)
    shutil.rmtree(folder)
    return code, output, err.replace(folder, "DIR"), made


def verdict(good, got):
    """None when a run with a failure ended as it should, otherwise what is wrong."""
    code, output, err, made = got
    if code == good[0] and (output, err, made) == good[1:]:
        return None
    if code < 0:
        return f"ends by signal {-code}: {err.strip()[-200:]}"
    if code not in (1, 2):
        what = [f for f in set(good[3]) | set(made) if good[3].get(f) != made.get(f)]
        return f"status {code}, and nobody says so; other files: {what[:3]}; err: {err.strip()[:100]}"
    new = [l for l in err.strip().split("\n") if l and l not in good[2].split("\n")]
    told = [l for l in new + output.split("\n") if "memory" in l]
    if not told:
        return f"status {code} without a word on memory: {err.strip()[:200]}"
    if len(new) > 1:
        return f"{len(new)} lines: {err.strip()[:300]}"
    return None


def sweep(pool, name, arguments):
    places_file = os.path.join(os.getcwd(), "places")
    good = run(arguments, {"ALLOCATION_PLACES": places_file})
    again = run(arguments, {})
    if good != again:
        return f"{name}: two runs differ without a failure", 0, 0
    places = [int(line) for line in open(places_file)]
    total = places.pop()
    if share:
        places = sorted(random.Random(1).sample(places, min(share, len(places))))
    bad = {}
    for n, got in zip(places, pool.map(lambda n: run(arguments, {"FAIL_ALLOCATION": str(n)}), places)):
        wrong = verdict(good, got)
        if wrong:
            bad.setdefault(wrong, []).append(n)
    return bad, len(places), total


def main():
    scratch = tempfile.mkdtemp()
    os.chdir(scratch)
    try:
        write_inputs()
        number = 0
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            for name, arguments in tasks():
                if word not in name:
                    continue
                number += 1
                bad, count, total = sweep(pool, name, arguments)
                print("not ok" if bad else "ok", number, "-", name, f"({count} of {total} allocations fail in turn)")
                if bad:
                    for wrong, which in bad.items() if isinstance(bad, dict) else [(bad, [])]:
                        print(f"# {len(which)} times, as with allocation {which[:4]}: {wrong}")
                sys.stdout.flush()
        print(f"1..{number}")
    finally:
        os.chdir("/")
        shutil.rmtree(scratch)


if __name__ == "__main__":
    main()
