#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What test/house/run sees, on small texts: includes against the order of the rooms, and what is too long. Needs no compiler."""
import os
import subprocess
import sys
import tempfile
import unittest

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.dont_write_bytecode = True
sys.path[:0] = [os.path.join(SOURCE, 'test/house'), os.path.join(SOURCE, 'test/mutation')]
import includes  # noqa: E402
import laws  # noqa: E402
import licence  # noqa: E402
import sizes  # noqa: E402
import words  # noqa: E402

PUBLIC = 'include/drill_rig_sim/'


def include(header):
    return '#include "drill_rig_sim/%s"\n' % header


def tree(**files):
    """One header in every room, and files named room__name of src/."""
    texts = {PUBLIC + '%s/%s.h' % (room, room): '' for room in includes.ORDER}
    texts.update({'src/%s.cpp' % name.replace('__', '/'): text for name, text in files.items()})
    return texts


def body(lines, head='void f()'):
    """A function of this number of lines."""
    return head + '\n{\n' + '  g();\n' * (lines - 3) + '}\n'


def measured(text, file='src/math/a.cpp'):
    return [(name, line, lines) for name, line, lines in sizes.functions(file, text)]


class Arrows(unittest.TestCase):
    def one(self, texts, *words):
        """There is one fault and its line holds the words."""
        lines = includes.faults(texts)
        self.assertEqual(len(lines), 1, lines)
        for word in words:
            self.assertIn(word, lines[0])

    def test_downwards_is_in_order(self):
        for room in includes.ORDER:
            below = includes.ORDER[:includes.ORDER.index(room) + 1]
            if room == 'realtime':
                below = ('math', 'realtime')
            if room in ('tools', 'python'):
                below = [other for other in below if other not in includes.OF_ROS]
            text = ''.join(include('%s/%s.h' % (other, other)) for other in below)
            self.assertEqual([], includes.faults(tree(**{room + '__a': text})), room)

    def test_upwards(self):
        self.one(tree(math__a='\n' + include('solve/solve.h')), 'src/math/a.cpp:2: ', 'solve/ comes later')
        self.one(tree(contact__a=include('string/string.h')), 'src/contact/a.cpp:1: ')
        self.one(tree(solve__a=include('reference/reference.h')), 'src/solve/a.cpp:1: ')

    def test_every_arrow_upwards(self):
        for n, room in enumerate(includes.ORDER):
            for above in includes.ORDER[n + 1:]:
                self.one(tree(**{room + '__a': include('%s/%s.h' % (above, above))}), 'src/%s/a.cpp:1: ' % room)

    def test_of_sub_folders_headers_and_neighbours(self):
        self.one(tree(solve__methods__deep__a=include('sim/sim.h')), 'src/solve/methods/deep/a.cpp:1: ', 'solve/ includes')
        texts = tree(model__a='#include "../sim/own.h"\n')
        texts['src/sim/own.h'] = '#pragma once\n'
        self.one(texts, 'src/model/a.cpp:1: ', 'sim/ comes later')
        texts = tree()
        texts[PUBLIC + 'well/well.h'] = '#include <drill_rig_sim/rig/rig.h>\n'
        self.one(texts, PUBLIC + 'well/well.h:1: ')

    def test_comments_and_texts_do_not_count(self):
        text = '// ' + include('sim/sim.h') + '/*\n' + include('sim/sim.h') + '*/\nconst char* t = R"(\n' + include('sim/sim.h') + ')";\n'
        self.assertEqual([], includes.faults(tree(math__a=text)))
        self.one(tree(math__a=text + '#  include  "drill_rig_sim/sim/sim.h"  // why\n'), 'src/math/a.cpp:8: ')

    def test_ros(self):
        texts = tree(ros__a='#include <ros/ros.h>\n' + include('RigState.h') + include('SaveStateResponse.h'),
                     rviz__a='#include <tf2_ros/buffer.h>\n')
        texts.update({'msg/RigState.msg': '', 'srv/SaveState.srv': ''})
        self.assertEqual([], includes.faults(texts))
        for header in ('ros/ros.h', 'tf2_ros/buffer.h', 'geometry_msgs/Point.h', 'std_srvs/Trigger.h', 'drill_rig_sim/RigState.h',
                       'drill_rig_sim/SaveState.h', 'drill_rig_sim/SaveStateResponse.h'):
            for room in ('sim', 'realtime', 'tools'):
                texts = tree(**{room + '__a': '#include <%s>\n' % header})
                texts.update({'msg/RigState.msg': '', 'srv/SaveState.srv': ''})
                self.one(texts, 'src/%s/a.cpp:1: ' % room, 'ROS is for ros/ and rviz/ alone')
        self.one(tree(tools__a=include('ros/ros.h')), 'src/tools/a.cpp:1: ', 'and ROS with it')
        bag = PUBLIC + 'ros/run_bag.h'
        self.assertEqual([], includes.faults({**tree(tools__a=include('ros/run_bag.h')), bag: include('sim/sim.h')}))
        self.one({**tree(), bag: include('ros/ros.h')}, bag + ':1: ', 'no ROS in it')
        self.one({**tree(), bag: '#include <rosbag/bag.h>\n'}, bag + ':1: ', 'no ROS in it')
        self.one({**tree(sim__a=include('ros/run_bag.h')), bag: ''}, 'src/sim/a.cpp:1: ', 'ros/ comes later')

    def test_sundials(self):
        for header in ('ida/ida.h', 'kinsol/kinsol.h', 'arkode/arkode_arkstep.h', 'sundials/sundials_context.h', 'nvector/nvector_serial.h',
                       'sunlinsol/sunlinsol_klu.h', 'sunmatrix/sunmatrix_sparse.h', 'sunnonlinsol/sunnonlinsol_newton.h'):
            line = '#include <%s>\n' % header
            self.assertEqual([], includes.faults(tree(solve__a=line, reference__a=line)))
            self.one(tree(sim__a=line), 'src/sim/a.cpp:1: ', 'SUNDIALS is for solve/ and reference/ and compared/ alone')

    def test_realtime_knows_what_a_frame_hands_out_alone(self):
        texts = tree()
        texts[includes.FRAME_OUTPUT] = include('sim/sim.h')
        self.assertEqual([], includes.faults(texts))
        self.one(tree(realtime__a=include('well/well.h')), 'src/realtime/a.cpp:1: ', 'frame_output.h alone')

    def test_what_is_in_no_room(self):
        self.one(tree(a=''), 'src/a.cpp:1: in no room')
        self.one(tree(cellar__a=''), 'src/cellar/a.cpp:1: in no room')
        self.assertEqual([], includes.faults({**tree(), 'src/manual/pages.py': ''}))
        self.one(tree(math__a=include('math/gone.h')), 'src/math/a.cpp:1: there is no drill_rig_sim/math/gone.h')

    def test_the_table_counts(self):
        table = includes.arrows(tree(well__a=include('math/math.h') + include('well/well.h'), well__b=include('math/math.h')))
        self.assertEqual(table['well'], {'math': 2})
        self.assertEqual(table['math'], {})
        self.assertIn('well       -> math 2\n', includes.as_text(table))
        self.assertIn('"well" -> "math" [label="2"];', includes.as_dot(table))
        self.assertIn('color=red', includes.as_dot({'math': {'well': 1}, 'well': {}}))


class Lengths(unittest.TestCase):
    def test_files(self):
        for file in ('src/math/a.cpp', 'msg/A.msg', 'test/unit/a.h', 'test/a.py'):
            self.assertEqual([], sizes.faults({file: '\n' * 400}), file)
            self.assertEqual(['%s:1: 401 lines, allowed: 400 in a file' % file], sizes.faults({file: '\n' * 401}))
        self.assertEqual(1, len(sizes.faults({'msg/A.msg': '\n' * 400 + 'last'})))

    def test_lines(self):
        self.assertEqual([], sizes.faults({'src/math/a.cpp': '\n' + '/' * 130 + '\n', 'test/a.py': '#' * 131}))
        self.assertEqual(['src/math/a.h:2: 131 columns, allowed: 130 in a line'], sizes.faults({'src/math/a.h': '\n' + '/' * 131}))

    def test_functions(self):
        self.assertEqual([], sizes.faults({'src/math/a.cpp': body(60)}))
        self.assertEqual(['src/math/a.cpp:2: f: 61 lines, allowed: 60 in a function'], sizes.faults({'src/math/a.cpp': '\n' + body(61)}))

    def test_functions_of_python(self):
        for lines, faults in ((60, []), (61, ['test/a/run:2: f: %d lines, allowed: 60 in a function' % 61])):
            text = '#!/usr/bin/python3\ndef f():\n' + '    g()\n' * (lines - 1)
            self.assertEqual(faults, sizes.faults({'test/a/run': text}))
            self.assertEqual([], sizes.faults({'test/a/run': text.replace('python3', 'perl')}))

    def test_wherever_a_function_stands(self):
        for head, name in (('double A::B<int>::f(int a, int b = 3) const noexcept', 'A::B<int>::f'),
                           ('template <class T = int>\nT f(T a)', 'f'),
                           ('A::A(int a) : a_{a}, b_{1, {2}}, c_(3)', 'A::A'), ('A::A() : B<int>{}, c_()', 'A::A'),
                           ('A& A::operator=(const A& o)', 'A::operator='), ('bool operator()(int a) const', 'operator()'),
                           ('void* operator new[](std::size_t n)', 'operator new[]'), ('auto f() -> std::vector<int>', 'f'),
                           ('TEST(Rig, Stands)', 'TEST(Rig, Stands)'), ('struct tm* f()', 'f'),
                           ('const auto f = [&](int a) mutable -> int', '[]'), ('extern "C" int f(void)', 'f')):
            text = body(61 + head.count('\n') - head.count('template <'), head)
            for before, after in (('', ''), ('namespace a::b\n{\n', '}\n'), ('class A : public B\n{\npublic:\n', '};\n'),
                                  ('namespace\n{\nstruct A\n{\n  int a = 3, b{4};\n  enum class E\n  {\n    one\n  };\n', '};\n}\n')):
                end = ';\n' if head.startswith('const auto') else ''
                found = [one for one in measured(before + text + end + after) if one[2] > 10]
                self.assertEqual(found, [(name, before.count('\n') + 1, text.count('\n'))], before + head)

    def test_what_is_no_function(self):
        rows = '  {1, 2},\n' * 70
        for text in ('const int table[][2] = {\n%s};\n' % rows, 'Table t{\n%s};\n' % rows, 'int t[]{\n%s};\n' % rows,
                     'enum class E\n{\n%s};\n' % ('  a,\n' * 70), 'enum E : int\n{\n%s};\n' % ('  a,\n' * 70),
                     'namespace a\n{\n%s}\n' % ('int a;\n' * 70), 'class alignas(8) A\n{\n%s};\n' % ('  int a;\n' * 70),
                     '// void f() {\n' * 70, '#define F(a) \\\n  { \\\n%s  }\n' % ('  a \\\n' * 70),
                     'const char* t = R"(void f()\n{\n%s})";\n' % ('\n' * 70)):
            self.assertEqual([one for one in measured(text) if one[2] > 60], [], text[:40])

    def test_braces_in_texts_do_not_count(self):
        text = body(20, 'void f()').replace('  g();\n', '  g("}", \'{\', 1\'000);  // }\n')
        self.assertEqual([('f', 1, 20), ('h', 21, 61)], measured(text + body(61, 'void h()')))

    def test_what_cannot_be_read_is_told(self):
        self.assertIn('cannot be read', sizes.faults({'src/math/a.cpp': 'void f()\n{\n'})[0])
        self.assertIn('cannot be read', sizes.faults({'test/a.py': 'def f(:\n'})[0])

    def test_exceptions(self):
        texts = {'src/math/a.cpp': body(61)}
        self.assertEqual([], sizes.faults(texts, {'src/math/a.cpp:f': 'reason'}))
        self.assertEqual(1, len(sizes.faults(texts, {'src/math/a.cpp:g': 'reason', 'src/math/a.cpp:f': 'reason'})))
        for key, reason in sizes.ALLOWED.items():
            self.assertTrue(reason, key)


class Laws(unittest.TestCase):
    ONCE = {PUBLIC + 'contact/a_text.h': 'excess = kinetic * (static_ratio - all(1.0))\n'}

    def test_a_law_may_stand_once(self):
        self.assertEqual([PUBLIC + 'contact/a_text.h:1'], laws.places(self.ONCE)['Stribeck curve'])
        twice = {**self.ONCE, 'src/model/b.cpp': '\nx = kinetic * (static_ratio - 1.0);\n'}
        said = [line for line in laws.faults(twice) if 'Stribeck' in line]
        self.assertEqual(1, len(said))
        self.assertIn('stands 2 times, allowed: 1', said[0])
        self.assertIn('src/model/b.cpp:2', said[0])

    def test_a_law_that_is_written_otherwise_is_told(self):
        self.assertIn('Stribeck curve stands nowhere', laws.faults({})[0])


class Licence(unittest.TestCase):
    def test_each_source_names_it(self):
        for file, text, first in (('src/sim/a.cpp', 'int a;\n', '// SPDX'), ('test/a.py', '#!/usr/bin/python3\nA = 1\n', '#!'), ('launch/demo', '#!/bin/bash\n', '#!'), ('src/a.py', '', '# SPDX')):
            self.assertEqual(1, len(licence.faults({file: text})), file)
            whole = licence.with_line(file, text)
            self.assertTrue(whole.startswith(first), whole)
            self.assertEqual([], licence.faults({file: whole}))
        self.assertEqual([], licence.faults({'msg/A.msg': '', 'config/a.yaml': 'a: 1\n'}))


class Words(unittest.TestCase):
    def test_what_is_looked_at(self):
        text = 'nobody knows\n'
        for file in ('README.md', 'msg/A.msg', 'launch/a.launch', PUBLIC + 'sim/a.h'):
            self.assertEqual(['%s:1: "nobody": %s' % (file, words.NEVER[r'\b(whoever|somebody|nobody|anybody)\b'])], words.faults({file: text}))
        for file, line in (('src/sim/a.cpp', '// nobody\n'), ('src/sim/a.cpp', 'refuse("nobody is there");\n'), ('src/python/a.py', '"""To nobody."""\n'),
                           ('test/unit/a.cpp', '// it breaks loose\n'), (PUBLIC + 'string/a.h', '/// nobody\n')):
            self.assertEqual(1, len(words.faults({file: line})), file)
        self.assertEqual([], words.faults({'src/python/a.py': 'self.untold = []\n', 'test/run': 'nobody\n'}))

    def test_old_entries_of_the_changelog_stay(self):
        text = 'Forthcoming\n-----------\n* new\n\n0.2.0 (2026-01-01)\n------\n* nobody\n'
        self.assertEqual([], words.faults({'CHANGELOG.rst': text}))
        self.assertEqual(1, len(words.faults({'CHANGELOG.rst': text.replace('new', 'nobody')})))

    def test_words_that_depend_on_the_sentence_are_left_to_the_writer(self):
        self.assertEqual([], words.faults({'README.md': 'the string hangs on its hook alone, and the gauge is silent; of course\n'}))


class Command(unittest.TestCase):
    def run_on(self, texts, dot=None):
        """(exit status, what it printed, names of the files it wrote) for a package of these files; `dot`: a script in graphviz' place."""
        with tempfile.TemporaryDirectory() as top:
            for file, text in texts.items():
                os.makedirs(os.path.dirname(os.path.join(top, file)), exist_ok=True)
                with open(os.path.join(top, file), 'w', encoding='utf-8') as out:
                    out.write(text)
            programs = os.path.join(top, 'bin')
            os.mkdir(programs)
            if dot:
                with open(os.path.join(programs, 'dot'), 'w', encoding='utf-8') as out:
                    out.write(dot)
                os.chmod(os.path.join(programs, 'dot'), 0o755)
            done = subprocess.run([os.path.join(SOURCE, 'test/house/run'), '--source', top, '--out', os.path.join(top, 'drawn')],
                                  env={'PATH': programs}, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
            drawn = os.path.join(top, 'drawn')
            return done.returncode, done.stdout, sorted(os.listdir(drawn)) if os.path.isdir(drawn) else []

    def test_in_order(self):
        status, text, files = self.run_on(tree(math__a=body(60), well__a=include('math/math.h')))
        self.assertEqual(status, 0, text)
        self.assertIn('well       -> math 1\n', text)
        self.assertEqual(files, ['rooms.dot', 'rooms.txt'])

    def test_pictures_where_graphviz_is_installed(self):
        _, _, files = self.run_on(tree(math__a=''), dot='#!/bin/sh\n[ "$2" = -o ] && [ -s "$4" ] && : > "$3"\n')
        self.assertEqual(files, ['rooms.dot', 'rooms.png', 'rooms.svg', 'rooms.txt'])

    def test_out_of_order(self):
        texts = tree(math__a=include('well/well.h'), math__b=body(61))
        texts.update({'test/unit/a.cpp': '\n' * 401, 'srv/A.srv': '\n' * 401})
        status, text, _ = self.run_on(texts)
        self.assertEqual(status, 1, text)
        for place in ('src/math/a.cpp:1: ', 'src/math/b.cpp:1: ', 'test/unit/a.cpp:1: ', 'srv/A.srv:1: ', ', 4 faults'):
            self.assertIn(place, text)

    def test_without_sources(self):
        self.assertEqual(self.run_on({'test/a.py': ''})[0], 2)


if __name__ == '__main__':
    unittest.main()
