"""Numbers of a contact: against quadrature with 30 digits, laws, and every kind of array."""

from __future__ import annotations

import math
import pickle

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

import sneddon

SPHERE = sneddon.Contact("R - sqrt(R^2 - r^2)", R=2.0, E_star=1.5)
SMOOTH = sneddon.Contact("tanh(r)^2", E_star=1.5)


def truth(slope, key, a):
    with mpmath.workdps(30):
        if key == "g":
            return mpmath.mpf(a) * mpmath.quad(lambda t: slope(a * mpmath.sin(t)), [0, mpmath.pi / 2])
        return 3 * mpmath.quad(lambda t: (a * mpmath.sin(t)) ** 2 * slope(a * mpmath.sin(t)), [0, mpmath.pi / 2])


@pytest.mark.parametrize("contact, slope", [(SPHERE, lambda r: r / mpmath.sqrt(4 - r**2)), (SMOOTH, lambda r: 2 * mpmath.tanh(r) / mpmath.cosh(r) ** 2)])
@pytest.mark.parametrize("a", [1e-8, 0.1, 1.0, 1.9])
def test_values_are_within_their_bounds(contact, slope, a):
    for key, found in (("g", contact.depth(radius=a, with_bound=True)), ("F", contact.force(radius=a, with_bound=True))):
        assert abs(found[0] - truth(slope, key, a)) <= found[1]
        assert found[1] < 1e-11 * abs(found[0])


def test_ways_round_meet():
    a = np.linspace(0.05, 1.9, 20)
    d, force = SPHERE.depth(radius=a), SPHERE.force(radius=a)
    for found in (SPHERE.contact_radius(depth=d, with_bound=True), SPHERE.contact_radius(force=force, with_bound=True)):
        assert (abs(found[0] - a) <= found[1] + 1e-14 * a).all()
    assert SPHERE.contact_radius(force=force[3], with_bound="ground")[2] == "proven"
    value, bound = SPHERE.force(depth=d, with_bound=True)
    assert (abs(value - force) <= bound + 1e-14 * force).all()
    value, bound = SPHERE.depth(force=force, with_bound=True)
    assert (abs(value - d) <= bound + 1e-14 * d).all()


# Roots by mpmath with 40 digits.
@pytest.mark.parametrize(
    "text, values, depth, radius",
    [
        ("h*(1-exp(-r^2/w^2))", {"h": 1.0, "w": 0.1}, 1.076, 0.0999827911989952),
        ("c*(cosh(r/c)-1)", {"c": 1e-3}, 1e-6, 3.162102005203696e-5),
        ("c*(cosh(r/c)-1)", {"c": 1e-3}, 1e100, 0.23490349973997096),
        ("piecewise(0, r<b, (r-b)^2/(2*R))", {"b": 1e-6, "R": 2e-7}, 1e-9, 1.0035522722079924e-6),
        ("h*sin(pi*r/l)^2", {"h": 2e-9, "l": 5e-8}, 1e-9, 8.48662033171752e-9),
        ("-h*ln(cos(r/w))", {"h": 1e-9, "w": 1e-8}, 1e-8, 1.5152643022404682e-8),
    ],
)
def test_radii_of_humps_waves_and_ends_are_found(text, values, depth, radius):
    assert sneddon.Contact(text, E_star=1.0, **values).contact_radius(depth=depth) == pytest.approx(radius, rel=4e-15)


def test_laws():
    """F = 2π∫p r dr, dF/dd = k, U = ∫F dd, u = d - f inside, the mean pressure."""
    a, n = 1.2, 400
    node, weight = np.polynomial.legendre.leggauss(n)
    # r = a sin t takes the root at the edge away.
    t = 0.25 * np.pi * (node + 1)
    r = a * np.sin(t)
    force = 2 * np.pi * np.sum(0.25 * np.pi * weight * SPHERE.pressure(r, radius=a) * r * a * np.cos(t))
    assert force == pytest.approx(SPHERE.force(radius=a), rel=1e-10)
    d, h = SPHERE.depth(radius=a), 1e-5
    slope = (SPHERE.force(depth=d + h) - SPHERE.force(depth=d - h)) / (2 * h)
    assert slope == pytest.approx(SPHERE.stiffness(depth=d), rel=1e-8)
    work = 0.5 * d * np.sum(weight * SPHERE.force(depth=0.5 * d * (node + 1)))
    assert work == pytest.approx(SPHERE.energy(depth=d), rel=1e-6)
    inside = np.linspace(0, a, 7)
    assert SPHERE.displacement(inside, radius=a) == pytest.approx(d - SPHERE.shape(inside), rel=1e-12)
    assert SPHERE.mean_pressure(radius=a) == pytest.approx(SPHERE.force(radius=a) / (np.pi * a**2), rel=1e-15)
    assert SPHERE.stress_on_axis(1e-9, radius=a) == pytest.approx(-SPHERE.pressure(0.0, radius=a), rel=1e-6)


def test_loads_may_be_given_any_way():
    d = SPHERE.depth(radius=1.0)
    force = SPHERE.force(radius=1.0)
    r = np.linspace(0, 1.5, 6)
    for key, value in (("depth", d), ("force", force)):
        for method in (SPHERE.pressure, SPHERE.displacement):
            found, bound = method(r, **{key: value}, with_bound=True)
            assert (abs(found - method(r, radius=1.0)) <= bound + 1e-15).all()


def test_material():
    one = sneddon.Contact("r^2/(2*R)", R=1.0, E=0.91, nu=0.3)
    assert one.E_star == pytest.approx(1.0, rel=1e-15)
    for wrong in ({}, {"E": 1.0}, {"E_star": 1.0, "E": 1.0, "nu": 0.3}):
        with pytest.raises(TypeError):
            sneddon.Contact("r^2", **wrong)
    for wrong in ({"E_star": -1.0}, {"E_star": np.nan}, {"E": 1.0, "nu": 0.7}, {"E_star": 1.0, "tolerance": 2.0}, {"E_star": 1.0, "method": "guess"}):
        with pytest.raises(sneddon.SneddonError):
            sneddon.Contact("r^2", **wrong)
    with pytest.raises(TypeError):
        one.force(depth=0.1, radius=0.1)
    with pytest.raises(TypeError):
        one.force()


def test_a_cone_has_an_infinite_pressure_at_its_apex():
    cone = sneddon.Contact("r*tan(theta)", theta=0.2, E_star=1.0)
    value, bound = cone.pressure([0.0, 0.5], radius=1.0, with_bound=True)
    assert np.isinf(value[0]) and np.isfinite(value[1]) and np.isfinite(bound).all()


def test_points_outside_the_domain_are_named():
    with pytest.raises(sneddon.SneddonError, match="R|2"):
        SPHERE.force(radius=[0.5, 2.5])
    with pytest.raises(sneddon.SneddonError) as found:
        SPHERE.force(radius=np.array([[0.5, np.nan]]))
    assert found.value.place == "radius, flat index 1"
    with pytest.raises(sneddon.SneddonError):
        SPHERE.force(radius=-1.0)
    assert pickle.loads(pickle.dumps(found.value)).place == found.value.place


LAYOUTS = {
    "plain": lambda own: own,
    "reversed": lambda own: own[::-1][::-1],
    "negative stride": lambda own: np.ascontiguousarray(own[::-1])[::-1],
    "strided": lambda own: np.repeat(own, 2, axis=-1)[..., ::2],
    "fortran": np.asfortranarray,
    "big-endian": lambda own: own.astype(">f8"),
    "longdouble": lambda own: own.astype(np.longdouble),
    "misaligned": lambda own: np.frombuffer(b"\0" + own.tobytes(), dtype=np.float64, offset=1).reshape(own.shape),
    "list": lambda own: own.tolist(),
}


@pytest.mark.parametrize("layout", LAYOUTS)
@given(shape=arrays.array_shapes(min_dims=1, max_dims=3, min_side=1, max_side=4), seed=st.integers(0, 2**31))
@settings(max_examples=15, deadline=None)
def test_every_layout_gives_what_a_loop_gives(layout, shape, seed):
    a = np.random.default_rng(seed).uniform(0.01, 1.9, shape)
    loop = np.array([SPHERE.force(radius=float(own)) for own in a.flat]).reshape(shape)
    given_array = LAYOUTS[layout](a)
    found, bound = SPHERE.force(radius=given_array, with_bound=True)
    assert found.shape == shape and found.dtype == np.float64
    assert (found == loop).all() and (bound > 0).all()
    assert (SPHERE.force(radius=given_array) == loop).all()


def test_odd_arrays():
    assert isinstance(SPHERE.force(radius=0.5), float)
    assert isinstance(SPHERE.force(radius=np.float32(0.5)), float)
    assert isinstance(SPHERE.force(radius=np.array(0.5)), float)
    assert SPHERE.force(radius=1) == SPHERE.force(radius=1.0)
    assert SPHERE.force(radius=np.empty((0, 3))).shape == (0, 3)
    assert SPHERE.pressure(np.linspace(0, 1, 5)[:, None], radius=[1.0, 1.5]).shape == (5, 2)
    read_only = np.array([0.5, 1.0])
    read_only.flags.writeable = False
    assert SPHERE.force(radius=read_only).shape == (2,)
    single = np.array([0.5], dtype=np.float32)
    assert SPHERE.force(radius=single)[0] == SPHERE.force(radius=0.5)
    for wrong in (np.ma.masked_array([0.5], [True]), np.array([0.5], dtype=object), "0.5", [1j], [True], [[1.0], [1.0, 2.0]], {}):
        with pytest.raises(TypeError):
            SPHERE.force(radius=wrong)
    with pytest.raises(ValueError):
        SPHERE.pressure(np.zeros(3), radius=np.ones(2))


@given(st.one_of(st.none(), st.text(), st.binary(), st.floats(), st.integers(), st.lists(st.floats()), st.dictionaries(st.text(), st.floats())))
@settings(max_examples=100, deadline=None)
def test_whatever_is_handed_in_nothing_panics(value):
    for call in (lambda: sneddon.Profile(value), lambda: SPHERE.force(radius=value), lambda: sneddon.solve(value), lambda: sneddon.validate("", value)):
        try:
            call()
        except (TypeError, ValueError):
            pass


def test_callables_and_measured_tips():
    function = sneddon.Contact(sneddon.Profile(lambda r: r * r / 2), E_star=1.5)
    assert function.force(radius=1.0) == pytest.approx(2.0, rel=1e-9)
    kinked = sneddon.Contact(sneddon.Profile(lambda r: max(0.0, r - 0.5), kinks=[0.5]), E_star=1.0)
    exact = sneddon.Contact("max(0, r - 1/2)", E_star=1.0)
    assert kinked.force(radius=1.0) == pytest.approx(exact.force(radius=1.0), rel=1e-9)
    with pytest.raises(ZeroDivisionError):
        sneddon.Contact(sneddon.Profile(lambda r: 1 / 0), E_star=1.0)
    r = np.linspace(0, 2, 400)
    tip = sneddon.Contact(sneddon.Profile(r, r**2 / 2), E_star=1.5)
    assert tip.force(radius=1.0) == pytest.approx(2.0, rel=1e-6)
    with pytest.raises(sneddon.SneddonError):
        sneddon.Profile([0.0, 1.0], [0.0])
    with pytest.raises(sneddon.SneddonError):
        sneddon.Profile(r, r**2).derive()


def test_long_arrays_do_not_copy_more_than_they_need():
    a = np.linspace(0.01, 1.9, 300_000)
    found = SPHERE.force(radius=a)
    assert found[::50_000] == pytest.approx([SPHERE.force(radius=float(own)) for own in a[::50_000]], rel=4e-16)


def test_contacts_know_their_parameters_and_pickle():
    assert SPHERE.parameters == {"R": 2.0}
    assert sneddon.Contact(sneddon.Profile("C*r^n", n="5/2"), C=0.3, E_star=1.0).parameters == {"n": 2.5, "C": 0.3}
    r = np.linspace(0.0, 2.0, 41)
    for own in (SPHERE, sneddon.Contact((r, r * r / 4), E_star=1.5), sneddon.Contact(np.cosh, E_star=1.5)):
        assert pickle.loads(pickle.dumps(own)).force(radius=0.5) == own.force(radius=0.5)
    with pytest.raises(AttributeError):
        SPHERE.E_star = 3.0


def test_loads_are_judged():
    """1 - sin(r)/r + r²/100 touches again at r = 5.617 when a = 3; a formula, a function and a measured tip say so."""
    shape = lambda r: 1 - np.sin(r) / r + r * r / 100 if r else 0.0
    r = np.linspace(0.0, 8.0, 4001)
    for own in (
        sneddon.Contact("1-sin(r)/r+r^2/100", E_star=1.0),
        sneddon.Contact(shape, E_star=1.0),
        sneddon.Contact((r, np.array([shape(own) for own in r])), E_star=1.0),
    ):
        assert own.valid(radius=[1.0, 3.0]).tolist() == [True, False]
        d, force = own.depth(radius=1.0), own.force(radius=1.0)
        assert own.valid(depth=d) is True and own.valid(force=force) is True
    assert SPHERE.valid(depth=[0.1, 100.0]).tolist() == [True, False]
    waves = sneddon.Contact("1-sin(r)/r+r^2/100", E_star=1.0)
    assert waves.valid(radius=np.linspace(0.1, 1.0, 8)).all()
    with pytest.raises(sneddon.SneddonError, match="depth = -1"):
        SPHERE.valid(depth=-1.0)
    with pytest.raises(TypeError, match="one of depth, force, radius"):
        SPHERE.valid()


@pytest.mark.parametrize("own", [{"E_star": "1 GPa"}, {"E": 1.0, "nu": "big"}, {"E_star": 1.0, "R": "2 um"}, {"E_star": 1.0, "tolerance": "fine"}])
def test_numbers_with_units_are_refused_by_name(own):
    with pytest.raises(TypeError, match="a number such as 1.5"):
        sneddon.Contact("r^2/(2*R)", **{"R": 2.0, **own})
    with pytest.raises(sneddon.SneddonError, match="R is larger than"):
        sneddon.Contact("r^2/(2*R)", R=10**400, E_star=1.0)


def test_every_quantity_is_known_by_its_key():
    own = sneddon.Contact("r^2/4", E_star=3.0)
    a, d, force = 0.6, own.depth(radius=0.6), own.force(radius=0.6)
    named = {
        "f": own.shape(0.2),
        "g": own.equivalent_profile(0.2),
        "G": 0.2**3 / 6,
        "d": d,
        "F": force,
        "a": a,
        "k": own.stiffness(radius=a),
        "A": math.pi * a**2,
        "p_mean": own.mean_pressure(radius=a),
        "U": own.energy(radius=a),
        "p": own.pressure(0.2, radius=a),
        "u": own.displacement(0.2, radius=a),
        "sigma_zz": own.stress_on_axis(0.2, radius=a),
        "q": 3.0 * (d - 0.2**2 / 2),
        "u_1d": d - 0.2**2 / 2,
    }
    places = {"f", "g", "G", "p", "u", "sigma_zz", "q", "u_1d"}
    for load in ({"radius": a}, {"depth": d}, {"force": force}):
        itself = {"radius": "a", "depth": "d", "force": "F"}[next(iter(load))]
        for key, value in named.items():
            place = (0.2,) if key in places else ()
            if key == itself:
                with pytest.raises(TypeError, match="is the load itself"):
                    own.quantity(key, **load)
                continue
            given = {} if key in ("f", "g", "G") else load
            found, bound, ground = own.quantity(key, *place, **given, with_bound="ground")
            assert abs(found - value) <= bound + 4e-15 * abs(value) and bound <= 1e-12 * abs(value), (key, load, found, value, bound)
            assert ground == "proven", (key, load)
    with pytest.raises(sneddon.SneddonError, match="not a quantity"):
        own.quantity("P", radius=a)
    with pytest.raises(TypeError, match="p needs r"):
        own.quantity("p", radius=a)
    with pytest.raises(TypeError, match="F takes no place"):
        own.quantity("F", 0.2, radius=a)


def test_long_arrays_of_expensive_pressures_agree_with_single_ones():
    """Class "finished work is never thrown away": 200 pressures, each of which takes some 10 ms alone."""
    contact = sneddon.Contact("struveh(0,r)*r^2", E_star=1.0)
    r = np.linspace(0, 0.99, 200)
    values, bounds = contact.pressure(r, radius=1.0, with_bound=True)
    assert (bounds <= 1e-10 * values).all()
    for index in (0, 57, 199):
        value, bound = contact.pressure(float(r[index]), radius=1.0, with_bound=True)
        assert abs(values[index] - value) <= bounds[index] + bound


def test_an_array_ends_with_the_error_of_its_first_failing_entry():
    with pytest.raises(sneddon.SneddonError, match="ends at r = 2") as raised:
        SPHERE.force(radius=[0.5, 2.5, 3.5])
    assert raised.value.place == "flat index 1"
