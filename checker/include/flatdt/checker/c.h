/* The checker for programs in any language: the C interface of libflatdt_checker.so.
 *
 * Numbers are strings, exact rationals in any form that the file formats allow ("1/3", "-0.75", "0x1.8p-2").
 * A caller that has both files as texts needs three functions: flatdt_check_texts, flatdt_report_outcome (or
 * flatdt_report_json) and flatdt_report_free.
 *
 * Ownership: an object that a function gives through its last argument belongs to the caller, who frees it by
 *   the function named after its type, which takes NULL too. A string that a function gives belongs to the
 *   object it was asked of and lives until that is freed or changed; without an object it lives for ever.
 *   Nothing that is passed in is kept.
 * Errors: where a function returns another code than FLATDT_OK, what it would have given is NULL and nothing
 *   else has changed. A wrong triangulation is not an error: the report says so. No exception leaves the
 *   library. GMP ends the process where an allocation of its own fails.
 * Threads: an object may be used by one thread at a time; different objects by different threads at once.
 * Stability: the soname carries the version of this interface; functions may be added to it.
 */
#ifndef FLATDT_CHECKER_C_H
#define FLATDT_CHECKER_C_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define FLATDT_API __attribute__((visibility("default")))
#else
#define FLATDT_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* NOLINTBEGIN(modernize-use-using): this is C */
typedef enum {
  FLATDT_OK = 0,
  FLATDT_INVALID_ARGUMENT = 1, /* a NULL, a count that does not fit the dimension, a string that is no token,
                                  objects of different dimensions */
  FLATDT_OUT_OF_MEMORY = 2,
  FLATDT_INTERNAL_ERROR = 3 /* a defect of the library */
} flatdt_error;

/* The values are the exit codes of flatdt-check. */
typedef enum {
  FLATDT_VERIFIED = 0,
  FLATDT_REFUTED = 1,
  FLATDT_MALFORMED = 2,
  FLATDT_UNKNOWN = 3
} flatdt_outcome;

typedef enum {
  FLATDT_HOLDS = 0,
  FLATDT_FAILS = 1,
  FLATDT_SKIPPED = 2,
  FLATDT_NO_CONDITION = 3 /* there is no condition of this number */
} flatdt_status;

typedef struct flatdt_report flatdt_report;
typedef struct flatdt_instance flatdt_instance;
typedef struct flatdt_triangulation flatdt_triangulation;
/* NOLINTEND(modernize-use-using) */

/* "0.1.0" */
FLATDT_API const char* flatdt_checker_version(void);
/* What a flatdt_error means, in English; never NULL. */
FLATDT_API const char* flatdt_error_text(int error);

/* --- Checking ---------------------------------------------------------------------------------------- */

/* Judges two files in memory, given by address and number of bytes; they need not end with a zero byte. */
FLATDT_API flatdt_error flatdt_check_texts(const char* instance, size_t instance_size,
                                           const char* triangulation, size_t triangulation_size,
                                           flatdt_report** report);
/* Judges what was built by the functions below: two objects of one dimension. */
FLATDT_API flatdt_error flatdt_check(const flatdt_instance* instance,
                                     const flatdt_triangulation* triangulation, flatdt_report** report);

/* --- The report -------------------------------------------------------------------------------------- */

/* The verdict. FLATDT_UNKNOWN for NULL. */
FLATDT_API flatdt_outcome flatdt_report_outcome(const flatdt_report* report);
/* Why the verdict is malformed or unknown, "instance:5: ..." where a line is to blame; else "". */
FLATDT_API const char* flatdt_report_reason(const flatdt_report* report);
/* The object that flatdt-check --json prints, in one line without a line feed. */
FLATDT_API const char* flatdt_report_json(const flatdt_report* report);
FLATDT_API void flatdt_report_free(flatdt_report* report);

/* Conditions are numbered from 0 in the order of evaluation. */
FLATDT_API size_t flatdt_condition_count(void);
/* "delaunay.empty"; NULL for a number that is too large. */
FLATDT_API const char* flatdt_condition_name(size_t condition);
FLATDT_API flatdt_status flatdt_report_status(const flatdt_report* report, size_t condition);
/* The witness of a condition: pairs of a key and a value. 0 and NULL for a number that is too large. */
FLATDT_API size_t flatdt_report_witness_size(const flatdt_report* report, size_t condition);
FLATDT_API const char* flatdt_report_witness_key(const flatdt_report* report, size_t condition, size_t entry);
FLATDT_API const char* flatdt_report_witness_value(const flatdt_report* report, size_t condition,
                                                   size_t entry);

/* --- Building an instance ---------------------------------------------------------------------------- */

/* The grammar is that of the file format, d the dimension. What is added is only checked to be tokens;
 * numbers that are none, names that do not exist and sections that are missing make the report malformed,
 * with the line of the text that flatdt_instance_text shows. */

/* manifold: the claimed name, or NULL if there is none. */
FLATDT_API flatdt_error flatdt_instance_new(int dimension, const char* manifold, flatdt_instance** instance);
/* The augmented matrix [R|t] of a generator, row by row. count: d (d + 1). */
FLATDT_API flatdt_error flatdt_instance_add_generator(flatdt_instance* instance, const char* const* entries,
                                                      size_t count);
/* The upper triangle of the Gram matrix, row by row, replacing an earlier one. count: d (d + 1) / 2. */
FLATDT_API flatdt_error flatdt_instance_set_metric(flatdt_instance* instance, const char* const* entries,
                                                   size_t count);
/* count: d. */
FLATDT_API flatdt_error flatdt_instance_add_point(flatdt_instance* instance, const char* const* coordinates,
                                                  size_t count);
/* The exact values of finite doubles. count: d. */
FLATDT_API flatdt_error flatdt_instance_add_point_doubles(flatdt_instance* instance,
                                                          const double* coordinates, size_t count);
/* The instance as a file, with a zero byte at its end. */
FLATDT_API flatdt_error flatdt_instance_text(flatdt_instance* instance, const char** text);
FLATDT_API void flatdt_instance_free(flatdt_instance* instance);

/* --- Building a triangulation ------------------------------------------------------------------------ */

FLATDT_API flatdt_error flatdt_triangulation_new(int dimension, flatdt_triangulation** triangulation);
/* A generator of the subgroup of a covering space, as flatdt_instance_add_generator. None: the manifold. */
FLATDT_API flatdt_error flatdt_triangulation_add_subgroup_generator(flatdt_triangulation* triangulation,
                                                                    const char* const* entries, size_t count);
/* A group element that cells use, as flatdt_instance_add_generator. Elements are numbered from 0. */
FLATDT_API flatdt_error flatdt_triangulation_add_element(flatdt_triangulation* triangulation,
                                                         const char* const* entries, size_t count);
/* d + 1 pairs of a point's and an element's number, in one list. count: 2 (d + 1). */
FLATDT_API flatdt_error flatdt_triangulation_add_cell(flatdt_triangulation* triangulation,
                                                      const uint32_t* pairs, size_t count);
/* The triangulation as a file, with a zero byte at its end. */
FLATDT_API flatdt_error flatdt_triangulation_text(flatdt_triangulation* triangulation, const char** text);
FLATDT_API void flatdt_triangulation_free(flatdt_triangulation* triangulation);

#ifdef __cplusplus
}
#endif

#endif
