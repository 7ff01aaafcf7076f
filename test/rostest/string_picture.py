# SPDX-License-Identifier: BSD-3-Clause
"""What a picture of the display Drillstring holds, told by colours: what the tests of rviz with it share."""


def is_string(r, g, b):
    """Viridis, shaded: purple, teal, green, yellow."""
    purple, green, yellow = b > 1.5 * g and 0.7 * g < r < 1.5 * g, g > 1.4 * r and not is_bit(r, g, b), b < 0.35 * g and 0.6 * g < r < 1.2 * g
    return max(r, g, b) > 60 and (purple or green or yellow)


def is_bit(r, g, b):
    """Blue with half as much green, shaded."""
    return b > 70 and b > 1.5 * g and g > 2 * r and g > 30


def is_wall(r, g, b):
    """Tan, more of it than the dark band of rock behind."""
    return 85 < r < 170 and r > 1.2 * g and g > 1.2 * b and b > 0.35 * r


def is_force(r, g, b):
    return r > 60 and b > 0.8 * r and r > 2.5 * g


def is_writing(r, g, b):
    return min(r, g, b) > 190 and max(r, g, b) - min(r, g, b) < 25


def measured(picture):
    return {"string": picture.count(is_string), "bit": picture.count(is_bit), "wall": picture.count(is_wall), "force": picture.count(is_force),
            "writing": picture.count(is_writing)}


def all_seen(seen):
    return seen["string"] > 3000 and seen["bit"] > 100 and seen["wall"] > 3000 and seen["force"] > 50 and seen["writing"] > 100
