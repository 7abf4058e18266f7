# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/site builds the site from what is there; its links hold, its search finds, and it fits a phone's screen."""

import functools
import html.parser
import http.server
import json
import re
import shutil
import subprocess
import threading
import urllib.parse
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SITE = ROOT / "build" / "site" / "html"


@pytest.fixture(scope="module")
def site():
    done = subprocess.run([ROOT / "scripts" / "site"], capture_output=True, text=True)
    assert done.returncode == 0, (done.stdout + done.stderr)[-4000:]
    return SITE


class Page(html.parser.HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.ids, self.links = set(), []
        self.feed(path.read_text())

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id":
                self.ids.add(value)
            elif name in ("href", "src") and value:
                self.links.append((tag, value))


def test_links_and_pictures_are_there_and_nothing_is_loaded_from_elsewhere(site):
    pages = {path: Page(path) for path in site.rglob("*.html")}
    lost = []
    for path, page in pages.items():
        for tag, link in page.links:
            if link.startswith(("http:", "https:")):
                if tag in ("script", "img", "link"):
                    lost.append((path.name, link))
                continue
            address, _, anchor = urllib.parse.unquote(link).partition("#")
            target = (path.parent / address.partition("?")[0]).resolve() if address else path
            if not target.exists() or (anchor and target in pages and anchor not in pages[target].ids | {""}):
                lost.append((path.name, link))
    assert lost == [] and len(pages) > 40


def test_every_page_of_docs_and_every_public_header_has_one(site):
    assert {path.stem for path in (ROOT / "docs").glob("*.md")} <= {path.stem for path in (site / "docs").glob("*.html")}
    headers = {path.stem for path in (ROOT / "include" / "bspline_curve").glob("*.h")} - {"bspline_curve"}
    assert headers == {path.stem for path in (site / "cpp").glob("*.html")} - {"index"}


def test_the_reference_of_cpp_has_what_the_headers_declare(site):
    page = re.sub(r"<[^>]+>", "", (site / "cpp" / "workpiece.html").read_text()).replace("&lt;", "<").replace("&gt;", ">")
    for text in ("CurveInputs (struct)", "Workpiece (class)", "std::span<const int> corners{}", "at which the curve may turn"):
        assert text in page, text


WIDTHS = """<body><script>
const pages = %s, told = {};
function look(i) {
    if (i == pages.length) { document.body.textContent = "WIDTHS" + JSON.stringify(told) + "END"; return; }
    const frame = document.createElement("iframe");
    frame.width = 390; frame.height = 800; frame.src = pages[i];
    frame.onload = () => { told[pages[i]] = frame.contentDocument.documentElement.scrollWidth; frame.remove(); look(i + 1); };
    document.body.append(frame);
}
look(0);
</script></body>"""


@pytest.fixture(scope="module")
def shown(site, tmp_path_factory):
    """What Chromium makes of a page."""
    if shutil.which("chromium") is None:
        pytest.skip("Chromium is not installed")

    class Quiet(http.server.SimpleHTTPRequestHandler):
        def log_message(self, *words):
            pass

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=site))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    folder = tmp_path_factory.mktemp("chromium")

    def call(page):
        command = ["chromium", "--headless=new", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder}", "--virtual-time-budget=60000",
                   "--dump-dom", f"http://127.0.0.1:{server.server_address[1]}/{page}"]
        return subprocess.run(command, capture_output=True, text=True, timeout=120).stdout

    yield call
    server.shutdown()


@pytest.mark.parametrize("word, page", [("tension", "docs/PARAMETERS"), ("semilandmarks", "docs/COMMAND_LINE"), ("CurveInputs", "cpp/workpiece"),
                                        ("reversed", "docs/PYTHON_REFERENCE")])
def test_the_search_finds(shown, word, page):
    assert re.search(rf'<a href="{page}\.html[#?"]', shown(f"search.html?q={word}").partition("search-results")[2])


def test_no_page_is_wider_than_a_phone(site, shown):
    pages = sorted(str(path.relative_to(site)) for path in site.rglob("*.html"))
    frames = site / "widths.html"
    frames.write_text(WIDTHS % json.dumps(pages))
    try:
        widths = json.loads(re.search(r"WIDTHS(.*)END", shown(frames.name))[1])
    finally:
        frames.unlink()
    assert set(widths) == set(pages) and {page: width for page, width in widths.items() if width > 390} == {}
