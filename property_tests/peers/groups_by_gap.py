#!/usr/bin/env python3
"""GAP confirms the catalogue: groups_by_gap.py FLATDT

For every group that `FLATDT manifolds` prints, both hands: the translations are Z^d, order of the holonomy, orientable,
no torsion, first homology, and conjugate by an affine map to the space group of the number that is claimed. Needs the
Debian packages gap-core gap-cryst gap-crystcat gap-polycyclic.

Exit code 0: all confirmed; 1: some not; 77: GAP or a package of it is not installed.
"""
import json
import re
import shutil
import subprocess
import sys

PROLOGUE = """
if LoadPackage("cryst") = fail or LoadPackage("polycyclic") = fail or LoadPackage("crystcat") = fail then
  Print("no packages\\n"); QUIT_GAP(77);
fi;
facts := function(name, d, number, generators)
  local s, h;
  s := AffineCrystGroupOnLeft(generators);
  h := AbelianInvariants(Image(IsomorphismPcpGroup(s)));
  Print("fact|", name,
    "|", TranslationBasis(s) = IdentityMat(d),
    "|", Size(PointGroup(s)),
    "|", ForAll(GeneratorsOfGroup(PointGroup(s)), r -> DeterminantMat(r) = 1),
    "|", IsTorsionFree(Image(IsomorphismPcpGroup(s))),
    "|", Filtered(h, x -> x <> 1),
    "|", ConjugatorSpaceGroups(s, SpaceGroupOnLeftIT(d, number)) <> fail, "\\n");
end;
"""


def gap_matrix(rows):
    dim = len(rows)
    return "[" + ",".join("[" + ",".join(row) + "]" for row in rows + [["0"] * dim + ["1"]]) + "]"


def elementary(h1):
    """Betti number and prime powers, as GAP lists abelian invariants: 0 for each Z, then prime powers, sorted."""
    powers = []
    for n in h1["torsion"]:
        n, p = int(n), 2
        while n > 1:
            q = 1
            while n % p == 0:
                n, q = n // p, q * p
            if q > 1:
                powers.append(q)
            p += 1
    return [0] * int(h1["betti"]) + sorted(powers)


def groups(manifolds):
    """(name, number, generators, manifold) of both hands; the numbers are in the order first, mirror image."""
    for m in manifolds:
        numbers = [int(re.search(r"no\. (\d+)", s)[1]) for s in m["space_groups"]]
        hands = [m["generators"]] + ([m["mirror_image_generators"]] if m["mirror_image_generators"] else [])
        if len(hands) != len(numbers):
            raise SystemExit(f"{m['name']}: {len(numbers)} space groups for {len(hands)} lists of generators")
        for number, generators in zip(numbers, hands):
            yield f"{m['name']}:{number}", number, generators, m


def main():
    if shutil.which("gap") is None:
        print("GAP is not installed (Debian packages gap-core gap-cryst gap-crystcat gap-polycyclic): "
              "the catalogue is not confirmed")
        return 77
    out = subprocess.run([sys.argv[1], "manifolds", "--json"], check=True, capture_output=True, text=True).stdout
    wanted = list(groups(json.loads(out)["manifolds"]))
    program = PROLOGUE
    for name, number, generators, m in wanted:
        program += (f'facts("{name}", {m["dimension"]}, {number}, '
                    f'[{",".join(gap_matrix(g) for g in generators)}]);\n')
    done = subprocess.run(["gap", "-q", "-b", "-A"], input=program + "QUIT_GAP(0);\n", capture_output=True, text=True)
    if done.returncode == 77:
        print("GAP has not all of its packages cryst, crystcat, polycyclic: the catalogue is not confirmed")
        return 77
    # GAP breaks long lines with a backslash.
    found = {line.split("|")[1]: line.split("|")[2:] for line in done.stdout.replace("\\\n", "").splitlines()
             if line.startswith("fact|")}
    failures = 0
    for name, number, _, m in wanted:
        facts = found.get(name)
        said = "nothing: " + done.stderr.strip()[-200:] if facts is None else None
        if facts is not None:
            h1 = sorted(int(x) for x in re.findall(r"\d+", facts[4]))
            truth = ["true", str(m["holonomy"]["order"]), str(bool(m["orientable"])).lower(), "true",
                     elementary(m["h1"]), "true"]
            said = facts[:4] + [h1] + facts[5:]
            failures += said != truth
        else:
            failures += 1
        print(f"{m['name']:<19} no. {number:<4} lattice Z^d, |holonomy|, orientable, torsion-free, H1, conjugate: "
              f"{said if facts is None else ' '.join(map(str, said))}"
              + ("" if facts is not None and said == truth else "  WRONG"))
    print(f"GAP: {len(wanted) - failures} of {len(wanted)} groups confirmed")
    return 0 if failures == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
