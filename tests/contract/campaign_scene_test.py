"""Campaigns against the real poreclog-solve: scenes are spelled out and checked by it, and
what it refuses is said of the line its user wrote."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["PORECLOG"]
SOLVER = os.environ["PORECLOG_SOLVE"]
SOURCE = pathlib.Path(os.environ["PORECLOG_SOURCE_DIR"])


class Scene(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="poreclog-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def check(self, campaign, code=0):
        """`poreclog check` without naming the solver: it is found beside the program."""
        path = self.folder / "c.json"
        if isinstance(campaign, dict):
            path.write_text(json.dumps(campaign, indent=1))
        else:
            path = campaign
        done = subprocess.run([PROGRAM, "check", str(path), "--json", "--runs",
                               str(self.folder / "runs"), "--database",
                               str(self.folder / "db")], capture_output=True, text=True,
                              env={k: v for k, v in os.environ.items()
                                   if k != "PORECLOG_SOLVER"}, timeout=60)
        self.assertEqual(done.returncode, code, done.stderr)
        if code != 0:
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            return done.stderr
        return json.loads(done.stdout)

    def campaign(self, **keys):
        return {"campaign": "c", "scene": str(SOURCE / "campaigns/throat.scene.json"),
                "realisations": 2, "master_seed": 1, **keys}

    def test_of_the_reference_campaign_has_models_and_reasons(self):
        plan = self.check(SOURCE / "campaigns/throat.json")
        self.assertEqual((plan["realisations"], plan["to_run"]), (100, 100))
        ensemble = plan["ensembles"][0]
        self.assertEqual(ensemble["tier"], "one_way")
        self.assertEqual(ensemble["models"]["brownian"], False)
        self.assertIn("Pe(a)", ensemble["reasons"]["brownian"])
        self.assertEqual(list(self.folder.iterdir()), [], "check has written something")

    def test_values_are_the_same_in_any_unit(self):
        vary = {"/colloids/diameter": ["10 um", "13.3 um"]}
        plan = self.check(self.campaign(vary=vary))
        self.assertEqual([e["varied"]["/colloids/diameter"] for e in plan["ensembles"]],
                         ["1e-05 m", "1.33e-05 m"])
        vary["/colloids/diameter"].append("0.01 mm")
        self.assertIn("c.json line 10, column 4: /vary/~1colloids~1diameter/2: gives the same",
                      self.check(self.campaign(vary=vary), 1))

    def test_refusals_name_the_line_of_who_wrote_it(self):
        why = self.check(self.campaign(vary={"/colloids/diameter": ["10 um", "10 kg"]}), 1)
        self.assertIn("c.json line 9, column 4: /vary/~1colloids~1diameter/1: as "
                      "/colloids/diameter of the scene: ", why)
        why = self.check(self.campaign(fidelity={"cells_per_colloid": -1}), 1)
        self.assertIn("c.json line 7, column 3: /fidelity/cells_per_colloid: ", why)
        why = self.check(self.campaign(scene={"geometry": {"preset": "throt"}}), 1)
        self.assertIn("c.json line 5, column 4: /scene/geometry/preset: ", why)
        self.assertIn('the nearest is "throat"', why)
        scene = self.folder / "own.scene.json"
        scene.write_text('{"geometry": {"preset": "throat"},\n "fluid": {"viscosty": "1 Pa s"}}')
        why = self.check(self.campaign(scene="own.scene.json"), 1)
        self.assertIn("own.scene.json line 2, column 12: /fluid/viscosty: ", why)
        why = self.check(self.campaign(scene="none.json"), 1)
        self.assertIn("c.json line 3, column 2: /scene: there is no file", why)
        why = self.check(self.campaign(vary={"/colloid/diameter": ["10 um"]}), 1)
        self.assertIn("/vary/~1colloid~1diameter/0: as /colloid of the scene: ", why)

    def test_files_of_a_scene_are_found_from_its_own_folder(self):
        plan = self.check(self.campaign(
            scene=str(SOURCE / "campaigns/scenes/random_pack.scene.json"),
            fidelity={"cells_per_colloid": 4}))
        self.assertEqual(len(plan["ensembles"]), 1)

    FAST = {"geometry": {"preset": "throat"}, "drive": {"inlet_velocity": "50 mm/s"},
            "colloids": {"diameter": "20 um"}, "duration": "10 ms",
            "fidelity": {"cells_per_colloid": 4}}

    def test_auto_means_what_the_solver_says(self):
        vary = {"/drive/inlet_velocity": ["0.5 mm/s", "50 mm/s"]}
        slow, fast = self.check(self.campaign(scene=self.FAST, vary=vary,
                                              fidelity={"tier": "auto"}))["ensembles"]
        self.assertEqual((slow["tier"], slow["runs_as"]), ("auto", "one_way"))
        self.assertEqual(slow["tier_reason"], "the cheapest that is valid")
        self.assertIsNone(slow["seconds_each"])
        self.assertEqual((fast["tier"], fast["runs_as"]), ("auto", "transient"))
        self.assertIn("inertia counts: Re_throat = ", fast["tier_reason"])

    def test_cost_of_the_tier_transient_is_predicted_and_shared_by_ranks(self):
        campaign = self.campaign(scene=self.FAST, fidelity={"tier": "transient"})
        one = self.check(campaign)
        each = one["ensembles"][0]
        self.assertEqual(each["seconds_basis"], "predicted by the solver")
        cost = each["regime"]["cost"]
        self.assertEqual(each["seconds_each"], cost["seconds"])
        self.assertGreater(cost["steps"], 10)
        self.assertGreater(cost["cells"], 1000)
        two = self.check({**campaign, "ranks": 2})
        self.assertAlmostEqual(two["ensembles"][0]["seconds_each"], 0.5 * cost["seconds"])
        self.assertAlmostEqual(two["core_hours"], one["core_hours"])

    def test_ranks_are_for_the_tier_transient_alone(self):
        campaign = self.campaign(scene=self.FAST, ranks=2, fidelity={"tier": "auto"})
        self.assertEqual(self.check(campaign)["ensembles"][0]["runs_as"], "transient")
        slow = {**self.FAST, "drive": {"inlet_velocity": "0.5 mm/s"}}
        self.assertIn("/ranks: is 2, but a realisation of tier one_way is one process",
                      self.check({**campaign, "scene": slow}, 1))

    def test_what_auto_cannot_be_told_for_is_refused_where_it_was_written(self):
        closed = {"box": ["40 um", "40 um", "40 um"],
                  "faces": {"z-": "outlet", "z+": "inlet"},
                  "spheres": [{"center": ["20 um", "20 um", "20 um"], "diameter": "58 um"}]}
        scene = {"geometry": closed, "drive": {"inlet_velocity": "1 mm/s"},
                 "colloids": {"diameter": "5 um"}}
        self.assertIn("/scene/drive/inlet_velocity: the way from the inlet to the outlet is "
                      "blocked", self.check(self.campaign(scene=scene), 1))

    def test_a_run_needs_the_program_of_the_tier_transient(self):
        alone = self.folder / "poreclog-solve"
        alone.symlink_to(SOLVER)
        path = self.folder / "c.json"
        path.write_text(json.dumps(self.campaign(scene=self.FAST)))
        done = subprocess.run([PROGRAM, "run", str(path), "--solver", str(alone), "--runs",
                               str(self.folder / "runs"), "--database",
                               str(self.folder / "db")], capture_output=True, text=True,
                              timeout=60)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn(f"/fidelity/tier: needs {alone}-transient, which is not there",
                      done.stderr)
        self.assertFalse((self.folder / "runs").exists())


if __name__ == "__main__":
    unittest.main()
