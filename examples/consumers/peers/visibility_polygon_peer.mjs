// visibility-polygon (npm) under test, asked by `through.py --doubles`: whether a point of a target is
// in the visibility polygon of a view point, both by the library. The frame is walls too, and
// all are broken where they meet, as the library wants.

import { createInterface } from "node:readline";
import library from "visibility-polygon";

const { breakIntersections, compute, inPolygon } = library;

function answer(line) {
  const words = line.split(" ").map(Number);
  let at = 0;
  const number = () => words[at++];
  const point = () => [number(), number()];
  const list = (read) => Array.from({ length: number() }, read);

  const [[x0, y0], [x1, y1]] = [point(), point()];
  const corners = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];
  const frame = corners.map((corner, i) => [corner, corners[(i + 1) % 4]]);
  const walls = breakIntersections([...frame, ...list(() => [point(), point()])]);
  const targets = list(() => list(point));
  const seen = targets.map(() => false);
  for (const eye of list(point)) {
    const region = seen.every((yes) => yes) ? [] : compute(eye, walls);
    for (const i of targets.keys()) {
      const ends = list(point);
      seen[i] ||= ends.some((end) => inPolygon(end, region));
    }
  }
  return seen.map(Number).join(" ");
}

for await (const line of createInterface({ input: process.stdin })) console.log(answer(line));
