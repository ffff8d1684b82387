"""A campaign with a target (/statistics/target) runs as many realisations as its number
needs to be known that well: the same ones with any number of workers and after kills.

Reference: the half-widths of growing samples, in seed order, from a campaign that ran all
of them, by quadrature of Student's density, and by `poreclog statistics` of a table.
Uses the solver of tests/anomaly, which takes milliseconds."""
import json
import math
import pathlib
import random
import statistics
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "anomaly"))
import orchestrator

MOST = 60
BATCH = 7


def student_quantile(freedom):
    """t with P(|T| <= t) = 0.95: Simpson's rule on the density, and bisection."""
    scale = math.exp(math.lgamma((freedom + 1) / 2) - math.lgamma(freedom / 2)) / math.sqrt(
        freedom * math.pi)

    def within(t, steps=400):
        h = t / steps
        density = [scale * (1 + (k * h) ** 2 / freedom) ** (-(freedom + 1) / 2)
                   for k in range(steps + 1)]
        return 2 * h / 3 * (density[0] + density[-1] + 4 * sum(density[1:-1:2])
                            + 2 * sum(density[2:-1:2]))

    low, high = 1.0, 4.0
    for _ in range(50):
        middle = (low + high) / 2
        low, high = (middle, high) if within(middle) < 0.95 else (low, middle)
    return low


def half_width_t(values):
    return student_quantile(len(values) - 1) * statistics.stdev(values) / math.sqrt(
        len(values))


class Target(orchestrator.Bench):
    def setUp(self):
        super().setUp()
        self.all = self.folder / "all.sqlite"

    def run_all(self):
        """t_1 of all realisations, in seed order."""
        self.poreclog("run", self.write(file="all.json", realisations=MOST),
                      database=self.all, runs=self.folder / "all-runs")
        return [t for t, in self.ask("SELECT t1_s FROM v_realisation ORDER BY idx", self.all)]

    def with_target(self, half_width, statistic="t1", file="c.json", workers=2, **keys):
        target = {"statistic": statistic, "half_width": half_width, "batch": BATCH}
        return self.write(file=file, limits={"workers": workers},
                          statistics={"target": target},
                          **{"realisations": MOST, **keys})

    def looks(self, most=MOST):
        return [*range(20, most, BATCH), most]

    def ingested(self):
        return [i for i, in self.ask("SELECT idx FROM v_realisation WHERE status = 'ingested'"
                                     " ORDER BY idx")]

    def a_target_met_half_way(self, t1):
        """A half-width, and the look at which it is first reached: neither first nor last."""
        widths = {n: half_width_t(t1[:n]) for n in self.looks()}
        for half_width in sorted(widths.values()):
            stop = next(n for n in self.looks() if widths[n] <= 1.0001 * half_width)
            if 20 < stop < 48:
                return 1.0001 * half_width, stop, widths
        self.fail("no such target")

    def test_stops_where_the_half_width_is_reached_whatever_the_workers(self):
        half_width, stop, widths = self.a_target_met_half_way(self.run_all())
        contents = []
        for workers in (1, 3, 8):
            self.database = self.folder / f"w{workers}.sqlite"
            self.runs = self.folder / f"w{workers}-runs"
            campaign = self.with_target(half_width, workers=workers)
            outcome = json.loads(self.poreclog("run", campaign, "--json").stdout)
            self.assertEqual(outcome["exit_code"], 0)
            self.assertEqual(outcome["not_needed"], MOST - stop)
            self.assertEqual(self.ingested(), list(range(stop)))
            self.assertEqual(len(list(self.runs.glob("c/p*/0*"))), stop)
            contents.append(self.content())
            state = json.loads(self.poreclog("statistics", "c", "--json").stdout)["points"][0]
            self.assertEqual(state["n"], stop)
            self.assertFalse(state["interim"])
            self.assertTrue(state["target"]["met"])
            self.assertAlmostEqual(state["target"]["half_width"] / widths[stop], 1.0,
                                   places=8)  # of the quadrature
        self.assertEqual(contents[0], contents[1])
        self.assertEqual(contents[0], contents[2])
        text = self.poreclog("status", "c").stdout
        self.assertIn(f"after {stop} realisations it is", text)
        self.assertIn(": met", text)
        # Asked again, nothing more is run; asked for more, it goes on from there.
        self.poreclog("resume", "c")
        self.assertEqual(self.ingested(), list(range(stop)))
        self.poreclog("run", self.with_target(1e-6), code=3)
        self.assertEqual(self.ingested(), list(range(MOST)))

    def test_decides_the_same_after_kills(self):
        half_width, stop, _ = self.a_target_met_half_way(self.run_all())
        campaign = self.with_target(half_width, workers=3)
        moments = random.Random(20260707)
        kills = 0
        for _ in range(12):
            process = self.start("run", campaign, SECONDS=0.03)
            time.sleep(moments.uniform(0.05, 0.5))
            if process.poll() is None:
                process.kill()
                kills += 1
            if process.wait() == 0:
                break
            self.assertLessEqual(len(list(self.runs.glob("c/p*/0*"))), stop)
        self.assertGreater(kills, 1)
        self.poreclog("run", campaign)
        self.assertEqual(self.ingested(), list(range(stop)))
        self.assertEqual(self.content(), self.undisturbed(campaign))

    def test_missed_is_said_and_extended(self):
        half_width = half_width_t(self.run_all()[:40])
        campaign = self.with_target(half_width / 2, realisations=25)
        done = self.poreclog("run", campaign, code=3)
        self.assertIn("the target is not met", done.stdout)
        self.assertIn("after 25 realisations it is", done.stdout)
        self.assertIn("NOT met", done.stdout)
        self.assertEqual(self.ingested(), list(range(25)))
        self.poreclog("resume", "c", code=3)
        self.poreclog("extend", "c", "--to", MOST, code=None)
        self.assertGreater(len(self.ingested()), 25)

    def test_every_number_has_the_half_width_that_statistics_prints(self):
        self.run_all()
        rows = self.ask("SELECT idx, t1_s, tc_s, duration_s FROM v_realisation ORDER BY idx",
                        self.all)[:20]
        table = self.folder / "t.csv"
        table.write_text("idx,t1_s,tc_s,censored\n" + "".join(
            f"{i},{t1!r},{end if tc is None else tc!r},{int(tc is None)}\n"
            for i, t1, tc, end in rows))
        known = json.loads(self.poreclog("statistics", "--csv", table, "--duration", 5,
                                         "--json").stdout)["points"][0]
        clogging = known["clogging"]
        expected = {name: [known[name]["ci_low"], known[name]["ci_high"]]
                    for name in ("t1", "tc", "tc_minus_t1")}
        expected.update(median_s=clogging["median_ci"],
                        restricted_mean_s=clogging["restricted_mean_ci"],
                        probability_by_end=clogging["probability_ci"])
        for name, (low, high) in expected.items():
            campaign = self.with_target(1e6, statistic=name, realisations=20)
            self.runs = self.folder / name
            self.database = self.folder / f"{name}.sqlite"
            determined = low is not None and high is not None
            outcome = json.loads(self.poreclog("run", campaign, "--json",
                                               code=0 if determined else 3).stdout)
            half_width = outcome["targets"][0]["half_width"]
            if determined:
                self.assertAlmostEqual(half_width, (high - low) / 2, places=9, msg=name)
            else:
                self.assertIsNone(half_width, name)
        self.assertTrue(any(low is None for low, _ in expected.values()), "none was censored")

    def test_where_the_target_stands_is_said_once(self):
        campaign = self.with_target(1e6)
        for report in ([], ["--no-report"]):
            done = self.poreclog("run", campaign, "--output", self.folder / "report", *report,
                                 prefix=("env", "-u", "PORECLOG_NO_REPORT"))
            self.assertEqual("report: " in done.stdout, not report)
            self.assertEqual(done.stdout.count("target: "), 1, done.stdout)

    def test_failed_realisations_are_counted_aloud(self):
        done = self.poreclog("run", self.with_target(1e6), "--json", code=2, FAULT="refuse",
                             ONE_IN=3)
        self.assertEqual(json.loads(done.stdout)["targets"][0]["n"], 20)  # it was looked at
        ended = self.ask("SELECT count(*) FROM v_realisation WHERE status IN "
                         "('ingested', 'failed')")
        self.assertEqual(ended, [(20,)])  # the pilot, the failed ones in it

    def test_plans_say_what_is_run_at_most(self):
        campaign = self.with_target(0.05)
        self.assertIn("stops when the half-width of t1 is at most 0.05 s: decided after 20",
                      self.poreclog("check", campaign).stdout)
        answer = json.loads(self.poreclog("run", campaign, "--dry-run", "--json").stdout)
        self.assertEqual(answer["to_run"], 20)
        self.assertEqual({c["reason"]: c["count"] for c in answer["ensembles"][0]["classes"]},
                         {"never_tried": 20, "target": MOST - 20})

    def test_refuses_a_pilot_that_never_ends(self):
        done = self.poreclog("check", self.with_target(0.1, realisations=12), code=1)
        self.assertIn("/statistics/target/pilot: is 20, but there are 12", done.stderr)


if __name__ == "__main__":
    unittest.main()
