"""Campaigns against the real poreclog-solve: scenes are spelled out and checked by it, and
what it refuses is said of the line its user wrote."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["PORECLOG"]
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


if __name__ == "__main__":
    unittest.main()
