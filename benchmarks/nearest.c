/* The nearest point on a path of lines in three axes, within a window of arc length around the place of each sample. */
#include <math.h>
#include <stddef.h>

/* corner: (lines + 1) x 3; along: arc length at each; place: of n samples; distance, foot: of the nearest point */
void nearest(const double *corner, const double *along, ptrdiff_t lines, const double *point, const double *place, double window,
             ptrdiff_t n, double *distance, double *foot) {
    ptrdiff_t first = 0;
    for (ptrdiff_t k = 0; k < n; k++, point += 3) {
        const double low = place[k] - window, high = place[k] + window;
        double least = INFINITY;
        while (first > 0 && along[first] > low) first--;
        while (first < lines - 1 && along[first + 1] < low) first++;
        for (ptrdiff_t i = first; i < lines && along[i] <= high; i++) {
            const double *a = corner + 3 * i, length = along[i + 1] - along[i];
            const double from = low > along[i] ? low - along[i] : 0.0, to = high < along[i + 1] ? high - along[i] : length;
            double way[3] = {(a[3] - a[0]) / length, (a[4] - a[1]) / length, (a[5] - a[2]) / length};
            double gap[3] = {point[0] - a[0], point[1] - a[1], point[2] - a[2]};
            double s = way[0] * gap[0] + way[1] * gap[1] + way[2] * gap[2], square = 0.0;
            s = s < from ? from : s > to ? to : s;
            for (int j = 0; j < 3; j++) square += (gap[j] - s * way[j]) * (gap[j] - s * way[j]);
            if (square < least) least = square, foot[k] = along[i] + s;
        }
        distance[k] = sqrt(least);
    }
}
