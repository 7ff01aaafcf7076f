# SPDX-License-Identifier: BSD-3-Clause
"""A copy of the tree with a build of its own, in which mutants are compiled and tested."""
import glob
import hashlib
import json
import os
import re
import resource
import shlex
import shutil
import signal
import subprocess
import threading
import time

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
MEMORY = 8 << 30  # a mutant may grow without end [bytes]
one_rostest_at_a_time = threading.Lock()


class Broken(Exception):
    """What is not mutated does not build or does not pass."""


class Stopped(Exception):
    """The user has had enough."""


def tree_files(*tops):
    """Files below these folders of the package, or all, relative to it; no build folders and nothing hidden but what keeps a folder."""
    found = []
    for folder, folders, names in os.walk(SOURCE):
        inside = os.path.relpath(folder, SOURCE)
        folders[:] = [f for f in folders if not f.startswith(('.', '__pycache__')) and not (inside == '.' and f.startswith('build'))]
        found += [os.path.normpath(os.path.join(inside, name)) for name in names if name == '.gitkeep' or not name.startswith('.')]
    return sorted(f for f in found if not tops or f.split('/')[0] in tops)


def read(path):
    with open(path, 'rb') as file:
        return file.read()


def hash_of(files):
    """Of names and contents."""
    sum_of_all = hashlib.sha1()
    for name in files:
        sum_of_all.update(name.encode() + b'\0' + read(os.path.join(SOURCE, name)) + b'\0')
    return sum_of_all.hexdigest()


class Test:
    """One ctest entry. `programs` are the executables it runs, as paths; `target` makes what is compiled for it alone."""

    def __init__(self, name, tier, command, programs, target=None):
        self.name, self.tier, self.command, self.programs, self.target = name, tier, command, programs, target
        self.seconds = None  # what it takes where nothing is mutated


class Copy:
    """The copy, its build and what its parts are made of."""

    def __init__(self, folder, tests_pattern, rostests, stop):
        self.folder, self.pattern, self.with_rostests, self.stop = folder, re.compile(tests_pattern), rostests, stop
        self.tree, self.build = os.path.join(folder, 'tree'), os.path.join(folder, 'tree/build')
        self.scratch = os.path.join(folder, 'tmp')  # emptied before each test: what a mutant leaves behind must not count for the next
        self.environment = self._environment()
        self.tests = []
        self.targets = {}      # (sources, output, libraries) by name
        self.headers = {}      # what each target was compiled with
        self.products = set()  # targets made of sources that can be mutated
        self.codes = {}        # time and hash of each object file
        self.pristine = {}     # hash of each object file of what is not mutated
        self.stale = set()     # targets that still hold an earlier mutant
        self.header = None     # the header that is mutated now

    # --- making it ---
    def _environment(self):
        env = dict(os.environ)
        if 'ROS_DISTRO' not in env:
            env['PATH'] = '/usr/sbin:/usr/bin:/sbin:/bin'
            for name in ('PYTHONPATH', 'ROS_PACKAGE_PATH', 'CMAKE_PREFIX_PATH', 'ROS_IP'):
                env.pop(name, None)
        env.update(ROS_HOSTNAME='localhost', ROS_HOME=os.path.join(self.build, 'ros_home'),
                   MPLCONFIGDIR=os.path.join(self.build, 'matplotlib'),
                   ROS_LOG_DIR=os.path.join(self.build, 'ros_home/log'),
                   CCACHE_BASEDIR=self.folder, CCACHE_NOHASHDIR='1', TMPDIR=self.scratch)
        return env

    def synchronise(self):
        """Makes the copy equal to the tree; touches only what differs."""
        wanted = set(tree_files())
        for name in wanted:
            source, target = os.path.join(SOURCE, name), os.path.join(self.tree, name)
            if not os.path.isfile(target) or read(source) != read(target):
                os.makedirs(os.path.dirname(target), exist_ok=True)
                shutil.copyfile(source, target)
                shutil.copymode(source, target)
        for folder, folders, names in os.walk(self.tree):
            folders[:] = [f for f in folders if os.path.join(folder, f) != self.build]
            for name in names:
                path = os.path.join(folder, name)
                if os.path.relpath(path, self.tree) not in wanted and '__pycache__' not in path:
                    os.remove(path)
        shared = os.path.join(SOURCE, '../shared')
        if os.path.isdir(shared) and not os.path.exists(os.path.join(self.folder, 'shared')):
            os.symlink(os.path.realpath(shared), os.path.join(self.folder, 'shared'))

    def run(self, command, seconds=None, log=None):
        """Exit status, negative on a signal; None if it took longer. Ends with all that it started."""
        with open(log or os.devnull, 'ab') as out:
            process = subprocess.Popen(command, cwd=self.build, env=self.environment, stdin=subprocess.DEVNULL, stdout=out,
                                       stderr=subprocess.STDOUT, start_new_session=True,
                                       preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY)))
            end = time.monotonic() + (seconds or 1e9)
            try:
                while time.monotonic() < end:
                    if self.stop.is_set():
                        raise Stopped()
                    try:
                        return process.wait(0.5)
                    except subprocess.TimeoutExpired:
                        pass
                return None
            finally:
                end_session(process)

    def make(self, *targets):
        return self.run(['make', '-C', self.build, *targets], log=os.path.join(self.folder, 'make.log'))

    def prepare(self, jobs):
        """Copies, configures, builds; then knows tests, targets and object files."""
        os.makedirs(self.environment['ROS_LOG_DIR'], exist_ok=True)
        os.makedirs(self.scratch, exist_ok=True)
        open(os.path.join(self.folder, 'make.log'), 'w').close()
        self.synchronise()
        launcher = ['-DCMAKE_CXX_COMPILER_LAUNCHER=ccache'] if shutil.which('ccache', path=self.environment['PATH']) else []
        log = os.path.join(self.folder, 'make.log')
        if self.run(['cmake', '-S', self.tree, '-B', self.build, '-DCATKIN_ENABLE_TESTING=ON',
                     '-DDRILL_RIG_SIM_UNITY=OFF', *launcher], log=log) != 0:
            raise Broken('cmake failed; all it said is in ' + log)
        self._learn_targets()
        used = {t for test in self._learn_tests() for program in test.programs for t in self._closure(program)}
        self.products = {t for t in used if self.targets[t][0][0].startswith('src/')}
        if not self.products:
            raise Broken('no test is linked from src/')
        # twice: only the second time make reads which file includes which
        if any(self.make('-j%d' % jobs, *sorted(used)) != 0 for _ in range(2)):
            raise Broken('the build failed; all it said is in ' + log)
        self.tests = self._learn_tests()  # ctest names a command only where its program is there
        self.headers = {t: self._headers_of(t) for t in self.targets}
        self.pristine = {o: self._code(o) for o in self._objects_of(self.products)}
        self.environment['CCACHE_READONLY'] = '1'  # no mutant is compiled twice

    def _learn_targets(self):
        """What each target is made of and makes, by what CMake wrote for make."""
        parts = {}
        with open(os.path.join(self.build, 'compile_commands.json')) as file:
            for entry in json.load(file):
                words = shlex.split(entry['command'])
                target = re.match(r'CMakeFiles/([^/]+)\.dir/', words[words.index('-o') + 1])
                source = os.path.relpath(entry['file'], self.tree)
                if target and not source.startswith('build/'):  # precompiled headers
                    parts.setdefault(target.group(1), []).append(source)
        for target, sources in parts.items():
            link = os.path.join(self.build, 'CMakeFiles/%s.dir/link.txt' % target)
            if os.path.isfile(link):
                words = shlex.split(read(link).decode())
                output = words[words.index('-o' if '-o' in words else 'qc') + 1]
                libraries = {self._absolute(w) for w in words if re.search(r'\.(so[.\d]*|a)$', w)}
                self.targets[target] = (sources, self._absolute(output), libraries)

    def _absolute(self, path):
        return os.path.normpath(os.path.join(self.build, path))

    def _linked_again(self, targets):
        """What must be linked again to hold what changed in these targets: whatever a static library of them is linked into."""
        static = {t for t in targets if self.targets[t][1].endswith('.a')}
        return {t for t in self.targets if static & self._closure(self.targets[t][1])} if static else set()

    def _is_node(self, target):
        return any(s.startswith('src/ros/') for s in self.targets[target][0])

    def _objects_of(self, targets):
        return [o for t in targets for o in glob.glob(os.path.join(self.build, 'CMakeFiles/%s.dir/**/*.o' % t), recursive=True)]

    def _code(self, path):
        """Hash of an object file without what debuggers read."""
        made = os.stat(path).st_mtime_ns
        if self.codes.get(path, (0, 0))[0] != made:
            stripped = os.path.join(self.folder, 'stripped.o')
            subprocess.run(['strip', '-g', '-o', stripped, path], check=True)
            self.codes[path] = made, hashlib.sha1(read(stripped)).digest()
        return self.codes[path][1]

    # --- tests ---
    def _learn_tests(self):
        listed = subprocess.run(['ctest', '--show-only=json-v1'], cwd=self.build, env=self.environment, stdout=subprocess.PIPE, check=True)
        tests = []
        for entry in json.loads(listed.stdout)['tests']:
            labels = [v for p in entry.get('properties', []) if p['name'] == 'LABELS' for v in p['value']]
            test = self._test(entry['name'], entry.get('command', []), 'timed' in labels)
            if test and self.pattern.search(test.name):
                tests.append(test)
        return tests

    def _test(self, name, command, timed):
        """None for one that mutants are not tried with: a suite of its own, or one that measures time."""
        unit = re.search(r'_gtest_(\w+)$', name)
        if unit:
            program, file = shlex.split(command[-1])[:2]  # of a room, and which of its sources
            target = os.path.basename(program)
            if target not in self.targets:
                return None
            return Test(unit.group(1), 'unit', [program, file, '--gtest_fail_fast', '--gtest_brief=1'], [program], target)
        if timed:
            return None
        rostest = re.search(r'_rostest_(.+)$', name)
        if rostest and self.with_rostests:
            node = [output for t, (_, output, _) in self.targets.items() if self._is_node(t)]
            return Test(name, 'rostest', ['ctest', '-R', '^%s$' % re.escape(name)], node)
        programs = [word for word in command if word in [output for _, output, _ in self.targets.values()]]
        if any('test/tool/' in word for word in command) and programs:
            return Test(name, 'tool', command, programs)
        if name in self.targets:
            return Test(name, 'cases', command, [self.targets[name][1]], name)
        return None

    def _headers_of(self, target):
        """The tree's headers that the target was compiled with."""
        path = os.path.join(self.build, 'CMakeFiles/%s.dir/compiler_depend.make' % target)
        named = re.findall(r'\S+\.h\b', read(path).decode()) if os.path.isfile(path) else []
        return {os.path.relpath(self._absolute(name), self.tree) for name in set(named)}

    def _closure(self, program):
        """Targets that the program at this path is linked from."""
        found, waiting = set(), [program]
        while waiting:
            path = waiting.pop()
            for target, (_, output, libraries) in self.targets.items():
                if output == path and target not in found:
                    found.add(target)
                    waiting += libraries
        return found

    def affected(self, file):
        """Targets whose compilation reads this file."""
        if file.endswith('.h'):
            return {t for t in self.targets if file in self.headers[t]}
        return {t for t, (sources, _, _) in self.targets.items() if file in sources}

    def tests_for(self, file, room, rostest_rooms):
        """Those that the file takes part in: the room's own first, each group the fastest first."""
        touched = self.affected(file)
        order = {'unit': 1, 'tool': 2, 'cases': 3, 'rostest': 4}
        out = []
        for test in self.tests:
            if test.tier == 'rostest' and room not in rostest_rooms:
                continue
            if any(touched & self._closure(p) for p in test.programs):
                own = test.name.startswith('test_%s_' % room)
                out.append((0 if own else order[test.tier], test.seconds or 0.0, test))
        return [test for _, _, test in sorted(out, key=lambda entry: entry[:2])]

    def passes(self, test, seconds=None):
        """Whether it passes; None if it took longer than `seconds`."""
        holds = test.target and self.header in self.headers[test.target]
        if test.target and (holds or test.target in self.stale):
            if holds:
                self.stale.add(test.target)
            else:
                self.stale.discard(test.target)
            if self.make(test.target) != 0:
                return False
        log = os.path.join(self.folder, 'test.log')
        open(log, 'w').close()
        shutil.rmtree(self.scratch, ignore_errors=True)
        os.makedirs(self.scratch)
        if test.tier == 'rostest':
            with one_rostest_at_a_time:
                status = self.run(test.command, seconds, log)
        else:
            status = self.run(test.command, seconds, log)
        return None if status is None else status == 0

    # --- mutants ---
    def write(self, file, text):
        with open(os.path.join(self.tree, file), 'wb') as out:
            out.write(text.encode())

    def compile(self, file):
        """Makes what holds the file: 'differs', or 'does not compile', or 'same' where no object file differs."""
        self.header = file if file.endswith('.h') else None
        now = self.affected(file) & self.products
        if not self._make_with(now):
            return 'does not compile'
        changed = any(self._code(o) != self.pristine[o] for o in self._objects_of(now))
        return 'differs' if changed or not now else 'same'

    def restore(self, file):
        """Puts the file back; what was compiled with it follows at the next compile()."""
        shutil.copyfile(os.path.join(SOURCE, file), os.path.join(self.tree, file))

    def make_again(self):
        """What is not mutated, once all faults are put back."""
        self.header = None
        if not self._make_with(set()):
            raise Broken('what is not mutated does not build any more')

    def _make_with(self, now):
        """Makes the products that hold the mutant now, those that held the one before, and what is linked from them; whether they build."""
        before = self.stale & self.products
        again = self._linked_again(now | before)
        self.stale = self.stale - before | now | again - self.products
        made = now | before | again & self.products
        return not made or self.make(*sorted(made)) == 0


def end_session(process):
    """Ends whatever the process and its children left running: roslaunch gives each node a group of its own, the session is one."""
    for stat in glob.glob('/proc/[0-9]*/stat'):
        try:
            with open(stat) as file:
                pid, rest = file.read().split(' ', 1)
            if int(rest.rsplit(')', 1)[1].split()[3]) == process.pid:
                os.kill(int(pid), signal.SIGKILL)
        except (OSError, ValueError):
            pass  # it has ended by itself
    process.wait()
