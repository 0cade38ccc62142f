"""Hostile solutions: what they do when Python reads their file."""

from classroom import LEAVES

# Before each of them.
HEADER = """
import ctypes, fcntl, mmap, os, shutil, signal, socket, sys, threading, time
here = os.path.dirname(os.path.dirname(__file__))
calls = ctypes.CDLL(None)

def error_of(call, *arguments):
    try:
        call(*arguments)
    except OSError as error:
        return error.errno

"""

# These keep all their points,
HARMLESS = {
    "leaves a process": LEAVES,
    "starts 60 processes": """
begun = []
try:
    for _ in range(60):
        begun.append(os.fork())
        while not begun[-1]:
            pass
except OSError:
    pass
for process in begun:
    os.kill(process, 9)
    os.waitpid(process, 0)
assert 0 < len(begun) < 8
""",
    "prints 10 MB": "print('x' * 10**7)",
    "closes the output": "sys.stdout.close()\nsys.stderr.close()",
    "makes warnings errors": """
import warnings
warnings.simplefilter('error')
left_open = open(__file__)
""",
    "makes deep folders": """
os.chdir(here)
for _ in range(2100):  # longer than a path can be
    os.mkdir('a')
    os.chdir('a')
os.chdir(here)
""",
    "gets no rights": "assert sys.platform != 'linux' or calls.prctl(39, 0, 0, 0, 0) == 1",
    "takes rights away": """
os.mkdir(here + '/a')
os.chmod(here + '/a', 0)
os.chmod(here + '/src', 0o500)
""",
}

# what is tried in vain in bubblewrap, by one of them,
BOXED = {
    "takes shared memory": "assert calls.shmget(0, 10**6, 0o1666) == -1",
    "takes memory in a file": "assert error_of(os.memfd_create, 'a')",
    "takes memory without a file": "assert error_of(mmap.mmap, -1, 9)",
    "takes zeros": "assert not os.path.exists('/dev/zero')",
    "calls in a ring": "assert calls.syscall(425, 1, ctypes.create_string_buffer(120)) == -1",
    "reads keys": """
number = 250 if os.uname().machine == 'x86_64' else 219
assert calls.syscall(number, 0, -4, 1) == -1
""",
    "locks": "assert error_of(fcntl.flock, open('/one_run.py'), fcntl.LOCK_EX)",
    "leases": "assert error_of(fcntl.fcntl, open(__file__), 1024, 1) == 38",
    "attaches": "assert calls.ptrace(16, 1, 0, 0) == -1",
    "calls machines": "assert error_of(socket.socket, 40, 1)",
    "makes namespaces": "assert calls.unshare(0x10000000) == -1",
}

# and these spoil their own run.
SPOILED = {
    "kills its parent": "os.kill(os.getppid(), 9)",
    "stops its parent": "os.kill(os.getppid(), signal.SIGSTOP)",
    "forks": """
while True:
    try:
        os.fork()
    except OSError:
        time.sleep(0.01)  # or all others would wait for it
""",
    "starts threads": """
while True:
    threading.Thread(target=time.sleep, args=(300,)).start()
""",
    "takes memory": """
rows = [0]
while True:
    rows += rows
""",
    "fills its folder": """
for i in range(10):
    open(f'{here}/{i}', 'wb').write(bytes(9_000_000))
""",
    "removes all": "shutil.rmtree(here, ignore_errors=True)",
    "makes a pipe": "os.mkfifo(here + '/grade.json')",
    "makes a link": "os.symlink('/dev/zero', here + '/grade.json')",
    "prints without end": """
while True:
    os.write(1, b'x' * 100_000)
""",
    "ends at once": "os.abort()",
}
