"""A contact with numbers."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from ._arrays import WithBound, check_with_bound, ground_of, map_over, real
from ._errors import SneddonError
from ._numbers import float_of_number, merged
from ._profile import Profile
from ._sneddon import quantities

_LOADS = ("depth", "force", "radius")


class Contact:
    """A rigid axisymmetric indenter pressed into an elastic half-space without friction and adhesion.

    Parameters
    ----------
    profile : Profile, or what makes one
        The shape of the indenter.
    E_star : float
        The effective modulus E*; or ``E`` and ``nu``, Young's modulus and Poisson's ratio of the half-space, E* = E/(1 - nu²).
    tolerance : float
        The relative tolerance of quadratures.
    method : {"auto", "exact", "quadrature"}
        How numbers are computed.
    parameters : mapping, optional
        Values of parameters by name; needed for names that are also arguments, such as ``nu``.
    **values : float
        The parameters that the profile leaves open.

    Notes
    -----
    Lengths, forces and moduli may have any consistent units.
    Every method takes numbers or arrays and broadcasts them; scalars give floats.
    ``with_bound=True`` returns a pair: values, and bounds of their errors; ``with_bound="ground"`` also returns what each bound
    rests on, ``"proven"`` or ``"estimated"``.
    A pressure that is theoretically infinite is infinite, with the bound 0.

    Examples
    --------
    >>> contact = Contact("r^2/(2*R)", R=2.0, E_star=1.5)
    >>> contact.depth(radius=0.5)
    0.125
    """

    def __init__(
        self,
        /,
        profile: Any,
        *,
        E_star: float | None = None,  # noqa: N803
        E: float | None = None,  # noqa: N803
        nu: float | None = None,
        tolerance: float = 1e-13,
        method: str = "auto",
        parameters: Mapping[str, Any] | None = None,
        **values: Any,
    ) -> None:
        values = merged(parameters, values)
        if not isinstance(profile, Profile):
            profile = Profile(profile)
        if E_star is None:
            if E is None or nu is None:
                raise TypeError("a contact needs E_star, or E and nu")
            E, nu = float_of_number("E", E), float_of_number("nu", nu)
            if not -1.0 <= nu <= 0.5:
                raise SneddonError(f"nu = {nu} is not a Poisson's ratio", "nu", "numbers from -1 to 0.5 are accepted")
            if nu == -1.0:
                raise SneddonError("nu = -1 makes the half-space rigid", "nu", "a larger number is accepted")
            E_star = E / ((1.0 - nu) * (1.0 + nu))
        elif E is not None or nu is not None:
            raise TypeError("a contact takes E_star, or E and nu, not both")
        E_star, tolerance = float_of_number("E_star", E_star), float_of_number("tolerance", tolerance)
        if not (E_star > 0.0 and np.isfinite(E_star)):
            raise SneddonError(f"E_star = {E_star} is not positive and finite", "E_star")
        if not 0.0 < tolerance < 1.0:
            raise SneddonError(f"tolerance = {tolerance} is not between 0 and 1", "tolerance")
        self.profile = profile
        self._modulus = E_star
        self._own = values
        self._how = method, tolerance
        self._engine = profile.engine(values, E_star, method, tolerance)

    def __repr__(self) -> str:
        return f"Contact({self.profile!r}, E_star={self.E_star!r})"

    def __getstate__(self) -> dict[str, Any]:
        return {key: own for key, own in self.__dict__.items() if key != "_engine"}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._engine = self.profile.engine(self._own, self.E_star, *self._how)

    @property
    def E_star(self) -> float:  # noqa: N802
        """The effective modulus."""
        return self._modulus

    @property
    def parameters(self) -> dict[str, float]:
        """The values of all parameters of the profile."""
        known: dict[str, float] = self.profile.numbers(self._own)
        return known

    def valid(self, *, depth: Any = None, force: Any = None, radius: Any = None) -> Any:
        """Return whether a contact belongs to each load whose pressure and gap are nowhere negative; ``sneddon.solve`` says why not.

        A load whose contact radius cannot be told, as next to the end of a sphere, has none.
        Formulas are proven where enclosures suffice; functions, and formulas without a proof, are looked at at many radii, between which
        a narrow groove may lie.
        """
        name, value = _one(depth=depth, force=force, radius=radius)
        loads = real(name, value)
        found = np.array(self._engine.valid(name, np.ascontiguousarray(loads).reshape(-1)), dtype=np.bool_)
        return found.reshape(loads.shape) if loads.shape else bool(found[0])

    def shape(self, r: Any, *, with_bound: WithBound = False) -> Any:
        """Return f(r) - f(0)."""
        return self._map("f", {"r": r}, with_bound)

    def equivalent_profile(self, x: Any, *, with_bound: WithBound = False) -> Any:
        """Return g(x) = x ∫₀ˣ f′(r)/√(x² − r²) dr, Popov and Heß (3.27)."""
        return self._map("g", {"x": x}, with_bound)

    def force(self, *, depth: Any = None, radius: Any = None, with_bound: WithBound = False) -> Any:
        """Return the normal force F, Popov and Heß (3.22), at a depth or a contact radius."""
        name, value = _one(depth=depth, radius=radius)
        return self._map("F" if name == "radius" else "F_of_d", {name: value}, with_bound)

    def depth(self, *, force: Any = None, radius: Any = None, with_bound: WithBound = False) -> Any:
        """Return the indentation depth d = g(a), Popov and Heß (3.26), at a force or a contact radius."""
        name, value = _one(force=force, radius=radius)
        return self._map("d" if name == "radius" else "d_of_F", {name: value}, with_bound)

    def contact_radius(self, *, force: Any = None, depth: Any = None, with_bound: WithBound = False) -> Any:
        """Return the contact radius a at a force or a depth."""
        name, value = _one(force=force, depth=depth)
        return self._map("a_of_d" if name == "depth" else "a_of_F", {name: value}, with_bound)

    def stiffness(self, *, depth: Any = None, force: Any = None, radius: Any = None, with_bound: WithBound = False) -> Any:
        """Return k = dF/dd = 2 E* a, Popov and Heß (3.1)."""
        return self._at("k", _one(depth=depth, force=force, radius=radius), with_bound)

    def energy(self, *, depth: Any = None, force: Any = None, radius: Any = None, with_bound: WithBound = False) -> Any:
        """Return the strain energy U = ∫ F dd."""
        return self._at("U", _one(depth=depth, force=force, radius=radius), with_bound)

    def mean_pressure(self, *, depth: Any = None, force: Any = None, radius: Any = None, with_bound: WithBound = False) -> Any:
        """Return F/(π a²)."""
        return self._at("p_mean", _one(depth=depth, force=force, radius=radius), with_bound)

    def pressure(self, r: Any, *, depth: Any = None, force: Any = None, radius: Any = None, with_bound: WithBound = False) -> Any:
        """Return the pressure p(r) = −σ_zz, Popov and Heß (3.37); it is 0 outside the contact."""
        return self._field("p", "r", r, _one(depth=depth, force=force, radius=radius), with_bound)

    def displacement(self, r: Any, *, depth: Any = None, force: Any = None, radius: Any = None, with_bound: WithBound = False) -> Any:
        """Return the displacement u(r) of the surface, positive into the half-space."""
        return self._field("u", "r", r, _one(depth=depth, force=force, radius=radius), with_bound)

    def stress_on_axis(self, z: Any, *, depth: Any = None, force: Any = None, radius: Any = None, with_bound: WithBound = False) -> Any:
        """Return σ_zz on the axis at the depth z below the surface; it is negative in compression."""
        return self._field("sigma_zz", "z", z, _one(depth=depth, force=force, radius=radius), with_bound)

    def quantity(
        self,
        key: str,
        place: Any = None,
        *,
        depth: Any = None,
        force: Any = None,
        radius: Any = None,
        with_bound: WithBound = False,
    ) -> Any:
        """Return a quantity by its key, one of ``f g G d F a k A p_mean U p u sigma_zz q u_1d``.

        Parameters
        ----------
        key : str
            The key, as in ``sneddon eval --quantity``.
        place : array_like
            r, x or z for what has values at places.
        depth, force, radius : array_like
            The load, one of them, for everything but f, g and G.
        with_bound : bool or "ground"
            Whether to return the error bounds beside the values, and what these rest on.

        Raises
        ------
        SneddonError
            For an unknown key.
        """
        kind, coordinate = _KINDS.get(key, (None, ""))
        if kind is None:
            raise SneddonError(f"{key} is not a quantity", "key", f"expected one of {', '.join(_KINDS)}")
        if (place is None) != (kind == "number"):
            raise TypeError(f"{key} needs {coordinate}" if place is None else f"{key} takes no place")
        if kind == "shape":
            return self._map(key, {coordinate: place}, with_bound)
        load = _one(depth=depth, force=force, radius=radius)
        if kind == "field":
            return self._field(key, coordinate, place, load, with_bound)
        by_load = {("a", "depth"): "a", ("a", "force"): "a_of_F", ("d", "force"): "d_of_F", ("F", "depth"): "F_of_d"}
        if (key, load[0]) in by_load:
            return self._map(by_load[key, load[0]], {load[0]: load[1]}, with_bound)
        if key in ("a", "F", "d") and load[0] == {"a": "radius", "F": "force", "d": "depth"}[key]:
            raise TypeError(f"{key} is the load itself")
        return self._at(key, load, with_bound)

    def _map(self, key: str, arguments: dict[str, Any], with_bound: WithBound) -> Any:
        return map_over(self._engine.one, self._engine.many, key, arguments, with_bound)

    def _at(self, key: str, load: tuple[str, Any], with_bound: WithBound) -> Any:
        if load[0] == "radius":
            return self._map(key, {"radius": load[1]}, with_bound)
        return self._through(lambda a: self._map(key, {"radius": a}, "ground"), load, with_bound)

    def _field(self, key: str, name: str, place: Any, load: tuple[str, Any], with_bound: WithBound) -> Any:
        if load[0] == "radius":
            return self._map(key, {name: place, "radius": load[1]}, with_bound)
        return self._through(lambda a: self._map(key, {name: place, "radius": a}, "ground"), load, with_bound)

    def _through(self, quantity: Any, load: tuple[str, Any], with_bound: WithBound) -> Any:
        """Evaluate a quantity at the radius of a load; what it changes within the radius's error is added to its own bound."""
        name, value = load
        a, error, ground = self._map("a_of_d" if name == "depth" else "a_of_F", {name: value}, "ground")
        found, bound, own_ground = quantity(a)
        if check_with_bound(with_bound) is False:
            return found
        below, below_bound, _ = quantity(np.maximum(real("radius", a) - error, 0.0))
        moved = abs(below - found) + below_bound
        try:
            above, above_bound, _ = quantity(real("radius", a) + error)
            moved = np.maximum(moved, abs(above - found) + above_bound)
        except SneddonError:
            # Next to the end of the profile there is one side only.
            moved = 2.0 * moved
        moved = np.where(np.isfinite(found), moved, 0.0)
        total = bound + moved
        total = float(total) if np.ndim(total) == 0 and np.ndim(found) == 0 else total
        if with_bound is True:
            return found, total
        proven = np.logical_and(np.asarray(ground) == "proven", np.asarray(own_ground) == "proven")
        return found, total, ground_of(bool(proven) if proven.ndim == 0 else proven)


# What each quantity is a function of, and the name of its coordinate.
_KINDS = {key: (kind, coordinate) for key, kind, coordinate, _ in quantities() if kind != "inverse"}


def _one(**loads: Any) -> tuple[str, Any]:
    given = [(name, value) for name, value in loads.items() if value is not None]
    if len(given) != 1:
        raise TypeError(f"one of {', '.join(loads)} is needed, and {len(given)} are given")
    return given[0]
