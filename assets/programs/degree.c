/* In radians, which C takes. */
static const double degree = 3.14159265358979323846 / 180;
