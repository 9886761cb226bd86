"""Properties with Hypothesis (Python), checked through `flatdt-check --serve`.

Run by `python3 hypothesis_recipe.py`, or by pytest. A failing example is shrunk, and printed with its witness.
MY_TRIANGULATION: the command under test, which reads an instance and writes a triangulation; by default the reference.
FLATDT_CHECK: the checker, by default the one in PATH.
"""

import os
import shlex
import subprocess

from hypothesis import given, settings, strategies as st

from flatdt_service import Service, explain

COMMAND = shlex.split(os.environ.get("MY_TRIANGULATION", "flatdt triangulate --quiet -"))
SERVICE = Service(os.environ.get("FLATDT_CHECK", "flatdt-check"))

coordinates = st.fractions(0, 1, max_denominator=12)
points = st.lists(st.tuples(coordinates, coordinates), min_size=1, max_size=5)
metrics = st.tuples(st.integers(1, 4), st.integers(1, 4))


@settings(max_examples=int(os.environ.get("EXAMPLES", "60")), deadline=None, derandomize=True, database=None)
@given(st.sampled_from(["torus", "klein-bottle"]), metrics, points)
def test_triangulations_are_delaunay(manifold, metric, points):
    instance = (f"flatdt-instance 1\ndimension 2\nmanifold {manifold}\nmetric {metric[0]} 0 {metric[1]}\n"
                f"points {len(points)}\n" + "".join(f"  {x} {y}\n" for x, y in points))
    triangulation = subprocess.run(COMMAND, input=instance, capture_output=True, text=True, check=True).stdout
    witness = explain(SERVICE.check(instance, triangulation))
    assert not witness, f"{witness}\n{instance}"


if __name__ == "__main__":
    test_triangulations_are_delaunay()
    print(f"{SERVICE.requests} triangulations, all Delaunay")
    SERVICE.close()
