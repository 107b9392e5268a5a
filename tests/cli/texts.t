#!/usr/bin/env bash
# Awkward characters in titles, sources and paths: each is refused in one line, or stands in every file so that a reader
# that is not ours (xmllint, Python's JSON and CSV, POV-Ray, OpenSCAD, make) finds the same text or a sound file.
set -u
export LAMELLA_TEMPLATES=$PWD/templates
. "$(dirname "$0")/scratch.sh"
command -v python3 >/dev/null || { echo "ok 1 # SKIP python3 is not installed"; exit 0; }

cat >texts.py <<'SCRIPT'
import csv, glob, io, json, os, re, shutil, struct, subprocess, sys, xml.etree.ElementTree as tree
program = sys.argv[1]
number = 0
def ok(name, wrong):
    global number
    number += 1
    print("ok" if not wrong else "not ok", number, "-", name)
    for line in wrong: print("#", line)
def run(*arguments):
    return subprocess.run([program, *arguments], capture_output=True)

DESIGN = """lamella: 1
name: probe
title: %s
source: %s
surface: {kind: enneper, size: 4 m}
net: {kind: asymptotic, grid: [3, 3], orthogonal: yes, animate: 2}
parts: [{kind: lamella, height: 60 mm, thickness: 1 mm}]
sheets: {stock: [3 m, 1.5 m], kerf: 0.2 mm}
plots: [edge_length]
"""
def binary_gltf(data):
    size = struct.unpack("<I", data[12:16])[0]
    return json.loads(data[20:20 + size])
def read_back(path, title):
    """What an outside reader has against the file; None: nothing. The title where the format holds it."""
    data = open(path, "rb").read()
    if path.endswith(".svg"):
        if not tree.fromstring(data)[0].text.startswith(title): return "another title"
    elif path.endswith("report.json"):
        report = json.loads(data)
        if report["title"] != title or report["source"] != title: return "another title or source"
    elif path.endswith(".json"): json.loads(data)
    elif path.endswith("probe.glb"):
        if binary_gltf(data)["scenes"][0]["name"] != title and "animation" not in path and "probe.glb" == path:
            return "another title"
    elif path.endswith(".glb"): binary_gltf(data)
    elif path.endswith(".csv"):
        rows = list(csv.reader(io.StringIO(data.decode(), newline=""), strict=True))
        if len({len(row) for row in rows}) != 1: return "rows of different lengths"
    elif path.endswith(".dxf"):
        lines = data.decode().split("\n")[:-1] # pairs of a code and a value
        if len(lines) % 2: return "no pairs"
        [int(code) for code in lines[::2]]
    elif path.endswith((".step", ".igs")):
        if any(byte > 126 for byte in data): return "not ASCII"
    elif path.endswith(".pov") and "#declare" in title and not re.search(rb"^// .*#declare x", data, re.M):
        return "the title is no comment"
    else: data.decode() if path.endswith((".scad", ".pov", ".obj")) else None
    return None

accepted = {"markup": "a ]]> b <![CDATA[ <&> \"q\" 'q' --> &amp;", "percent signs": "%s %n %d 100%",
            "backslashes": "a\\nb \\\\ C:\\new", "comments": "*/ cube(1); // #declare x=1; /* #",
            "right to left": "\u202e\u05e9\u05dc\u05d5\u05dd\u202c", "beyond 16 bits": "\U0001F600\U000E0001",
            "a formula": "=1+1;,\"", "a thousand letters": "x" * 1000, "STEP's quotes": "it''s \\X2\\00E9\\X0\\ \u00e9"}
refused = {"a control character": "x\x01y", "a line feed": "one\ntwo", "a carriage return": "one\rtwo", "a tab": "a\tb",
           "DEL": "x\x7fy", "C1": "x\u009by", "U+FFFE": "x\ufffey", "U+FFFF": "x\uffffy", "a line separator": "x\u2028y",
           "more than a thousand letters": "x" * 1001, "a zero": "a\0b"}
for name, text in accepted.items():
    shutil.rmtree("made", ignore_errors=True)
    quoted = json.dumps(text, ensure_ascii=False)
    open("d.yaml", "w").write(DESIGN % (quoted, quoted))
    done = run("build", "d.yaml", "-o", "made", "--skip", "png")
    wrong = [done.stderr.decode()] if done.returncode else []
    for path in glob.glob("made/**", recursive=True):
        if os.path.isdir(path): continue
        try: bad = read_back(path, text)
        except Exception as error: bad = repr(error)[:200]
        if bad: wrong.append(f"{path}: {bad}")
    ok(f"a title with {name} is read back from {len(glob.glob('made/**', recursive=True))} files", wrong)
    if name == "comments": shutil.copytree("made", "commented")
for name, text in refused.items():
    open("d.yaml", "w").write(DESIGN.replace("source: %s\n", "") % json.dumps(text))
    wrong = []
    for verb in (["check", "d.yaml"], ["build", "d.yaml", "-o", "none", "--skip", "png"]):
        done = run(*verb)
        lines = done.stderr.decode().strip().split("\n")
        if done.returncode != 2 or len(lines) != 1 or not lines[0].startswith("d.yaml:3:"):
            wrong.append(f"{verb[0]}: status {done.returncode}, {lines}")
    ok(f"a title with {name} is refused in one line", wrong + (["written"] if os.path.exists("none") else []))

# ---- names of files, which may be any bytes but / and zero ----
roof = open("roof.obj").read()
for name in (b"a<&>\"']]>.obj", b"\xff\xfe.obj", b"a\nb\tc.obj", "\ufffe \u202e.obj".encode(), b"%s%n.obj", b"--x.obj"):
    path = b"./" + name
    open(path, "w").write(roof)
    wrong = []
    for ending in ("svg", "glb"):
        done = run("measure", path, "--map", "edge_ratio", "-o", "map." + ending)
        if done.returncode: wrong.append(done.stderr.decode("latin1"))
        data = open("map." + ending, "rb").read()
        try: tree.fromstring(data) if ending == "svg" else binary_gltf(data)
        except Exception as error: wrong.append(f"{ending}: {error}")
    for verb in (["measure", path, "--json"], ["inspect", path, "--json"], ["diff", path, "roof.obj", "--json"]):
        done = run(*verb)
        try: json.loads(done.stdout)
        except Exception:
            if done.returncode != 1 or done.stderr.count(b"\n") != 1 or b"UTF-8" not in done.stderr:
                wrong.append(f"{verb[0]}: {done.returncode} {done.stdout[:80]} {done.stderr[:80]}")
    ok(f"a map of and JSON about {name!r}", wrong)

# ---- make ----
for name in ("with space", "a:b", "a#b", "a$b", "a$(shell touch gone)b", "a'b\"c", "a&b", "a*b?[c]", "~x", "(a)", "a,b", "-a",
             "a;b", "a|b", "a=b", "a%b", "a\\b", "a\nb", "\u05e9\u05dc"):
    folder = "./make " + name
    os.makedirs(folder, exist_ok=True)
    open(folder + "/roof.obj", "w").write(roof)
    open(folder + "/tent.yaml", "w").write("lamella: 1\nname: tent\nnet: {kind: free, from: {file: roof.obj}}\n")
    done = run("build", folder + "/tent.yaml", "-o", folder + "/out", "--deps", "rule", "--only", "obj,report")
    if done.returncode:
        lines = done.stderr.decode().strip().split("\n")
        ok(f"--deps refuses {name!r} in a path, in a line for each", [] if done.returncode == 2 and
           all("make rule cannot name" in line for line in lines) and not os.path.exists("rule") else lines)
        continue
    # the target is the report; it is up to date until it is older than what it needs
    open("rule", "a").write("%.json:\n\t@exit 1\n") # how it would be made
    asked = ["make", "-q", "-f", "rule"]
    fresh = subprocess.run(asked, capture_output=True)
    os.utime(folder + "/out/report.json", (1, 1))
    stale = subprocess.run(asked, capture_output=True)
    os.remove("rule")
    ok(f"make reads a rule with {name!r} in its paths", [] if (fresh.returncode, stale.returncode) == (0, 1) else
       [f"{fresh.returncode}, {stale.returncode}: {fresh.stderr.decode()[:200]}"])
ok("and no text was run as a command", ["touched"] if os.path.exists("gone") else [])
print(number, file=open("count", "w"))
SCRIPT
cp "$project/tests/cases/meshes/roof.obj" .
# "beyond ASCII" in names must not depend on the reader's locale
PYTHONUTF8=1 python3 texts.py "$lamella"
number=$(cat count)
status=0 out=/dev/null err=/dev/null
: >out; : >err

# The scene and the model whose title tries to end its comment.
if command -v povray >/dev/null; then
  povray -Icommented/probe.pov -Lcommented -W32 -H24 -D -GA -Opicture.png >out 2>err
  ok "POV-Ray reads the scene" [ -s picture.png ]
else
  number=$((number + 1)); echo "ok $number # SKIP povray is not installed"
fi
if command -v openscad >/dev/null; then
  (cd commented && openscad -o ../model.csg probe.scad) >out 2>err
  ok "OpenSCAD reads the model" [ -s model.csg ]
else
  number=$((number + 1)); echo "ok $number # SKIP openscad is not installed"
fi
echo "1..$number"
