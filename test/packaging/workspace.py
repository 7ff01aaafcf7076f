#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The part of ./test/packaging/run that runs in its chroot: builds /ws/src with each of catkin's tools and tries what they leave. One line for each
thing. Usage: workspace.py [--unit] [--rostest] [--demo]. Exit status: 0 nothing failed, 1 something failed."""
import glob
import os
import re
import shutil
import subprocess
import sys
import time

WORKSPACE = '/ws'
SOURCE = WORKSPACE + '/src/drill_rig_sim'
LOGS = WORKSPACE + '/log'
SCENE = SOURCE + '/config/scenes/quick.yaml'
SPACES = {'catkin_make': ('devel', 'install'), 'catkin_make_isolated': ('devel_isolated', 'install_isolated'), 'catkin build': ('devel_tools', 'install_tools')}
# the first build has all parts; the others show that the structure suits their tool
FEWER = '-DDRILL_RIG_SIM_RUNNER=OFF -DDRILL_RIG_SIM_RVIZ=OFF -DDRILL_RIG_SIM_HIGHWAY=OFF -DDRILL_RIG_SIM_KNOBS=OFF'
LARGEST = 40.0  # installed and stripped [MB]
ENVIRONMENT = {'CCACHE_BASEDIR': WORKSPACE, 'CCACHE_NOHASHDIR': '1', 'CCACHE_SLOPPINESS': 'pch_defines,time_macros,include_file_mtime,include_file_ctime',
               'CMAKE_CXX_COMPILER_LAUNCHER': 'ccache', 'CMAKE_C_COMPILER_LAUNCHER': 'ccache', 'ROS_HOSTNAME': 'localhost',
               'CMAKE_POLICY_VERSION_MINIMUM': '3.5'}  # CMake 4 of sid refuses the toplevel.cmake of its own catkin


class Skipped(Exception):
    """Why a thing was not tried."""


class Failed(Exception):
    """What went wrong, in a line."""


class Log:
    """The commands of one thing, with all that they print, in a file of its own."""

    def __init__(self, name):
        self.path = os.path.join(LOGS, re.sub(r'\W+', '_', name) + '.log')
        open(self.path, 'w', encoding='utf-8').close()

    def bash(self, lines, setup=None, folder=WORKSPACE):
        """What the lines print on stdout in a bash with the environment of a space."""
        sourced = ". '%s/setup.bash'\n" % setup if setup else ''
        with open(self.path, 'a', encoding='utf-8') as log:
            log.write('== %s%s\n' % (sourced, lines))
            log.flush()
            done = subprocess.run(['bash', '-e', '-o', 'pipefail', '-c', sourced + lines], cwd=folder, stdout=subprocess.PIPE, stderr=log, stdin=subprocess.DEVNULL,
                                  universal_newlines=True, errors='replace', check=False)
            log.write(done.stdout)
        if done.returncode:
            raise Failed('status %d' % done.returncode)
        return done.stdout


def jobs():
    return int(os.environ.get('JOBS', os.cpu_count()))


def catkin_make(log):
    tests_too = 'ON' if '--unit' in sys.argv or '--rostest' in sys.argv else 'OFF'
    log.bash('catkin_make -j%d -DCATKIN_ENABLE_TESTING=%s; catkin_make -j%d install' % (jobs(), tests_too, jobs()))
    left_out = re.findall(r'^-- (.*): left out, (.*)$', open(log.path, encoding='utf-8', errors='replace').read(), re.M)
    return ', '.join(dict.fromkeys('without %s (%s)' % (re.sub(r' \(.*', '', part), why) for part, why in left_out))


def catkin_make_isolated(log):
    log.bash('catkin_make_isolated -j%d --install --cmake-args -DCATKIN_ENABLE_TESTING=OFF %s' % (jobs(), FEWER))


def catkin_build(log):
    if not shutil.which('catkin'):
        raise Skipped('this release has no catkin-tools')
    log.bash('catkin config --init --build-space build_tools --devel-space devel_tools --install-space install_tools --log-space log_tools --install'
             ' --cmake-args -DCATKIN_ENABLE_TESTING=OFF -DDRILL_RIG_SIM_PYTHON_MODULE=OFF %s; catkin build --no-status -j%d' % (FEWER, jobs()))


def has(space, *names):
    """The first of these files that a space has."""
    return next((path for name in names for path in glob.glob(os.path.join(space, name))), None)


def rosrun(log, space):
    programs = ['rig_simulator', 'weight_holder', 'autodriller.py'] + (['drill'] if has(space, 'lib/drill_rig_sim/drill', '*/lib/drill_rig_sim/drill') else [])
    for program in programs:
        found = log.bash('rosrun --prefix echo drill_rig_sim %s' % program, space).strip()
        if not found.endswith('/' + program):
            raise Failed('%s: found %s' % (program, found))
    if 'drill' in programs:
        log.bash("rosrun drill_rig_sim drill check '%s' | grep 'quick: OK'" % SCENE, space)
    return ', '.join(programs)


def roslaunch(log, space):
    """The rig begins without a screen and publishes its state."""
    port = 12000 + os.getpid() % 1000
    printed = log.bash("""export ROS_MASTER_URI=http://localhost:%d
roslaunch -p %d drill_rig_sim rig.launch scene:=quick.yaml headless:=true 1>&2 &
trap 'kill -INT $!; wait $! || true' EXIT
timeout 60 python3 - <<'END'
import time
import rosgraph
while not rosgraph.is_master_online():
    time.sleep(0.1)
import rospy
from drill_rig_sim.msg import RigState
rospy.init_node('listener', disable_rostime=True)
print('hook_load:', rospy.wait_for_message('/rig/rig_state', RigState, 30.0).hook_load)
END""" % (port, port), space)
    return check_hook_load(printed)


def check_hook_load(printed):
    """Block, top drive and a short string weigh more than 10 t."""
    loads = [float(number) for number in re.findall(r'^hook_load: (\S+)$', printed, re.M)]
    if len(loads) != 1 or not 1e5 < loads[0] < 1e6:
        raise Failed('hook loads %s' % loads)
    return 'hook load %.1f kN' % (1e-3 * loads[0])


def rviz(log, space):
    library = has(space, 'lib/libdrill_rig_sim_rviz.so', '*/lib/libdrill_rig_sim_rviz.so')
    if not library:
        raise Skipped('no plug-ins in this build')
    printed = log.bash('rospack plugins --attrib=plugin rviz', space)
    listed = [line.split(None, 1)[1] for line in printed.splitlines() if line.startswith('drill_rig_sim ')]
    if len(listed) != 1 or not os.path.isfile(listed[0]):
        raise Failed('listed: %s' % listed)
    with open(listed[0], encoding='utf-8') as file:
        text = file.read()
    if not re.search(r'path="lib/libdrill_rig_sim_rviz"', text):
        raise Failed('%s names no library' % listed[0])
    log.bash("! ldd -r '%s' | grep -E 'not found|undefined symbol'" % library, space)
    return '%d classes' % len(re.findall('<class ', text))


def python_module(log, space):
    messages = log.bash("python3 -c 'from drill_rig_sim.msg import RigState; from drill_rig_sim import units; print(RigState.__module__)'", space)
    if not has(space, 'lib/python3/dist-packages/drill_rig_sim/_sim.*', '*/lib/python3/dist-packages/drill_rig_sim/_sim.*'):
        return messages.strip() + ', no _sim in this build'
    printed = log.bash("python3 -c 'from drill_rig_sim.sim import Simulator; print(Simulator(\"%s\").step(0.1).t)'" % SCENE, space)
    if printed.strip() != '0.1':
        raise Failed('printed ' + printed.strip())
    return 'Simulator, messages'


def dependent(log, space):
    """The one that was built in the same workspace, then one that is built against this space alone."""
    here = check_hook_load(log.bash("rosrun rig_user rig_user '%s'" % SCENE, space))
    folder = WORKSPACE + '/user'
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    shutil.copytree(SOURCE + '/test/dependent', folder + '/src/rig_user')
    log.bash('catkin_make', space, folder)
    check_hook_load(log.bash("'%s/devel/lib/rig_user/rig_user' '%s'" % (folder, SCENE), folder + '/devel'))
    return here


def install(log):
    """Into any folder, and with DESTDIR."""
    if not os.path.isdir(WORKSPACE + '/build_isolated/drill_rig_sim'):
        raise Failed('catkin_make_isolated left no build')
    log.bash("python3 '%s/test/tool/test_install.py' build_isolated/drill_rig_sim devel_isolated/drill_rig_sim 1>&2" % SOURCE)
    with open(log.path, encoding='utf-8') as file:
        return ' '.join(re.findall(r'^Ran \d+ tests|skipped=\d+', file.read(), re.M))


def size(log):
    prefix = WORKSPACE + '/stripped'
    shutil.rmtree(prefix, ignore_errors=True)
    log.bash("cmake --install build/drill_rig_sim --prefix '%s' --strip" % prefix)
    total = sum(os.lstat(os.path.join(place, name)).st_size for place, _, names in os.walk(prefix) for name in names) / 1e6
    headers = [name for name in glob.glob(prefix + '/include/drill_rig_sim/**/*.h', recursive=True) if not re.search(r'/drill_rig_sim/[A-Z]\w*\.h$', name)]
    text = '%.1f MB, %d headers beside those of messages' % (total, len(headers))
    if total > LARGEST:
        raise Failed('%s: more than %.0f MB' % (text, LARGEST))
    return text


def neon(log):
    if not os.path.exists('/usr/include/hwy/highway.h'):
        raise Skipped('this release has no Highway')
    for program in ('aarch64-linux-gnu-g++', 'qemu-aarch64'):
        if not shutil.which(program):
            raise Skipped(program + ' is not installed')
    printed = log.bash("'%s/test/neon/run' /ws/neon" % SOURCE)
    return ', '.join(re.findall(r'PASSED +\] (\d+ tests)', printed))


def tests(log, target, chosen):
    """Those that options of ctest choose, when `target` is built."""
    log.bash("make -C build/drill_rig_sim -j%d %s; cd build/drill_rig_sim; ctest %s -j%d --output-on-failure || true" % (jobs(), target, chosen, jobs()), WORKSPACE + '/devel')
    with open(log.path, encoding='utf-8', errors='replace') as file:
        return passed(file.read())


def passed(text):
    """How many of the tests in the output of ctest, if all."""
    summary = re.search(r'(\d+)% tests passed, (\d+) tests failed out of (\d+)', text)
    if not summary or summary.group(2) != '0':
        failed = re.findall(r'\d+ - _ctest_drill_rig_sim_(?:gtest|rostest_test_rostest)_(\S+) \(', text)
        raise Failed('%s: %s' % (summary.group(0) if summary else 'ctest ended early', ' '.join(failed)))
    return '%s programs passed' % summary.group(3)


def unit(log):
    return tests(log, 'unit_tests', '-L unit')


def rostests(log):
    # as in ./test/run: their pictures and logs are beside the build, whose folder one of them installs
    os.environ['ROS_HOME'] = WORKSPACE + '/build/drill_rig_sim/ros_home'
    return tests(log, 'tests', '-R _rostest_')


def demo(log):
    printed = log.bash("'%s/launch/demo' --headless --duration 30 --no-install" % SOURCE)
    factor = re.search(r'^simulated 30.*: real-time factor ([\d.]+)', printed, re.M)
    if not factor:
        raise Failed('no real-time factor at the end')
    return 'real-time factor ' + factor.group(1)


OPTIONAL = (('--unit', 'tests of the library', unit), ('--rostest', 'tests of the node', rostests), ('--demo', 'launch/demo', demo))


def tried(name, thing, *given):
    """Prints the line of a thing; whether it did not fail."""
    log, begun = Log(name), time.monotonic()
    try:
        text = thing(log, *given) or ''
        result = 'ok'
    except Skipped as why:
        result, text = 'skipped', str(why)
    except (Failed, OSError, ValueError, subprocess.SubprocessError) as error:
        result, text = 'failed', '%s; all it said is in %s' % (error, log.path)
    print('%-8s%-42s%6.0f s  %s' % (result, name, time.monotonic() - begun, text), flush=True)
    return result


def main():
    os.makedirs(LOGS, exist_ok=True)
    os.environ.update(ENVIRONMENT)
    results = []
    for tool, build in (('catkin_make', catkin_make), ('catkin_make_isolated', catkin_make_isolated), ('catkin build', catkin_build)):
        results.append(tried(tool, build))
        if results[-1] != 'ok':
            continue
        for space in SPACES[tool]:
            for name, thing in (('rosrun', rosrun), ('roslaunch', roslaunch), ('plug-ins of rviz', rviz), ('Python', python_module), ('dependent package', dependent)):
                results.append(tried('%s, %s' % (name, space), thing, os.path.join(WORKSPACE, space)))
    results.append(tried('install: prefix, DESTDIR', install))
    results.append(tried('installed size, stripped', size))
    results.append(tried('NEON under qemu', neon))
    results += [tried(name, thing) for option, name, thing in OPTIONAL if option in sys.argv]
    print('%d ok, %d failed, %d skipped' % tuple(results.count(result) for result in ('ok', 'failed', 'skipped')))
    return 1 if 'failed' in results else 0


if __name__ == '__main__':
    sys.exit(main())
