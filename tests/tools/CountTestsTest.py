"""The counter of ./test, on the log of a real ctest run.

Usage: CountTestsTest.py COUNTER CTEST [unittest arguments]
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

COUNTER, CTEST = sys.argv.pop(1), sys.argv.pop(1)

# Prints as a program of GoogleTest does, and ends with the exit code of its number of failures.
GTEST = """\
[==========] Running 3 tests from 1 test suite.
[       OK ] Suite.good (0 ms)
[  SKIPPED ] Suite.skipped (0 ms)
[  FAILED  ] Suite.bad/1, where GetParam() = 2 (0 ms)
[==========] 3 tests from 1 test suite ran. (0 ms total)
[  PASSED  ] 1 test.
[  SKIPPED ] 1 test, listed below:
[  SKIPPED ] Suite.skipped
[  FAILED  ] 1 test, listed below:
[  FAILED  ] Suite.bad/1, where GetParam() = 2
"""

TESTS = """\
add_test(by_exit_code "/bin/true")
add_test(by_output "/bin/echo" "the answer is 42")
set_tests_properties(by_output PROPERTIES PASS_REGULAR_EXPRESSION "is 42")
add_test(by_wrong_output "/bin/echo" "the answer is 41")
set_tests_properties(by_wrong_output PROPERTIES PASS_REGULAR_EXPRESSION "is 42")
add_test(by_wrong_exit_code "/bin/false")
add_test(skipped "/bin/echo" "OK (skipped=1)")
set_tests_properties(skipped PROPERTIES SKIP_REGULAR_EXPRESSION "skipped=")
add_test(suite "/bin/sh" "-c" "cat suite.txt; exit 1")
add_test(crashed "/bin/sh" "-c" "echo '[==========] Running 1 test from 1 test suite.'; kill -SEGV $$")
"""


class CountTests(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.build = pathlib.Path(directory.name)
        (self.build / "suite.txt").write_text(GTEST)

    def counted(self, tests, *options):
        (self.build / "CTestTestfile.cmake").write_text(tests)
        subprocess.run([CTEST, "--test-dir", self.build], capture_output=True, check=False)
        return subprocess.run([sys.executable, COUNTER, self.build, *options], capture_output=True, text=True, check=True).stdout.split("\n")

    def test_each_kind_of_end_counts_once(self):
        self.assertEqual(self.counted(TESTS)[0], "3 4 2")

    def test_failed_tests_are_named(self):
        self.assertEqual(self.counted(TESTS, "--failed")[:-1],
                         ["by_wrong_output (ended without naming a test)", "by_wrong_exit_code (ended without naming a test)", "Suite.bad/1",
                          "crashed (ended without naming a test)"])

    def test_a_test_judged_by_its_output_is_no_failure(self):
        self.assertEqual(self.counted("\n".join(TESTS.splitlines()[:3]))[0], "2 0 0")


if __name__ == "__main__":
    unittest.main()
