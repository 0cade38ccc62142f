"""The loop that keeps a simulation in step with the clock on the wall."""

import time

# One picture (s): the page asks for new positions about sixty times a second.
FRAME = 1 / 60

# Ticking takes at most this much of a frame (s), so that the threads that serve the page get their turn as well.
BUSY = 0.75 * FRAME

# How far behind the clock the simulation may be (s). A hiccup up to this long is made up for; what is beyond (a slow
# machine, a laptop that slept) is dropped.
MAX_BEHIND = 0.25


def keep_real_time(tick, dt, clock=time.perf_counter, sleep=time.sleep) -> None:
    """Call tick() for ever, so often that a simulated second, of 1/dt ticks, lasts a second on the wall.

    A machine too slow for that shows slow motion. VPython's rate() can do neither: it is off by a tenth and more, and
    it waits by keeping a processor core busy. clock() and sleep(seconds) may be replaced by a test's.
    """
    simulated = clock()  # the moment on the wall clock that the simulation has reached
    while True:
        frame_start = clock()
        simulated = max(simulated, frame_start - MAX_BEHIND)
        while simulated + dt <= frame_start and clock() - frame_start < BUSY:
            tick()
            simulated += dt
        sleep(max(0, frame_start + FRAME - clock()))
