"""The ghosts of a file on the page: they come, and they go."""

from collections.abc import Sequence

from support.cradle.settings import NextCradle
from support.files.cradle_csv import Snapshot
from support.files.ghosts import Ghosts, read_ghosts
from support.page.cradle_settings import CradleSettings
from support.page.names import State
from support.pendulum import angle_to_outwards


class GhostFile:
    """The ghosts of the last good file, or none."""

    def __init__(self, keys: Sequence[str], next_cradle: NextCradle, settings: CradleSettings):
        """Begin without ghosts; keys are a pendulum's of its angles."""
        self.keys = keys
        self.next_cradle = next_cradle
        self.settings = settings
        self.remove()

    def remove(self) -> None:
        """Remove the ghosts."""
        self.ghosts = Ghosts()
        self.mistake = ""  # in a later file, which is not taken

    def load(self, name: str, text: str) -> None:
        """Release the cradle with the ghosts of a file with this name and this text.

        It is released from their angle, if the file has one. Or show the mistake in the file.
        """
        try:
            ghosts = read_ghosts(Snapshot(name, text.encode()), self.keys)
        except ValueError as error:
            self.mistake = str(error)
        else:
            self.take(ghosts)

    def take(self, ghosts: Ghosts, with_angle: bool = True) -> None:
        """Release the cradle with these ghosts, from their angle if they have one."""
        self.ghosts = ghosts
        self.mistake = ""
        self.next_cradle.want()
        if with_angle and ghosts.angle is not None:
            self.settings.set_release_angle(0, angle_to_outwards(ghosts.angle))

    def state(self) -> State:
        """Return the names of the file, and the mistake."""
        return {"ghosts": self.ghosts.name, "mistake_in_ghosts": self.mistake}
