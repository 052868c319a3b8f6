/* Closed forms of g over 10^6 points, written by hand: what a compiled formula has to be held against. */
#include "bench.h"

#define POINTS 1000000
static double x[POINTS], g[POINTS];

#define FORM(name, formula) \
    static void name(void *unused) { (void)unused; for (int i = 0; i < POINTS; i++) { double v = x[i]; g[i] = formula; } }
FORM(paraboloid, v * v / 2.0)
FORM(sphere, v * atanh(v / 2.0))
FORM(power, 2.07 * pow(v, 2.7))
FORM(root, 1.1981402347355922 * 0.7659 * sqrt(v))
FORM(worn, v / 2.0 * sqrt((v - 0.6) * (v + 0.6)))
FORM(kink, 0.3 * v * acos(0.6 / v))

static const struct { const char *work; void (*run)(void *); double low, high; } FORMS[] = {
    {"closed paraboloid", paraboloid, 0.01, 3.0}, {"closed sphere", sphere, 0.01, 1.99}, {"closed power", power, 0.01, 3.0},
    {"closed root", root, 0.01, 3.0},             {"closed worn", worn, 0.61, 3.0},      {"closed kink", kink, 0.61, 3.0},
};

int main(void)
{
    for (unsigned f = 0; f < sizeof FORMS / sizeof *FORMS; f++) {
        for (int i = 0; i < POINTS; i++) x[i] = FORMS[f].low + (FORMS[f].high - FORMS[f].low) * (i + 0.5) / POINTS;
        line(FORMS[f].work, "C", "gcc -O2", median_ns(FORMS[f].run, 0) / POINTS, 0.0, 0);
        if (!(g[POINTS / 2] > 0.0)) return 1;
    }
    return 0;
}
