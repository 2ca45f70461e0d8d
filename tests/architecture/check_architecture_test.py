#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Hindsight authors
# SPDX-License-Identifier: BSD-2-Clause
"""Seeds each kind of violation into a small tree and expects check_architecture.py to name exactly that."""

import pathlib
import tempfile
import unittest

from check_architecture import FLOORS, violations

CLEAN = {
    "config/params.h": "#include <vector>\n",
    "drivers/samples.h": '#include "config/params.h"\n',
    "perception/pose.h": '#include "drivers/samples.h"\n#include <opencv2/core.hpp>\n',
    "planning/dstar.cpp": '#include "perception/pose.h"\n#include "planning/dstar.h"\n',
    "daemon/robot.cpp": '#include "planning/dstar.h"\n#include <hindsight/state_t.hpp>\n',
    "tools/verify.cpp": '#include "daemon/robot.h"\n',
    "drivers/CMakeLists.txt": "hindsight_library(hindsight_drivers hindsight_config PkgConfig::GPIOD)\n",
}


class Seeded(unittest.TestCase):
    def found(self, files):
        with tempfile.TemporaryDirectory() as root:
            for name in FLOORS:
                (pathlib.Path(root) / name).mkdir()
            for name, text in (CLEAN | files).items():
                path = pathlib.Path(root) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            return list(violations(pathlib.Path(root)))

    def expect(self, name, text, place):
        found = self.found({name: text})
        self.assertEqual(len(found), 1, found)
        self.assertTrue(found[0].startswith(place), found)

    def test_a_clean_tree_passes(self):
        self.assertEqual(self.found({}), [])

    def test_an_include_upwards(self):
        self.expect("perception/a.cpp", '\n#include "planning/dstar.h"\n', "perception/a.cpp:2: planning/dstar.h")

    def test_an_include_of_the_daemon_by_a_stand_in(self):
        self.expect("sim_replay/a.h", '#include "daemon/robot.h"\n', "sim_replay/a.h:1")

    def test_more_of_drivers_than_samples(self):
        self.expect("perception/a.h", '#include "drivers/v4l2_camera.h"\n', "perception/a.h:1")

    def test_more_of_perception_than_data(self):
        self.expect("planning/a.h", '#include "perception/segmenter.h"\n', "planning/a.h:1")

    def test_an_include_by_relative_path(self):
        self.expect("tools/a.cpp", '#include "../daemon/robot.h"\n', "tools/a.cpp:1")

    def test_opencv_in_a_driver(self):
        self.expect("drivers/a.cpp", "#include <opencv2/core.hpp>\n", "drivers/a.cpp:1")

    def test_lcm_in_the_core(self):
        self.expect("perception/a.cpp", "#include <lcm/lcm-cpp.hpp>\n", "perception/a.cpp:1")
        self.expect("planning/a.cpp", "#include <hindsight/state_t.hpp>\n", "planning/a.cpp:1")

    def test_a_link_upwards(self):
        self.expect("perception/CMakeLists.txt",
                    "# a comment\nhindsight_library(hindsight_perception hindsight_config hindsight_drivers)\n",
                    "perception/CMakeLists.txt:2: hindsight_drivers")

    def test_a_link_to_a_library_of_other_floors(self):
        self.expect("planning/CMakeLists.txt",
                    "target_link_libraries(hindsight_planning PRIVATE\n  opencv_core)\n", "planning/CMakeLists.txt:1")

    def test_a_folder_without_a_floor(self):
        self.expect("utils/a.cpp", "", "utils")


if __name__ == "__main__":
    unittest.main()
