"""poreclog statistics: the keys that users' scripts rely on are there, of a campaign and of
a table; numbers of a published example."""
import json
import os
import pathlib
import sqlite3
import subprocess
import tempfile
import time
import unittest

import h5py

PROGRAM = os.environ["PORECLOG"]
FAKE_SOLVER = os.environ["FAKE_SOLVER"]

MEAN = ["mean", "sd", "ci_low", "ci_high", "method"]
CURVE = ["mean", "sd", "ci_low", "ci_high", "band_low", "band_high"]
KEYS = {
    "": ["n", "n_censored", "n_failed", "t1", "tc", "tc_minus_t1", "clogging", "curves",
         "stages", "alpha_fit", "injection_fits"],
    "t1": MEAN, "tc": MEAN, "tc_minus_t1": MEAN,
    "clogging": ["kaplan_meier", "median_s", "median_ci", "restricted_mean_s",
                 "restricted_mean_ci", "probability_by_end", "probability_ci"],
    "clogging/kaplan_meier": ["time_s", "survival", "ci_low", "ci_high"],
    "curves": ["time_s", "critical_diameter", "permeability_ratio"],
    "curves/critical_diameter": CURVE, "curves/permeability_ratio": CURVE,
    "stages": ["end_of_first_s", "end_of_second_s", "end_of_third_s"],
    "alpha_fit": ["slope_s_per_deg", "intercept_s", "slope_ci", "r_squared", "n",
                  "n_excluded"],
}
INJECTION = ["order", "annulus_centre_m", "probability", "amplitude", "rate_per_m",
             "amplitude_ci", "rate_ci", "r_squared"]

# Remission times [weeks] of 21 patients on 6-mercaptopurine (Freireich et al. 1963, Blood
# 21, 699), the example of Klein & Moeschberger (2003), table 4.1, where S is printed:
# 0.857 at 6, 0.807 at 7, 0.753 at 10, 0.690 at 13, 0.627 at 16, 0.538 at 22, 0.448 at 23.
REMISSION = [(6, 0), (6, 0), (6, 0), (6, 1), (7, 0), (9, 1), (10, 0), (10, 1), (11, 1),
             (13, 0), (16, 0), (17, 1), (19, 1), (20, 1), (22, 0), (23, 0), (25, 1),
             (32, 1), (32, 1), (34, 1), (35, 1)]
SURVIVAL = {6: 0.857, 7: 0.807, 10: 0.753, 13: 0.690, 16: 0.627, 22: 0.538, 23: 0.448}


class Statistics(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="poreclog-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def environment(self):
        return {**os.environ, "PORECLOG_SOLVER": FAKE_SOLVER,
                "PORECLOG_DATABASE": str(self.folder / "db"),
                "PORECLOG_RUNS": str(self.folder / "runs"),
                "PORECLOG_OUTPUT": str(self.folder / "report")}

    def poreclog(self, *words, code=0):
        done = subprocess.run([PROGRAM, *map(str, words)], env=self.environment(), text=True,
                              capture_output=True, timeout=120)
        if code is not None:
            self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def campaign(self, **keys):
        path = self.folder / "c.json"
        path.write_text(json.dumps({"campaign": "c", "scene": {"duration": "5 s"},
                                    "realisations": 30, "master_seed": 7, **keys}))
        return path

    def table(self, rows, header="tc_s,censored"):
        path = self.folder / "t.csv"
        path.write_text(header + "\n" + "".join(",".join(map(str, r)) + "\n" for r in rows))
        return path

    def check_keys(self, point):
        for place, keys in KEYS.items():
            value = point
            for step in filter(None, place.split("/")):
                value = value[step]
            for key in keys:
                self.assertIn(key, value, place)
        for fit in point["injection_fits"]:
            for key in INJECTION:
                self.assertIn(key, fit)

    def test_of_a_campaign_has_the_promised_keys(self):
        self.poreclog("run", self.campaign(vary={"/duration": ["5 s", "4 s"]}))
        printed = json.loads(self.poreclog("statistics", "c", "--json").stdout)
        self.assertEqual(printed["schema_version"], 1)
        self.assertEqual([p["point"] for p in printed["points"]], [0, 1])
        self.assertEqual([p["varied"] for p in printed["points"]], [{"/duration": "5 s"}, {"/duration": "4 s"}])
        for point in printed["points"]:
            self.assertEqual(point["tier"], "one_way")
            self.check_keys(point)
        written = json.loads((self.folder / "report/statistics.json").read_text())
        self.assertEqual(written, printed)
        self.assertTrue((self.folder / "report/report.html").exists())

    def test_of_a_table_has_the_promised_keys(self):
        rows = [(i, 0.1 * i, 1 + 0.2 * i, 0, 40 - i) for i in range(10)]
        table = self.table(rows, "idx,t1_s,tc_s,censored,alpha_deg")
        point = json.loads(self.poreclog("statistics", "--csv", table, "--json").stdout
                           )["points"][0]
        self.check_keys(point)
        self.assertEqual((point["n"], point["n_censored"], point["n_failed"]), (10, 0, 0))
        self.assertAlmostEqual(point["tc"]["mean"], 1.9, delta=1e-12)
        # t_c - t_1 = 1 + 0.1 i and alpha = 40 - i: the line has no scatter.
        self.assertAlmostEqual(point["alpha_fit"]["slope_s_per_deg"], -0.1, delta=1e-12)
        self.assertAlmostEqual(point["alpha_fit"]["intercept_s"], 5.0, delta=1e-10)

    def test_survival_of_a_published_example(self):
        printed = json.loads(self.poreclog("statistics", "--csv", self.table(REMISSION),
                                           "--duration", 35, "--json").stdout)
        clogging = printed["points"][0]["clogging"]
        curve = dict(zip(clogging["kaplan_meier"]["time_s"],
                         clogging["kaplan_meier"]["survival"]))
        for time, survival in SURVIVAL.items():
            self.assertAlmostEqual(curve[time], survival, delta=0.0006)  # printed digits
        self.assertEqual(clogging["median_s"], 23)
        self.assertEqual(printed["points"][0]["n_censored"], 12)
        self.assertIsNone(printed["points"][0]["tc"]["mean"])

    def test_of_a_running_campaign_says_what_it_counts(self):
        campaign = self.campaign(limits={"workers": 30, "seconds_per_realisation": 300,
                                         "seconds_to_stop": 1})
        environment = {**self.environment(), "FAKE_FAULT": "hang", "FAKE_ONE_IN": "3"}
        running = subprocess.Popen([PROGRAM, "run", str(campaign)], env=environment,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            hung = self.wait_for_the_others()
            self.check_interim(hung)
        finally:
            self.poreclog("cancel", "c", "--now", code=None)
            running.wait(timeout=60)

    def standing(self):
        """Index, seed and status of each realisation; none while the database is made."""
        try:
            with sqlite3.connect(f"file:{self.folder}/db?mode=ro", uri=True) as database:
                return database.execute(
                    "SELECT idx, seed, status FROM v_realisation").fetchall()
        except sqlite3.OperationalError:
            return []

    def wait_for_the_others(self):
        """Indices of the realisations that hang, once all others are ingested."""
        end = time.monotonic() + 60
        while time.monotonic() < end:
            time.sleep(0.2)
            rows = self.standing()
            if all((status == "active") == (int(seed) % 3 == 0) for _, seed, status in rows):
                hung = sorted(i for i, _, status in rows if status == "active")
                if rows and hung:
                    return hung
        self.fail("the others did not finish")

    def check_interim(self, hung):
        # Nothing is known of those that hang: the complete prefix alone counts.
        point = self.statistics_of("c")
        self.assertTrue(point["interim"])
        self.assertIn("everything is of the complete prefix", point["rule"])
        self.assertEqual(point["n"], hung[0])
        self.assertEqual(point["clogging"]["kaplan_meier"]["n"], hung[0])
        self.assertEqual((point["n_running"], point["n_beyond_prefix"]),
                         (len(hung), 30 - len(hung) - hung[0]))
        # Checkpoints say how far they are: one has clogged, the others have not by 0.5 s.
        for index in hung:
            folder = self.folder / f"runs/c/p0000-one_way/{index:06}"
            with h5py.File(folder / "checkpoint.h5", "w") as checkpoint:
                state = checkpoint.create_group("realisation")
                state["series/time_s"] = [0.0, 0.5]
                state.attrs["t1_s"] = 0.1
                state.attrs["tc_s"] = 0.25 if index == hung[0] else float("nan")
        point = self.statistics_of("c")
        self.assertIn("censored at the physical time", point["rule"])
        curve = point["clogging"]["kaplan_meier"]
        self.assertEqual((point["n"], curve["n"]), (hung[0], 30))
        seen = dict(zip(curve["time_s"], curve["censored"]))
        self.assertEqual(seen[0.5], len(hung) - 1)
        self.assertEqual(seen[0.25], 0)

    def statistics_of(self, campaign):
        return json.loads(self.poreclog("statistics", campaign, "--json").stdout)["points"][0]

    def test_refuses_what_it_cannot_use(self):
        for words, why in [
                (("--csv", self.folder / "none.csv"), "none.csv"),
                (("--csv", self.table([("x", 0)])), "line 2"),
                (("nobody",), "has no run folder"),
                ((), "names neither"),
                (("c", "--csv", "t.csv"), "excludes")]:
            error = self.poreclog("statistics", *words, code=1).stderr
            self.assertIn(why, error)
            self.assertEqual(error.count("\n"), 1, error)


if __name__ == "__main__":
    unittest.main()
