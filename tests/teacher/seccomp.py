"""What the kernel refuses a solution: docs.kernel.org/userspace-api/seccomp_filter.html."""

import platform
import struct
from typing import NamedTuple


class Calls(NamedTuple):
    """The numbers of the kernel's calls on a processor."""

    processor: int
    # Memory that outlives a process, or that no process has (shmget, semget, msgget, memfd_create,
    # memfd_secret), keys (add_key, request_key, keyctl), namespaces (unshare, clone3), processes of
    # others (ptrace, pidfd_getfd, process_vm_writev), locks (flock), and io_uring, which makes
    # other calls past this filter
    refused: tuple[int, ...]
    by_argument: tuple[int, ...]  # clone, fcntl, mmap, socket


CALLS = {
    "x86_64": Calls(
        0xC000003E,
        refused=(29, 64, 68, 319, 447, 248, 249, 250, 272, 435, 101, 438, 311, 73, 425),
        by_argument=(56, 72, 9, 41),
    ),
    "aarch64": Calls(
        0xC00000B7,
        refused=(194, 190, 186, 279, 447, 217, 218, 219, 97, 435, 117, 438, 271, 32, 425),
        by_argument=(220, 25, 222, 198),
    ),
}


class Refused(NamedTuple):
    """Values of an argument that are refused: these bits of it, under the mask."""

    argument: int
    mask: int
    bits: int


BY_ARGUMENT = (
    Refused(0, 0x10000000, 0x10000000),  # clone: a namespace of users
    Refused(1, 0xFFFFFFFF, 1024),  # fcntl: a lease
    Refused(3, 0x21, 0x21),  # mmap: shared memory without a file
    Refused(0, 0xFFFFFFFF, 40),  # socket: to other virtual machines
)
# What an instruction of a filter does. It is (what, jump if true, jump if false, number).
LOAD = 0x20
AND = 0x54
IS = 0x15
IS_FROM = 0x35
RETURN = 0x06
OTHER_TABLE = 0x40000000  # the calls of x32 begin there
REFUSE = (RETURN, 0, 0, 0x50026)  # ENOSYS: glibc then takes clone for clone3
ALLOW = (RETURN, 0, 0, 0x7FFF0000)


def seccomp_filter() -> bytes:
    """Return the filter for this processor, b"" if its numbers are not known."""
    calls = CALLS.get(platform.machine())
    if calls is None:
        return b""
    rows = [
        (LOAD, 0, 0, 4),
        (IS, 1, 0, calls.processor),
        REFUSE,
        (LOAD, 0, 0, 0),
        (IS_FROM, 0, 1, OTHER_TABLE),
        REFUSE,
    ]
    for number in calls.refused:
        rows += [(IS, 0, 1, number), REFUSE]
    for number, refused in zip(calls.by_argument, BY_ARGUMENT, strict=True):
        rows += [
            (IS, 0, 5, number),
            (LOAD, 0, 0, 16 + 8 * refused.argument),
            (AND, 0, 0, refused.mask),
            (IS, 0, 1, refused.bits),
            REFUSE,
            ALLOW,
        ]
    return b"".join(struct.pack("HBBI", *row) for row in [*rows, ALLOW])
