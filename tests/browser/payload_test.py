#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Hostile titles, names and notes stay text in pages and pictures: payload_test.py EPURA.

Each payload is put into every field of a drawing; the files are parsed (html.parser, an XML parser), and opened in a
browser, if there is one, where none of them may run: each third one, or all with EPURA_AT_LENGTH.
"""
import html.parser
import json
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.dirname(HERE)]
import chromium  # noqa: E402
from claims import check, failures  # noqa: E402

EPURA = os.path.abspath(sys.argv[1])

# Each calls ran(), if it is taken for more than text.
PAYLOADS = [
    "<script>ran()</script>",
    "</script><script>ran()</script>",
    "</ScRiPt ><script>ran()</script>",
    "<script src=data:text/javascript,ran()></script>",
    "<script/src='data:,ran()'>",
    "<img src=x onerror=ran()>",
    "<img src=x onerror='ran()'//",
    "<svg onload=ran()>",
    "<svg><script>ran()</script></svg>",
    "</svg><script>ran()</script>",
    "<svg><animate onbegin=ran() attributeName=x dur=1s>",
    "<svg><set onbegin=ran() attributeName=x>",
    "<svg><a href='javascript:ran()'><text>x</text></a></svg>",
    "<svg><foreignObject><iframe srcdoc='<script>parent.ran()</script>'></foreignObject></svg>",
    "<svg><use href='data:image/svg+xml,<svg id=x onload=ran()/>#x'/></svg>",
    "</title><script>ran()</script>",
    "</style><script>ran()</script>",
    "</textarea><script>ran()</script>",
    "<!--<script>ran()</script>",
    "--><script>ran()</script>",
    "<![CDATA[<script>ran()</script>]]>",
    "]]><script>ran()</script>",
    "<!DOCTYPE x [<!ENTITY e SYSTEM 'file:///etc/passwd'>]>&e;",
    "<?xml-stylesheet href='javascript:ran()'?>",
    "\" onmouseover=\"ran()",
    "\" autofocus onfocus=\"ran()",
    "' onmouseover='ran()",
    "\"><script>ran()</script>",
    "'><script>ran()</script>",
    "`onmouseover=`ran()",
    "javascript:ran()",
    "JaVaScRiPt:ran()//",
    "data:text/html,<script>ran()</script>",
    "{{constructor.constructor('ran()')()}}",
    "{{script}}{{data}}{{sheets}}",
    "${ran()}",
    "\\u003cscript>ran()</script>",
    "\\\"};ran();//",
    "\"};ran();var x={\"a\":\"",
    "');ran();//",
    "*/ran();/*",
    "</pre><iframe src=javascript:parent.ran()>",
    "<iframe srcdoc='<script>parent.ran()</script>'>",
    "<meta http-equiv=refresh content='0;url=javascript:ran()'>",
    "<base href=javascript:ran()//>",
    "<link rel=stylesheet href='data:text/css,*{display:none}'>",
    "<style>*{display:none}</style>",
    "<details open ontoggle=ran()>",
    "<math><mtext></form><form><mglyph><style></math><img src onerror=ran()>",
    "&lt;script&gt;ran()&lt;/script&gt;",
    "&#60;script&#62;ran()&#60;/script&#62;",
    "\u2028ran()\u2029",
    "\u202e<script>ran()</script>",
    "%3Cscript%3Eran()%3C/script%3E",
    "+ADw-script+AD4-ran()+ADw-/script+AD4-",
    "\ufeff<script>ran()</script>",
    "<scr\u00adipt>ran()</scr\u00adipt>",
]
# Elements that the page itself has, and no others.
PAGE = set("html head meta title style body header h1 h2 label select div button form input output main section svg rect g "
           "path text aside pre details summary p kbd script".split())
PICTURE = set("svg namedview title desc metadata RDF Work format type Agent creator contributor rights identifier date "
              "language description style g path text".split())


class Elements(html.parser.HTMLParser):
    """What a page consists of."""

    def __init__(self, text):
        super().__init__()
        self.names, self.attributes, self.comments, self.scripts, self.texts = [], [], [], [], []
        self.inside = ""
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attrs):
        self.names.append(tag)
        self.attributes += attrs
        self.inside = tag
        if tag == "script":
            self.scripts.append("")

    def handle_endtag(self, tag):
        self.inside = ""

    def handle_data(self, data):
        if self.inside == "script":
            self.scripts[-1] += data
        self.texts.append(data)

    def handle_comment(self, data):
        self.comments.append(data)


def quoted(text):
    return json.dumps(text, ensure_ascii=False)


FIELDS = ("title supplementary_title owner number date creator approver document_type revision status department "
          "technical_reference classification language material mass general_tolerance standard").split()


def scene_of(payload, model):
    """Every text of a scene that comes into a drawing."""
    word = quoted(payload)
    fields = "\n".join(f"{key} = {word}" for key in FIELDS)
    return f"""
[sheet]
size = "A1"
scale = "1:1"
[title_block]
{fields}
[title_block.free]
{word} = {word}
[[model]]
file = {quoted(model)}
name = {word}
[[style]]
match = "*"
material = {word}
[[section]]
name = {word}
point = [10, 10, 10]
[[detail]]
name = {word}
view = {quoted("cut " + payload)}
centre = [10, 10, 10]
radius = 5
[[view]]
projection = "front"
name = {word}
label = {word}
[[view]]
projection = "front"
name = {quoted("cut " + payload)}
section = {word}
[[view]]
detail = {word}
name = {quoted("detail " + payload)}
scale = "5:1"
[[dimension]]
type = "linear"
direction = "horizontal"
from = [{word}, 1]
to = [{word}, 2]
text = {word}
view = {word}
[[note]]
text = [{word}, {word}]
to = [{word}, 4]
view = {word}
[[note]]
text = {word}
[[tolerance_frame]]
characteristic = "flatness"
zone = "0.1"
text = {word}
to = [{word}, 5]
view = {word}
[[surface_texture]]
text = {word}
process = {word}
to = [{word}, 6]
view = {word}
[[table]]
title = {word}
header = [{word}, "b"]
rows = [[{word}, {word}]]
[[revision]]
revision = {word}
text = {word}
date = {word}
author = {word}
[parts_list]
view = {word}
"""


def model_of(payload):
    """Two bodies that have the payload in their names."""
    name = "".join(" " if c in "\n\u2028\u2029" else c for c in payload)
    corners = [[i & 1, i >> 1 & 1, i >> 2 & 1] for i in range(8)]
    faces = [(1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)]
    text = ""
    for first, shift, body in ((0, 0, name), (8, 30, name + " 2")):
        text += f"o {body}\n" + "".join(f"v {20 * x + shift} {20 * y} {20 * z}\n" for x, y, z in corners)
        text += "".join("f " + " ".join(str(c + first) for c in face) + "\n" for face in faces)
    return text


def draw(payload, number):
    """Draws a page and a picture; the names of their files."""
    model = payload.replace("/", "\u2215")[:60] + f"{number}.obj"
    with open(model, "w", encoding="utf-8") as file:
        file.write(model_of(payload))
    with open("scene.toml", "w", encoding="utf-8") as file:
        file.write(scene_of(payload, model))
    names = [f"{number}.html", f"{number}.svg"]
    ran = subprocess.run([EPURA, "draw", "scene.toml", "-o", names[0], "-o", names[1], "--svg-text", "text", "--why", "1-3"],
                         capture_output=True, text=True)
    check(f"{payload!r} is drawn", ran.returncode == 0, ran.stderr)
    test_inline(payload)
    return names if ran.returncode == 0 else []


def test_page(payload, name):
    with open(name, encoding="utf-8") as file:
        page = Elements(file.read())
    check(f"{payload!r} adds no elements", set(page.names) <= PAGE, set(page.names) - PAGE)
    check(f"{payload!r} adds no scripts", page.names.count("script") == 2, page.names.count("script"))
    check(f"{payload!r} adds no comments", not page.comments, page.comments)
    handlers = [key for key, _ in page.attributes if key.startswith("on") or key in ("src", "href", "srcdoc", "style")]
    check(f"{payload!r} adds no handlers", not handlers, handlers)
    data = json.loads(page.scripts[0])
    check(f"{payload!r} remains what it is", data["sheets"][0]["title"] == payload, data["sheets"][0]["title"])


def test_inline(payload):
    """The picture as an element of a page."""
    ran = subprocess.run([EPURA, "draw", "scene.toml", "-o", "-", "--format", "svg", "--inline"], capture_output=True,
                         text=True)
    page = Elements("<main>" + ran.stdout + "</main>")
    check(f"{payload!r} adds no elements inline", set(page.names) <= PAGE | {"desc"}, set(page.names) - PAGE)
    check(f"{payload!r} adds no scripts inline", "script" not in page.names)
    handlers = [key for key, _ in page.attributes if key.startswith("on") or key in ("src", "href", "srcdoc")]
    check(f"{payload!r} adds no handlers inline", not handlers, handlers)
    check(f"{payload!r} remains what it is inline", payload in page.texts)


def test_picture(payload, name):
    root = xml.etree.ElementTree.parse(name).getroot()
    names = {node.tag.rsplit("}", 1)[-1] for node in root.iter()}
    check(f"{payload!r} adds no elements to SVG", names <= PICTURE, names - PICTURE)
    handlers = [key for node in root.iter() for key in node.attrib if key.lower().startswith("on") or "href" in key]
    check(f"{payload!r} adds no handlers to SVG", not handlers, handlers)


def test_running(payload, name, browser):
    """Nothing runs, at the start or when the page is used."""
    browser.open(name)
    browser.evaluate("""(() => {
        for (const box of document.querySelectorAll('details')) box.open = true;
        document.querySelector('.sheet').focus();
        for (const key of ['n', 'n', 'm', 'n', 'Enter', 'Escape'])
            document.querySelector('.sheet').dispatchEvent(new KeyboardEvent('keydown', {key, bubbles: true}));
        document.getElementById('search').value = 'a';
        document.getElementById('search').dispatchEvent(new Event('input'));
    })()""")
    browser.settle()
    check(f"{payload!r} does not run", browser.evaluate("!window.hasRun"))
    ours = [node for node in browser.evaluate("[...document.querySelectorAll('*')].map(node => node.localName)")
            if node not in PAGE | {"ul", "li", "dl", "dt", "dd", "span", "option", "circle", "text"}]
    check(f"{payload!r} makes no elements", not ours, ours)
    check(f"{payload!r} is shown", "ready" in browser.evaluate("document.body.className"))
    check(f"{payload!r} makes no trouble", not browser.complaints(), browser.complaints())


def main():
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        files = [(payload, *names) for payload, names in
                 ((payload, draw(payload, number)) for number, payload in enumerate(PAYLOADS)) if names]
        for payload, page, picture in files:
            test_page(payload, page)
            test_picture(payload, picture)
        if chromium.find():
            with chromium.Browser() as browser:
                browser.call("Page.addScriptToEvaluateOnNewDocument", source="window.ran = () => { window.hasRun = 1; }")
                for payload, page, _ in files[::1 if "EPURA_AT_LENGTH" in os.environ else 3]:
                    test_running(payload, page, browser)
        else:
            print("without a browser: there is no Chromium here (package chromium, or EPURA_CHROMIUM)")
        os.chdir("/")
    print(f"{len(PAYLOADS)} payloads, {len(failures)} failures")
    return 1 if failures else 0


sys.exit(main())
