/// What --help shows of the use of each command; every line that starts with a blank is run by a test, in
/// this order.
#pragma once

#include <array>
#include <string_view>

namespace flatdt::ref::cli {

struct Examples {
  std::string_view command;  // empty: of the program
  const char* lines;
};

inline constexpr std::array<Examples, 7> kExamples = {{
    {"",
     "Example:\n"
     "  flatdt generate --manifold klein-bottle --points 5 --family uniform --seed 1 -o k.instance\n"
     "  flatdt triangulate k.instance -o k.triangulation\n"
     "  flatdt-check k.instance k.triangulation\n"
     "`flatdt COMMAND --help` shows the options of a command.\n"
     "Exit codes: 0 done, 2 bad input or wrong usage, 3 internal error or a resource limit.\n"},
    {"manifolds",
     "Examples:\n"
     "  flatdt manifolds\n"
     "  flatdt manifolds --json > catalogue.json\n"},
    {"info",
     "Examples:\n"
     "  flatdt info k.instance\n"
     "  flatdt generate --manifold P32 --points 1 --metric random | flatdt info --json -\n"},
    {"generate",
     "Examples:\n"
     "  flatdt generate --family list\n"
     "  flatdt generate --manifold didicosm --points 20 --family cospherical --seed 1 -o d.instance\n"
     "  flatdt generate --manifold G4 --points 8 --metric random --seed 7 > g4.instance\n"},
    {"triangulate",
     "Examples:\n"
     "  flatdt triangulate d.instance -o d.triangulation --json-summary d.json\n"
     "  flatdt triangulate --quiet - < k.instance | flatdt-check k.instance -\n"
     "  flatdt triangulate --smallest-cover k.instance -o smallest.triangulation\n"
     "  flatdt triangulate --engine covering --sheets theorem10 k.instance -o same.triangulation\n"},
    {"import",
     "Examples:\n"
     "  flatdt import crystal.cif -o crystal.instance\n"
     "  flatdt import --coincident merge --altloc all crystal.cif | flatdt triangulate - -o "
     "crystal.triangulation\n"},
    {"draw",
     "Examples:\n"
     "  flatdt draw k.instance k.triangulation -o k.svg\n"
     "  flatdt draw k.instance k.triangulation --two-cycle -o loop.svg\n"
     "  flatdt draw d.instance d.triangulation -o d.html\n"
     "  flatdt-check --json k.instance k.triangulation > k.json;\n"
     "    flatdt draw k.instance k.triangulation --verdict k.json -o verdict.svg\n"},
}};

}  // namespace flatdt::ref::cli
