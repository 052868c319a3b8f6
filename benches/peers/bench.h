/* What the C and C++ programs share: slopes of the profiles, places, the clock, and the line that each measurement becomes. */
#ifndef BENCH_H
#define BENCH_H
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define QUARTER 1.57079632679489661923
#define BATCHES 15
/* Nanoseconds that one batch should last. */
#define BATCH 1.0e6

enum profile { SPHERE, POWER, WORN, COSINE, ROOT, LN_COSH, GAUSSIAN, KINK, PROFILES };
static const char *const NAMES[PROFILES] = {"sphere", "power", "worn", "cosine", "root", "ln_cosh", "gaussian", "kink"};

static inline double slope(enum profile p, double r)
{
    switch (p) {
    case SPHERE: return r / sqrt((2.0 - r) * (2.0 + r));
    case POWER: return 2.7 * pow(r, 1.7);
    case WORN: return r > 0.6 ? 0.5 * r : 0.0;
    case COSINE: return 0.88 * sin(2.2 * r);
    case ROOT: return 0.35 / sqrt(r);
    case LN_COSH: return tanh(r);
    case GAUSSIAN: return 0.8 * r / 1.69 * exp(-r * r / 1.69);
    case KINK: return r > 0.6 ? 0.3 : 0.0;
    default: return NAN;
    }
}

/* Where f' of the profile jumps or bends; 0 where it does not. */
static inline double kink_of(enum profile p) { return p == WORN || p == KINK ? 0.6 : 0.0; }

struct place { char work[32]; enum profile profile; double x, value, rest; };

/* The places whose name starts with one of the profiles' names; others belong to other programs. */
static inline int read_places(const char *file, struct place *list, int most)
{
    FILE *in = fopen(file, "r");
    char text[256], profile[32];
    int count = 0;
    if (!in) { perror(file); exit(1); }
    while (count < most && fgets(text, sizeof text, in)) {
        struct place own;
        if (sscanf(text, "%31[^,],%31[^,],%lf,%lf,%lf", own.work, profile, &own.x, &own.value, &own.rest) != 5) continue;
        for (int p = 0; p < PROFILES; p++)
            if (!strcmp(profile, NAMES[p])) { own.profile = (enum profile)p; list[count++] = own; }
    }
    fclose(in);
    return count;
}

/* Processor time: what other programs do on the machine does not count. */
static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The median of the batches; `call` is repeated until a batch is long enough. */
static double median_ns(void (*call)(void *), void *data)
{
    double t[BATCHES], start = now();
    call(data);
    double once = now() - start;
    int repeats = once > BATCH ? 1 : (int)(BATCH / (once > 20.0 ? once : 20.0));
    for (int b = 0; b < BATCHES; b++) {
        start = now();
        for (int i = 0; i < repeats; i++) call(data);
        t[b] = (now() - start) / repeats;
    }
    qsort(t, BATCHES, sizeof *t, by_size);
    return t[BATCHES / 2];
}

static void line(const char *work, const char *who, const char *form, double ns, double error, long evaluations)
{
    printf("%s,%s,%s,%.5g,%.3g,%ld\n", work, who, form, ns, error, evaluations);
    fflush(stdout);
}

static inline double relative_error(const struct place *p, double found) { return fabs((found - p->value) - p->rest) / fabs(p->value); }
#endif
