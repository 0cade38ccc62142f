"""The sound of the hits: how fast the fastest hit of each picture was."""

from support.cradle.motion import Motion

# m/s: a hit makes no sound up to this speed; bobs that rest on each other meet again in each tick.
SLOWEST_SOUND = 0.01


class Sound:
    """The fastest hit since the last picture with a hit to hear."""

    def __init__(self, motion: Motion):
        self.motion = motion
        self.count = 0  # of the pictures with a hit to hear
        self.speed = 0.0  # m/s: of the fastest hit in the last one of them

    def look(self) -> None:
        """Look at the hits since the last look."""
        if self.motion.loudest > SLOWEST_SOUND:
            self.count += 1
            self.speed = round(self.motion.loudest, 4)
        self.motion.loudest = 0.0

    def state(self) -> dict[str, float]:
        """Return the number of the picture, and the speed."""
        return {"count": self.count, "speed": self.speed}
