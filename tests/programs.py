#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Drawings in the programs of others:  tests/programs.py EPURA

Outside of CI: each program that is installed (openscad, librecad, libreoffice, inkscape, freecad, chromium, pstoedit,
python3-ezdxf, python3-pdfminer, qpdf, poppler-utils, mupdf-tools, nodejs with libjs-pdf, libpdfbox2-java) opens a
drawing, and what it made of that is measured. Prints a row for each, and fails if one is wrong. docs/recipes.md says the
same in words."""
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

WIDTH, HEIGHT, CORNER, BORE, THICK = 40, 30, 5, 5, 6  # mm: a plate with rounded corners and a bore in its middle
AREA = WIDTH * HEIGHT - (4 - math.pi) * CORNER ** 2 - math.pi * BORE ** 2
STEPS = 24  # of a quarter of a circle

epura = str(Path(sys.argv[1]).resolve())
samples = Path(__file__).resolve().parent.parent / "samples"
rows, failed = [], []


def run(*command, **options):
    environment = {**os.environ, "HOME": os.getcwd(), "QT_QPA_PLATFORM": "offscreen", **options.pop("env", {})}
    ran = subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=300, env=environment,
                         stdin=subprocess.DEVNULL, errors="replace", **options)
    return ran.stdout + ran.stderr


def draw(*arguments):
    subprocess.run([epura, "draw", *map(str, arguments)], check=True, capture_output=True, text=True)


def judge(program, what, found, expected, slack=0.0):
    right = found is not None and (abs(found - expected) <= slack if slack else found == expected)
    rows.append((program, what, found, expected, "" if right else "WRONG"))
    if not right:
        failed.append(what)


def plate():
    """The outline as OBJ: two rings of the plate and of the bore, walls between them, and rings of quadrangles."""
    rim = []
    for quarter, (x, y) in enumerate([(1, 1), (-1, 1), (-1, -1), (1, -1)]):
        for step in range(STEPS + 1):
            angle = (quarter + step / STEPS) * math.pi / 2
            rim.append((x * (WIDTH / 2 - CORNER) + CORNER * math.cos(angle),
                        y * (HEIGHT / 2 - CORNER) + CORNER * math.sin(angle)))
    # The bore has its corners in the directions of those of the rim, and straight sides have some, too.
    rim = [(x0 + (x1 - x0) * step / STEPS, y0 + (y1 - y0) * step / STEPS)
           for (x0, y0), (x1, y1) in zip(rim, rim[1:] + rim[:1])
           for step in range(STEPS if math.hypot(x1 - x0, y1 - y0) > 1 else 1)]
    angles = [math.atan2(y, x) for x, y in rim]
    bore = [(BORE * math.cos(a), BORE * math.sin(a)) for a in angles]
    count = len(rim)
    with open("plate.obj", "w") as obj:
        for ring in (rim, bore):
            for z in (0, THICK):
                for x, y in ring:
                    obj.write(f"v {x:.17g} {y:.17g} {z}\n")
        corner = lambda ring, i: ring * count + i % count + 1
        for i in range(count):
            for a, b in ((0, 1), (1, 3), (3, 2), (2, 0)):  # outside, top, bore, bottom
                obj.write(f"f {corner(a, i)} {corner(a, i + 1)} {corner(b, i + 1)} {corner(b, i)}\n")


def area_of_paths(svg):
    """Of closed polygons, by the even-odd rule of rings in rings: the bore counts negative."""
    areas = []
    for data in re.findall(r' d="([^"]*)"', svg):
        for ring in re.findall(r"M[^zZ]*", data):
            numbers = [float(n) for n in re.findall(r"-?[\d.]+(?:e-?\d+)?", ring)]
            points = list(zip(numbers[::2], numbers[1::2]))
            areas.append(abs(sum(x0 * y1 - x1 * y0 for (x0, y0), (x1, y1) in zip(points, points[1:] + points[:1]))) / 2)
    areas.sort(reverse=True)
    return areas[0] - sum(areas[1:]) if areas else None


def page_of(pdf):
    found = re.search(r"Page size: *([\d.]+) x ([\d.]+)", run("pdfinfo", pdf))
    pages = re.search(r"Pages: *(\d+)", run("pdfinfo", pdf))
    return (round(float(found[1]) * 25.4 / 72), round(float(found[2]) * 25.4 / 72), int(pages[1])) if found else None


def box_of_ink(pdf, dpi=100):
    """Left, lower, right and upper end of what is dark on the first page, mm."""
    run("pdftoppm", "-r", dpi, "-gray", "-singlefile", pdf, "ink")
    data = Path("ink.pgm").read_bytes()
    header = re.match(rb"P5\s+(\d+)\s+(\d+)\s+\d+\s", data)
    width, height = int(header[1]), int(header[2])
    pixels = data[header.end():]
    dark = [[x for x in range(width) if row[x] < 128]
            for row in (pixels[y * width:(y + 1) * width] for y in range(height))]
    lines = [y for y, row in enumerate(dark) if row]
    if not lines:
        return None
    mm = 25.4 / dpi
    return (min(min(row) for row in dark if row) * mm, (height - max(lines) - 1) * mm,
            (max(max(row) for row in dark if row) + 1) * mm, (height - min(lines)) * mm)


def openscad():
    draw("plate.obj", "--projection", "top", "--hidden", "none", "--sheet", "none", "--scale", "1:1", "--arcs",
         "--dxf-arcs", "entities", "-o", "plate.dxf")
    Path("plate.scad").write_text('import("plate.dxf", $fn = 360);\n')
    Path("plate.svg").unlink(missing_ok=True)
    words = run("openscad", "-o", "plate.svg", "plate.scad")
    judge("openscad", "area of the plate, mm2", area_of_paths(Path("plate.svg").read_text()), AREA, 0.2)
    judge("openscad", "warnings", words.count("WARNING"), 0)


def librecad():
    draw(samples / "bracket.toml", "-o", "bracket.dxf")
    run("librecad", "dxf2pdf", "-a", "-o", "bracket-librecad.pdf", "bracket.dxf")
    # It writes PDF beside the drawing, whatever -o says.
    pdf = "bracket-librecad.pdf" if Path("bracket-librecad.pdf").exists() else "bracket.pdf"
    judge("librecad", "page, mm", page_of(pdf)[:2], (420, 297))


def libreoffice():
    draw(samples / "bracket.toml", "-o", "office.dxf")
    run("soffice", "--headless", "--convert-to", "pdf", "office.dxf")
    box = box_of_ink("office.pdf")
    judge("libreoffice", "width by height, to the trimming marks", round((box[2] - box[0]) / (box[3] - box[1]), 2),
          420 / 297, 0.01)
    judge("libreoffice", "escapes in its texts", run("pdftotext", "office.pdf", "-").count("U+"), 0)


def inkscape():
    draw(samples / "bracket.toml", "-o", "bracket.svg")
    run("inkscape", "bracket.svg", "-o", "bracket-inkscape.pdf")
    judge("inkscape", "page, mm", page_of("bracket-inkscape.pdf")[:2], (420, 297))


def freecad():
    draw(samples / "models" / "flange.obj", "--views", "front,top", "--sheet", "A3", "--dxf-blocks", "-o", "blocks.dxf")
    Path("box.py").write_text(
        "import FreeCAD, Import\n"
        "document = FreeCAD.newDocument('d')\nImport.readDXF('blocks.dxf', 'd')\nbox = FreeCAD.BoundBox()\n"
        "for o in document.Objects:\n    if hasattr(o, 'Shape') and not o.Shape.isNull(): box.add(o.Shape.BoundBox)\n"
        "print('BOX', round(box.XMax), round(box.YMax))\n")
    found = re.search(r"BOX (\d+) (\d+)", run("freecadcmd", "box.py"))
    judge("freecad", "upper right end of the frame, mm", found and (int(found[1]), int(found[2])), (415, 292))


def chromium():
    draw(samples / "bracket.toml", "-o", "print.svg")
    run("chromium", "--headless", "--no-sandbox", "--disable-gpu", "--print-to-pdf=print.pdf",
        Path("print.svg").resolve().as_uri())
    judge("chromium", "printed: page in mm, pages", page_of("print.pdf"), (420, 297, 1))
    judge("chromium", "printed: right end of the ink, mm", box_of_ink("print.pdf")[2], 420, 0.5)


def pstoedit():
    model = samples / "models" / "bearing.obj"
    pens = {}
    for strokes in ("dashed", "real"):
        draw(model, "--views", "front,left", "--centre-lines", "--frame", "none", "--strokes", strokes, "-o",
             f"{strokes}.eps")
        run("pstoedit", "-f", "hpgl", f"{strokes}.eps", f"{strokes}.hpgl")
        pens[strokes] = Path(f"{strokes}.hpgl").read_text(errors="replace").count("PU")
    judge("pstoedit", "more pen moves with real strokes", pens["real"] > 2 * pens["dashed"] > 0, True)


def ezdxf():
    draw(samples / "bracket.toml", "-o", "texts.dxf")
    texts = run("/usr/bin/python3", "-c",
                "import ezdxf; print(*[t.dxf.text for t in ezdxf.readfile('texts.dxf').modelspace().query('TEXT')])")
    judge("ezdxf", "signs of diameters in texts", "⌀" in texts and "U+" not in texts, True)


def pdfminer():
    draw(samples / "models" / "bearing.obj", "--views", "front,left", "--title", "A bearing", "--number", "12-345", "-o",
         "words.pdf")
    words = run("/usr/bin/python3", "-c", "from pdfminer.high_level import extract_text; print(extract_text('words.pdf'))")
    lines = [line.strip() for line in words.splitlines()]
    judge("pdfminer", "title and number are lines", ("A bearing" in lines, "12-345" in lines), (True, True))


def archive():
    """A PDF for archives with attachments, its dimensions, and the words of its second view."""
    draw(samples / "models" / "flange.obj", "--views", "front,top", "--dimensions", "auto", "--title", "A flange", "--pdf", "archive",
         "--proof", "data", "-o", "archive.pdf")
    return "archive.pdf"


def qpdf():
    words = run("qpdf", "--check", archive())
    judge("qpdf", "errors and warnings", len(re.findall("(?i)warning|error(?!s that qpdf|s found)", words)), 0)
    names = {line.split(" ->")[0] for line in run("qpdf", "--list-attachments", "archive.pdf").splitlines() if " ->" in line}
    judge("qpdf", "attachments", {"proof.toml", "lint.json"} <= names, True)


def pdfinfo():
    facts = dict(re.findall(r"^([A-Za-z ]+): +(.*)$", run("pdfinfo", archive()), re.M))
    judge("poppler", "tagged", facts.get("Tagged"), "yes")
    elements = [line.split()[0] for line in run("pdfinfo", "-struct", "archive.pdf").splitlines() if line.strip()]
    judge("poppler", "views that are figures", elements.count("Figure"), 2)
    judge("poppler", "text", "A flange" in run("pdftotext", "archive.pdf", "-"), True)


def mutool():
    words = run("mutool", "draw", "-F", "txt", archive())
    judge("mupdf", "text", "A flange" in words, True)
    judge("mupdf", "complaints", len(re.findall("^(?:error|warning): (?!ICC support)", words, re.M)), 0)


# What ISO 19005-1 forbids and ISO 19005-3 permits: attachments (1.2.9, 1.4.7), layers (1.4.8), streams of references (1.4),
# profiles of ICC 4 (2.1.6), numbers above 32767 (1.0.6), and that it is part 3 (7.11.2).
PERMITTED = {"1.2.9", "1.4.7", "1.4.8", "1.4", "2.1.6", "1.0.6", "7.11.2"}


def java():
    """PDFBox's preflight, which judges PDF/A-1b (packages libpdfbox2-java, libactivation-java, libjaxb-api-java)."""
    names = "preflight pdfbox2 xmpbox fontbox2 commons-logging commons-io javax.activation jaxb-api".split()
    jars = [Path("/usr/share/java", name + ".jar") for name in names]
    if not jars[0].exists():
        print("preflight: not installed")
        return
    words = run("java", "-cp", ":".join(map(str, jars)), "org.apache.pdfbox.preflight.Validator_A1b", archive())
    codes = set(re.findall(r"^([\d.]+) : ", words, re.M))
    judge("preflight", "it judges", "PDF/A-1b" in words, True)
    judge("preflight", "what PDF/A-3b forbids, too", sorted(codes - PERMITTED), [])


PDF_JS = "/usr/share/javascript/pdf/build/pdf.js"  # package libjs-pdf


def node():
    if not Path(PDF_JS).exists():
        print("pdf.js: not installed")
        return
    Path("read.js").write_text(f"""
const pdfjs = require('{PDF_JS}');
pdfjs.GlobalWorkerOptions.workerSrc = '{PDF_JS.replace('pdf.js', 'pdf.worker.js')}';
(async () => {{
  const data = new Uint8Array(require('fs').readFileSync('{archive()}'));
  const file = await pdfjs.getDocument({{data, verbosity: 0}}).promise, page = await file.getPage(1), roles = [];
  const walk = one => {{ if (one.role) roles.push(one.role); (one.children ?? []).forEach(walk); }};
  walk(await page.getStructTree());
  console.log('FIGURES', roles.filter(role => role === 'Figure').length);
  console.log('TEXT', (await page.getTextContent()).items.map(item => item.str).join('|'));
  console.log('FILES', Object.keys(await file.getAttachments()).join(' '));
  process.exit();
}})();
""")
    words = run("node", "read.js")
    judge("pdf.js", "views that are figures", "FIGURES 2" in words, True)
    judge("pdf.js", "text", "A flange" in words, True)
    judge("pdf.js", "attachments", bool(re.search("FILES .*proof.toml", words)), True)


def main():
    needs = {openscad: "openscad", librecad: "librecad", libreoffice: "soffice", inkscape: "inkscape",
             freecad: "freecadcmd", chromium: "chromium", pstoedit: "pstoedit", ezdxf: None, pdfminer: None,
             qpdf: "qpdf", pdfinfo: "pdfinfo", mutool: "mutool", node: "node", java: "java"}
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        plate()
        for test, program in needs.items():
            has = shutil.which(program) if program else not subprocess.run(
                ["/usr/bin/python3", "-c", f"import {test.__name__}"], capture_output=True).returncode
            if not has:
                print(f"{test.__name__}: not installed")
                continue
            try:
                test()
            except Exception as error:  # a program that fails is a finding, and the others go on
                judge(test.__name__, f"it runs: {error!r}", None, True)
        os.chdir("/")
    for row in rows:
        print("{:12} {:45} {!s:28} {!s:28} {}".format(*row))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
