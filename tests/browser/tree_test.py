#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What the browser hands to screen readers, and what keys reach: of accessible SVG files, of pages with drawings and of the
page of `epura serve`. tree_test.py EPURA."""
import os
import re
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.dirname(HERE)]
import chromium  # noqa: E402
from claims import check, failures, same  # noqa: E402
from served import Served  # noqa: E402

EPURA = os.path.abspath(sys.argv[1])
BRACKET = os.path.join(os.path.dirname(os.path.dirname(HERE)), "samples", "models", "bracket.obj")
# Roles that a key or a reader acts upon.
ACTIVE = {"button", "checkbox", "combobox", "searchbox", "slider", "spinbutton", "textbox", "DisclosureTriangle", "link"}


class Node:
    """A node of the accessibility tree, with those below it that are not ignored."""

    def __init__(self, raw):
        self.role = raw.get("role", {}).get("value", "")
        self.name = raw.get("name", {}).get("value", "")
        self.description = raw.get("description", {}).get("value", "")
        self.focusable = any(one["name"] == "focusable" for one in raw.get("properties", []))
        self.inner = []

    def all(self):
        yield self
        for one in self.inner:
            yield from one.all()

    def of(self, *roles):
        return [one for one in self.all() if one.role in roles]


def tree(browser):
    browser.call("Accessibility.enable")
    raw = {one["nodeId"]: one for one in browser.call("Accessibility.getFullAXTree")["nodes"]}

    def told(one):
        inner = [node for child in one.get("childIds", []) if child in raw for node in told(raw[child])]
        if one.get("ignored"):
            return inner
        node = Node(one)
        node.inner = inner
        return [node]
    root = next(one for one in raw.values() if "parentId" not in one)
    return told(root)[0]


def run(*arguments):
    return subprocess.run([EPURA, *arguments], check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout


DRAWN = [BRACKET, "--views", "front,top,left", "--dimensions", "auto", "--title", "Bracket", "--language", "en"]


def test_file(browser):
    browser.open("bracket.svg")
    document = tree(browser).of("graphics-document")
    same("documents", len(document), 1)
    same("its name", document[0].name, "Bracket")
    same("its description", document[0].description, " ".join(run("describe", *DRAWN).splitlines()))
    views = document[0].inner
    views = [one for one in views if one.role == "graphics-object" and one.name.startswith("View ")]
    same("views", [re.match(r"View (\w+), scale", one.name).group(1) for one in views], ["front", "top", "left"])
    holes = [one for view in views for one in view.inner if "hole, diameter" in one.name]
    check("holes are features of views", holes)
    check("holes have lines", all(one.of("graphics-symbol") for one in holes), [one.name for one in holes])
    dimensions = [one for hole in holes for one in hole.inner if one.role == "graphics-object"]
    check("and dimensions", dimensions and all(one.name.startswith(("diameter ", "length ")) for one in dimensions),
          [one.name for one in dimensions])
    check("dimensions have texts", all(one.of("image") for one in dimensions))
    named = [one for one in document[0].all() if one.role.startswith("graphics-") or one.role == "image"]
    check("all have names", all(one.name for one in named), [one.role for one in named if not one.name])
    lines = sum(int(count) for view in views for count in re.findall(r"(\d+) (?:visible|hidden) lines?", view.name))
    same("lines are there once", len(document[0].of("graphics-symbol")), lines)


FOCUSED = """(() => {
    const at = document.activeElement;
    if (!at || at === document.body) return null;
    at.dataset.reached = '';
    const name = one => one.localName + '#' + one.id + '.' + (one.dataset.do ?? one.name ?? '') + ':' + one.textContent.slice(0, 20);
    const before = window.lastFocused;
    window.lastFocused = at;
    const style = getComputedStyle(at), box = at.getBoundingClientRect();
    return {name: name(at), ring: style.outlineStyle === 'none' ? 0 : parseFloat(style.outlineWidth),
            isSeen: box.width > 0 && box.bottom > 0 && box.top < innerHeight && box.right > 0 && box.left < innerWidth,
            follows: !before || !!(before.compareDocumentPosition(at) & Node.DOCUMENT_POSITION_FOLLOWING)};
})()"""


def tab_through(browser, back=False, most=80):
    """What has the focus after each Tab, or Shift and Tab, until it comes back or leaves the page."""
    seen = []
    browser.evaluate("document.body.focus(); window.lastFocused = null")
    for _ in range(most):
        browser.key("Tab", code="Tab", windowsVirtualKeyCode=9, modifiers=8 if back else 0)
        where = browser.evaluate(FOCUSED)
        if not where or where["name"] in [one["name"] for one in seen[:1]]:
            break
        seen.append(where)
    return seen


UNREACHED = """[...document.querySelectorAll('button, input, select, textarea, summary, a[href], [tabindex="0"]')].filter(one =>
    one.checkVisibility() && !one.disabled && one.dataset.reached === undefined && one.type !== 'radio').map(one =>
    one.outerHTML.slice(0, 120))"""


def expect_reachable(browser, page):
    reached = tab_through(browser)
    check(f"{page}: Tab goes somewhere", len(reached) > 3, reached)
    same(f"{page}: what has the focus and does not show it", [one["name"] for one in reached if one["ring"] < 2], [])
    same(f"{page}: what has the focus and is out of sight", [one["name"] for one in reached if not one["isSeen"]], [])
    same(f"{page}: where Tab leaves the order of reading", [one["name"] for one in reached if not one["follows"]], [])
    back = [one["name"] for one in tab_through(browser, back=True)]
    same(f"{page}: Shift and Tab go back", back[::-1], [one["name"] for one in reached])
    same(f"{page}: what no key reaches", browser.evaluate(UNREACHED), [])
    nodes = tree(browser)
    unnamed = [one.role for one in nodes.all() if (one.role in ACTIVE or one.focusable) and not one.name]
    same(f"{page}: what has no name", unnamed, [])
    for role in ("banner", "main", "complementary"):
        same(f"{page}: landmark {role}", len(nodes.of(role)), 1)
    check(f"{page}: a heading", nodes.of("heading"))


def test_page(browser):
    browser.open("bracket.html")
    expect_reachable(browser, "page")
    sheet = "document.activeElement.className"
    browser.evaluate("document.querySelector('.sheet').focus()")
    same("the sheet has the focus", browser.evaluate(sheet), "sheet")
    browser.key("n")
    told = " ".join(one.name for one in tree(browser).all() if one.role in ("StaticText", "term", "definition"))
    check("a line that keys choose is told", "True length" in told and "front" in told, told[:200])
    browser.key("Escape")
    told = " ".join(one.name for one in tree(browser).all() if one.role in ("StaticText", "term", "definition"))
    check("Escape takes it back", "True length" not in told, told[:200])
    same("and the focus stays", browser.evaluate(sheet), "sheet")


def test_served(browser):
    with Served(EPURA, BRACKET) as server:
        browser.go(server.url)
        expect_reachable(browser, "serve")
        sliders = tree(browser).of("slider")
        browser.evaluate("document.querySelector('input[type=range]')?.focus()")
        before = browser.evaluate("document.activeElement.value")
        browser.key("ArrowRight", code="ArrowRight", windowsVirtualKeyCode=39)
        check("keys move a slider", not sliders or browser.evaluate("document.activeElement.value") != before)


def main():
    chromium.expect()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        run("draw", *DRAWN, "--svg", "accessible", "-o", "bracket.svg", "-o", "bracket.html")
        with chromium.Browser() as browser:
            for test in (test_file, test_page, test_served):
                test(browser)
        os.chdir("/")
    print(f"{len(failures)} failures")
    return 1 if failures else 0


sys.exit(main())
