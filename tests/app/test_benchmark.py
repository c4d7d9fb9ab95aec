# SPDX-License-Identifier: BSD-3-Clause
"""What `coronet bench` prints and writes."""
import json
import unittest

from test_command_line import CommandLine


class ABenchmark(CommandLine):
    """The rows of `coronet bench`: each a configuration, in the table and in the JSON."""

    def bench(self, *words):
        done = self.coronet("bench", "--threads", 1, "--particles", 1000, "--steps", 3, "--json", "f", *words)
        lines = [line.split() for line in done.stdout.splitlines()]
        head = next(k for k, line in enumerate(lines) if line[:2] == ["dimension", "gradient"])
        names = lines[head][:lines[head].index("|")]
        phases = lines[head][lines[head].index("seconds:") + 1:]
        table = [(dict(zip(names, line)), dict(zip(phases, line[len(names) + 1:]))) for line in lines[head + 1:]]
        return done, table, json.loads((self.folder / "f").read_text())

    def test_prints_a_row_per_configuration_and_the_same_as_json(self):
        done, table, found = self.bench()
        precisions = [row["precision"] for row in found["rows"][:len(found["rows"]) // 4]]
        wanted = [(str(d), g, p) for d in (2, 3) for g in ("sph", "fpm") for p in precisions]
        self.assertEqual([(row["dimension"], row["gradient"], row["precision"]) for row, _ in table], wanted)
        self.assertEqual(len(found["rows"]), len(table))
        for (cells, seconds), row in zip(table, found["rows"]):
            for name in ("dimension", "gradient", "precision", "threads", "particles"):
                self.assertEqual(cells[name], str(row[name]))
            rate, neighbours = row["particle_evaluations_per_second"], row["neighbours"]
            self.assertAlmostEqual(float(cells["neighbours"]), neighbours, delta=0.06)
            self.assertAlmostEqual(float(cells["Mevaluations/s"]) / rate * 1e6, 1, delta=1e-3)
            self.assertAlmostEqual(float(cells["Mpairs/s/core"]) / row["pairs_per_second_per_core"] * 1e6, 1, delta=1e-3)
            self.assertAlmostEqual(row["pairs_per_second_per_core"] / (rate * neighbours), 1, delta=1e-9)
            self.assertAlmostEqual(float(cells["roofline"].rstrip("%")), 100 * row["roofline_fraction"], delta=0.06)
            self.assertAlmostEqual(float(cells["bytes/particle"]), row["bytes_per_particle"], delta=0.6)
            self.assertEqual({name: time for name, time in seconds.items() if time != "-"},
                             {name: f"{time:.3f}" for name, time in row["seconds_per_phase"].items()})
            worked = row["particles"] * row["evaluations"]
            self.assertAlmostEqual(sum(row["seconds_per_phase"].values()) * rate / worked, 1, delta=1e-9)
            self.assertEqual((row["steps"], row["evaluations"]), (3, 6))
        roof = found["machine"]["roofs"][-1]
        self.assertIn(f"1 thread: {roof['double_operations_per_second'] / 1e9:.1f} Gflop/s in double", done.stdout)
        self.assertIn("measuring", done.stderr)

    def test_measures_what_it_is_asked_to(self):
        _, table, found = self.bench("--dimension", 2, "--gradient", "cph", "--precision", "double", "--particles", 500,
                                     "--repeat", 2)
        self.assertEqual([cells["gradient"] for cells, _ in table], ["cph", "cph"])
        self.assertGreater(int(table[0][0]["particles"]), int(table[1][0]["particles"]))
        for (cells, _), row in zip(table, found["rows"]):
            rates = row["repeated_particle_evaluations_per_second"]
            self.assertEqual(len(rates), 2)
            self.assertEqual((min(rates), max(rates)), (row["particle_evaluations_per_second"],
                                                        row["best_particle_evaluations_per_second"]))
            self.assertAlmostEqual(float(cells["best"]) / max(rates) * 1e6, 1, delta=1e-3)

    def test_that_is_asked_for_wrongly_says_what_is_allowed(self):
        self.assertIn("--gradient is 'spg', but must be one of sph, cph, fpm; did you mean 'sph'?",
                      self.refused("bench", "--gradient", "spg"))
        self.assertIn("--precision is 'half', but must be one of double", self.refused("bench", "--precision", "half"))
        for option, value in (("--dimension", 4), ("--particles", 5), ("--steps", 0), ("--threads", 0),
                              ("--repeat", 0), ("--steps", "many")):
            self.assertIn(option, self.refused("bench", option, value))
        self.assertRegex(self.refused("bench", "--json", "missing/f"), "^--json missing/f: cannot write .*No such file")
        self.assertIn("--fast", self.refused("bench", "--fast"))
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main()
