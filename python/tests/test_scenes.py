"""Scenes solved, references on grids, and validations of arrays."""

from __future__ import annotations

import pathlib

import numpy as np
import pytest

import sneddon
from sneddon.testing import assert_converges, assert_matches

SCENE = {
    "profile": {"f": "r^2/(2*R)", "parameters": {"R": 10.0}},
    "material": {"effective_modulus": 2.0},
    "load": {"contact_radius": 1.9},
}
A, R, MODULUS = 1.9, 10.0, 2.0
RUNS = pathlib.Path(__file__).parents[2] / "tests/data/solver_runs"


def pressure(r):
    return 2 * MODULUS / (np.pi * R) * np.sqrt(np.maximum(A**2 - r**2, 0))


def test_scenes_are_solved_from_dicts_text_and_files(tmp_path):
    scene = {**SCENE, "load": {"depth": [0.1, 0.2]}}
    found = sneddon.solve(scene)
    assert len(found) == 2 and found.valid
    assert found["F"] == pytest.approx(4 / 3 * MODULUS * np.sqrt(R) * np.array([0.1, 0.2]) ** 1.5, rel=1e-14)
    table = found.to_numpy()
    assert table.dtype.names[-1] == "valid" and table["a"] == pytest.approx(np.sqrt(R * np.array([0.1, 0.2])), rel=1e-14)
    text = '[profile]\nshape = "sphere"\nparameters = { R = "1 um" }\n[material]\nE = "70 GPa"\nnu = 0.3\n[load]\nforce = "1 uN"\n'
    path = tmp_path / "tip.toml"
    path.write_text(text)
    for own in (text, path, str(path)):
        assert sneddon.solve(own).units is not None
    pandas = pytest.importorskip("pandas")
    assert isinstance(found.to_pandas(), pandas.DataFrame)


def test_bad_scenes_say_where():
    with pytest.raises(sneddon.SneddonError) as found:
        sneddon.solve('[profile]\nf = "r^2/("\n[material]\neffective_modulus = 1\n[load]\ndepth = 1\n')
    assert "line 2" in found.value.place
    with pytest.raises(sneddon.SneddonError, match="cannot read"):
        sneddon.solve("missing.toml")
    with pytest.raises(sneddon.SneddonError):
        sneddon.solve({"profile": 3})
    with pytest.raises(TypeError):
        sneddon.solve(3)


def test_references_are_given_at_any_place():
    x = np.linspace(-3, 3, 8)
    field = sneddon.reference(SCENE, x[None, :], x[:, None])
    r = np.hypot(x[None, :], x[:, None])
    assert field.p.shape == (8, 8)
    assert (abs(field.p - pressure(r)) <= field.p_bound + 1e-15).all()
    inside = r < A
    assert field.u[inside] == pytest.approx((A**2 / R - r**2 / (2 * R))[inside], rel=1e-13)
    means = sneddon.reference(SCENE, *np.meshgrid(x, x), cells=True)
    # The force is the sum of the means over all cells.
    edge = np.linspace(-2, 2, 41)
    cells = sneddon.reference(SCENE, *np.meshgrid(edge[:-1] + 0.05, edge[:-1] + 0.05), cells=True)
    assert cells.p.sum() * 0.01 == pytest.approx(4 / 3 * MODULUS * A**3 / R, rel=1e-9)
    assert means.p.shape == (8, 8)
    with pytest.raises(sneddon.SneddonError, match="square grid"):
        sneddon.reference(SCENE, np.linspace(0, 1, 5), cells=True)


def columns(n=64, factor=1.0):
    h = 8 / n
    x = (np.arange(n) - n // 2) * h
    xs, ys = np.meshgrid(x, x)
    return {"x": xs, "y": ys, "p": factor * pressure(np.hypot(xs, ys))}


def test_data_are_validated():
    pandas = pytest.importorskip("pandas")
    good, bad = columns(), columns(factor=2.0)
    assert sneddon.validate(SCENE, good).passed
    found = sneddon.validate(SCENE, bad)
    assert not found.passed and found.suspicion
    assert "p" in found._repr_html_()
    flat = {name: own.ravel() for name, own in good.items()}
    assert sneddon.validate(SCENE, pandas.DataFrame(flat)).passed
    table = np.rec.fromarrays(list(flat.values()), names=list(flat))
    assert sneddon.validate(SCENE, table).passed
    assert sneddon.validate(SCENE, {**good, "press": good["p"], "p": 0 * good["p"]}, map={"p": "press"}).passed
    shifted = {**good, "x": good["x"] + 4, "y": good["y"] + 4}
    assert sneddon.validate(SCENE, shifted).suspicion_id == "origin-corner"
    assert sneddon.validate(SCENE, shifted, box=8.0, origin="corner").passed
    assert not sneddon.validate(SCENE, good, load="a=1.8").passed
    with pytest.raises(sneddon.SneddonError):
        sneddon.validate(SCENE, good, origin="middle")
    with pytest.raises(TypeError):
        sneddon.validate(SCENE, 3)


def test_assertions_fail_with_the_verdict():
    assert_matches(SCENE, **columns())
    with pytest.raises(AssertionError, match="failed"):
        assert_matches(SCENE, **columns(factor=1.05))
    assert_converges(SCENE, [columns(32), columns(64)], grid=[32, 64])
    with pytest.raises(AssertionError):
        assert_converges(SCENE, [columns(32, 1.02), columns(64, 1.02)], grid=[32, 64])
    with pytest.raises(TypeError):
        assert_converges(SCENE, columns())


def test_real_solver_runs_converge():
    scene = (
        '[profile]\nf = "r^2/(2*R)"\nparameters = { R = "10 um" }\n[material]\nE = "72 GPa"\nnu = 0.17\n'
        '[data]\nbox = "8 um"\ngrid = [64, 128, 256]\nboundary = "free"\n'
    )
    files = [RUNS / f"paraboloid_cm_n{n}_Fd.csv" for n in (64, 128, 256)]
    found = sneddon.validate(scene, files)
    assert found.passed and 1.5 < found.orders["F"]["value"] < 2.3
    assert not sneddon.validate(scene.replace("72", "75"), files).passed


def test_sweeps():
    xarray = pytest.importorskip("xarray")
    scene = {**SCENE, "load": {"depth": 0.1}}
    found = sneddon.sweep(scene, {"profile.parameters.R": [1.0, 4.0], "load.depth": [0.1, -1.0, 0.2]})
    assert isinstance(found, xarray.Dataset) and found["F"].shape == (2, 3)
    truth = 4 / 3 * MODULUS * 2.0 * 0.2**1.5
    assert abs(float(found["F"][1, 2]) - truth) <= float(found["F_error"][1, 2]) + 2e-16 * truth and found["F_error"][1, 2] < 2e-15 * truth
    assert found["F_proven"].values.all() and (found["k_error"].values[:, 1] == 0.0).all()
    apart = sneddon.sweep({**SCENE, "profile": {"f": "tan(r)"}}, {"load.contact_radius": [1.0, 2.0]})
    assert list(apart["F_proven"].values) == [True, False] and np.isnan(apart["F_error"].values[1]) and apart["error"].values[1]
    asked = sneddon.sweep({**scene, "outputs": {"quantities": ["U", "p_mean"]}}, {"load.depth": [0.1, 0.2]})
    assert (abs(asked["p_mean"] * np.pi * asked["a"] ** 2 / asked["F"] - 1.0) < 1e-15).all()
    truth = 8 / 15 * MODULUS * np.sqrt(10.0) * asked["load.depth"] ** 2.5
    assert (abs(asked["U"] - truth) <= asked["U_error"] + 4e-16 * truth).all() and asked["U_proven"].all()
    assert "quantities" in str(sneddon.sweep({**scene, "outputs": {"quantities": ["typo"]}}, {"load.depth": [0.1]})["error"].values[0])
    with pytest.raises(sneddon.SneddonError, match="F_error is a result of the sweep"):
        sneddon.sweep(scene, {"F_error": [1.0]})
    with pytest.raises(sneddon.SneddonError):
        sneddon.sweep(scene, {"laod.depth": [1.0]})


def test_a_fit_model_of_nanite():
    module = sneddon.nanite.model("R - sqrt(R^2 - r^2)", "sneddon_sphere", defaults={"R": 5e-6}, register=False)
    delta = np.linspace(2e-6, -2e-6, 30)
    force = module.model_func(delta, E=3e3, R=5e-6, nu=0.5, contact_point=0.0, baseline=1e-12)
    contact = sneddon.Contact("R - sqrt(R^2 - r^2)", R=5e-6, E=3e3, nu=0.5)
    expected = np.array([contact.force(depth=-own) if own < 0 else 0.0 for own in delta]) + 1e-12
    assert force == pytest.approx(expected, rel=1e-12)
    assert module.parameter_keys == ["E", "R", "nu", "contact_point", "baseline"]
    with pytest.raises(sneddon.SneddonError):
        sneddon.nanite.model("E*r^2", register=False)


def test_errors_have_a_moderate_length_and_name_the_file(tmp_path):
    """Error messages are short for any input, and do not quote a file that is not a table of points."""
    long = "n" * 20_000
    for bad in (lambda: sneddon.Profile(f"r^2/{long}").derive().g(1.0), lambda: sneddon.Contact("r^2", E_star=1.0, **{long: 1.0})):
        with pytest.raises(sneddon.SneddonError) as raised:
            bad()
        assert len(str(raised.value)) <= 300 and "n" * 20 in str(raised.value)
    scene = {"profile": {"points": "tip.csv"}, "material": {"effective_modulus": 1.0}, "load": {"depth": 0.1}}
    scene["profile"]["points"] = str(tmp_path / "tip.csv")
    (tmp_path / "tip.csv").write_text("r,z\n0,0\n1,word\n")
    with pytest.raises(sneddon.SneddonError, match=r"line 3, column 3"):
        sneddon.solve(scene)
    (tmp_path / "tip.csv").write_text("token secret and more\n1,2\n")
    with pytest.raises(sneddon.SneddonError, match=r"does not contain a column of radii") as raised:
        sneddon.solve(scene)
    assert "tip.csv" in raised.value.place and "secret" not in str(raised.value)


def test_solutions_have_a_verdict_a_reason_and_curves():
    found = sneddon.solve({**SCENE, "outputs": {"quantities": ["F", "p"], "at": [0.0, 1.0]}})
    assert (found.verdict, found.why) == ("valid", None)
    (curve,) = found.curves
    assert curve["quantity"] == "p" and [own["value"] for own in curve["points"]] == pytest.approx(pressure(np.array([0.0, 1.0])), rel=1e-14)
    again = sneddon.solve({**SCENE, "profile": {"f": "1-sin(r)/r+r^2/100"}, "load": {"contact_radius": [1.0, 3.0]}})
    assert again.verdict == "not valid" and "5.6169570" in again.why


def test_sweeps_take_points():
    scene = {**SCENE, "load": {"depth": 0.1}}
    points = [{"load.depth": 0.1, "profile.parameters.R": 5.0}, {"load.depth": 0.3, "profile.parameters.R": 10.0}]
    found = sneddon.sweep(scene, points)
    assert found["F"].dims == ("point",) and found["load.depth"].values.tolist() == [0.1, 0.3]
    d, radius = np.array([0.1, 0.3]), np.array([5.0, 10.0])
    assert found["F"].values == pytest.approx(4 / 3 * MODULUS * np.sqrt(radius) * d**1.5, rel=1e-14)
    assert sneddon.sweep(scene, [])["F"].size == 0
    assert (sneddon.sweep(scene, iter(points))["F"].values == found["F"].values).all()
    assert sneddon.sweep(scene, [{"load.depth": np.array(0.1)}])["F"].values == pytest.approx([4 / 3 * MODULUS * 10**0.5 * 0.1**1.5])
    again = sneddon.sweep({**SCENE, "load": {"contact_radius": 1.0}}, [{"profile": {"f": "1-sin(r)/r+r^2/100"}, "load.contact_radius": own} for own in (1.0, 3.0)])
    assert again["error"].values[0] == "" and "5.6169570" in again["error"].values[1]
    with pytest.raises(TypeError, match="3 is not the dotted name"):
        sneddon.sweep(scene, [{3: 4}])
    with pytest.raises(sneddon.SneddonError, match="F is a result of the sweep"):
        sneddon.sweep(scene, [{"F": 1.0}])
    with pytest.raises(sneddon.SneddonError, match="over.1"):
        sneddon.sweep(scene, [{}, points[0]])
    with pytest.raises(sneddon.SneddonError, match="over.1"):
        sneddon.sweep(scene, [points[0], {"load.depth": 0.1}])
    with pytest.raises(TypeError, match="over.0. is a int"):
        sneddon.sweep(scene, [3])
