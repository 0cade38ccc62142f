"""What the kernel refuses a solution: docs.kernel.org/userspace-api/seccomp_filter.html."""

import platform
import struct

# Memory that outlives a process, or that no process has (shmget, semget, msgget, memfd_create,
# memfd_secret), keys (add_key, request_key, keyctl), namespaces (unshare, clone3), processes of
# others (ptrace, pidfd_getfd, process_vm_writev), locks (flock), and io_uring, which makes other
# calls past this filter.
# Of a processor: its number, the numbers of these calls, and those of clone, fcntl, mmap and socket
CALLS = {
    "x86_64": (
        0xC000003E,
        (29, 64, 68, 319, 447, 248, 249, 250, 272, 435, 101, 438, 311, 73, 425),
        (56, 72, 9, 41),
    ),
    "aarch64": (
        0xC00000B7,
        (194, 190, 186, 279, 447, 217, 218, 219, 97, 435, 117, 438, 271, 32, 425),
        (220, 25, 222, 198),
    ),
}
# The number of an argument, a mask, and the bits of it that are refused: a namespace of users, a
# lease, shared memory without a file, a socket to other virtual machines.
BY_ARGUMENT = (
    (0, 0x10000000, 0x10000000),
    (1, 0xFFFFFFFF, 1024),
    (3, 0x21, 0x21),
    (0, 0xFFFFFFFF, 40),
)
LOAD, AND, IS, IS_FROM, RETURN = 0x20, 0x54, 0x15, 0x35, 0x06
OTHER_TABLE = 0x40000000  # the calls of x32 begin there
# ENOSYS: glibc then takes clone for clone3
REFUSE = (RETURN, 0, 0, 0x50026)
ALLOW = (RETURN, 0, 0, 0x7FFF0000)


def seccomp_filter() -> bytes:
    """Return the filter for this processor, b"" if its numbers are not known."""
    if platform.machine() not in CALLS:
        return b""
    processor, refused, by_argument = CALLS[platform.machine()]
    rows = [
        (LOAD, 0, 0, 4),
        (IS, 1, 0, processor),
        REFUSE,
        (LOAD, 0, 0, 0),
        (IS_FROM, 0, 1, OTHER_TABLE),
        REFUSE,
    ]
    for number in refused:
        rows += [(IS, 0, 1, number), REFUSE]
    for number, (argument, mask, bits) in zip(by_argument, BY_ARGUMENT, strict=True):
        rows += [
            (IS, 0, 5, number),
            (LOAD, 0, 0, 16 + 8 * argument),
            (AND, 0, 0, mask),
            (IS, 0, 1, bits),
            REFUSE,
            ALLOW,
        ]
    return b"".join(struct.pack("HBBI", *row) for row in [*rows, ALLOW])
