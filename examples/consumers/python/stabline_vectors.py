"""Loads test vectors (stabline-vectors/1), and judges answers. Standard library only."""

import json
from fractions import Fraction
from pathlib import Path


def cases(folder, kinds=None):
    """Yields (file name, case, test): the case as a program gets it, the test with its answer."""
    for path in sorted(Path(folder).glob("*.json")):
        vectors = json.loads(path.read_text())
        if vectors["format"] != "stabline-vectors/1":
            raise ValueError(f"{path}: not stabline-vectors/1")
        for group in vectors["groups"]:
            if kinds and group["kind"] not in kinds:
                continue
            for test in group["tests"]:
                yield path.name, case_of(group, test), test


def case_of(group, test):
    """The question of a test."""
    scene = group.get("scene", {}).get("input")
    given = test.get("input")
    case = {key: test[key] for key in ("tcId", "comment", "flags", "from", "to") if key in test}
    case["kind"] = group["kind"]
    if scene is not None and given is not None:
        case["input"] = {**given, "scene": scene}
    else:
        case["input"] = given if scene is None else scene
    return case


def number(value):
    """A coordinate, exactly: an integer or a string such as "7/3"."""
    return Fraction(value)


def judge(test, seen, policy="any"):
    """The mark of a yes or no about a pair: "exact", "allowed", "waste" or "hole"."""
    truth = test["class"]
    if truth == "grazing":
        if policy == "any":
            return "allowed"
        return "exact" if seen == (policy == "closed") else ("waste" if seen else "hole")
    if seen == (truth == "open"):
        return "exact"
    return "waste" if seen else "hole"
