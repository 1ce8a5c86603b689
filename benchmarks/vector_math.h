/* exp, tanh, sin and cos without branches or tables, to a few units in the last place: a compiler makes them vector code.
   Calls of the C library would end the vectors. */
#include <math.h>
#include <stdint.h>
#include <string.h>

#define HORNER(c) p = fma(p, r, c)

/* 2^n for a whole n from -1022 to 1023 */
static inline double power_of_two(double n) {
    int64_t bits = ((int64_t)n + 1023) << 52;
    double power;
    memcpy(&power, &bits, sizeof power);
    return power;
}

/* e^r - 1 of x = n ln 2 + r: interpolated at Chebyshev points, to 1.3e-17; terms in pairs, which run side by side */
static inline double exp_less_one(double x, double *n) {
    *n = rint(x * 1.4426950408889634);
    double r = fma(-*n, 1.9082149292705877e-10, fma(-*n, 0.69314718036912382, x)), r2 = r * r, r4 = r2 * r2;
    double a = fma(r, 0.16666666666666669, 0.5000000000000001), b = fma(r, 0.008333333333330008, 0.041666666666624115);
    double c = fma(r, 0.0001984126986320094, 0.001388888891721834), d = fma(r, 2.7557268299267734e-06, 2.4801521290566992e-05);
    double e = fma(r, 2.5100445462573073e-08, 2.7620090550614496e-07);
    return fma(fma(fma(e, r4, fma(d, r2, c)), r4, fma(b, r2, a)), r2, r);
}

/* exp of x <= 0, cut off before it becomes a denormal */
static inline double vector_exp(double x) {
    double n, p = exp_less_one(x > -700.0 ? x : -700.0, &n);
    return x > -700.0 ? power_of_two(n) * (1.0 + p) : 0.0;
}

static inline double vector_tanh(double x) {
    double size = fabs(x), n, p = exp_less_one(2.0 * (size < 20.0 ? size : 20.0), &n), power = power_of_two(n);
    double rise = fma(power, p, power - 1.0); /* e^(2|x|) - 1 */
    return copysign(rise / (rise + 2.0), x);
}

/* x = n pi/2 + r, then the polynomials of fdlibm */
static inline void vector_sincos(double x, double *sine, double *cosine) {
    double n = rint(x * 0.63661977236758134);
    double r0 = fma(-n, 2.0222662487959506e-21, fma(-n, 6.0771005063039660e-11, fma(-n, 1.5707963267341256, x)));
    double r = r0 * r0, p = 1.5896909952115501e-10;
    HORNER(-2.5050760253406863e-08), HORNER(2.7557313707070068e-06), HORNER(-1.9841269829857949e-04);
    HORNER(8.3333333333224895e-03), HORNER(-1.6666666666666632e-01);
    double s = fma(p * r, r0, r0);
    p = -1.1359647557788195e-11;
    HORNER(2.0875723212981748e-09), HORNER(-2.7557314351390663e-07), HORNER(2.4801587289476729e-05);
    HORNER(-1.3888888888874110e-03), HORNER(4.1666666666666602e-02);
    double c = fma(p * r, r, fma(-0.5, r, 1.0));
    int64_t quarter = (int64_t)n;
    double first = quarter & 1 ? c : s, second = quarter & 1 ? s : c;
    *sine = quarter & 2 ? -first : first;
    *cosine = (quarter + 1) & 2 ? -second : second;
}
