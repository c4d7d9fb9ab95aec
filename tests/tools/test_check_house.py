# SPDX-License-Identifier: BSD-3-Clause
"""tools/check_house: every rule of the house is seen to be broken."""
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CHECK_HOUSE = Path(__file__).resolve().parents[2] / "tools" / "check_house"
SPDX = "// SPDX-License-Identifier: BSD-3-Clause\n"


class CheckHouse(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)

    def check(self, path, text, *options, **how):
        """What is complained about in a house of one file."""
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        command = [sys.executable, "-B", CHECK_HOUSE, "--root", self.root, *options]
        done = subprocess.run(command, capture_output=True, text=True, **how)
        self.assertEqual(done.returncode, 1 if done.stderr else 0, done.stderr)
        file.unlink()
        return done.stderr

    def include(self, folder, line):
        return self.check(f"src/coronet/{folder}/file.hpp", SPDX + "#pragma once\n" + line + "\n")

    def test_includes_go_down(self):
        self.assertEqual(self.include("terms", '#include "coronet/core/tensor.hpp"'), "")
        self.assertEqual(self.include("terms", '#include "coronet/terms/other.hpp"'), "")
        self.assertEqual(self.include("terms", '#include "coronet/version.hpp"'), "")
        self.assertEqual(self.include("terms", "#include <vector>"), "")
        self.assertIn("file.hpp:3: terms/ includes upwards: coronet/schemes/scheme.hpp",
                      self.include("terms", '#include "coronet/schemes/scheme.hpp"'))
        self.assertIn("core/ includes upwards", self.include("core", '  #  include "coronet/app/plot.hpp"'))

    def test_includes_are_spelt_in_one_way(self):
        for line in ('#include "tensor.hpp"', '#include "../core/tensor.hpp"', '#include "core/tensor.hpp"',
                     '#include "coronet/core/detail/tensor.hpp"', '#include "coronet/core/tensor.h"'):
            self.assertIn("is not spelt coronet/<folder>/<file>.hpp", self.include("terms", line))
        self.assertIn("is ours", self.include("terms", "#include <coronet/core/tensor.hpp>"))

    def test_every_folder_has_a_floor(self):
        self.assertIn("misc/ has no floor", self.include("misc", ""))
        self.assertIn("core/detail/ has no floor", self.include("core/detail", ""))
        self.assertIn("misc/ has no floor", self.include("terms", '#include "coronet/misc/file.hpp"'))
        self.assertIn("a file of no floor includes core/",
                      self.check("src/coronet/all.hpp", SPDX + '#include "coronet/core/tensor.hpp"\n'))

    def test_machines_are_told_apart_in_two_folders(self):
        for condition in ("#if defined(__CUDACC__)", "#ifdef __AVX512F__", "#ifndef CORONET_SIMD",
                          "#if _OPENMP >= 201511", "# elif defined(__x86_64__)", "#ifdef __aarch64__",
                          "#if defined(__ARM_NEON)"):
            self.assertIn("outside core/ and pairs/", self.include("schemes", condition), condition)
            self.assertEqual(self.include("core", condition), "")
            self.assertEqual(self.include("pairs", condition), "")
            self.assertIn("outside core/ and pairs/", self.check("tests/file_test.cpp", SPDX + condition + "\n"))
        self.assertEqual(self.include("schemes", "#ifndef NDEBUG"), "")

    def test_threads_are_made_in_one_folder(self):
        self.assertEqual(self.include("core", "#pragma omp parallel for"), "")
        self.assertIn("OpenMP outside core/", self.include("pairs", "#pragma omp parallel for"))
        self.assertIn("OpenMP outside core/", self.include("run", '_Pragma("omp barrier")'))

    def test_every_source_begins_with_its_licence(self):
        script = "#!/bin/sh\n# SPDX-License-Identifier: BSD-3-Clause\n"
        self.assertEqual(self.check("tools/script", script), "")
        for path in ("src/coronet/core/a.cpp", "src/coronet/core/a.cu", "tests/a.py", "tools/a", "cmake/a.cmake",
                     "CMakeLists.txt", "bench/CMakeLists.txt", "python/coronet_plot/a.py"):
            self.assertIn("SPDX", self.check(path, "\n" + SPDX), path)
            self.assertIn("SPDX", self.check(path, ""), path)
        self.assertIn("SPDX", self.check("src/coronet/core/a.cpp", "// SPDX-License-Identifier: MIT\n"))

    def test_files_are_short(self):
        self.assertEqual(self.check("src/coronet/core/a.cpp", SPDX + 399 * "\n"), "")
        self.assertIn("a.cpp: 401 lines; at most 400", self.check("src/coronet/core/a.cpp", SPDX + 400 * "\n"))

    def test_a_house_without_sources_is_none(self):
        self.assertIn("no sources", self.check("README.md", "coronet\n"))

    def count(self, names):
        """A program that prints symbols stands in for nm."""
        tool = self.root / "bin" / "nm"
        tool.parent.mkdir(exist_ok=True)
        lines = [f"00000000000b5bf0 t {name}" for name in names]
        lines.append("                 U coronet::sweep_rows<2, double, Undefined>()")
        tool.write_text("#!/bin/sh\ncat <<'END'\n" + "\n".join(lines) + "\nEND\n")
        tool.chmod(0o755)
        path = f"{tool.parent}:{os.environ['PATH']}"
        return self.check("src/coronet/core/a.cpp", SPDX, "--binary", "program", env=dict(os.environ, PATH=path))

    def test_pair_loops_are_few(self):
        laws = [f"void coronet::detail::sweep_rows<{dimension}, double, coronet::Sum<Law{k}> >()"
                for dimension in (2, 3) for k in range(32)]
        self.assertEqual(self.count(laws), "")
        self.assertEqual(self.count(laws + laws), "")  # in two objects
        self.assertEqual(self.count(laws + [laws[0] + " [clone .constprop.0]"]), "")
        self.assertIn("33 pair loops in 3D, double", self.count(laws + ["void coronet::detail::sweep_rows<3, double, One>()"]))
        self.assertIn("no pair loop was found", self.count(["main"]))


if __name__ == "__main__":
    unittest.main()
