#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The faults that test/mutation/run tries: found in code alone, drawn by the seed, counted rightly. Needs no compiler."""
import os
import subprocess
import sys
import tempfile
import unittest

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(SOURCE, 'test/mutation'))
import builds  # noqa: E402
import draw  # noqa: E402
import mutants  # noqa: E402
import score  # noqa: E402
import tokens  # noqa: E402


def body(*lines):
    return 'void f(Rig& rig)\n{\n' + ''.join('  %s\n' % line for line in lines) + '}\n'


def found(line):
    """{(kind, the line with the fault)} of a line inside a function."""
    return {(m.kind, m.after) for m in mutants.find('a.cpp', body(line))}


class Generators(unittest.TestCase):
    def test_sum(self):
        self.assertEqual(found('const double sum = a + b - c;'), {
            ('sign', 'const double sum = a - b - c;'), ('sign', 'const double sum = a + b + c;'),
            ('dropped term', 'const double sum = a - c;'), ('dropped term', 'const double sum = a + b;')})

    def test_product(self):
        self.assertEqual(found('const double x = a * rate[i] / c;'), {
            ('product', 'const double x = a / rate[i] / c;'), ('product', 'const double x = a * rate[i] * c;'),
            ('factor', 'const double x = a / c;'), ('factor', 'const double x = a * rate[i];')})

    def test_a_term_takes_its_factors_along(self):
        self.assertIn(('dropped term', 'y = a;'), found('y = a + 2.0 * g(b, c) * d;'))

    def test_statement(self):
        self.assertEqual(found('count += n;'), {('sign', 'count -= n;'), ('dropped statement', ';')})
        self.assertEqual(found('rig.stop();'), {('dropped statement', ';')})
        self.assertEqual(found('++n;'), {('dropped statement', ';')})
        self.assertEqual(found('a.b[i]->c = d;'), {('dropped statement', ';')})

    def test_a_declaration_stays(self):
        for line in ('double x = y;', 'const Rig& other = rig;', 'Rig other(rig);', 'std::vector<double> v;', 'auto* p = q;', 'std::vector<double>& v = w;'):
            self.assertEqual(found(line), set(), line)

    def test_comparison(self):
        self.assertEqual(found('if (a < b) return;'), {
            ('flipped comparison', 'if (a > b) return;'), ('boundary', 'if (a <= b) return;'), ('negated condition', 'if (!(a < b)) return;'),
            ('early return', 'if (a < b) ;')})
        self.assertEqual(found('if (a == b && c) stop();'), {
            ('equality', 'if (a != b && c) stop();'), ('logic', 'if (a == b || c) stop();'), ('negated condition', 'if (!(a == b && c)) stop();'),
            ('dropped statement', 'if (a == b && c) ;')})

    def test_a_loop_reads_nothing_beyond_its_end(self):
        self.assertNotIn('boundary', {kind for kind, _ in found('for (int i = 0; i < n; ++i) stop();')})

    def test_constant(self):
        self.assertEqual(found('const double x = 0.5;'), {('constant', 'const double x = 0.55;')})
        self.assertEqual(found('const double x = 10.0;'), {('constant', 'const double x = 11.0;')})
        self.assertEqual(found('const double x = 0.0;'), {('constant', 'const double x = 1.0;')})
        self.assertEqual(found('const double x = 1e-9;'), {('constant', 'const double x = 1e-06;')})
        self.assertEqual(found('const int x = 3;'), {('constant', 'const int x = 4;')})
        self.assertEqual(found('const bool x = true;'), {('boolean', 'const bool x = false;')})

    def test_template_arguments_stay(self):
        self.assertEqual(found('const auto x = b.block<3, 3>(i, i);'), set())

    def test_unary(self):
        self.assertEqual(found('const double x = -a;'), {('dropped minus', 'const double x = a;')})
        self.assertEqual(found('const bool x = !a;'), {('boolean', 'const bool x = a;')})

    def test_function_and_component(self):
        self.assertEqual(found('const double x = std::sin(a);'), {('function', 'const double x = std::cos(a);')})
        self.assertEqual(found('const double x = std::max(a, b);'), {('function', 'const double x = std::min(a, b);')})
        self.assertEqual(found('const double x = v[2];'), {('component', 'const double x = v[1];')})
        self.assertEqual(found('const double x = v.x();'), {('component', 'const double x = v.y();')})
        self.assertEqual(found('const double x = std::numeric_limits<double>::max();'), set())

    def test_arguments(self):
        self.assertEqual(found('const double x = g(a, b[i], c);'), {
            ('swapped arguments', 'const double x = g(b[i], a, c);'), ('swapped arguments', 'const double x = g(a, c, b[i]);')})
        self.assertEqual(found('return {a, b};'), {('swapped arguments', 'return {b, a};')})
        self.assertEqual(mutants.find('a.cpp', 'double g(const Rig& rig, double a, int b);\n'), [], 'parameters')

    def test_branches(self):
        self.assertEqual(found('const double x = c ? a : b;'), {('swapped branches', 'const double x = c ? b : a;')})

    def test_what_is_thrown_upon_may_be_wrong_and_what_is_said_not(self):
        self.assertEqual(found('if (a < b) throw Error("depth " + text(a - b));'), {
            ('flipped comparison', 'if (a > b) throw Error("depth " + text(a - b));'), ('boundary', 'if (a <= b) throw Error("depth " + text(a - b));'),
            ('negated condition', 'if (!(a < b)) throw Error("depth " + text(a - b));')})

    def test_none_in_comments_texts_directives_assertions_and_the_profiler(self):
        for line in ('// a + b - c < 3.0', '/* x = a * b; */', 'const char* x = "a + b < 3 \\" * 2";', "const char x = '-';", 'const char* x = R"(a + "b" * 3.0)";',
                     'assert(a + b < 3.0);', 'static_assert(sizeof(a) == 3 * 8);', 'profiler_.lap(a + b);', 'ROS_INFO_STREAM(a + 1.0);',
                     '// ends in a backslash \\\n a + b'):
            self.assertEqual(found(line), set(), line)
        self.assertEqual(mutants.find('a.cpp', '#define TWICE(a) \\\n  (2.0 * (a))\n#if A < 3\n#endif\n'), [])

    def test_of_a_header_only_what_functions_do(self):
        text = 'struct A\n{\n  double a = 1.0;\n  double g() const noexcept { return -a; }\n};\n'
        self.assertEqual([m.after for m in mutants.find('a.h', text)], ['double g() const noexcept { return a; }'])

    def test_applied_it_changes_its_place_alone(self):
        text = body('a = b;', 'c = d;')
        [fault] = [m for m in mutants.find('a.cpp', text) if m.before == 'c = d;']
        self.assertEqual(fault.apply(text), text.replace('c = d;', ';'))
        self.assertEqual((fault.line, fault.before, fault.after), (4, 'c = d;', ';'))


class Tree(unittest.TestCase):
    """The sources as they are."""

    def test_no_fault_begins_in_a_comment_or_text(self):
        for files in draw.rooms(builds.tree_files('src', 'include')).values():
            for file in files:
                text = builds.read(os.path.join(SOURCE, file)).decode()
                closed = bytearray(len(text))
                for match in tokens.TOKEN.finditer(text):
                    if match.lastgroup in ('comment', 'directive', 'string', 'tag', 'char'):
                        closed[match.start():match.end()] = b'\1' * (match.end() - match.start())
                wrong = [(m.line, m.before) for m in mutants.find(file, text) if closed[m.start]]
                self.assertEqual(wrong, [], file)

    def test_every_room_has_faults_to_draw_and_the_seed_decides(self):
        rooms = draw.rooms(builds.tree_files('src', 'include'))
        self.assertNotIn('rviz', rooms)
        for room, files in rooms.items():
            first = [m.name for m in draw.draw(files, 1, room)]
            self.assertGreater(len(first), 60, room)
            self.assertEqual(len(set(first)), len(first), room)
        self.assertEqual([m.name for m in draw.draw(files, 1, room)], first)
        self.assertNotEqual([m.name for m in draw.draw(files, 2, room)][:10], first[:10])


class Score(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = os.path.join(folder.name, 'seed_7.jsonl')
        self.record = score.Record(self.path)
        self.record.add({'seed': 7, 'sources': ''})

    def add(self, room, index, result):
        self.record.add({'room': room, 'index': index, 'file': 'src/%s/a.cpp' % room, 'line': 3, 'kind': 'sign', 'before': 'a + b;', 'after': 'a - b;',
                         'result': result, 'by': None, 'tests': ['test_a']})

    def test_goals(self):
        for index in range(19):
            self.add('well', index, 'caught')
        self.add('well', 19, 'same')
        self.assertTrue(score.report(self.record, [])[1])
        self.add('well', 20, 'survived')
        self.assertFalse(score.report(self.record, [])[1], 'nothing argues for the survivor')
        argued = [('src/well/a.cpp', 'a + b;', 'a - b;', 'b is 0')]
        text, reached = score.report(self.record, argued)
        self.assertTrue(reached)
        self.assertRegex(text, r'well +20 +19 +95 % +1 +1\n')
        self.assertIn('src/well/a.cpp:3: sign\n  - a + b;\n  + a - b;\n  tests: test_a\n  argued: b is 0', text)
        self.add('rig', 0, 'caught')
        self.add('rig', 1, 'survived')
        self.assertFalse(score.report(self.record, argued)[1], 'half of a room')

    def test_a_run_cut_off_goes_on(self):
        self.add('well', 0, 'survived')
        with open(self.path, 'a') as file:
            file.write('{"room": "we')
        again = score.Record(self.path)
        self.assertEqual(again.head['seed'], 7)
        self.assertEqual(again.results, self.record.results)
        again.add(dict(again.results['well', 0], result='caught'))
        self.assertEqual(score.Record(self.path).results['well', 0]['result'], 'caught')

    def test_arguments_are_read_as_the_report_prints_them(self):
        self.add('well', 0, 'survived')
        line = [l for l in score.report(self.record, [])[0].split('\n') if 'to argue: ' in l][0].split('to argue: ')[1]
        with open(self.path + '.md', 'w') as file:
            file.write('# Title\n\n%s\n' % line.replace('REASON', 'why not'))
        self.assertEqual(score.read_argued(self.path + '.md'), [('src/well/a.cpp', 'a + b;', 'a - b;', 'why not')])

    def test_what_is_argued_is_a_fault_of_the_sources(self):
        faults = {}
        for file, before, after, _ in score.read_argued(os.path.join(SOURCE, 'test/mutation/argued.md')):
            if file not in faults:
                with open(os.path.join(SOURCE, file), encoding='utf-8') as source:
                    faults[file] = {(m.before, m.after) for m in mutants.find(file, source.read())}
            self.assertTrue((before, after) in faults[file], '%s: %s => %s' % (file, before, after))


class Usage(unittest.TestCase):
    def test_wrong_usage_is_one_line_and_status_2(self):
        with tempfile.TemporaryDirectory() as folder:
            record = score.Record(os.path.join(folder, 'seed_1.jsonl'))
            record.add({'seed': 1, 'sources': 'others'})
            for words in (['--report', '--seed', '2'], ['--resume', '--seed', '1']):
                done = subprocess.run([sys.executable, os.path.join(SOURCE, 'test/mutation/run'), '--folder', folder] + words,
                                      stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, check=False)
                self.assertEqual((done.returncode, done.stdout, done.stderr.count('\n')), (2, '', 1), done.stderr)


if __name__ == '__main__':
    unittest.main(verbosity=2)
