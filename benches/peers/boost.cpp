// Boost.Math on g(x) at 1e-12, pointwise: Gauss–Kronrod over the angle, tanh-sinh over the radius with its distance to the end.
#include "bench.h"
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <exception>

using boost::math::quadrature::gauss_kronrod;
using boost::math::quadrature::tanh_sinh;

static long evaluations;
static const double TOLERANCE = 1e-12;
static tanh_sinh<double> double_exponential(15);

template <profile P, int Points> struct kronrod {
    struct place place;
    double found;
    static void call(void *data)
    {
        auto *own = static_cast<kronrod *>(data);
        double x = own->place.x, kink = kink_of(P), start = kink > 0.0 ? asin(kink / x) : 0.0, error, size;
        auto f = [x](double t) { evaluations++; return x * slope(P, x * sin(t)); };
        own->found = gauss_kronrod<double, Points>::integrate(f, start, QUARTER, 15, TOLERANCE, &error, &size);
        // The kink is told: two pieces that meet there.
        if (kink > 0.0) own->found += gauss_kronrod<double, Points>::integrate(f, 0.0, start, 15, TOLERANCE, &error, &size);
    }
};

template <profile P> struct exponential {
    struct place place;
    double found;
    static void call(void *data)
    {
        auto *own = static_cast<exponential *>(data);
        double x = own->place.x, start = kink_of(P), error, size;
        // The second argument is the distance to the nearer end, positive at the upper one.
        auto f = [x](double r, double rest) { evaluations++; return x * slope(P, r) / sqrt((rest > 0.0 ? rest : x - r) * (x + r)); };
        own->found = double_exponential.integrate(f, start, x, TOLERANCE, &error, &size);
        if (start > 0.0) {
            auto before = [x](double r) { evaluations++; return x * slope(P, r) / sqrt((x - r) * (x + r)); };
            own->found += double_exponential.integrate(before, 0.0, start, TOLERANCE, &error, &size);
        }
    }
};

template <class Task> static void run(const place &place, const char *form)
{
    Task own{place, 0.0};
    evaluations = 0;
    try {
        Task::call(&own);
    } catch (const std::exception &) {
        return;
    }
    long count = evaluations;
    double ns = median_ns(Task::call, &own);
    line(place.work, "Boost", form, ns, relative_error(&place, own.found), count);
}

template <profile P> static void every(const place &place)
{
    run<kronrod<P, 15>>(place, "gk15");
    run<kronrod<P, 31>>(place, "gk31");
    run<kronrod<P, 61>>(place, "gk61");
    run<exponential<P>>(place, "tanh_sinh");
}

int main(int count, char **arguments)
{
    place places[64];
    if (count != 2) return 1;
    int all = read_places(arguments[1], places, 64);
    for (int i = 0; i < all; i++) {
        const place &own = places[i];
        if (!strncmp(own.work, "force", 5) || !strncmp(own.work, "pressure", 8)) continue;
        switch (own.profile) {
        case SPHERE: every<SPHERE>(own); break;
        case POWER: every<POWER>(own); break;
        case WORN: every<WORN>(own); break;
        case COSINE: every<COSINE>(own); break;
        case ROOT: every<ROOT>(own); break;
        case LN_COSH: every<LN_COSH>(own); break;
        case GAUSSIAN: every<GAUSSIAN>(own); break;
        default: every<KINK>(own);
        }
    }
    return 0;
}
