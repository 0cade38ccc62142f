"""The mouse: which bob its ray meets, and where this ray meets the plane of swing."""

from vpython import cross, dot, mag

FINGER = 1.5  # radii from a bob's centre at which a finger, or the mouse, still grabs it; panel.js knows it, too


def bob_at(bobs, place, direction) -> int | None:
    """Return the index of the foremost bob that this ray meets, or of the nearest one within FINGER radii.

    place is a point on the ray. Return None if no bob is near.
    """
    hits, near = [], []
    for number, bob in enumerate(bobs):
        radii = mag(cross(bob.pos - place, direction)) / mag(direction) / bob.radius
        if radii <= 1:
            hits.append((dot(bob.pos - place, direction), number))
        elif radii <= FINGER:
            near.append((radii, number))
    return min(hits or near)[1] if hits or near else None


def point_in_plane(place, direction):
    """Return the point where this ray meets the plane of swing, z = 0; None if it is seen from the side, as a line."""
    if abs(direction.z) <= 0.01 * mag(direction):
        return None
    return place - direction * (place.z / direction.z)
