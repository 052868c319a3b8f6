"""Fit models of nanite and PyJibe for any profile."""

from __future__ import annotations

import types
from collections.abc import Callable
from typing import Any

import numpy as np

from ._contact import Contact
from ._errors import SneddonError
from ._numbers import float_of_number
from ._profile import Profile


def model(
    profile: Any,
    key: str = "sneddon",
    name: str | None = None,
    *,
    defaults: dict[str, float] | None = None,
    register: bool = True,
    **parameters: Any,
) -> types.ModuleType:
    """Return a module that nanite takes for a fit model, and register it where nanite is installed.

    Parameters
    ----------
    profile : Profile, or what makes one
        The tip; lengths in metres.
    key, name : str
        The model's key, and the name that is shown.
    defaults : dict
        Starting values of the parameters that the profile leaves open, each of them; they are fixed until ``vary`` is set.
    register : bool
        Whether nanite is told of it.
    **parameters
        Values of parameters that are no parameters of the fit.

    Returns
    -------
    module
        With ``model_func``, ``get_parameter_defaults`` and the other names of nanite's documented extension point.

    Notes
    -----
    The indentation is ``contact_point - delta``, as in nanite; the force before the contact is the baseline.
    A depth that the profile does not reach gives NaN.
    """
    shape = Profile(profile, **parameters)
    free = shape.parameters
    reserved = {"E", "nu", "contact_point", "baseline", "delta"}
    for own in free:
        if own in reserved:
            raise SneddonError(f"the parameter {own} has the name of a parameter of the fit", f"parameter {own}", "another name is accepted")
    values: dict[str, float] = {}
    for own, value in (defaults or {}).items():
        if own not in free:
            raise SneddonError(f"the profile has no open parameter {own}", f"defaults, {own}")
        values[own] = float_of_number(own, value)
        if not (values[own] > 0.0 and np.isfinite(values[own])):
            raise SneddonError(f"{own} = {values[own]} is not positive and finite", f"defaults, {own}")
    for own in free:
        if own not in values:
            help_text = f"set it in SI units (angles in radians): defaults={{'{own}': ...}} for a fit parameter, {own}=... for a known value"
            raise SneddonError(f"the parameter {own} has no starting value", f"defaults, {own}", help_text)
    contacts: dict[tuple[float, ...], Contact] = {}

    def contact(numbers: tuple[float, ...]) -> Contact:
        if numbers not in contacts:
            if len(contacts) > 100:
                contacts.clear()
            given: dict[str, Any] = dict(zip(free, numbers))
            contacts[numbers] = Contact(shape, E_star=1.0, **given)
        return contacts[numbers]

    def get_parameter_defaults() -> Any:
        """Return the default parameters of the model."""
        import lmfit

        params = lmfit.Parameters()
        params.add("E", value=3e3, min=0)
        for own, value in values.items():
            params.add(own, value=value, min=1e-12, vary=False)
        params.add("nu", value=0.5, min=0, max=0.5, vary=False)
        params.add("contact_point", value=0)
        params.add("baseline", value=0)
        return params

    def force(delta: Any, E: float, *numbers: float, nu: float = 0.5, contact_point: float = 0.0, baseline: float = 0.0) -> Any:
        depth = contact_point - np.asarray(delta, dtype=float)
        found = np.zeros_like(depth)
        inside = depth > 0.0
        own = contact(tuple(float(value) for value in numbers))
        try:
            found[inside] = own.force(depth=depth[inside])
        except SneddonError:
            found[inside] = [_force(own, value) for value in depth[inside]]
        return E / (1.0 - nu**2) * found + baseline

    module = types.ModuleType(f"sneddon_nanite_{key}")
    module.__dict__.update(
        model_func=_named(free, force),
        get_parameter_defaults=get_parameter_defaults,
        model_doc=f"Force of an indenter with the shape {shape!r}.",
        model_key=key,
        model_name=name or key,
        parameter_keys=["E", *free, "nu", "contact_point", "baseline"],
        parameter_names=["Young's Modulus", *free, "Poisson's Ratio", "Contact Point", "Force Baseline"],
        parameter_units=["Pa", *("SI" for _ in free), "", "m", "N"],
        valid_axes_x=["tip position"],
        valid_axes_y=["force"],
    )
    module.__doc__ = module.__dict__["model_doc"]
    if register:
        try:
            from nanite.model import register_model
        except ImportError:
            return module
        register_model(module)
    return module


def _force(contact: Contact, depth: float) -> float:
    try:
        return float(contact.force(depth=float(depth)))
    except SneddonError:
        return float("nan")


def _named(free: list[str], force: Callable[..., Any]) -> Callable[..., Any]:
    """Return the function with the arguments that nanite reads from its signature."""
    import inspect

    def model_func(*arguments: Any, **keywords: Any) -> Any:
        bound = signature.bind(*arguments, **keywords)
        bound.apply_defaults()
        own = bound.arguments
        return force(
            own["delta"],
            own["E"],
            *(own[name] for name in free),
            nu=own["nu"],
            contact_point=own["contact_point"],
            baseline=own["baseline"],
        )

    kind = inspect.Parameter.POSITIONAL_OR_KEYWORD
    names = [inspect.Parameter(own, kind) for own in ["delta", "E", *free, "nu"]]
    names += [inspect.Parameter(own, kind, default=0.0) for own in ("contact_point", "baseline")]
    signature = inspect.Signature(names)
    model_func.__signature__ = signature  # type: ignore[attr-defined]
    model_func.__doc__ = "Force of an indenter [N] over the tip position [m]."
    return model_func
