static const double pi = 3.14159265358979323846;
