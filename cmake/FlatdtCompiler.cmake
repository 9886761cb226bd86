# Compiler settings shared by both sides of the wall: C++20, warnings as errors, no floating-point contraction.
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

option(FLATDT_WARNINGS_AS_ERRORS "Treat warnings as errors" ON)

add_library(flatdt_compiler INTERFACE)
# The error bounds of the floating-point filters assume that no multiply-add is fused.
target_compile_options(flatdt_compiler INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow
  -Wnon-virtual-dtor -Wold-style-cast -Wcast-qual -Woverloaded-virtual)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # False positives of g++ 12 at -O3 (initializer lists of structs with vectors; GCC bugs 105329, 105651 on string
  # concatenation). ASan and clang watch instead.
  target_compile_options(flatdt_compiler INTERFACE -Wno-maybe-uninitialized -Wno-restrict)
endif()
if(FLATDT_WARNINGS_AS_ERRORS)
  target_compile_options(flatdt_compiler INTERFACE -Werror)
endif()

# The programs' own sources hold no hot code, but the headers for command lines and JSON take most of the build's time:
# unoptimised they compile several times faster.
add_library(flatdt_front_end INTERFACE)
target_compile_options(flatdt_front_end INTERFACE -O0)

# Debian's GMP C++ interface, as the imported target flatdt_gmp.
if(NOT TARGET flatdt_gmp)
  find_path(FLATDT_GMP_INCLUDE_DIR gmpxx.h REQUIRED)
  find_library(FLATDT_GMP_LIBRARY gmp REQUIRED)
  find_library(FLATDT_GMPXX_LIBRARY gmpxx REQUIRED)
  add_library(flatdt_gmp INTERFACE)
  target_include_directories(flatdt_gmp SYSTEM INTERFACE "${FLATDT_GMP_INCLUDE_DIR}")
  target_link_libraries(flatdt_gmp INTERFACE "${FLATDT_GMPXX_LIBRARY}" "${FLATDT_GMP_LIBRARY}")
endif()
