"""The same pictures in numbers that no machine word holds, for what a checker computes with integers of any size."""

from flatgeom import F, Instance, apply

DENOMINATOR = 3 ** 50  # of 80 bits


def with_points(instance, points):
    return Instance(instance.dim, points, instance.manifold, instance.generators, instance.metric)


def far(instance, tri):
    """All points moved by one vector, about -2/3 along each axis that every linear part keeps: for R v = v the elements
    g of the cells commute with it, g(p + v) = gp + v, so the picture is congruent, ties included, and some points leave
    the unit cell to the negative side."""
    step = (F(-2 * 3 ** 49 - 1, DENOMINATOR),) * instance.dim
    linear = [(g[0], (F(0),) * instance.dim) for g in instance.group().reps.values()]
    v = tuple(sum(x) / len(linear) for x in zip(*(apply(r, step) for r in linear)))
    assert any(v), "no direction is kept"
    return with_points(instance, [tuple(a + b for a, b in zip(p, v)) for p in instance.points]), tri


def apart(instance, tri):
    """Each coordinate moved by less than 10^-24, to a denominator of its own: for pictures without near ties."""
    k, points = 0, []
    for p in instance.points:
        points.append(tuple(x + F(1, 10 ** 24 + 7 * (k + i) + 1) for i, x in enumerate(p)))
        k += instance.dim
    return with_points(instance, points), tri


def coprime(instance, tri):
    """Each coordinate moved by less than 2^-33, to a denominator that fits a machine word, the very last to another one. Their
    common multiple does not fit; modulo 2^64 it is small."""
    a, b = 2 ** 33 + 1, 2 ** 33 + 3
    assert a * b >= 2 ** 64 and a * b % 2 ** 64 < 2 ** 36
    points = [[F(round(x * a), a) for x in p] for p in instance.points]
    points[-1][-1] = F(round(instance.points[-1][-1] * b), b)
    return with_points(instance, list(map(tuple, points))), tri
