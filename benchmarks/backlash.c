/* The stage with backlash of backlash.py, written by hand: two axes on a circle, one variant, SI units.
   Motor and load of an axis are joined by a damped shaft with a gap; the load sticks. A sub-step is divided where a flank is reached or
   left and where the load stops or breaks loose, each located on the cubic through both ends, as contourlab does. */
#include <math.h>
#include <stddef.h>

typedef struct {
    double force, motor_mobility, load_mobility, motor_decay, load_decay;                   /* plant: masses and viscous damping */
    double stiffness, damper, half_gap, unwinding;                                          /* its shaft */
    double coulomb, breakaway, inverse_stribeck, viscous;                                   /* friction of the load */
    double difference_weight, velocity_weight, filter, estimate_weight, inverse_gain;       /* filtered difference, observer */
    double position_gain, velocity_gain, integral_rate, forward_velocity, forward_acceleration; /* cascade */
} axis_t;

typedef struct { double motor, motor_velocity, load, load_velocity; } motion_t;
typedef struct { double motor, load; } pair_t;

typedef struct {
    motion_t y;
    double side, twist;       /* 1 or -1 on a flank, 0 in the gap; twist that the shaft kept there */
    double previous, velocity, filtered, estimate, integral, applied;
} state_t;

/* A cubic through values and slopes at both ends of a step, over the part u of the step; an event past its end happens NEVER. */
typedef struct { double c0, c1, c2, c3; } cubic_t;
static const double NEVER = 2.0;

static inline cubic_t cubic(double y0, double y1, double d0, double d1) {
    return (cubic_t){y0, d0, 3.0 * (y1 - y0) - 2.0 * d0 - d1, 2.0 * (y0 - y1) + d0 + d1};
}

static inline double at(cubic_t c, double u) { return c.c0 + u * (c.c1 + u * (c.c2 + u * c.c3)); }

static double lowest(cubic_t c) {
    double radicand = c.c2 * c.c2 - 3.0 * c.c3 * c.c1, root = sqrt(fabs(radicand));
    double over = c.c2 > 0.0 ? c.c2 + root : 3.0 * c.c3;
    return radicand < 0.0 || over == 0.0 ? NEVER : (c.c2 > 0.0 ? -c.c1 : root - c.c2) / over;
}

/* Newton's method in a bracket; the cubic ends below zero. */
static double first_zero(cubic_t c) {
    double low = 0.0, high = 1.0;
    if (c.c1 < 0.0 || c.c3 < 0.0) {
        double bottom = lowest(c);
        if (0.0 < bottom && bottom < 1.0 && at(c, bottom) < 0.0) high = bottom;
    }
    double u = high;
    for (int i = 0; i < 50; i++) {
        double value = at(c, u), slope = c.c1 + u * (2.0 * c.c2 + 3.0 * u * c.c3);
        if (value == 0.0) break;
        if (value > 0.0) low = u; else high = u;
        double last = u, wanted = u - value / (slope == 0.0 ? 1.0 : slope);
        u = wanted >= low && wanted <= high && fabs(wanted - u) < high - low ? wanted : 0.5 * (low + high);
        if (fabs(u - last) <= 1e-15) break;
    }
    return u;
}

/* Where the cubic falls below zero between ends above. */
static inline double first_dip(double y0, double y1, double d0, double d1) {
    if (!(y0 > 0.0 && d0 < 0.0 && d1 > 0.0)) return NEVER;
    cubic_t c = cubic(y0, y1, d0, d1);
    double bottom = lowest(c), depth = at(c, bottom);
    return depth < 0.0 ? bottom * first_zero(cubic(y0, depth, bottom * d0, 0.0)) : NEVER;
}

static inline double falling_exp(double x) { return x > -700.0 ? exp(x) : 0.0; }

static inline double friction(const axis_t *a, double speed) {
    double ratio = speed * a->inverse_stribeck;
    return a->coulomb + (a->breakaway - a->coulomb) * falling_exp(-ratio * ratio) + a->viscous * speed;
}

static inline double shaft(const axis_t *a, double side, motion_t y) {
    if (side == 0.0) return 0.0;
    return a->stiffness * (y.motor - y.load - side * a->half_gap) + a->damper * (y.motor_velocity - y.load_velocity);
}

/* Accelerations while the load slides in the direction `way`; 0: it is held. */
static inline pair_t rates(const axis_t *a, double side, double way, double push, motion_t y) {
    double torque = shaft(a, side, y), load = torque - way * friction(a, way * y.load_velocity);
    return (pair_t){a->motor_mobility * (push - torque) - a->motor_decay * y.motor_velocity,
                    way == 0.0 ? 0.0 : a->load_mobility * load - a->load_decay * y.load_velocity};
}

static inline motion_t ahead(motion_t y, motion_t slope, pair_t rate, double h) {
    return (motion_t){y.motor + h * slope.motor_velocity, y.motor_velocity + h * rate.motor,
                      y.load + h * slope.load_velocity, y.load_velocity + h * rate.load};
}

/* A Runge-Kutta step, with the accelerations at its start and at its last stage. */
static inline motion_t slide(const axis_t *a, double side, double way, double push, motion_t y, double h, pair_t *first, pair_t *last) {
    pair_t k1 = rates(a, side, way, push, y);
    motion_t y2 = ahead(y, y, k1, 0.5 * h);
    pair_t k2 = rates(a, side, way, push, y2);
    motion_t y3 = ahead(y, y2, k2, 0.5 * h);
    pair_t k3 = rates(a, side, way, push, y3);
    motion_t y4 = ahead(y, y3, k3, h);
    pair_t k4 = rates(a, side, way, push, y4);
    motion_t mean = {0.0, (y.motor_velocity + 2.0 * (y2.motor_velocity + y3.motor_velocity) + y4.motor_velocity) / 6.0,
                     0.0, (y.load_velocity + 2.0 * (y2.load_velocity + y3.load_velocity) + y4.load_velocity) / 6.0};
    pair_t rate = {(k1.motor + 2.0 * (k2.motor + k3.motor) + k4.motor) / 6.0, (k1.load + 2.0 * (k2.load + k3.load) + k4.load) / 6.0};
    *first = k1, *last = k4;
    return ahead(y, mean, rate, h);
}

static inline double shaft_slope(const axis_t *a, double side, motion_t y, pair_t rate) {
    if (side == 0.0) return 0.0;
    return a->stiffness * (y.motor_velocity - y.load_velocity) + a->damper * (rate.motor - rate.load);
}

static inline double unwound(const axis_t *a, double twist, double h) { return twist == 0.0 ? 0.0 : twist * exp(-a->unwinding * h); }

/* Falls to zero where the shaft leaves its flank, or crosses the gap to `flank`. */
static inline double contact(const axis_t *a, double side, double flank, motion_t y, double twist) {
    return side == 0.0 ? a->half_gap - flank * (y.motor - y.load - twist) : side * shaft(a, side, y);
}

static inline double contact_slope(const axis_t *a, double side, double flank, motion_t y, pair_t rate, double twist) {
    double apart = y.motor_velocity - y.load_velocity;
    return side == 0.0 ? -flank * (apart + a->unwinding * twist) : side * shaft_slope(a, side, y, rate);
}

/* Where a load that slides in the direction `way` stops, or a held one breaks loose `toward`; y, rate and y1, rate1 at both ends of h. */
static inline double load_event(const axis_t *a, double side, double way, double toward, motion_t y, motion_t y1, pair_t rate, pair_t rate1,
                                double h) {
    if (way == 0.0) {
        double hold = a->breakaway - toward * shaft(a, side, y), hold1 = a->breakaway - toward * shaft(a, side, y1);
        double d0 = -toward * h * shaft_slope(a, side, y, rate), d1 = -toward * h * shaft_slope(a, side, y1, rate1);
        return hold1 < 0.0 ? first_zero(cubic(hold, hold1, d0, d1)) : NEVER;
    }
    double v0 = way * y.load_velocity, v1 = way * y1.load_velocity, d0 = way * h * rate.load, d1 = way * h * rate1.load;
    return v1 < 0.0 ? first_zero(cubic(v0, v1, d0, d1)) : first_dip(v0, v1, d0, d1);
}

/* Follow the motion to the next event or the end of h; return the time left. A load just `released` slides that way. */
static inline double stretch(const axis_t *a, state_t *x, double push, double *released, double h) {
    const motion_t y = x->y;
    const double side = x->side, twist = x->twist, torque = shaft(a, side, y);
    double rest = fabs(torque) <= a->breakaway ? *released : copysign(1.0, torque);
    double way = y.load_velocity == 0.0 ? rest : copysign(1.0, y.load_velocity);
    pair_t rate, rate1;
    motion_t y1 = slide(a, side, way, push, y, h, &rate, &rate1);
    double twist1 = unwound(a, twist, h), flank = y1.motor - y1.load - twist1 > 0.0 ? 1.0 : -1.0;
    double toward = shaft(a, side, y1) > 0.0 ? 1.0 : -1.0;
    double touch = NEVER, guard1 = contact(a, side, flank, y1, twist1);
    if (guard1 < 0.0) {
        double d0 = contact_slope(a, side, flank, y, rate, twist), d1 = contact_slope(a, side, flank, y1, rate1, twist1);
        touch = first_zero(cubic(contact(a, side, flank, y, twist), guard1, h * d0, h * d1));
    }
    double stop = load_event(a, side, way, toward, y, y1, rate, rate1, h), u = stop < touch ? stop : touch;
    if (u >= 1.0 && touch == NEVER) {
        x->y = y1, x->twist = twist1;
        return 0.0;
    }
    x->y = (motion_t){at(cubic(y.motor, y1.motor, h * y.motor_velocity, h * y1.motor_velocity), u),
                      at(cubic(y.motor_velocity, y1.motor_velocity, h * rate.motor, h * rate1.motor), u),
                      at(cubic(y.load, y1.load, h * y.load_velocity, h * y1.load_velocity), u),
                      at(cubic(y.load_velocity, y1.load_velocity, h * rate.load, h * rate1.load), u)};
    double kept = side == 0.0 ? unwound(a, twist, u * h) : x->y.motor - x->y.load - side * a->half_gap;
    *released = 0.0;
    if (stop < touch) x->y.load_velocity = 0.0, *released = way == 0.0 ? toward : 0.0;
    else x->side = side == 0.0 ? flank : 0.0;
    x->twist = x->side == 0.0 ? kept : 0.0;
    return (1.0 - u) * h;
}

static inline void move(const axis_t *a, state_t *x, double dt) {
    double left = dt, released = 0.0;
    while (left > 0.0) left = stretch(a, x, a->force * x->applied, &released, left);
}

static inline double control(const axis_t *a, state_t *x, double target, double measured, double rv, double ra, double dt) {
    x->velocity += a->difference_weight * ((x->y.motor - x->previous) / dt - x->velocity);
    x->previous = x->y.motor;
    x->filtered += a->velocity_weight * (x->velocity - x->filtered);
    x->estimate += a->estimate_weight * (a->filter * (x->velocity - x->filtered) * a->inverse_gain - x->applied - x->estimate);
    double speed_error = a->position_gain * (target - measured) + a->forward_velocity * rv - x->velocity;
    x->integral += dt * a->integral_rate * speed_error;
    return x->applied = a->velocity_gain * speed_error + x->integral + a->forward_acceleration * ra - x->estimate;
}

/* A point of the circle, and its distance to the tool. */
typedef struct { double angle, c, s, square; } foot_t;

static inline foot_t foot_at(double radius, double angle, double x, double y) {
    foot_t f = {angle, cos(angle), sin(angle), 0.0};
    double gx = radius * f.c - x, gy = radius * f.s - y;
    f.square = gx * gx + gy * gy;
    return f;
}

/* Two Newton steps towards the foot point, within a window around the reference. */
static inline foot_t seek(double radius, double angle, double x, double y, double centre, double window) {
    for (int i = 0; i < 2; i++) {
        double c = cos(angle), s = sin(angle), gx = radius * c - x, gy = radius * s - y;
        double slope = radius - (c * gx + s * gy);
        angle -= (c * gy - s * gx) / (slope > 0.1 * radius ? slope : 0.1 * radius);
        angle = angle < centre - window ? centre - window : angle;
        angle = angle > centre + window ? centre + window : angle;
    }
    return foot_at(radius, angle, x, y);
}

/* par: two axes, then radius, angular frequency, weight, window, resolution; log: n x (p1, p2, u1, u2, contour error) */
void simulate(const double *par, ptrdiff_t n, double dt, int substeps, double *log) {
    const axis_t *a = (const axis_t *)par, *b = a + 1;
    const double *rest = (const double *)(b + 1), radius = rest[0], rate = rest[1], weight = rest[2];
    const double window = rest[3] / radius, count = rest[4];
    state_t x = {.y = {radius, 0, radius, 0}, .previous = radius}, y = {0};
    double foot = 0.0;
    for (ptrdiff_t k = 0; k < n; k++, log += 5) {
        double angle = rate * ((double)k * dt), s = sin(angle), c = cos(angle);
        double px = count * rint(x.y.load / count), py = count * rint(y.y.load / count);
        foot_t warm = seek(radius, foot, px, py, angle, window), fresh = seek(radius, angle, px, py, angle, window);
        foot_t near = fresh.square < warm.square ? fresh : warm;
        foot = near.angle;
        double qx = radius * near.c, qy = radius * near.s;
        log[0] = x.y.load, log[1] = y.y.load;
        log[2] = control(a, &x, (1 - weight) * radius * c + weight * qx, px, -rate * radius * s, -rate * rate * radius * c, dt);
        log[3] = control(b, &y, (1 - weight) * radius * s + weight * qy, py, rate * radius * c, -rate * rate * radius * s, dt);
        log[4] = near.c * (qx - px) + near.s * (qy - py);
        for (int i = 0; i < substeps; i++) move(a, &x, dt / substeps), move(b, &y, dt / substeps);
    }
}
