#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Drawings inside other pages: --inline and <epura-drawing>.   element_test.py EPURA EPURA_DRAWING_JS"""
import functools
import http.server
import os
import re
import shutil
import subprocess
import sys
import tempfile
import threading

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.dirname(HERE)]
import chromium  # noqa: E402
from claims import check, failures, same  # noqa: E402

EPURA, ELEMENT = (os.path.abspath(path) for path in sys.argv[1:3])

CUBE = ("".join(f"v {40 * (i & 1)} {30 * (i >> 1 & 1)} {20 * (i >> 2 & 1)}\n" for i in range(8)) +
        "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n")
HOSTILE = """<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" viewBox="0 0 10 10"
 onload="parent.hasRun = 1"><script>window.hasRun = 1</script><style>*{display:none}</style>
<foreignObject><iframe xmlns="http://www.w3.org/1999/xhtml" src="javascript:parent.hasRun=1"/></foreignObject>
<image xlink:href="x.png" onerror="window.hasRun = 1"/><a href="javascript:hasRun=1"><text>x</text></a>
<g onclick="window.hasRun = 1" style="display:none"><path data-kind="crease&lt;img src=x onerror=hasRun=1&gt;" d="M1 1h8"
 onmouseover="window.hasRun = 1" fill="url(#x)"/></g><animate onbegin="window.hasRun = 1" attributeName="x" dur="1s"/>
<title>&lt;img src=x onerror=hasRun=1></title></svg>"""


def draw(*arguments):
    return subprocess.run([EPURA, "draw", "cube.obj", *arguments], check=True, capture_output=True, text=True).stdout


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


def serve(folder):
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return server


def page(body, policy="script-src 'self' 'unsafe-inline'"):
    return (f'<!DOCTYPE html><html lang="en"><meta charset="utf-8"><meta http-equiv="Content-Security-Policy" content="{policy}">'
            f"<title>x</title><style>body{{margin:0;width:800px}} path{{stroke:red}}</style><body>{body}</body></html>")


def test_inline(browser, address):
    svg = draw("--projection", "isometric", "--sheet", "A4", "--title", "A <cube>", "-o", "-", "--format", "svg", "--inline")
    check("begins with its element", svg.startswith("<svg id="), svg[:60])
    check("no declaration, no size, no foreign names", not re.search(r"<\?xml|<!DOCTYPE|mm\"|inkscape|sodipodi|rdf", svg))
    other = draw("--projection", "front", "--sheet", "A4", "-o", "-", "--format", "svg", "--inline")
    write("inline.html", page(f"<h1>x</h1><main><figure>{svg}<figcaption>One</figcaption></figure><div>{other}</div></main>"))
    browser.go(address + "inline.html")
    same("ids used twice", browser.evaluate("""[...document.querySelectorAll('[id]')].map(node => node.id)
        .filter((id, i, all) => all.indexOf(id) !== i)"""), [])
    box = browser.evaluate("(({width, height}) => [width, height])(document.querySelectorAll('svg')[1].getBoundingClientRect())")
    check("as wide as what contains it", abs(box[0] - 800) < 1 and abs(box[1] - 800 * 210 / 297) < 1, box)
    nodes = browser.call("Accessibility.getFullAXTree")["nodes"]
    names = [(node["name"]["value"], node.get("description", {}).get("value")) for node in nodes
             if node["role"]["value"] in ("image", "img") and not node["ignored"]]
    check("its name and description", ("A <cube>", "isometric 5:1") in names or
          any(name == "A <cube>" and (about or "").startswith("isometric") for name, about in names), names)
    same("rules of the page do not apply", browser.evaluate("getComputedStyle(document.querySelector('path[data-kind]')).stroke"),
         "rgb(0, 0, 0)")


IN = "document.querySelector('epura-drawing').shadowRoot"


def wait(browser, condition):
    browser.evaluate("new Promise(done => { const ask = () => " + condition + " ? done(0) : setTimeout(ask, 20); ask(); })")


def test_element(browser, address):
    draw("--projection", "top", "--sheet", "A4", "--title", "A <cube>", "-o", "cube.svg")
    write("element.html", page('<epura-drawing src="cube.svg"></epura-drawing><script src="epura-drawing.js"></script>'
                               "<script>addEventListener('epura-line', event => { window.chosen = event.detail; }, true)</script>"))
    browser.go(address + "element.html")
    wait(browser, f"{IN}?.querySelector('.stage')")
    browser.settle()
    at = browser.evaluate(f"""(() => {{
        const path = {IN}.querySelector('path[data-kind]'), at = path.getPointAtLength(5).matrixTransform(path.getScreenCTM());
        return [at.x, at.y, path.dataset.edge];
    }})()""")
    browser.move(*at[:2])
    told = browser.evaluate(f"{IN}.querySelector('output').textContent")
    check("tells the line", told.startswith("contour, visible · top"), told)
    browser.evaluate("document.querySelector('epura-drawing').addEventListener('epura-line', event => { window.chosen = event.detail; })")
    browser.click(*at[:2])
    chosen = browser.evaluate("window.chosen")
    same("an event of the click", (chosen["kind"], chosen["view"], chosen["layer"], chosen["model"], " ".join(chosen["edges"])),
         ("contour", "top", "visible", 0, at[2]))
    same("its name", browser.evaluate(f"{IN}.querySelector('.stage').getAttribute('aria-label').split(':')[0]"), "A <cube>")
    width = f"Number({IN}.querySelector('svg').getAttribute('viewBox').split(' ')[2])"
    before = browser.evaluate(width)
    browser.evaluate(f"{IN}.querySelector('.stage').focus()")
    browser.key("+")
    check("keys zoom", abs(browser.evaluate(width) - before / 1.25) < 1e-6)
    picture = browser.picture()
    browser.key("0")
    check("and are seen", browser.picture() != picture)
    same("and fit again", round(browser.evaluate(width), 6), round(before, 6))
    browser.mouse("mouseWheel", 300, 300, deltaX=0, deltaY=-200)
    browser.settle()
    same("the wheel scrolls the page", round(browser.evaluate(width), 6), round(before, 6))
    check("no trouble", not browser.complaints(address), browser.complaints(address))


def test_hostile(browser, address):
    write("hostile.svg", HOSTILE)
    write("hostile.html", page('<epura-drawing src="hostile.svg"></epura-drawing><script src="epura-drawing.js"></script>'))
    browser.go(address + "hostile.html")
    wait(browser, f"{IN}?.querySelector('.stage')")
    browser.settle()
    browser.evaluate(f"{IN}.querySelector('.stage').dispatchEvent(new KeyboardEvent('keydown', {{key: 'n'}}))")
    found = set(browser.evaluate(f"[...{IN}.querySelectorAll('*')].map(node => node.localName)"))
    same("what is left of a hostile picture", found - {"div", "svg", "g", "path", "button", "output", "text"}, set())
    same("handlers and references", browser.evaluate(f"""[...{IN}.querySelectorAll('svg, svg *')].flatMap(node =>
        [...node.attributes].map(one => one.name)).filter(name => /^on|href|style/.test(name))"""), [])
    check("nothing has run", browser.evaluate("!window.hasRun"))
    write("none.html", page('<epura-drawing src="none.svg"></epura-drawing><script src="epura-drawing.js"></script>'))
    browser.go(address + "none.html")
    wait(browser, f"{IN}?.querySelector('p')")
    check("a missing picture", "404" in browser.evaluate(f"{IN}.textContent"))


def main():
    chromium.expect()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        shutil.copy(ELEMENT, "epura-drawing.js")
        write("cube.obj", CUBE)
        server = serve(folder)
        address = f"http://127.0.0.1:{server.server_port}/"
        with chromium.Browser() as browser:
            for test in (test_inline, test_element, test_hostile):
                test(browser, address)
        server.shutdown()
        os.chdir("/")
    print(f"{len(failures)} failures")
    return 1 if failures else 0


sys.exit(main())
