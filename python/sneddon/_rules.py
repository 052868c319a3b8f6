"""The catalogue of exact rules."""

from __future__ import annotations

import json
from typing import Any

from . import _sneddon


def rules() -> list[dict[str, Any]]:
    """Return the rules by which terms are closed: ``id``, ``title``, ``pattern``, ``result``, ``guard``, ``source``."""
    document = json.loads(_sneddon.rules())
    found: list[dict[str, Any]] = document["rules"] if isinstance(document, dict) else document
    return found
