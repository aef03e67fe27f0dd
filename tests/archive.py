# SPDX-License-Identifier: Apache-2.0
"""What validators of PDF/A-3b (ISO 19005-3) and PDF/UA-1 (ISO 14289-1) would refuse in sheets: each rule under its clause, read here from
the bytes by qpdf, not from what epura means to write.  python3 archive.py EPURA | --look FILE.pdf

Left out is what no sheet has: forms, actions, links, encryption, pictures, sound, and what only a reader of the words can judge.
"""

import base64
import json
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

SAMPLES = pathlib.Path(__file__).resolve().parent.parent / "samples"
# Of annex A of ISO 32000-1; BX and EX would hide others.
OPERATORS = set("b B b* B* BDC BMC BT c cm CS cs d d0 d1 Do DP EMC ET f f* G g gs h i j J K k l m M MP n q Q re RG rg ri s S SC sc SCN scn sh T* "
                "Tc Td TD Tf Tj TJ TL Tm Tr Ts Tw Tz v w W W* y ' \"".split())
PAINTS = set("S s f f* B B* b b* Tj TJ ' \" Do sh".split())
STRUCTURE = set("Document Part Art Sect Div BlockQuote Caption TOC TOCI Index NonStruct Private P H H1 H2 H3 H4 H5 H6 L LI Lbl LBody Table TR TH TD "
                "THead TBody TFoot Span Quote Note Reference BibEntry Code Link Annot Figure Formula Form".split())
NAMES = {"http://purl.org/dc/elements/1.1/", "http://ns.adobe.com/xap/1.0/", "http://ns.adobe.com/pdf/1.3/", "http://www.aiim.org/pdfa/ns/id/",
         "http://www.aiim.org/pdfa/ns/extension/", "http://www.aiim.org/pdfa/ns/schema#", "http://www.aiim.org/pdfa/ns/property#",
         "http://www.w3.org/1999/02/22-rdf-syntax-ns#", "adobe:ns:meta/", "http://www.w3.org/XML/1998/namespace"}


class Pdf:
    def __init__(self, file):
        self.bytes = pathlib.Path(file).read_bytes()
        text = subprocess.run(["qpdf", "--json=2", "--json-stream-data=inline", "--decode-level=generalized", file], check=True, stdout=subprocess.PIPE).stdout
        self.objects = json.loads(text)["qpdf"][1]
        self.trailer = self.objects["trailer"]["value"]
        self.root = self.of(self.trailer["/Root"])

    def of(self, value):
        """What a reference stands for: the dictionary of a stream."""
        while isinstance(value, str) and re.fullmatch(r"\d+ \d+ R", value):
            thing = self.objects["obj:" + value]
            value = thing["stream"]["dict"] if "stream" in thing else thing["value"]
        return value

    def data(self, reference):
        return base64.b64decode(self.objects["obj:" + reference]["stream"]["data"])

    def dictionaries(self):
        """All of them, also those within others."""
        left = [thing["stream"]["dict"] if "stream" in thing else thing["value"] for thing in self.objects.values()]
        while left:
            thing = left.pop()
            if isinstance(thing, dict):
                yield thing
            left += thing.values() if isinstance(thing, dict) else thing if isinstance(thing, list) else []

    def typed(self, kind):
        return [thing for thing in self.dictionaries() if thing.get("/Type") == kind]

    def content(self, page):
        streams = page["/Contents"]
        return b"\n".join(self.data(stream) for stream in (streams if isinstance(streams, list) else [streams]))


TOKEN = re.compile(rb"\s*(?:%[^\r\n]*|(\((?:\\.|[^()\\]|\((?:\\.|[^()\\])*\))*\))|(<<|>>|\[|\])|(<[0-9A-Fa-f\s]*>)|(/[^\s()<>\[\]{}/%]*)|([^\s()<>\[\]{}/%]+))", re.S)


def instructions(content):
    """Pairs of an operator and its operands, in which strings are bytes and all else is text."""
    operands = []
    for string, bracket, hexadecimal, name, word in TOKEN.findall(content):
        if string:
            plain = re.sub(rb"\\([0-7]{1,3}|\r\n|.)", lambda found: unescaped(found[1]), string[1:-1], flags=re.S)
            operands.append(plain)
        elif hexadecimal:
            operands.append(bytes.fromhex(hexadecimal[1:-1].decode()))
        elif name or bracket:
            operands.append((name or bracket).decode())
        elif word:
            if re.fullmatch(rb"[-+.\d]+|true|false|null", word):
                operands.append(word.decode())
            else:
                yield word.decode(), operands
                operands = []


def unescaped(code):
    if code.isdigit():
        return bytes([int(code, 8) & 255])
    return {b"n": b"\n", b"r": b"\r", b"t": b"\t", b"b": b"\b", b"f": b"\f", b"\n": b"", b"\r\n": b""}.get(code, code)


def file_structure(pdf):
    """6.1"""
    if not re.match(rb"%PDF-1\.[0-7][\r\n]+%[\x80-\xff]{4}", pdf.bytes):
        yield "6.1.2 no header with four bytes above 127"
    if "/ID" not in pdf.trailer or "/Encrypt" in pdf.trailer:
        yield "6.1.3 no ID, or encrypted"
    if not re.search(rb"%%EOF[\r\n]{0,2}$", pdf.bytes):
        yield "6.1.3 something behind the end"
    for thing in pdf.dictionaries():
        if "LZW" in str(thing.get("/Filter")) or "/FFilter" in thing or "/F" in thing and thing.get("/Type") == "/EmbeddedFile":
            yield "6.1.7 a stream is compressed by LZW or lies elsewhere"
        if any(len(key.encode()) > 127 for key in thing) or any(isinstance(value, str) and len(value.encode()) > 32767 for value in thing.values()):
            yield "6.1.13 a long name or text"


def contents(pdf):
    """6.2.2, 6.1.13; and 7.1 of PDF/UA: what is painted is marked as part of an element or as an artifact."""
    for page in pdf.typed("/Page"):
        depth, marks = 0, []
        if "/Resources" not in page:
            yield "6.2.2 a page without resources of its own"
        for operator, operands in instructions(pdf.content(page)):
            if operator not in OPERATORS:
                yield f"6.2.2 the operator {operator}"
            depth += (operator == "q") - (operator == "Q")
            if depth > 28 or depth < 0:
                yield f"6.1.13 states within each other: {depth}"
            if operator in ("BDC", "BMC"):
                marks.append("/Artifact" in operands or "/MCID" in operands)
            elif operator == "EMC":
                marks.pop()
            elif operator in PAINTS and not any(marks):
                yield f"UA 7.1 {operator} is neither in an element nor an artifact"
            if operator in ("K", "k") or operator in ("CS", "cs") and "CMYK" in operands[0]:
                yield "6.2.4 colours that the output intent does not describe"
        if marks or depth:
            yield "6.2.2 marks or states that do not end"


def colours(pdf):
    """6.2.3, 6.2.5, 6.2.10"""
    intents = [pdf.of(intent) for intent in pdf.root.get("/OutputIntents", [])]
    if [intent["/S"] for intent in intents] != ["/GTS_PDFA1"] or pdf.of(intents[0]["/DestOutputProfile"])["/N"] != 3:
        yield "6.2.3 no output intent of RGB"
    else:
        profile = pdf.data(intents[0]["/DestOutputProfile"])
        if profile[36:40] != b"acsp" or profile[8] > 4 or profile[12:16] not in (b"mntr", b"prtr") or profile[16:20] != b"RGB ":
            yield "6.2.3 the profile is none of RGB"
    for state in pdf.dictionaries():
        if {"/TR", "/HTP"} & state.keys() or state.get("/BM", "/Normal") not in ("/Normal", "/Multiply", "/Compatible"):
            yield "6.2.5 a transfer function, a halftone's origin, or an unknown blend mode"


class TrueType:
    def __init__(self, data):
        self.tables = {}
        for i in range(struct.unpack(">H", data[4:6])[0]):
            tag, _, begin, size = struct.unpack(">4sIII", data[12 + 16 * i:28 + 16 * i])
            self.tables[tag] = data[begin:begin + size]
        self.unit = struct.unpack(">H", self.tables[b"head"][18:20])[0]
        self.wide = struct.unpack(">H", self.tables[b"hhea"][34:36])[0]
        self.count = struct.unpack(">H", self.tables[b"maxp"][4:6])[0]
        self.maps = {}
        if cmap := self.tables.get(b"cmap"):
            for i in range(struct.unpack(">H", cmap[2:4])[0]):
                platform, encoding, begin = struct.unpack(">HHI", cmap[4 + 8 * i:12 + 8 * i])
                self.maps[platform, encoding] = self.glyphs(cmap[begin:])

    @staticmethod
    def glyphs(table):
        """Of codes: formats 0, 4 and 6."""
        kind = struct.unpack(">H", table[:2])[0]
        if kind == 0:
            return dict(enumerate(table[6:262]))
        if kind == 6:
            first, count = struct.unpack(">HH", table[6:10])
            return dict(enumerate(struct.unpack(f">{count}H", table[10:10 + 2 * count]), first))
        count, found = struct.unpack(">H", table[6:8])[0] // 2, {}
        row = lambda i: struct.unpack(f">{count}H", table[14 + 2 * count * i + 2 * (i > 0):14 + 2 * count * (i + 1) + 2 * (i > 0)])
        ends, starts, deltas, offsets = (row(i) for i in range(4))
        for i in range(count):
            for code in range(starts[i], ends[i] + 1):
                if offsets[i]:
                    at = 16 + 6 * count + 2 * i + offsets[i] + 2 * (code - starts[i])
                    glyph = struct.unpack(">H", table[at:at + 2])[0]
                    found[code] = (glyph + deltas[i]) % 65536 if glyph else 0
                else:
                    found[code] = (code + deltas[i]) % 65536
        return found

    def width(self, glyph):
        return struct.unpack(">H", self.tables[b"hmtx"][4 * min(glyph, self.wide - 1):][:2])[0] * 1000 / self.unit


def shown(pdf):
    """The codes that each font shows, by the font's reference."""
    codes = {}
    for page in pdf.typed("/Page"):
        fonts, font = pdf.of(pdf.of(page["/Resources"]).get("/Font", {})), None
        for operator, operands in instructions(pdf.content(page)):
            if operator == "Tf":
                font = fonts[operands[0]]
            elif operator in ("Tj", "TJ"):
                size = 2 if pdf.of(font)["/Subtype"] == "/Type0" else 1
                for text in (part for part in operands if isinstance(part, bytes)):
                    codes.setdefault(font, set()).update(int.from_bytes(text[i:i + size], "big") for i in range(0, len(text), size))
    return codes


def fonts(pdf):
    """6.2.11, and 7.21 of PDF/UA"""
    for reference, codes in shown(pdf).items():
        font = pdf.of(reference)
        below = pdf.of(font["/DescendantFonts"][0]) if font["/Subtype"] == "/Type0" else font
        descriptor = pdf.of(below.get("/FontDescriptor", {}))
        if "/FontFile2" not in descriptor:
            yield f"6.2.11.4 {font.get('/BaseFont')} is not embedded as TrueType"
            continue
        program = TrueType(pdf.data(descriptor["/FontFile2"]))
        if below is not font:
            if below.get("/CIDToGIDMap") != "/Identity" or font["/Encoding"] != "/Identity-H":
                yield "6.2.11.3 a map of glyphs that is not the identity"
            if "/CIDSet" in descriptor and len(pdf.data(descriptor["/CIDSet"])) * 8 < program.count:
                yield "6.2.11.4.2 a CIDSet without all glyphs"
            glyph_of, widths = {code: code for code in codes}, wide_of(below)
        else:
            if descriptor["/Flags"] & 36 != 32 or font.get("/Encoding") not in ("/WinAnsiEncoding", "/MacRomanEncoding"):
                yield "6.2.11.6 a font of letters without their encoding"
            if (3, 1) not in program.maps:
                yield "6.2.11.6 a font without a map of letters"
            letters = "cp1252" if font.get("/Encoding") == "/WinAnsiEncoding" else "mac-roman"
            glyph_of = {code: program.maps.get((3, 1), {}).get(ord(bytes([code]).decode(letters, "replace"))) for code in codes}
            widths = dict(enumerate(font["/Widths"], font["/FirstChar"]))
        known = unicode_of(pdf.data(font["/ToUnicode"])) if "/ToUnicode" in font else {}
        for code in sorted(codes):
            glyph = glyph_of.get(code) or 0
            if glyph == 0 or glyph >= program.count:
                yield f"6.2.11.8 {font['/BaseFont']} shows a glyph that it does not have: {code}"
            elif abs(widths.get(code, 0) - program.width(glyph)) > 1:
                yield f"6.2.11.5 {font['/BaseFont']}: {code} is {widths.get(code, 0)} wide, {program.width(glyph):.1f} in its program"
            if known.get(code, 0) in (0, 0xFEFF, 0xFFFE):
                yield f"UA 7.21.7 no letter is known for {code} of {font['/BaseFont']}"


def wide_of(font):
    widths, row = {}, font.get("/W", [])
    while row:
        if isinstance(row[1], list):
            widths.update(enumerate(row[1], row[0]))
            row = row[2:]
        else:
            widths.update(dict.fromkeys(range(row[0], row[1] + 1), row[2]))
            row = row[3:]
    return widths


def unicode_of(cmap):
    """The first letter of each code of a ToUnicode map."""
    text, known = cmap.decode("latin-1"), {}
    for block in re.findall(r"beginbfchar(.*?)endbfchar", text, re.S):
        known.update((int(code, 16), int(letter[:4], 16)) for code, letter in re.findall(r"<(\w+)>\s*<(\w+)>", block))
    for block in re.findall(r"beginbfrange(.*?)endbfrange", text, re.S):
        for first, last, letters in re.findall(r"<(\w+)>\s*<(\w+)>\s*(<\w+>|\[[^\]]*\])", block):
            each = [int(letter[:4], 16) for letter in re.findall(r"<(\w+)>", letters)]
            for i, code in enumerate(range(int(first, 16), int(last, 16) + 1)):
                known[code] = each[i] if letters[0] == "[" else each[0] + i
    return known


def metadata(pdf):
    """6.6.2, and 5 and 7.1 of PDF/UA"""
    if "/Filter" in pdf.of(pdf.root["/Metadata"]):
        yield "6.6.2.1 the metadata is compressed"
    text = pdf.data(pdf.root["/Metadata"])
    if re.search(rb"<\?xpacket begin[^?]*(bytes|encoding)=", text):
        yield "6.6.2.1 a packet with its size or encoding"
    tree = xml.etree.ElementTree.fromstring(text)
    words = {element.tag: "".join(element.itertext()).strip() for element in tree.iter()}
    described = {words for tag, words in words.items() if tag.endswith("namespaceURI")}
    for name in {tag[1:].partition("}")[0] for tag in words} - NAMES - described:
        yield f"6.6.2.3 no schema describes {name}"
    identity = "{http://www.aiim.org/pdfa/ns/id/}"
    if words.get(identity + "part") != "3" or words.get(identity + "conformance") not in ("A", "B", "U"):
        yield "6.6.4 not marked as PDF/A-3"
    if words.get("{http://www.aiim.org/pdfua/ns/id/}part") != "1":
        yield "UA 5 not marked as PDF/UA-1"
    if not words.get("{http://purl.org/dc/elements/1.1/}title") or pdf.of(pdf.root.get("/ViewerPreferences", {})).get("/DisplayDocTitle") is not True:
        yield "UA 7.1 no title to be shown"


def attachments(pdf):
    """6.8, and 7.11 of PDF/UA"""
    associated = pdf.root.get("/AF", [])
    for thing in pdf.dictionaries():
        if "/EF" in thing:
            if not {"/F", "/UF", "/AFRelationship", "/Desc"} <= thing.keys():
                yield "6.8 a file without both names, its relation or a description"
            if "/" not in pdf.of(pdf.of(thing["/EF"])["/F"]).get("/Subtype", "")[1:]:
                yield "6.8 a file without its media type"
            if thing not in [pdf.of(each) for each in associated]:
                yield "6.8 a file that belongs to nothing"


def layers(pdf):
    """6.9, and 7.10 of PDF/UA"""
    properties = pdf.of(pdf.root.get("/OCProperties"))
    if properties:
        settings = [pdf.of(properties["/D"]), *map(pdf.of, properties.get("/Configs", []))]
        if len({each.get("/Name") for each in settings} - {None}) < len(settings) or any("/AS" in each for each in settings):
            yield "6.9 a setting of layers without a name of its own, or which changes by itself"
        if any("/Order" in each and not set(properties["/OCGs"]) <= set(flat(each["/Order"])) for each in settings):
            yield "6.9 an order without all layers"


def flat(rows):
    return [item for row in rows for item in (flat(row) if isinstance(row, list) else [row])]


def extras(pdf):
    """6.3 to 6.5, 6.10, 6.11: what may not be there."""
    for key in {"/AA", "/OpenAction", "/Requirements", "/Perms"} & pdf.root.keys():
        yield f"6.5 the catalog has {key}"
    for page in pdf.typed("/Page"):
        for key in {"/AA", "/PresSteps"} & page.keys():
            yield f"6.10 a page has {key}"
        if page.get("/Annots") and page.get("/Tabs") != "/S":
            yield "UA 7.18.3 annotations without an order"
    if any(thing.get("/S") in ("/JavaScript", "/Launch", "/Hide", "/Sound", "/Movie") for thing in pdf.dictionaries()):
        yield "6.5 an action"


def structure(pdf):
    """7.1 to 7.5 of PDF/UA: elements, their words, tables, and the way back from what is marked."""
    if pdf.of(pdf.root.get("/MarkInfo", {})).get("/Marked") is not True or not pdf.root.get("/Lang"):
        yield "UA 7.1 not tagged, or without a language"
    tree = pdf.of(pdf.root.get("/StructTreeRoot"))
    if not tree:
        yield "UA 7.1 no structure"
        return
    parents = pdf.of(tree["/ParentTree"])["/Nums"]
    found = {}

    def walk(reference, parent):
        element = pdf.of(reference)
        kind = element["/S"][1:]
        if kind not in STRUCTURE:
            yield f"UA 7.1 {kind} is no known kind of element"
        if element.get("/P") != parent:
            yield f"UA 7.1 {kind} does not know where it belongs"
        if kind in ("Figure", "Formula") and not (element.get("/Alt") or element.get("/ActualText")):
            yield f"UA 7.3 {kind} without words"
        kids = element.get("/K", [])
        kids = kids if isinstance(kids, list) else [kids]
        if kind == "Table":
            yield from table(kids)
        for kid in kids:
            if isinstance(kid, str):
                yield from walk(kid, reference)
            else:
                page = element["/Pg"] if isinstance(kid, int) else kid.get("/Pg", element.get("/Pg"))
                found[page, kid if isinstance(kid, int) else kid["/MCID"]] = reference

    def table(rows):
        widths = set()
        heads = False
        for row in map(pdf.of, rows):
            width = 0
            for cell in map(pdf.of, row["/K"]):
                attributes = pdf.of(cell.get("/A", {}))
                attributes = attributes[0] if isinstance(attributes, list) else attributes
                width += pdf.of(attributes).get("/ColSpan", 1)
                heads = heads or cell["/S"] == "/TH"
                if cell["/S"] == "/TH" and "/Scope" not in pdf.of(attributes):
                    yield "UA 7.5 a head of a table for nothing"
            widths.add(width)
        if len(widths) != 1:
            yield f"UA 7.2 rows of a table with different widths: {sorted(widths)}"
        if not heads:
            yield "UA 7.5 a table without heads"

    yield from walk(tree["/K"][0] if isinstance(tree["/K"], list) else tree["/K"], pdf.root["/StructTreeRoot"])
    by_number = dict(zip(parents[::2], parents[1::2]))
    for reference, thing in ((key[4:], value.get("value")) for key, value in pdf.objects.items() if key.startswith("obj:")):
        if isinstance(thing, dict) and thing.get("/Type") == "/Page":
            for mark, element in enumerate(pdf.of(by_number[thing["/StructParents"]])):
                if found.get((reference, mark)) != element:
                    yield f"UA 7.1 the mark {mark} does not lead to its element"


RULES = (file_structure, contents, colours, fonts, metadata, attachments, layers, extras, structure)


def complaints(pdf):
    found = []
    for rule in RULES:
        try:
            found += dict.fromkeys(rule(pdf))
        except (KeyError, IndexError, TypeError) as error:
            found.append(f"{rule.__name__}: {error!r}")
    return found


SHEETS = {
    "parts": ["step/clamp.step", "--views", "front,top,isometric", "--dimensions", "hole-table", "--sheet", "auto", "--parts-list", "--title", "Clamp", "--proof", "model"],
    "words": ["models/bracket.obj", "--views", "front,top", "--dimensions", "auto", "--title", "\u0391\u0392\u0393 \u0448\u043a\u0430\u043b\u0430 \u2300", "--language", "de"],
    "pages": ["flange.toml"],
}


def first(pdf, test):
    return next(thing for thing in pdf.dictionaries() if test(thing))


def without(key, test=lambda thing: True):
    """Takes the key from the first dictionary of which this is true."""
    return lambda pdf: first(pdf, lambda thing: key in thing and test(thing)).pop(key)


def with_words(old, new):
    """Changes the metadata."""
    def plant(pdf):
        stream = pdf.objects["obj:" + pdf.root["/Metadata"]]["stream"]
        stream["data"] = base64.b64encode(base64.b64decode(stream["data"]).replace(old, new)).decode()
    return plant


def set_value(key, value, test=lambda thing: True):
    def plant(pdf):
        first(pdf, lambda thing: key in thing and test(thing))[key] = value
    return plant


# What each of these breaks is told under its clause.
PLANTS = {
    "6.1.3": lambda pdf: pdf.trailer.pop("/ID"), "6.2.3": without("/OutputIntents"), "6.2.11.4": without("/FontFile2"),
    "6.2.11.5": set_value("/Widths", [900] * 224), "UA 7.21.7": without("/ToUnicode"), "6.6.2.3": with_words(b"ua/ns/id/</pdfaSchema", b"</pdfaSchema"),
    "6.6.4": with_words(b"<pdfaid:part>3", b"<pdfaid:part>2"), "UA 5": with_words(b"<pdfuaid:part>1", b"<pdfuaid:part>2"),
    "UA 7.1 no title": without("/DisplayDocTitle"), "6.8": without("/AFRelationship"), "6.8 a file that": without("/AF"),
    "6.9": without("/Name", lambda thing: "/Order" in thing), "6.5": set_value("/S", "/JavaScript", lambda thing: thing["/S"] == "/P"),
    "UA 7.3": without("/Alt", lambda thing: thing.get("/S") == "/Figure"), "UA 7.2": lambda pdf: first(pdf, lambda thing: "/Scope" in thing).update({"/ColSpan": 3}), "UA 7.5": without("/Scope"),
    "UA 7.1 Rect": set_value("/S", "/Rect", lambda thing: thing["/S"] == "/Span"), "UA 7.1 the mark": lambda pdf: next(
        thing["value"] for thing in pdf.objects.values() if isinstance(thing.get("value"), list) and len(thing["value"]) > 9).reverse(),
    "UA 7.1 not tagged": without("/Lang", lambda thing: thing.get("/Type") == "/Catalog"),
}


def unseen(file):
    """The planted faults that no rule tells."""
    for clause, plant in PLANTS.items():
        pdf = Pdf(file)
        plant(pdf)
        if not any(told.startswith(clause) for told in complaints(pdf)):
            yield f"a planted fault is not seen: {clause}"


def main(epura):
    if not shutil.which("qpdf"):
        print("archive: skipped, for there is no qpdf")
        return 77
    wrong = []
    with tempfile.TemporaryDirectory() as folder:
        for name, (source, *options) in SHEETS.items():
            file = f"{folder}/{name}.pdf"
            subprocess.run([epura, "draw", SAMPLES / source, *options, "--pdf", "archive", "-o", file], stderr=subprocess.DEVNULL, check=False)
            wrong += [f"{name}: {told}" for told in complaints(Pdf(file))]
        wrong += unseen(f"{folder}/parts.pdf")
    for told in wrong:
        print("archive:", told, file=sys.stderr)
    return int(len(wrong) > 0)


if sys.argv[1] == "--look":
    print("\n".join(complaints(Pdf(sys.argv[2]))))
else:
    sys.exit(main(sys.argv[1]))
