"""A boundary-element solver: rigid indenters on an elastic half-space with E* = 1, under a given depth.

Pixels are squares with a constant pressure, whose displacements are Love's; the convolution is done by FFT on twice the grid, without images.
The pressures are found by conjugate gradients with p >= 0 (Polonsky and Keer, Wear 231, 206, 1999).
"""
import numpy as np


class Solver:
    """A square of n x n pixels with the side `side`; `axis` is the part of a pixel by which the axis lies beside the centre of a pixel."""

    def __init__(self, n, side, axis):
        self.n, self.h = n, side / n
        self.x = (np.arange(n) - n // 2 + axis) * self.h
        self.r = np.hypot(*np.meshgrid(self.x, self.x))
        far = np.arange(-n, n) * self.h
        x, y = np.meshgrid(far, far, indexing="ij")
        half = self.h / 2
        corner = lambda x, y: x * np.arcsinh(y / np.abs(x)) + y * np.arcsinh(x / np.abs(y))
        love = corner(x + half, y + half) - corner(x - half, y + half) - corner(x + half, y - half) + corner(x - half, y - half)
        self.kernel = np.fft.rfft2(np.fft.ifftshift(love / np.pi))

    def displacement(self, p):
        """Returns the displacement of every pixel under the pressures p."""
        n = self.n
        wide = np.zeros((2 * n, 2 * n))
        wide[:n, :n] = p
        return np.fft.irfft2(np.fft.rfft2(wide) * self.kernel, s=(2 * n, 2 * n))[:n, :n]

    def pressures(self, shape, depth, start=None, tolerance=1e-9):
        """Returns the pressures under an indenter whose heights are `shape`, infinite where there is none."""
        wanted = depth - np.where(np.isinf(shape), 1e6, shape)
        p = np.maximum(wanted, 0) if start is None else start.copy()
        step, norm, keep = np.zeros_like(p), 1.0, 0.0
        for _ in range(2000):
            gap = self.displacement(p) - wanted
            touching = p > 0 if (p > 0).any() else wanted > 0
            before, norm = norm, (gap[touching] ** 2).sum()
            if norm == 0:
                return p
            step = np.where(touching, -gap + keep * norm / before * step, 0)
            response = self.displacement(step)
            length = -(gap[touching] * step[touching]).sum() / (response[touching] * step[touching]).sum()
            new = np.maximum(p + length * step, 0)
            joins = (new == 0) & (gap < 0) & ~np.isinf(shape)
            new[joins] = -length * gap[joins]
            keep = 0.0 if joins.any() else 1.0
            change, p = np.abs(new - p).sum() / new.sum(), new
            if change < tolerance:
                return p
        raise ArithmeticError("the pressures do not converge")
