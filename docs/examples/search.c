/* A random local search for ikbench in C: ikbench evaluates the candidates. cc -O2 -o search search.c */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { most = 64, size = 10 };
static char line[1000001];
static double uniform(void) { return rand() / (RAND_MAX + 1.0); }

static const char *at(const char *key) { /* where the value of a key begins */
  const char *found = strstr(line, key);
  return found ? strchr(found + strlen(key), ':') + 1 : "0";
}

static void numbers(const char *key, double *out) { /* those that are null become large */
  char *next = strchr(at(key), '[');
  for (int n = 0; next && *next != ']' && n < most; ++n) {
    char *from = next + 1;
    out[n] = strtod(from, &next);
    if (next != from) continue;
    out[n] = 1e300;
    next += strcspn(next, ",]");
  }
}

static void solve(int joints) {
  double best[most], lower[most], upper[most], q[size][most], errors[most], least = 1e301, reach = 0.5;
  const int id = atoi(at("\"id\""));
  numbers("\"start\"", best), numbers("\"lower\"", lower), numbers("\"upper\"", upper);
  srand((unsigned)strtoul(at("\"seed\""), NULL, 10));
  do {
    printf("{\"message\":\"ask\",\"id\":%d,\"candidates\":[", id);
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < joints; ++j) {
        double x = best[j] + (i ? reach * (2 * uniform() - 1) : 0);
        q[i][j] = x < lower[j] ? lower[j] : x > upper[j] ? upper[j] : x;
        printf("%s%.17g%s", j ? "," : i ? ",[" : "[", q[i][j], j + 1 < joints ? "" : "]");
      }
    puts("]}"), fflush(stdout);
    if (!fgets(line, sizeof line, stdin)) return;
    numbers("\"errors\"", errors);
    const double before = least;
    for (int i = 0; i < size; ++i)
      if (errors[i] < least) least = errors[i], memcpy(best, q[i], sizeof best);
    reach = reach < 1e-9 ? 0.5 : reach * (least < before ? 1.2 : 0.9);
  } while (!strstr(line, "\"over\":true"));
  printf("{\"message\":\"solved\",\"id\":%d}\n", id);
}

int main(void) {
  int joints = 0;
  puts("{\"ikbench\":1,\"message\":\"hello\",\"name\":\"c_search\",\"version\":\"1.0\",\"modes\":[\"ask\"]}");
  while (fflush(stdout), fgets(line, sizeof line, stdin) && !strstr(line, "\"message\":\"bye\"")) {
    for (const char *j = line; strstr(line, "\"robot\"") && (j = strstr(j, "\"alpha\"")); ++j) ++joints;
    if (strstr(line, "\"message\":\"robot\"")) puts("{\"message\":\"ready\"}");
    if (strstr(line, "\"message\":\"start\"")) solve(joints);
  }
}
