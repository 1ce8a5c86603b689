/* The benchmark's work, written by hand: two axes, one variant. benchmarks/README.md states it step by step.
   Lengths in mm, commands in parts of full scale. */
#include <math.h>
#include <stddef.h>

typedef struct {
    double gain, damping, coulomb, breakaway, stribeck, smoothing, limit;      /* plant, friction, drive */
    double bandwidth, filter, model_gain, model_damping;                       /* observer */
    double kv, kp, ki, forward_gain, forward_damping;                          /* controller */
} axis_t;

typedef struct { double position, velocity, filtered, estimate, integral, applied; } state_t;

/* exp of a large negative number is a denormal, which halves the speed: cut it off. */
static inline double falling_exp(double x) { return x > -700.0 ? exp(x) : 0.0; }

static inline double acceleration(const axis_t *a, double velocity, double command) {
    double ratio = velocity / a->stribeck;
    double level = a->coulomb + (a->breakaway - a->coulomb) * falling_exp(-ratio * ratio);
    return a->gain * (command - level * tanh(velocity / a->smoothing)) - a->damping * velocity;
}

static inline void move(const axis_t *a, state_t *x, double dt) {
    double u = x->applied, v1 = x->velocity, k1 = acceleration(a, v1, u);
    double v2 = v1 + 0.5 * dt * k1, k2 = acceleration(a, v2, u);
    double v3 = v1 + 0.5 * dt * k2, k3 = acceleration(a, v3, u);
    double v4 = v1 + dt * k3, k4 = acceleration(a, v4, u);
    x->position += dt / 6.0 * (v1 + 2.0 * (v2 + v3) + v4);
    x->velocity += dt / 6.0 * (k1 + 2.0 * (k2 + k3) + k4);
}

static inline double control(const axis_t *a, state_t *x, double target, double rv, double ra, double wz, double wd, double dt) {
    x->filtered += wz * (x->velocity - x->filtered);
    double slope = a->filter * (x->velocity - x->filtered);
    x->estimate += wd * ((slope + a->model_damping * x->velocity) / a->model_gain - x->applied - x->estimate);
    double error = target - x->position;
    x->integral += dt * error;
    double u = a->kv * (rv - x->velocity) + a->kp * error + a->kp * a->ki * x->integral
             + (ra + a->forward_damping * rv) / a->forward_gain - x->estimate;
    u = u > a->limit ? a->limit : u;
    return x->applied = u < -a->limit ? -a->limit : u;
}

/* par: two axes, then radius, angular frequency, weight; log: n x (p1, p2, u1, u2, contour error) */
void simulate(const double *par, ptrdiff_t n, double dt, double *log) {
    const axis_t *a = (const axis_t *)par, *b = a + 1;
    const double radius = par[32], rate = par[33], weight = par[34];
    state_t x = {radius, 0, 0, 0, 0, 0}, y = {0, 0, 0, 0, 0, 0};
    double foot = 0.0;
    const double zx = a->filter * dt / (1 + a->filter * dt), dx = a->bandwidth * dt / (1 + a->bandwidth * dt);
    const double zy = b->filter * dt / (1 + b->filter * dt), dy = b->bandwidth * dt / (1 + b->bandwidth * dt);
    for (ptrdiff_t k = 0; k < n; k++, log += 5) {
        double angle = rate * ((double)k * dt), s = sin(angle), c = cos(angle), fs = sin(foot), fc = cos(foot);
        double ex = radius * fc - x.position, ey = radius * fs - y.position;
        double along = radius * (fc * ey - fs * ex);
        double bend = radius * radius - radius * (fc * ex + fs * ey);
        foot -= along / bend;
        fs = sin(foot), fc = cos(foot);
        double qx = radius * fc, qy = radius * fs, tx = -radius * fs, ty = radius * fc;
        double error = (tx * (y.position - qy) - ty * (x.position - qx)) / sqrt(tx * tx + ty * ty);
        double mx = (1 - weight) * radius * c + weight * qx, my = (1 - weight) * radius * s + weight * qy;
        log[0] = x.position, log[1] = y.position;
        log[2] = control(a, &x, mx, -rate * radius * s, -rate * rate * radius * c, zx, dx, dt);
        log[3] = control(b, &y, my, rate * radius * c, -rate * rate * radius * s, zy, dy, dt);
        log[4] = error;
        move(a, &x, dt);
        move(b, &y, dt);
    }
}
