"""Prints the scores of runs as a Markdown table: `table.py NAME=score.json ...`.

A score is what `stabline vectors run --json` prints. A cell counts the cases answered well, those
with waste, and those that fail; it is empty where all were skipped.
"""

import json
import sys

WELL, WASTE = ["exact", "allowed"], ["waste"]
FAILS = ["hole", "wrong", "wrong-witness", "crash", "hang", "unreadable"]


def cell(marks):
    counts = [sum(marks.get(mark, 0) for mark in group) for group in (WELL, WASTE, FAILS)]
    return " / ".join(map(str, counts)) if any(counts) else ""


names, scores = [], []
for argument in sys.argv[1:]:
    name, path = argument.split("=", 1)
    names.append(name)
    with open(path) as file:
        scores.append(json.load(file))

print("|", " | ".join(["flag", *names]), "|")
print("|" + "---|" * (len(names) + 1))
for flag in ["all", *sorted({flag for score in scores for flag in score["by_flag"]})]:
    cells = [cell(s["all"] if flag == "all" else s["by_flag"].get(flag, {})) for s in scores]
    if any(cells):
        print("|", " | ".join([flag, *cells]), "|")
