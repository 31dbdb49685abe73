"""Rotations as unit quaternions, for libraries that want them."""
import math


def quaternion(rotation):
    """x, y, z, w of a rotation, 3 rows of 3 (Shepperd, J. Guidance and Control 1(3), 1978, 223). Numpy would take longer."""
    (a, b, c), (d, e, f), (g, h, i) = rotation
    fours = [1 + a - e - i, 1 - a + e - i, 1 - a - e + i, 1 + a + e + i]  # 4 x^2, 4 y^2, 4 z^2, 4 w^2
    largest = max(range(4), key=fours.__getitem__)
    products = [[fours[0], b + d, c + g, h - f], [b + d, fours[1], f + h, c - g], [c + g, f + h, fours[2], d - b],
                [h - f, c - g, d - b, fours[3]]]  # 4 times that with each other
    scale = 0.5 / math.sqrt(fours[largest])
    return [scale * product for product in products[largest]]
