"""The Python examples of README.md and of the tutorial run as they are."""

from __future__ import annotations

import pathlib
import re

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


@pytest.mark.parametrize("document", ["README.md", "docs/tutorial-python.md"])
def test_the_examples_of_a_document_run(document: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    blocks = re.findall(r"```python\n(.*?)```", (ROOT / document).read_text(encoding="utf-8"), re.DOTALL)
    assert blocks
    names: dict[str, object] = {}
    for block in blocks:
        exec(compile(block, document, "exec"), names)
    comments = re.findall(r"^(\S.*?) +# (True|'.*')$", "\n".join(blocks), re.MULTILINE)
    for expression, shown in comments:
        assert repr(eval(expression, names)) == shown, expression
