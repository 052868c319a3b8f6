/* GSL on g(x) = x int f'(x sin t) dt at 1e-12, pointwise; and F and p of ln cosh by its integrators nested in each other. */
#include "bench.h"
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

static gsl_integration_workspace *outer, *inner;
static gsl_integration_cquad_workspace *clenshaw;
static gsl_integration_qaws_table *edge;
static long evaluations;
static const double TOLERANCE = 1e-12;

/* One integrand per profile, so that the compiler sees the formula and not a switch. */
#define EACH(P) \
    static double angle_##P(double t, void *x) { evaluations++; double a = *(double *)x; return a * slope(P, a * sin(t)); } \
    static double weighted_##P(double r, void *x) { evaluations++; double a = *(double *)x; return a * slope(P, r) / sqrt(a + r); }
EACH(SPHERE) EACH(POWER) EACH(WORN) EACH(COSINE) EACH(ROOT) EACH(LN_COSH) EACH(GAUSSIAN) EACH(KINK)
typedef double (*integrand)(double, void *);
static const integrand ANGLE[] = {angle_SPHERE, angle_POWER, angle_WORN, angle_COSINE, angle_ROOT, angle_LN_COSH, angle_GAUSSIAN, angle_KINK};
static const integrand WEIGHTED[] = {weighted_SPHERE, weighted_POWER, weighted_WORN, weighted_COSINE,
                                     weighted_ROOT, weighted_LN_COSH, weighted_GAUSSIAN, weighted_KINK};

enum way { QAG15, QAG21, QAG31, QAG61, QAGS, CQUAD, QAWS, WAYS };
static const char *const WAY[WAYS] = {"qag15", "qag21", "qag31", "qag61", "qags", "cquad", "qaws"};
struct task { struct place place; enum way way; double found; int failed; };

static void piece(struct task *own, double start, double end)
{
    gsl_function f = {own->way == QAWS ? WEIGHTED[own->place.profile] : ANGLE[own->place.profile], &own->place.x};
    double value = 0.0, error;
    size_t count;
    int status, key = own->way == QAG15 ? 1 : own->way == QAG21 ? 2 : own->way == QAG31 ? 3 : 6;
    switch (own->way) {
    case CQUAD: status = gsl_integration_cquad(&f, start, end, 0, TOLERANCE, clenshaw, &value, &error, &count); break;
    case QAGS: status = gsl_integration_qags(&f, start, end, 0, TOLERANCE, 1000, inner, &value, &error); break;
    case QAWS: status = gsl_integration_qaws(&f, start, end, edge, 0, TOLERANCE, 1000, inner, &value, &error); break;
    default: status = gsl_integration_qag(&f, start, end, 0, TOLERANCE, 1000, key, inner, &value, &error);
    }
    own->found += value;
    own->failed |= status;
}

/* The kink is told: two pieces that meet there. */
static void integrate(void *data)
{
    struct task *own = data;
    double kink = kink_of(own->place.profile), x = own->place.x, end = own->way == QAWS ? x : QUARTER;
    own->found = 0.0;
    own->failed = 0;
    if (kink > 0.0) {
        double middle = own->way == QAWS ? kink : asin(kink / x);
        piece(own, 0.0, middle);
        piece(own, middle, end);
    } else {
        piece(own, 0.0, end);
    }
}

static void pointwise(struct place place)
{
    for (int way = 0; way < WAYS; way++) {
        /* The weight belongs to the end of the last piece only. */
        if (way == QAWS && kink_of(place.profile) > 0.0) continue;
        struct task own = {place, (enum way)way, 0.0, 0};
        evaluations = 0;
        integrate(&own);
        long count = evaluations;
        if (own.failed) continue;
        double ns = median_ns(integrate, &own);
        line(place.work, "GSL", WAY[way], ns, relative_error(&place, own.found), count);
    }
}

/* Nested: g or g' by an inner integral at every point of an outer one, for ln cosh. */
struct nest { double a, s, g_at_a, found; };
static double rise_angle(double t, void *x)
{
    evaluations++;
    double r = *(double *)x * sin(t), u = tanh(r);
    return u + r * (1.0 - u * u);
}
static double inside(integrand f, double x)
{
    gsl_function own = {f, &x};
    double value, error;
    gsl_integration_qags(&own, 0, QUARTER, 0, TOLERANCE, 500, inner, &value, &error);
    return value;
}
static double gap(double x, void *data) { return ((struct nest *)data)->g_at_a - inside(angle_LN_COSH, x); }
static double rise(double y, void *data) { return inside(rise_angle, ((struct nest *)data)->s * cosh(y)); }
static void force(void *data)
{
    struct nest *own = data;
    gsl_function f = {gap, own};
    double error;
    own->g_at_a = inside(angle_LN_COSH, own->a);
    gsl_integration_qags(&f, 0, own->a, 0, 1e-11, 500, outer, &own->found, &error);
    own->found *= 2.0;
}
static void pressure(void *data)
{
    struct nest *own = data;
    gsl_function f = {rise, own};
    double error;
    gsl_integration_qags(&f, 0, acosh(own->a / own->s), 0, 1e-11, 500, outer, &own->found, &error);
}
#define MANY 100
/* The same at places all over the contact; each starts anew. */
static void pressures(void *data)
{
    struct nest *own = data;
    for (int i = 0; i < MANY; i++) {
        own->s = own->a * (i + 0.5) / MANY;
        pressure(own);
    }
}
static void nested(struct place place, void (*call)(void *))
{
    struct nest own = {3.0, place.x, 0.0, 0.0};
    evaluations = 0;
    call(&own);
    long count = evaluations;
    double ns = median_ns(call, &own);
    line(place.work, "GSL", "qags in qags", ns, relative_error(&place, own.found), count);
    if (call != pressure) return;
    /* The error is that of the single place. */
    double error = relative_error(&place, own.found);
    evaluations = 0;
    pressures(&own);
    count = evaluations / MANY;
    line("pressure 100 points", "GSL", "qags in qags", median_ns(pressures, &own) / MANY, error, count);
}

int main(int count, char **arguments)
{
    struct place places[64];
    if (count != 2) return 1;
    int all = read_places(arguments[1], places, 64);
    gsl_set_error_handler_off();
    outer = gsl_integration_workspace_alloc(1000);
    inner = gsl_integration_workspace_alloc(1000);
    clenshaw = gsl_integration_cquad_workspace_alloc(1000);
    edge = gsl_integration_qaws_table_alloc(0, -0.5, 0, 0);
    for (int i = 0; i < all; i++) {
        if (!strncmp(places[i].work, "force", 5)) nested(places[i], force);
        else if (!strncmp(places[i].work, "pressure", 8)) nested(places[i], pressure);
        else pointwise(places[i]);
    }
    return 0;
}
