"""Writes tests/data/periodic_boxes.csv: pressures of tips in small periodic boxes, by tamaas (E* = 1, contact radius 1 on a free half-space).

The axis lies at the centre of 64 x 64 pixels. By symmetry, only pixels with 0 <= j <= i < 32, counted from the axis, are written.
Usage: python3 periodic_boxes.py > ../data/periodic_boxes.csv
"""

import math

import numpy as np
import tamaas as tm

COUNT = 64
# f and F/2 = int_0^1 (g(1) - g(x)) dx of each tip at a = 1.
TIPS = {
    "cone": (lambda r: 0.2 * r, 0.2 * math.pi / 4),
    "paraboloid": (lambda r: r * r / 20, 1 / 15),
    "quartic": (lambda r: 0.05 * r**4, 0.05 * 8 / 3 * 4 / 5),
}


def main():
    tm.set_log_level(tm.LogLevel.error)
    print("tip,side,i,j,p")
    for name, (shape, half) in TIPS.items():
        for side in (2.05, 3.0):
            pixel = side / COUNT
            x = (np.arange(COUNT) - COUNT // 2 + 0.5) * pixel
            heights = shape(np.hypot(*np.meshgrid(x, x)))
            model = tm.ModelFactory.createModel(tm.model_type.basic_2d, [side, side], [COUNT, COUNT])
            model.E, model.nu = 1.0, 0.0
            solver = tm.PolonskyKeerRey(model, np.ascontiguousarray(-heights), 1e-12)
            solver.max_iter = 5000
            solver.solve(2 * half / side**2)
            p = np.array(model.traction).reshape(COUNT, COUNT)
            middle = COUNT // 2
            for i in range(middle):
                for j in range(i + 1):
                    print(f"{name},{side},{i},{j},{p[middle + i, middle + j]:.6g}")


main()
