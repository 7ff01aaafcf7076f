# SPDX-License-Identifier: BSD-3-Clause
"""What the figures were measured on."""
import datetime
import os
import platform
import subprocess

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def cpu_model():
    with open('/proc/cpuinfo') as file:
        for line in file:
            if line.startswith('model name'):
                return line.split(':')[1].strip()
    return platform.processor()


def cache_value(build, key):
    """A variable of the build's CMake cache."""
    try:
        with open(os.path.join(build, 'CMakeCache.txt')) as file:
            for line in file:
                if line.startswith(key + ':'):
                    return line.strip().split('=', 1)[1]
    except OSError:
        pass
    return ''


def describe(program):
    build = os.path.abspath(os.path.join(os.path.dirname(program), '..', '..', '..'))
    compiler = cache_value(build, 'CMAKE_CXX_COMPILER') or 'c++'
    version = subprocess.run([compiler, '--version'], stdout=subprocess.PIPE, universal_newlines=True).stdout.splitlines()
    kind = cache_value(build, 'CMAKE_BUILD_TYPE') or 'Release'
    flags = ' '.join([cache_value(build, 'CMAKE_CXX_FLAGS'), cache_value(build, 'CMAKE_CXX_FLAGS_' + kind.upper())]).strip()
    return {'cpu': cpu_model(), 'cores': os.cpu_count(), 'compiler': version[0] if version else compiler, 'build_type': kind, 'flags': flags,
            'system': platform.platform(), 'load': list(os.getloadavg()), 'date': datetime.datetime.utcnow().strftime('%Y-%m-%d %H:%M UTC')}
