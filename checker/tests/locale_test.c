/* The C interface in a process whose decimal point is a comma, as a program with a user interface has it:
 * doubles are written and numbers read as ever. Exit code 77 where no such locale can be had. */
#include <locale.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "expect.h"
#include "flatdt/checker/c.h"

/* The category LC_NUMERIC of a locale as glibc stores it, so that none need be installed: a number that says
 * what it is, the number of entries, where each begins, and they: point, separator, grouping, the first two
 * as wide characters, codeset. */
static int write_comma_locale(const char* folder) {
  enum { kEntries = 6, kHead = 4 * (2 + kEntries) };
  static const char strings[16] = ",\0\0\0\0\0\0\0UTF-8";
  const uint32_t head[2 + kEntries] = {
      0x20031115 ^ LC_NUMERIC, kEntries, kHead, kHead + 1, kHead + 2, kHead + 16, kHead + 20, kHead + 8};
  const uint32_t wide[2] = {',', 0};
  char path[300];
  snprintf(path, sizeof path, "%s/comma", folder);
  if (mkdir(path, 0700) != 0) return 0;
  snprintf(path, sizeof path, "%s/comma/LC_NUMERIC", folder);
  FILE* file = fopen(path, "wb");
  if (file == NULL) return 0;
  fwrite(head, sizeof head, 1, file);
  fwrite(strings, sizeof strings, 1, file);
  fwrite(wide, sizeof wide, 1, file);
  return fclose(file) == 0;
}

static void remove_comma_locale(const char* folder) {
  char path[300];
  snprintf(path, sizeof path, "%s/comma/LC_NUMERIC", folder);
  remove(path);
  snprintf(path, sizeof path, "%s/comma", folder);
  remove(path);
  remove(folder);
}

/* Sets a locale whose decimal point is a comma. */
static int set_comma(void) {
  char folder[] = "/tmp/flatdt-locale-XXXXXX";
  if (mkdtemp(folder) == NULL) return 0;
  int set = write_comma_locale(folder) && setenv("LOCPATH", folder, 1) == 0 &&
            setlocale(LC_NUMERIC, "comma") != NULL;
  remove_comma_locale(folder);
  return set && strcmp(localeconv()->decimal_point, ",") == 0;
}

int main(void) {
  if (!set_comma()) {
    puts("skipped: no locale with a decimal comma");
    return 77;
  }
  char shown[32];
  snprintf(shown, sizeof shown, "%.1f", 0.5);
  EXPECT(strcmp(shown, "0,5") == 0); /* the locale is in force */

  flatdt_instance* instance = NULL;
  flatdt_triangulation* triangulation = NULL;
  EXPECT(flatdt_instance_new(2, "torus", &instance) == FLATDT_OK);
  const double point[] = {0.1, -0.75};
  const char* const metric[] = {"1.5", "0", "0x1.8p0"};
  EXPECT(flatdt_instance_set_metric(instance, metric, 3) == FLATDT_OK);
  EXPECT(flatdt_instance_add_point_doubles(instance, point, 2) == FLATDT_OK);
  const char* text = NULL;
  EXPECT(flatdt_instance_text(instance, &text) == FLATDT_OK);
  EXPECT(text != NULL &&
         strcmp(text,
                "flatdt-instance 1\ndimension 2\nmanifold torus\nmetric  1.5 0 0x1.8p0\npoints 1\n"
                "  0x1.999999999999ap-4 -0x1.8p-1\n") == 0);

  EXPECT(flatdt_triangulation_new(2, &triangulation) == FLATDT_OK);
  flatdt_report* report = NULL;
  EXPECT(flatdt_check(instance, triangulation, &report) == FLATDT_OK);
  EXPECT(flatdt_report_outcome(report) == FLATDT_REFUTED); /* well formed: all that is missing is cells */
  EXPECT(strcmp(flatdt_report_reason(report), "") == 0);
  flatdt_report_free(report);
  flatdt_triangulation_free(triangulation);
  flatdt_instance_free(instance);
  if (failures == 0) puts("all passed");
  return failures == 0 ? 0 : 1;
}
