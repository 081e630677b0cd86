"""The radius of the paper's patch on a grid of 1001 x 1001 points in double precision: fast, and it proves nothing."""
from math import sqrt

import numpy as np

w, z = 0.467959158138040, 2.370695072453977
a, h, c = 1 / sqrt(3), sqrt(2) / 2, sqrt(6) / 3
net = np.array([
    [[-a, -a, a, 1], [0, -h, h, c], [a, -a, a, 1]],
    [[-h, 0, h, c], [0, 0, w * z, w], [h, 0, h, c]],
    [[-a, a, a, 1], [0, h, h, c], [a, a, a, 1]],
])
t = np.linspace(0, 1, 1001)
basis = np.stack([(1 - t) ** 2, 2 * t * (1 - t), t * t], axis=1)
x, y, z, w = (basis @ net[:, :, k] @ basis.T for k in range(4))
radius = np.sqrt(x * x + y * y + z * z) / w
print(f"{radius.min():.12f} {radius.max():.12f}")
