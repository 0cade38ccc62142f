"""Hostile solutions, and such as look for a way out: what they do when Python reads their file.

Those of HARMLESS keep all their points, and those of SPOILED spoil their own run.
"""

from classroom import LEAVES

# Before each of them.
HEADER = """
import ctypes, mmap, os, resource, shutil, signal, socket, sys, time
here = os.path.dirname(os.path.dirname(__file__))
calls = ctypes.CDLL(None, use_errno=True)

def error_of(call, *arguments):
    try:
        call(*arguments)
    except OSError as error:
        return error.errno

"""

HARMLESS = {
    "leaves a process": LEAVES,
    "starts 60 processes": """
begun = []
try:
    for _ in range(60):
        begun.append(os.fork())
        while not begun[-1]:
            time.sleep(1)
except OSError:
    pass
for process in begun:
    os.kill(process, 9)
    os.waitpid(process, 0)
assert 0 < len(begun) < 12
""",
    "prints 10 MB": "print('x' * 10**7)",
    "makes warnings errors": """
import warnings
warnings.simplefilter('error')
left_open = open(__file__)
""",
    "ignores signals": """
for number in (signal.SIGTERM, signal.SIGXCPU, signal.SIGHUP):
    signal.signal(number, signal.SIG_IGN)
""",
    "looks for a way out": """
assert calls.prctl(39, 0, 0, 0, 0) == 1  # it gets no rights
assert os.getuid() == os.getgid() == 65534
assert not [line for line in open('/proc/self/status') if line[:3] == 'Cap' and int(line[8:], 16)]
assert calls.unshare(0x10000000) == calls.unshare(0x20000) == -1
for path in ('/a', '/tmp/a', '/autograder/source/a', '/etc/passwd', '/proc/sysrq-trigger',
             '/proc/sys/kernel/core_pattern', '/sys/fs/cgroup/a', '/dev/kmsg', '/dev/mem'):
    assert error_of(open, path, 'w')
assert {int(n) for n in os.listdir('/proc') if n.isdigit()} <= {*range(1, 60)}
for name in ('CORE', 'CPU', 'FSIZE', 'NOFILE', 'NPROC'):
    assert resource.getrlimit(getattr(resource, f'RLIMIT_{name}'))[1] != resource.RLIM_INFINITY
assert not any(v for n, v in os.environ.items() if 'proxy' in n.lower())
""",
}

SPOILED = {
    "kills all": "os.kill(-1, 9)",
    "stops all": "os.kill(-1, signal.SIGSTOP)",
    "takes shared memory": """
taken = mmap.mmap(-1, 4 * 10**9)
for i in range(0, 4 * 10**9, 4096):
    taken[i] = 1
""",
    "fills its folder": """
for i in range(10):
    open(f'{here}/{i}', 'wb').write(bytes(9_000_000))
""",
    "removes all": "shutil.rmtree(here, ignore_errors=True)",
    "makes a link": "os.symlink('/dev/zero', here + '/grade.json')",
    "makes a file with holes": """
with open(here + '/grade.json', 'wb') as file:
    file.truncate(39_000_000)
os.abort()
""",
    "prints without end": """
while True:
    os.write(1, b'x' * 100_000)
""",
}
