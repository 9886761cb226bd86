/* The C interface, from C: every function, what it refuses, who owns what (leaks show under
 * AddressSanitizer). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "expect.h"
#include "flatdt/checker/c.h"

static size_t condition_called(const char* name) {
  for (size_t i = 0; i < flatdt_condition_count(); ++i)
    if (strcmp(flatdt_condition_name(i), name) == 0) return i;
  fprintf(stderr, "there is no condition %s\n", name);
  exit(1);
}

/* The nine points (i/3, j/3) of the square torus. */
static flatdt_instance* grid(void) {
  static const char* const thirds[] = {"0", "1/3", "2/3"};
  flatdt_instance* instance = NULL;
  EXPECT(flatdt_instance_new(2, "torus", &instance) == FLATDT_OK);
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) {
      const char* const point[] = {thirds[i], thirds[j]};
      EXPECT(flatdt_instance_add_point(instance, point, 2) == FLATDT_OK);
    }
  }
  return instance;
}

/* Each square of the grid cut along the same diagonal; `cells` of the 18 cells. */
static flatdt_triangulation* diagonals(int cells) {
  flatdt_triangulation* triangulation = NULL;
  EXPECT(flatdt_triangulation_new(2, &triangulation) == FLATDT_OK);
  for (int k = 0; k < 4; ++k) {
    const char* const element[] = {"1", "0", k % 2 == 1 ? "1" : "0", "0", "1", k / 2 == 1 ? "1" : "0"};
    EXPECT(flatdt_triangulation_add_element(triangulation, element, 6) == FLATDT_OK);
  }
  for (int c = 0; c < cells; ++c) {
    const uint32_t x = (uint32_t)(c / 2 % 3), y = (uint32_t)(c / 6);
    const uint32_t a = x == 2, b = y == 2, east = (x + 1) % 3, north = (y + 1) % 3;
    const uint32_t lower[] = {x + 3 * y, 0, east + 3 * y, a, east + 3 * north, a + 2 * b};
    const uint32_t upper[] = {x + 3 * y, 0, x + 3 * north, 2 * b, east + 3 * north, a + 2 * b};
    EXPECT(flatdt_triangulation_add_cell(triangulation, c % 2 == 0 ? lower : upper, 6) == FLATDT_OK);
  }
  return triangulation;
}

static void builds_and_checks(void) {
  flatdt_instance* instance = grid();
  flatdt_triangulation* triangulation = diagonals(18);
  flatdt_report* report = NULL;
  EXPECT(flatdt_check(instance, triangulation, &report) == FLATDT_OK);
  EXPECT(flatdt_report_outcome(report) == FLATDT_VERIFIED);
  EXPECT(strcmp(flatdt_report_reason(report), "") == 0);
  EXPECT(flatdt_report_status(report, condition_called("delaunay.empty")) == FLATDT_HOLDS);

  /* The same from the texts. */
  const char *instance_text = NULL, *triangulation_text = NULL;
  EXPECT(flatdt_instance_text(instance, &instance_text) == FLATDT_OK);
  EXPECT(flatdt_triangulation_text(triangulation, &triangulation_text) == FLATDT_OK);
  EXPECT(strncmp(instance_text, "flatdt-instance 1\ndimension 2\nmanifold torus\npoints 9\n", 54) == 0);
  flatdt_report* again = NULL;
  EXPECT(flatdt_check_texts(instance_text, strlen(instance_text), triangulation_text,
                            strlen(triangulation_text), &again) == FLATDT_OK);
  EXPECT(strcmp(flatdt_report_json(report), flatdt_report_json(again)) == 0);
  EXPECT(strncmp(flatdt_report_json(again), "{\"schema\":\"flatdt-check 1\",\"verdict\":\"VERIFIED\",", 47) ==
         0);
  EXPECT(strchr(flatdt_report_json(again), '\n') == NULL);
  flatdt_report_free(again);
  flatdt_report_free(report);
  flatdt_triangulation_free(triangulation);
  flatdt_instance_free(instance);
}

static void shows_witnesses(void) {
  flatdt_instance* instance = grid();
  flatdt_triangulation* triangulation = diagonals(17);
  flatdt_report* report = NULL;
  EXPECT(flatdt_check(instance, triangulation, &report) == FLATDT_OK);
  EXPECT(flatdt_report_outcome(report) == FLATDT_REFUTED);
  const size_t volume = condition_called("volume.exact");
  EXPECT(flatdt_report_status(report, volume) == FLATDT_FAILS);
  EXPECT(flatdt_report_witness_size(report, volume) >= 2);
  EXPECT(strcmp(flatdt_report_witness_key(report, volume, 0), "volume-of-cells") == 0);
  EXPECT(strcmp(flatdt_report_witness_value(report, volume, 0), "17/18") == 0);
  EXPECT(strcmp(flatdt_report_witness_value(report, volume, 1), "1") == 0);
  EXPECT(flatdt_report_witness_key(report, volume, 1000) == NULL);
  EXPECT(flatdt_report_witness_value(report, flatdt_condition_count(), 0) == NULL);
  EXPECT(flatdt_report_witness_size(report, flatdt_condition_count()) == 0);
  EXPECT(flatdt_report_status(report, flatdt_condition_count()) == FLATDT_NO_CONDITION);
  EXPECT(flatdt_condition_name(flatdt_condition_count()) == NULL);
  flatdt_report_free(report);
  flatdt_triangulation_free(triangulation);
  flatdt_instance_free(instance);
}

static void builds_all_sections(void) {
  flatdt_instance* instance = NULL;
  EXPECT(flatdt_instance_new(2, NULL, &instance) == FLATDT_OK);
  const char* const translation[] = {"1", "0", "1", "0", "1", "0"};
  const char* const glide[] = {"-1", "0", "0", "0", "1", "1/2"};
  const char* const metric[] = {"1", "0", "4"};
  EXPECT(flatdt_instance_add_generator(instance, translation, 6) == FLATDT_OK);
  EXPECT(flatdt_instance_add_generator(instance, glide, 6) == FLATDT_OK);
  EXPECT(flatdt_instance_set_metric(instance, glide, 3) == FLATDT_OK);
  EXPECT(flatdt_instance_set_metric(instance, metric, 3) == FLATDT_OK); /* replaces */
  const double point[] = {0.1, -0.75};
  EXPECT(flatdt_instance_add_point_doubles(instance, point, 2) == FLATDT_OK);
  const char* text = NULL;
  EXPECT(flatdt_instance_text(instance, &text) == FLATDT_OK);
  EXPECT(strcmp(text,
                "flatdt-instance 1\ndimension 2\ngenerators 2\n  1 0 1 0 1 0\n  -1 0 0 0 1 1/2\n"
                "metric  1 0 4\npoints 1\n  0x1.999999999999ap-4 -0x1.8p-1\n") == 0);

  flatdt_triangulation* triangulation = NULL;
  EXPECT(flatdt_triangulation_new(2, &triangulation) == FLATDT_OK);
  EXPECT(flatdt_triangulation_add_subgroup_generator(triangulation, translation, 6) == FLATDT_OK);
  flatdt_report* report = NULL;
  EXPECT(flatdt_check(instance, triangulation, &report) == FLATDT_OK);
  EXPECT(flatdt_report_outcome(report) == FLATDT_REFUTED); /* a subgroup of infinite index */
  EXPECT(flatdt_report_status(report, condition_called("group.name")) == FLATDT_SKIPPED);
  EXPECT(flatdt_report_status(report, condition_called("subgroup.member")) == FLATDT_FAILS);
  flatdt_report_free(report);
  flatdt_triangulation_free(triangulation);
  flatdt_instance_free(instance);
}

static void refuses_arguments(void) {
  flatdt_instance* instance = NULL;
  EXPECT(flatdt_instance_new(4, "torus", &instance) == FLATDT_INVALID_ARGUMENT && instance == NULL);
  EXPECT(flatdt_instance_new(2, "torus points", &instance) == FLATDT_INVALID_ARGUMENT);
  EXPECT(flatdt_instance_new(2, "torus", NULL) == FLATDT_INVALID_ARGUMENT);
  EXPECT(flatdt_instance_new(2, "torus", &instance) == FLATDT_OK);
  static char long_token[4099];
  memset(long_token, '1', 4098);
  const char* const bad[][2] = {{"0", NULL},  {"0", ""},         {"0", "1 2"},     {"0", "1#"},
                                {"0", "1\n"}, {"0", "\xC3\xA9"}, {"0", long_token}};
  for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i)
    EXPECT(flatdt_instance_add_point(instance, bad[i], 2) == FLATDT_INVALID_ARGUMENT);
  const char* const good[] = {"0", "0", "0"};
  EXPECT(flatdt_instance_add_point(instance, good, 3) == FLATDT_INVALID_ARGUMENT);
  EXPECT(flatdt_instance_add_point(instance, NULL, 2) == FLATDT_INVALID_ARGUMENT);
  EXPECT(flatdt_instance_add_point(NULL, good, 2) == FLATDT_INVALID_ARGUMENT);
  EXPECT(flatdt_instance_add_generator(instance, good, 3) == FLATDT_INVALID_ARGUMENT);
  EXPECT(flatdt_instance_set_metric(instance, good, 2) == FLATDT_INVALID_ARGUMENT);
  const double coordinates[] = {0, NAN};
  EXPECT(flatdt_instance_add_point_doubles(instance, coordinates, 2) == FLATDT_INVALID_ARGUMENT);
  EXPECT(flatdt_instance_text(instance, NULL) == FLATDT_INVALID_ARGUMENT);
  const char* text = "";
  EXPECT(flatdt_instance_text(NULL, &text) == FLATDT_INVALID_ARGUMENT && text == NULL);

  /* Refused pieces have left nothing behind: no point was added. */
  EXPECT(flatdt_instance_text(instance, &text) == FLATDT_OK);
  EXPECT(strcmp(text, "flatdt-instance 1\ndimension 2\nmanifold torus\npoints 0\n") == 0);
  flatdt_triangulation* triangulation = NULL;
  EXPECT(flatdt_triangulation_new(1, &triangulation) == FLATDT_INVALID_ARGUMENT && triangulation == NULL);
  EXPECT(flatdt_triangulation_new(2, &triangulation) == FLATDT_OK);
  const uint32_t pairs[] = {0, 0, 0, 0, 0, 0, 0, 0};
  EXPECT(flatdt_triangulation_add_cell(triangulation, pairs, 8) == FLATDT_INVALID_ARGUMENT);
  flatdt_report* report = NULL;
  EXPECT(flatdt_check(instance, NULL, &report) == FLATDT_INVALID_ARGUMENT && report == NULL);
  EXPECT(flatdt_check(NULL, triangulation, &report) == FLATDT_INVALID_ARGUMENT);
  EXPECT(flatdt_check(instance, triangulation, NULL) == FLATDT_INVALID_ARGUMENT);
  EXPECT(flatdt_check_texts(NULL, 5, "", 0, &report) == FLATDT_INVALID_ARGUMENT && report == NULL);

  /* Of another dimension, also where no element and no cell shows it. */
  flatdt_triangulation* solid = NULL;
  EXPECT(flatdt_triangulation_new(3, &solid) == FLATDT_OK);
  EXPECT(flatdt_check(instance, solid, &report) == FLATDT_INVALID_ARGUMENT && report == NULL);
  flatdt_triangulation_free(solid);

  /* What only the grammar can refuse, the report says. */
  EXPECT(flatdt_check(instance, triangulation, &report) == FLATDT_OK);
  EXPECT(flatdt_report_outcome(report) == FLATDT_MALFORMED);
  EXPECT(strncmp(flatdt_report_reason(report), "instance:4: ", 12) == 0);
  flatdt_report_free(report);
  EXPECT(flatdt_check_texts(NULL, 0, NULL, 0, &report) == FLATDT_OK);
  EXPECT(flatdt_report_outcome(report) == FLATDT_MALFORMED);
  flatdt_report_free(report);
  flatdt_triangulation_free(triangulation);
  flatdt_instance_free(instance);
}

static void takes_null(void) {
  flatdt_report_free(NULL);
  flatdt_instance_free(NULL);
  flatdt_triangulation_free(NULL);
  EXPECT(flatdt_report_outcome(NULL) == FLATDT_UNKNOWN);
  EXPECT(strcmp(flatdt_report_reason(NULL), "") == 0);
  EXPECT(flatdt_report_json(NULL) == NULL);
  EXPECT(flatdt_report_status(NULL, 0) == FLATDT_NO_CONDITION);
  EXPECT(flatdt_report_witness_size(NULL, 0) == 0);
  EXPECT(strlen(flatdt_checker_version()) >= 5);
  for (int code = 0; code < 6; ++code) EXPECT(strlen(flatdt_error_text(code)) > 0);
}

int main(void) {
  builds_and_checks();
  shows_witnesses();
  builds_all_sections();
  refuses_arguments();
  takes_null();
  if (failures == 0) puts("all passed");
  return failures == 0 ? 0 : 1;
}
