"""Writes tests/data/arrays: exact results of a paraboloid (E* = 2, R = 10) in NumPy's formats, as NumPy itself writes them."""

from pathlib import Path

import numpy as np

PLACE = Path(__file__).parent.parent / "data" / "arrays"
MODULUS, RADIUS, SIDE, A = 2.0, 10.0, 8.0, 1.9


def pressure(x, y):
    inside = np.maximum(A**2 - x[None, :] ** 2 - y[:, None] ** 2, 0.0)
    return 2 * MODULUS / (np.pi * RADIUS) * np.sqrt(inside)


a = np.linspace(0.8, 1.9, 12)
d, F = a**2 / RADIUS, 4 / 3 * MODULUS * a**3 / RADIUS
np.savez_compressed(PLACE / "loads.npz", d=d, F=F.astype(">f8"), area=np.pi * a**2, steps=np.arange(12))
np.savez(PLACE / "table.npz", np.asfortranarray(np.column_stack([d, F, a])))
rows = np.zeros(12, dtype=[("depth", "<f8"), ("load", "<f4")])
rows["depth"], rows["load"] = d, F
np.save(PLACE / "rows.npy", rows)
np.savetxt(PLACE / "blanks.txt", np.column_stack([d, F, a]), header="d, F, a")
np.savetxt(PLACE / "nameless.txt", np.column_stack([F, d]))
n = 40
pixel = (np.arange(n) - n // 2) * SIDE / n
between = pixel + 0.5 * SIDE / n
corner = np.arange(n) * SIDE / n
np.save(PLACE / "press.npy", pressure(pixel, pixel).astype("<f4"))
np.save(PLACE / "between.npy", pressure(between, between).astype("<f4"))
np.savez_compressed(PLACE / "corner.npz", x=corner, y=corner, p=pressure(pixel, pixel).astype("<f4"), p_unit="")
