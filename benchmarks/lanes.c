/* The loop of reference.c for any number of axes on a sampled reference, each variant in a lane of its own.
   Compiled with AXES, with WIDTH, the number of lanes (1: a single variant), and with TABLE for a path in quintic pieces, else a circle.
   Each loop over the lanes is free of branches and calls, so that a compiler makes it vector code. Lengths in mm. */
#include <stddef.h>
#include "vector_math.h"
#if WIDTH == 1 /* no vectors: the C library is faster */
#define vector_exp(x) ((x) > -700.0 ? exp(x) : 0.0)
#define vector_tanh tanh
#define vector_sincos(x, sine, cosine) (*(sine) = sin(x), *(cosine) = cos(x))
#endif

#define LANES _Pragma("omp simd") for (int i = 0; i < WIDTH; i++)
#define SAMPLE (3 * AXES + 1) /* of the reference: position, velocity and acceleration of each axis, arc length */
#define SIGNALS (2 * AXES + 1) /* of the log: position and command of each axis, contour error */

typedef double lane_t[WIDTH] __attribute__((aligned(WIDTH % 8 ? 8 : 64)));

/* What does not change during a run is worked out before it: inverse values, and weights of the low-passes. */
typedef struct {
    lane_t gain, damping, coulomb, breakaway, inverse_stribeck, inverse_smoothing, limit;   /* plant, friction, drive */
    lane_t estimate_weight, velocity_weight, filter, inverse_model_gain, model_damping;     /* observer */
    lane_t kv, kp, ki, forward_acceleration, forward_velocity;                              /* controller */
} axis_t;

typedef struct { lane_t position, velocity, filtered, estimate, integral, applied; } state_t;

/* Whether exp or tanh of the friction differs from 0 or 1 in any lane, as they do near rest alone: elsewhere they are left out, which
   halves the time, and which contourlab and the C library do too. */
static inline int near_rest(const axis_t *a, const lane_t velocity) {
    int near = WIDTH == 1;
    _Pragma("omp simd reduction(|:near)") for (int i = 0; i < WIDTH; i++) {
        double ratio = velocity[i] * a->inverse_stribeck[i];
        near |= (ratio * ratio < 700.0) | (fabs(velocity[i] * a->inverse_smoothing[i]) < 20.0);
    }
    return near;
}

static inline void acceleration(const axis_t *a, const lane_t velocity, const lane_t command, lane_t found) {
    if (near_rest(a, velocity)) LANES {
        double ratio = velocity[i] * a->inverse_stribeck[i], sign = vector_tanh(velocity[i] * a->inverse_smoothing[i]);
        double level = a->coulomb[i] + (a->breakaway[i] - a->coulomb[i]) * vector_exp(-ratio * ratio);
        found[i] = a->gain[i] * (command[i] - level * sign) - a->damping[i] * velocity[i];
    } else LANES found[i] = a->gain[i] * (command[i] - copysign(a->coulomb[i], velocity[i])) - a->damping[i] * velocity[i];
}

static inline void move(const axis_t *a, state_t *x, double dt) {
    lane_t k1, k2, k3, k4, v2, v3, v4;
    acceleration(a, x->velocity, x->applied, k1);
    LANES v2[i] = x->velocity[i] + 0.5 * dt * k1[i];
    acceleration(a, v2, x->applied, k2);
    LANES v3[i] = x->velocity[i] + 0.5 * dt * k2[i];
    acceleration(a, v3, x->applied, k3);
    LANES v4[i] = x->velocity[i] + dt * k3[i];
    acceleration(a, v4, x->applied, k4);
    LANES {
        x->position[i] += dt / 6.0 * (x->velocity[i] + 2.0 * (v2[i] + v3[i]) + v4[i]);
        x->velocity[i] += dt / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
    }
}

static inline double control(const axis_t *a, state_t *x, int i, double target, double rv, double ra, double dt) {
    double v = x->velocity[i], error = target - x->position[i];
    x->filtered[i] += a->velocity_weight[i] * (v - x->filtered[i]);
    double slope = a->filter[i] * (v - x->filtered[i]);
    double push = (slope + a->model_damping[i] * v) * a->inverse_model_gain[i] - x->applied[i];
    x->estimate[i] += a->estimate_weight[i] * (push - x->estimate[i]);
    x->integral[i] += dt * error;
    double u = a->kv[i] * (rv - v) + a->kp[i] * error + a->ki[i] * x->integral[i]
             + a->forward_acceleration[i] * ra + a->forward_velocity[i] * rv - x->estimate[i];
    u = u > a->limit[i] ? a->limit[i] : u;
    return x->applied[i] = u < -a->limit[i] ? -a->limit[i] : u;
}

#ifdef TABLE
typedef struct {
    const double *start, *coefficients;  /* of each piece: arc length, and AXES x 6 coefficients of its powers */
    const int *cell;                     /* the first piece in each cell of equal length; at most one more starts inside */
    double inverse_cell, length;
    int last_cell, last_piece;
} path_t;
typedef struct { lane_t beyond; int base[WIDTH]; } place_t;

static inline void locate(const path_t *path, const lane_t s, place_t *at) {
    LANES {
        double along = s[i] - path->length * floor(s[i] * (1.0 / path->length));
        along = along < 0.0 ? 0.0 : along;
        along = along > path->length ? path->length : along;
        int cell = (int)(along * path->inverse_cell);
        int piece = path->cell[cell < path->last_cell ? cell : path->last_cell];
        piece += along >= path->start[piece + 1];
        piece = piece < path->last_piece ? piece : path->last_piece;
        at->beyond[i] = along - path->start[piece];
        at->base[i] = 6 * AXES * piece;
    }
}

/* Point and derivatives of axis j. */
static inline void evaluate(const path_t *path, const place_t *at, int i, int j, double *q, double *q1, double *q2) {
    const double *c = path->coefficients + 6 * j, h = at->beyond[i];
    int k = at->base[i];
    double c0 = c[k], c1 = c[k + 1], c2 = c[k + 2], c3 = c[k + 3], c4 = c[k + 4], c5 = c[k + 5];
    *q = c0 + h * (c1 + h * (c2 + h * (c3 + h * (c4 + h * c5))));
    *q1 = c1 + h * (2.0 * c2 + h * (3.0 * c3 + h * (4.0 * c4 + h * 5.0 * c5)));
    *q2 = 2.0 * c2 + h * (6.0 * c3 + h * (12.0 * c4 + h * 20.0 * c5));
}
#else
typedef struct { double radius, curvature; } path_t;
typedef struct { lane_t sine, cosine; } place_t;

static inline void locate(const path_t *path, const lane_t s, place_t *at) {
    LANES vector_sincos(s[i] * path->curvature, &at->sine[i], &at->cosine[i]);
}

static inline void evaluate(const path_t *path, const place_t *at, int i, int j, double *q, double *q1, double *q2) {
    double unit = j == 0 ? at->cosine[i] : at->sine[i];
    *q = path->radius * unit;
    *q1 = j == 0 ? -at->sine[i] : at->cosine[i];
    *q2 = -unit * path->curvature;
}
#endif

/* Move the foot points by a Newton step on the distance, within the window around the reference. */
static inline void improve(const path_t *path, const state_t *x, double centre, double window, lane_t foot) {
    lane_t along, square, bend;
    place_t at;
    locate(path, foot, &at);
    for (int j = 0; j < AXES; j++) LANES {
        double q, q1, q2;
        evaluate(path, &at, i, j, &q, &q1, &q2);
        double gap = q - x[j].position[i];
        along[i] = (j ? along[i] : 0.0) + q1 * gap;
        square[i] = (j ? square[i] : 0.0) + q1 * q1;
        bend[i] = (j ? bend[i] : 0.0) + q2 * gap;
    }
    LANES {
        double slope = square[i] + bend[i], least = 0.1 * square[i];
        double s = foot[i] - along[i] / (slope > least ? slope : least);
        s = s < centre - window ? centre - window : s;
        foot[i] = s > centre + window ? centre + window : s;
    }
}

#if AXES == 2
/* Sample the reference of the circle, from an angle of zero. */
void sample_circle(ptrdiff_t n, double dt, double radius, double rate, double *reference) {
    for (ptrdiff_t k = 0; k < n; k++, reference += SAMPLE) {
        double angle = rate * ((double)k * dt), s = sin(angle), c = cos(angle), speed = rate * radius;
        double row[] = {radius * c, radius * s, -speed * s, speed * c, -rate * speed * c, -rate * speed * s, radius * angle};
        memcpy(reference, row, sizeof row);
    }
}
#endif

/* axis: AXES of them; weight: WIDTH; log: n x SIGNALS x WIDTH */
void simulate(const axis_t *axis, const double *weight, const path_t *path, const double *reference, ptrdiff_t n, double dt, double window,
              double *log) {
    state_t x[AXES] = {0};
    lane_t foot;
    LANES foot[i] = reference[3 * AXES];
    for (int j = 0; j < AXES; j++) LANES x[j].position[i] = reference[j];
    for (ptrdiff_t k = 0; k < n; k++, reference += SAMPLE, log += SIGNALS * WIDTH) {
        place_t at;
        lane_t q[AXES], q1[AXES], square, along, error;
        improve(path, x, reference[3 * AXES], window, foot);
        locate(path, foot, &at);
        for (int j = 0; j < AXES; j++) LANES {
            double unused;
            evaluate(path, &at, i, j, &q[j][i], &q1[j][i], &unused);
            square[i] = (j ? square[i] : 0.0) + q1[j][i] * q1[j][i];
            along[i] = (j ? along[i] : 0.0) + q1[j][i] * (q[j][i] - x[j].position[i]);
        }
#if AXES == 2 /* with a sign */
        LANES error[i] = (q1[1][i] * (q[0][i] - x[0].position[i]) - q1[0][i] * (q[1][i] - x[1].position[i])) / sqrt(square[i]);
#else
        for (int j = 0; j < AXES; j++) LANES {
            double normal = q[j][i] - x[j].position[i] - along[i] / square[i] * q1[j][i];
            error[i] = (j ? error[i] : 0.0) + normal * normal;
        }
        LANES error[i] = sqrt(error[i]);
#endif
        for (int j = 0; j < AXES; j++) {
            double r = reference[j], rv = reference[AXES + j], ra = reference[2 * AXES + j];
            LANES {
                log[j * WIDTH + i] = x[j].position[i];
                double target = (1.0 - weight[i]) * r + weight[i] * q[j][i];
                log[(AXES + j) * WIDTH + i] = control(axis + j, x + j, i, target, rv, ra, dt);
            }
            move(axis + j, x + j, dt);
        }
        LANES log[2 * AXES * WIDTH + i] = error[i];
    }
}
