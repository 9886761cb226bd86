/* EXPECT(condition): says where it does not hold, and goes on; `failures` counts. For tests in C. */
#pragma once

#include <stdio.h>

static int failures = 0;

#define EXPECT(condition)                                                  \
  do {                                                                     \
    if (!(condition)) {                                                    \
      fprintf(stderr, "%s:%d: not: %s\n", __FILE__, __LINE__, #condition); \
      ++failures;                                                          \
    }                                                                      \
  } while (0)
