# SPDX-License-Identifier: BSD-3-Clause
"""What a run is made of: a master, the node, a subscriber of all its topics, a hog; and what the system knows of them."""
import os
import signal
import socket
import subprocess
import tempfile
import time
import xmlrpc.client

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PATIENCE = 60.0  # wall seconds that anything may take on a loaded machine
# offset of the stamp in the message [bytes], of those that come with every frame
STAMPED = {'rig_state': 4, 'truth/rig_state': 4, 'joint_states': 4, 'bit/pose': 4, 'bit/twist': 4, 'bit/wrench': 4,
           'truth/bit': 4, '/clock': 0}
OTHERS = ('hook_load', 'torque', 'accuracy', 'rig_limits', 'downhole/mwd', 'downhole/toolface', 'drillstring_state', 'markers', 'trajectory',
          '/tf', '/tf_static', '/diagnostics')


def wait_for(condition, what):
    """What `condition()` gives, once that is true."""
    deadline = time.monotonic() + PATIENCE
    while time.monotonic() < deadline:
        result = condition()
        if result:
            return result
        time.sleep(0.05)
    raise RuntimeError('not within %g s: %s' % (PATIENCE, what))


def stop(process, how=signal.SIGINT):
    """Exit status of a process that is told to end, or killed."""
    if process.poll() is None:
        process.send_signal(how)
    try:
        return process.wait(20.0)
    except subprocess.TimeoutExpired:
        process.kill()
        return process.wait()


def stolen():
    """Time that the host of a virtual machine has kept its processors for others so far [s]."""
    with open('/proc/stat') as file:
        return float(file.readline().split()[8]) / os.sysconf('SC_CLK_TCK')


class Master:
    """A rosmaster on a port of its own, which this process and its children then use."""

    def __init__(self):
        with socket.socket() as free:
            free.bind(('127.0.0.1', 0))
            port = free.getsockname()[1]
        self.uri = 'http://127.0.0.1:%d' % port
        os.environ.update(ROS_MASTER_URI=self.uri, ROS_IP='127.0.0.1')
        os.environ.pop('ROS_HOSTNAME', None)
        self.process = subprocess.Popen(['rosmaster', '--core', '-p', str(port)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        wait_for(self.answers, 'a rosmaster; is it installed and on the PATH?')

    def proxy(self):
        return xmlrpc.client.ServerProxy(self.uri)

    def answers(self):
        if self.process.poll() is not None:
            raise RuntimeError('rosmaster has ended')
        try:
            return self.proxy().getPid('/run')[0] == 1
        except OSError:
            return False

    def set(self, name, value):
        self.proxy().setParam('/run', name, value)


class Node:
    """The node, with private parameters, in a namespace that none has had before: rospy may miss a node that comes back under an old name."""
    count = 0

    def __init__(self, program, parameters):
        Node.count += 1
        self.namespace = '/rig_%d' % Node.count
        self.output = tempfile.TemporaryFile('w+')
        words = ['_%s:=%s' % (name, value) for name, value in parameters.items()]
        self.process = subprocess.Popen([program, '__ns:=' + self.namespace] + words, stdout=self.output, stderr=subprocess.STDOUT)

    def said(self):
        self.output.seek(0)
        return self.output.read().strip()

    def cpu(self):
        """CPU time of each kind of thread so far [s]; roscpp's own have no names and are `ros`."""
        spent = {}
        folder = '/proc/%d/task' % self.process.pid
        for task in os.listdir(folder):
            try:
                with open('%s/%s/comm' % (folder, task)) as name, open('%s/%s/schedstat' % (folder, task)) as times:
                    kind = name.read().strip()
                    seconds = 1e-9 * int(times.read().split()[0])
            except OSError:
                continue  # it has ended
            kind = kind if kind in ('simulation', 'publishing') else 'ros'
            spent[kind] = spent.get(kind, 0.0) + seconds
        return spent


class Listener:
    """One process that subscribes to all topics of a node."""

    def __init__(self, program, node, period):
        self.prefix = node.namespace + '/'
        topics = ['%s=%d' % (name, offset) for name, offset in STAMPED.items()] + list(OTHERS)
        words = [name if name.startswith('/') else self.prefix + name for name in topics]
        self.process = subprocess.Popen([program, str(period)] + words, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)

    def end(self):
        """{topic: (received, missing)}, without the rig's namespace."""
        stop(self.process)
        rows = [line.split() for line in self.process.stdout.read().splitlines()]
        return {name.replace(self.prefix, ''): (int(received), int(missing)) for name, received, missing in rows}


class Hog:
    """So many busy loops a processor that a fair share of one is too little for the rig."""
    PER_CORE = 32

    def __init__(self):
        self.loops = [subprocess.Popen(['sh', '-c', 'while :; do :; done']) for _ in range(self.PER_CORE * os.cpu_count())]

    def end(self):
        for loop in self.loops:
            loop.kill()
        for loop in self.loops:
            loop.wait()
