"""pytest, one test a case: `pytest examples/consumers/python`. Replace `sees` by your own."""

from pathlib import Path
import pytest
from float_consumer import sees
from stabline_vectors import cases, judge

VECTORS = Path(__file__).resolve().parents[3] / "vectors"
POLICY = "any"


def name(entry):
    file, case, _ = entry
    return f"{file}-{case['tcId']}-{'-'.join(case['flags'])}"


@pytest.mark.parametrize("entry", list(cases(VECTORS, {"sequence", "graph"})), ids=name)
def test_no_hole(entry):
    _, case, test = entry
    seen = sees(case)
    if seen is None:
        pytest.skip("the plane only")
    assert judge(test, seen, POLICY) != "hole", test["comment"]
