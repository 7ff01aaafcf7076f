#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""catkin_lint has nothing to say about the package but what cannot be otherwise, each with its reason here. Status 77: not installed."""
import re
import shutil
import subprocess
import sys

# what it says (a pattern of the whole line, without package and place) and why that stays
ALLOWED = {
    r"warning: file 'src/manual/run' is executable but not installed": "it reads the sources, so it stays with them",
    r"warning: file 'launch/demo' is executable but not installed": "it builds from the sources, so it stays with them",
    r"warning: file 'build-rosrun/(drill|rig_simulator|weight_holder)' is executable but not installed": "a link of the build for rosrun, not a source",
    r"warning: target '(benchmark_kernels|benchmark_speed|stability_map|accuracy_cases|fuzz_replay_\$\{target\}|fuzz_replay_\w+)' is not installed": "a program of the tests",
    r"warning: environment variables should not be used": "it is DESTDIR, at install time",
    r"error: find_package\((rviz|dynamic_reconfigure)\) has no REQUIRED option": "it is optional: optional_part() looks at whether it was found",
    r"error: catkin_package\(\) exports package include path that is not installed": "install_headers() installs it, header by header",
    r"notice: list of source files should be sorted": "a loop's variable is one of the names",
    r"warning: target 'realtime_listener' is not installed": "a part of test/realtime/run",
    r"notice: package path name '.*' differs from package name": "a checkout may be called anything",
    r"notice: global variable 'DRILL_RIG_SIM_(SANITIZE|UNITY|RUNNER|RVIZ|PYTHON_MODULE|KNOBS|HIGHWAY)' should contain project name": "it does, in capitals as CMake's own variables",
}


def main():
    if shutil.which("catkin_lint") is None:
        print("catkin_lint is not installed")
        return 77
    done = subprocess.run(["catkin_lint", "-W2", "--offline", sys.argv[1]], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    said = [line for line in done.stdout.splitlines() if re.match(r"\S+: ", line) and not line.startswith("catkin_lint: ")]
    if not re.search(r"checked 1 packages", done.stdout):
        print(done.stdout)
        return 1
    unexpected = [line for line in said if not any(re.search(r": " + pattern + "$", line) for pattern in ALLOWED)]
    for line in unexpected:
        print(line)
    return 1 if unexpected else 0


if __name__ == "__main__":
    sys.exit(main())
