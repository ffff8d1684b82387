"""From a campaign to its report, with the real solver and a real browser: a small sweep is
run once; then the numbers are compared with the database, and the page is opened in
Chromium, where every figure must be drawn and no script may fail."""
import html.parser
import json
import os
import pathlib
import re
import shutil
import sqlite3
import statistics
import struct
import subprocess
import tempfile
import unittest
import zlib

PROGRAM = os.environ["PORECLOG"]
SOURCE = pathlib.Path(os.environ["PORECLOG_SOURCE_DIR"])
CHROMIUM = os.environ.get("CHROMIUM", "chromium")
HOSTILE = "</script><img src=x onerror=\"document.title='owned'\"> & <b>'bold'</b>"

FIGURES = ["curves", "survival", "alpha", "injection", "profiles", "examples", "deposit",
           "mechanisms"]
# Marks that a figure consists of at least: curves, dots, bars; and what its axes say.
NEEDS = {"curves": ("path", 8), "survival": ("path", 2), "alpha": ("circle|path", 4),
         "injection": ("circle|path", 10), "profiles": ("circle|path", 50),
         "examples": ("path", 10), "deposit": ("circle", 30), "mechanisms": ("rect", 1),
         "sweep": ("circle|path", 6), "comparison": ("path", 8)}
LABELS = {"curves": ["critical diameter (µm)", "permeability, k/k(0)", "time (s)"],
          "survival": ["fraction not clogged", "time (s)"],
          "alpha": ["time from first retention to clogging (s)", "α (deg)"],
          "injection": ["x (µm)", "y (µm)"],
          "profiles": ["distance from the centre (µm)", "probability"],
          "examples": ["critical diameter (µm)", "colloids", "time (s)"],
          "deposit": ["20 µm"], "mechanisms": ["retained colloids per realisation"],
          "sweep": ["colloids diameter (µm)", "mean t1 (s)", "probability"],
          "comparison": ["fraction not clogged", "mean critical diameter (µm)"]}


class Figures(html.parser.HTMLParser):
    """Of every figure its state, the elements in its drawings, and its text."""

    def __init__(self):
        super().__init__()
        self.figures = {}
        self.root = {}
        self.images = 0
        self.current = None
        self.depth = 0
        self.svg = 0
        self.bad = []

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag == "html":
            self.root = attributes
        self.images += tag == "img"
        if tag == "figure":
            if "data-figure" in attributes:
                self.current = {"state": attributes["data-state"], "tags": [], "text": "",
                                "d": []}
                self.figures[attributes["data-figure"]] = self.current
                self.depth = 0
            self.depth += 1
        if tag == "svg":
            self.svg += 1
        if self.current is not None and self.svg:
            self.current["tags"].append(tag)
            for name, value in attributes.items():
                if value and re.search(r"NaN|undefined|Infinity", value):
                    self.bad.append((tag, name, value[:80]))

    def handle_endtag(self, tag):
        if tag == "svg":
            self.svg -= 1
        if tag == "figure" and self.current is not None:
            self.depth -= 1
            if self.depth == 0:
                self.current = None

    def handle_data(self, data):
        if self.current is not None:
            self.current["text"] += data


def pixels(png):
    """Width, height and rows of RGB bytes of a PNG without interlacing."""
    data = png.read_bytes()
    at, packed = 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, _, colour = struct.unpack(">IIBB", body[:10])
        packed += body if kind == b"IDAT" else b""
        at += 12 + size
    channels = {2: 3, 6: 4}[colour]
    raw, stride = zlib.decompress(packed), width * channels
    above, rows = bytearray(stride), []
    for y in range(height):
        kind = raw[y * (stride + 1)]
        line = bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            a = line[i - channels] if i >= channels else 0
            b, c = above[i], above[i - channels] if i >= channels else 0
            if kind == 1:
                line[i] = (line[i] + a) & 255
            elif kind == 2:
                line[i] = (line[i] + b) & 255
            elif kind == 3:
                line[i] = (line[i] + (a + b) // 2) & 255
            elif kind == 4:
                p = a + b - c
                best = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))
                line[i] = (line[i] + best[2]) & 255
        rows.append(line)
        above = line
    return width, height, channels, rows


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="poreclog-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        scene = json.loads((SOURCE / "campaigns/throat.scene.json").read_text())
        scene["duration"] = "0.6 s"
        scene["colloids"]["volume_fraction"] = 0.03
        campaign = {"campaign": "small", "description": HOSTILE, "scene": scene,
                    "realisations": 4, "master_seed": 5,
                    "vary": {"/colloids/diameter": ["16 um", "20 um"]},
                    "fidelity": {"tier": "one_way", "cells_per_colloid": 3,
                                 "capture_gap": "200 nm"},
                    "statistics": {"bootstrap": 200}}
        (cls.folder / "small.json").write_text(json.dumps(campaign))
        cls.done = cls.poreclog("run", "small.json")
        cls.out = cls.folder / "results/reports/small"

    @classmethod
    def poreclog(cls, *words):
        return subprocess.run([PROGRAM, *words], cwd=cls.folder, capture_output=True,
                              text=True, timeout=400)

    def browse(self, *words, page=None):
        where = (page or self.out / "report.html").as_uri() + "#all"
        done = subprocess.run(
            [CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
             f"--user-data-dir={self.folder / 'chromium'}", "--window-size=1200,2600",
             "--enable-logging=stderr", *words, where],
            capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr[-2000:])
        console = [l for l in done.stderr.splitlines() if ":CONSOLE" in l]
        self.assertEqual(console, [], "the page's scripts complain")
        return done.stdout

    def ask(self, sql):
        with sqlite3.connect(self.folder / "results/poreclog.sqlite") as database:
            return database.execute(sql).fetchall()

    def test_run_says_where_the_report_is(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        self.assertIn(f"report: {self.out / 'report.html'}", self.done.stdout)
        self.assertIn("mean t_1", self.done.stdout)

    def test_numbers_are_those_of_the_database(self):
        points = json.loads((self.out / "statistics.json").read_text())["points"]
        self.assertEqual(len(points), 2)
        for point in points:
            rows = self.ask("SELECT t1_s, tc_s FROM v_realisation WHERE status = 'ingested'"
                            f" AND point = {point['point']} ORDER BY idx")
            self.assertEqual((point["n"], point["n_failed"]), (4, 0))
            self.assertEqual(point["n_censored"], sum(tc is None for _, tc in rows))
            t1 = [t for t, _ in rows]
            self.assertNotIn(None, t1)
            # Student's t with 3 degrees of freedom, 0.975: 3.182446 (tables).
            half = 3.182446 * statistics.stdev(t1) / 2
            mean = statistics.mean(t1)
            self.assertAlmostEqual(point["t1"]["mean"], mean, delta=1e-12)
            self.assertAlmostEqual(point["t1"]["ci_low"], mean - half, delta=1e-6)
            reached = [0.6 if tc is None else tc for _, tc in rows]
            self.assertAlmostEqual(point["clogging"]["restricted_mean_s"],
                                   statistics.mean(reached), delta=1e-9)
            last = self.ask("SELECT avg(lc_end_m), avg(permeability_ratio_end) FROM"
                            f" v_realisation WHERE point = {point['point']}")[0]
            self.assertAlmostEqual(point["curves"]["critical_diameter"]["mean"][-1],
                                   last[0], delta=1e-12)
            self.assertAlmostEqual(point["curves"]["permeability_ratio"]["mean"][-1],
                                   last[1], delta=1e-12)

    def test_every_figure_is_drawn_and_no_script_fails(self):
        page = Figures()
        page.feed(self.browse("--dump-dom"))
        self.assertEqual(page.root.get("data-errors"), None)
        self.assertEqual(page.root.get("data-ready"), "1")
        expected = ["sweep", "comparison"] + [f"{f}-{p}" for p in (0, 1) for f in FIGURES]
        self.assertEqual(sorted(page.figures), sorted(expected))
        self.assertEqual(page.bad, [], "an attribute is not a number")
        for name, figure in page.figures.items():
            kind = name.split("-")[0]
            self.assertEqual(figure["state"], "drawn", name)
            marks, least = NEEDS[kind]
            found = sum(bool(re.fullmatch(marks, tag)) for tag in figure["tags"])
            self.assertGreaterEqual(found, least, name)
            for label in LABELS[kind]:
                self.assertIn(label, figure["text"], name)

    def test_the_regime_is_there(self):
        html = (self.out / "report.html").read_text()
        self.assertNotIn('"regime":{"note"', html, "a note instead of the regime")
        self.assertIn('"reasons":{', html)

    def test_hostile_text_stays_text(self):
        dom = self.browse("--dump-dom")
        page = Figures()
        page.feed(dom)
        self.assertEqual(page.images, 0)
        self.assertIn("<title>small - poreclog report</title>", dom)
        self.assertIn("&lt;/script&gt;&lt;img src=x onerror=", dom)

    def test_a_failing_figure_would_be_noticed(self):
        broken = self.folder / "broken.html"
        text = (self.out / "report.html").read_text()
        call = "function survivalFigure(statistics) {"
        self.assertEqual(text.count(call), 1)
        broken.write_text(text.replace(call, call + " throw new Error('broken');"))
        page = Figures()
        page.feed(self.browse("--dump-dom", page=broken))
        self.assertIn("broken", page.root.get("data-errors", ""))
        self.assertEqual(page.figures["survival-0"]["state"], "failed")
        self.assertEqual(page.figures["curves-0"]["state"], "drawn")

    def test_the_page_is_visible(self):
        picture = self.folder / "report.png"
        self.browse(f"--screenshot={picture}")
        width, height, channels, rows = pixels(picture)
        self.assertEqual((width, height), (1200, 2600))
        colours = {}
        for row in rows[::4]:
            for x in range(0, width, 4):
                colour = bytes(row[x * channels:x * channels + 3])
                colours[colour] = colours.get(colour, 0) + 1
        seen = sum(colours.values())
        self.assertLess(colours[b"\xff\xff\xff"] / seen, 0.97)  # a white page: all of it
        self.assertIn(b"\x00\x72\xb2", colours)  # the blue of the first curve

    def test_report_again_is_the_same_but_for_its_date(self):
        again = self.folder / "again"
        done = self.poreclog("report", "small", "--output", str(again))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((again / "statistics.json").read_text(),
                         (self.out / "statistics.json").read_text())
        made = re.compile(r'"made":"[^"]*"')
        self.assertEqual(made.sub("", (again / "report.html").read_text()),
                         made.sub("", (self.out / "report.html").read_text()))


if __name__ == "__main__":
    unittest.main()
