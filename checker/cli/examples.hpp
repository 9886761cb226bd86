// What --help shows of the use of flatdt-check; every line that starts with a blank is run by a test.
#pragma once

namespace flatdt::checker {

inline constexpr const char* kExamples =
    "Examples:\n"
    "  flatdt-check k.instance k.triangulation\n"
    "  flatdt-check --json k.instance k.triangulation > verdict.json\n"
    "  flatdt triangulate -q k.instance | flatdt-check k.instance -\n"
    "  (printf 'check 1 %d %d\\n' $(wc -c < k.instance) $(wc -c < k.triangulation);\n"
    "    cat k.instance k.triangulation; echo) | flatdt-check --serve\n";

}  // namespace flatdt::checker
