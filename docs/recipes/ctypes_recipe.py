"""The checker as a shared library, from Python by ctypes: checks two files, or shows what a list of cells lacks.

    python3 ctypes_recipe.py INSTANCE TRIANGULATION     exit code as flatdt-check
    python3 ctypes_recipe.py                            a small example, built piece by piece
FLATDT_LIBRARY: libflatdt_checker.so.1 where the loader does not find it. The interface: flatdt/checker/c.h.
"""

import ctypes
import json
import os
import sys

VERDICTS = ["VERIFIED", "REFUTED", "MALFORMED", "UNKNOWN"]

library = ctypes.CDLL(os.environ.get("FLATDT_LIBRARY", "libflatdt_checker.so.1"))
handle, text, size = ctypes.c_void_p, ctypes.c_char_p, ctypes.c_size_t
for name, result, arguments in [
        ("flatdt_error_text", text, [ctypes.c_int]),
        ("flatdt_check_texts", ctypes.c_int, [text, size, text, size, ctypes.POINTER(handle)]),
        ("flatdt_check", ctypes.c_int, [handle, handle, ctypes.POINTER(handle)]),
        ("flatdt_report_outcome", ctypes.c_int, [handle]),
        ("flatdt_report_reason", text, [handle]),
        ("flatdt_report_json", text, [handle]),
        ("flatdt_report_free", None, [handle]),
        ("flatdt_instance_new", ctypes.c_int, [ctypes.c_int, text, ctypes.POINTER(handle)]),
        ("flatdt_instance_add_point", ctypes.c_int, [handle, ctypes.POINTER(text), size]),
        ("flatdt_instance_free", None, [handle]),
        ("flatdt_triangulation_new", ctypes.c_int, [ctypes.c_int, ctypes.POINTER(handle)]),
        ("flatdt_triangulation_add_element", ctypes.c_int, [handle, ctypes.POINTER(text), size]),
        ("flatdt_triangulation_add_cell", ctypes.c_int, [handle, ctypes.POINTER(ctypes.c_uint32), size]),
        ("flatdt_triangulation_free", None, [handle])]:
    function = getattr(library, name)
    function.restype, function.argtypes = result, arguments


def call(function, *arguments):
    """Calls a function that returns a code."""
    code = function(*arguments)
    if code != 0:
        raise ValueError(library.flatdt_error_text(code).decode())


def strings(numbers):
    return (text * len(numbers))(*[str(number).encode() for number in numbers])


def taken(report):
    """Verdict, reason and conditions of a report, which is freed."""
    try:
        conditions = json.loads(library.flatdt_report_json(report))["conditions"]
        return (VERDICTS[library.flatdt_report_outcome(report)], library.flatdt_report_reason(report).decode(),
                {condition["name"]: condition for condition in conditions})
    finally:
        library.flatdt_report_free(report)


def check_texts(instance, triangulation):
    """instance, triangulation: the bytes of two files."""
    report = handle()
    call(library.flatdt_check_texts, instance, len(instance), triangulation, len(triangulation), ctypes.byref(report))
    return taken(report)


def check_torus(points, elements, cells):
    """A triangulation of points of the square torus; an element is a matrix [R|t] row by row, a cell a list of pairs."""
    instance, triangulation, report = handle(), handle(), handle()
    try:
        call(library.flatdt_instance_new, 2, b"torus", ctypes.byref(instance))
        for point in points:
            call(library.flatdt_instance_add_point, instance, strings(point), len(point))
        call(library.flatdt_triangulation_new, 2, ctypes.byref(triangulation))
        for element in elements:
            call(library.flatdt_triangulation_add_element, triangulation, strings(element), len(element))
        for cell in cells:
            flat = [number for pair in cell for number in pair]
            call(library.flatdt_triangulation_add_cell, triangulation, (ctypes.c_uint32 * len(flat))(*flat), len(flat))
        call(library.flatdt_check, instance, triangulation, ctypes.byref(report))
        return taken(report)
    finally:
        library.flatdt_triangulation_free(triangulation)
        library.flatdt_instance_free(instance)


def example():
    """The nine points (i/3, j/3), each square cut along the same diagonal; then without the last cell."""
    points = [(f"{i}/3", f"{j}/3") for j in range(3) for i in range(3)]
    elements = [(1, 0, x, 0, 1, y) for y in (0, 1) for x in (0, 1)]

    def vertex(i, j):
        return i % 3 + 3 * (j % 3), i // 3 + 2 * (j // 3)

    cells = []
    for j in range(3):
        for i in range(3):
            cells.append([vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)])
            cells.append([vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1)])
    print("all cells:", check_torus(points, elements, cells)[0])
    verdict, _, conditions = check_torus(points, elements, cells[:-1])
    print("without the last:", verdict, conditions["volume.exact"]["witness"])


if __name__ == "__main__":
    if len(sys.argv) != 3:
        example()
        sys.exit(0)
    with open(sys.argv[1], "rb") as first, open(sys.argv[2], "rb") as second:
        found, reason, _ = check_texts(first.read(), second.read())
    print(found, reason)
    sys.exit(VERDICTS.index(found))
