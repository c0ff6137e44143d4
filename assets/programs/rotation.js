// As glRotate; without an axis nothing turns.
function rotation(degrees, x, y, z) {
    const length = Math.hypot(x, y, z);
    if (length === 0) return translation(0, 0, 0);
    const turn = degrees % 360;
    const right = turn % 90 === 0; // whose sine and cosine are whole
    const sine = right ? Math.round(Math.sin((turn * Math.PI) / 180)) : Math.sin((turn * Math.PI) / 180);
    const cosine = right ? Math.round(Math.cos((turn * Math.PI) / 180)) : Math.cos((turn * Math.PI) / 180);
    x /= length;
    y /= length;
    z /= length;
    const rest = 1 - cosine;
    return [
        rest * x * x + cosine, rest * x * y + sine * z, rest * x * z - sine * y, 0,
        rest * y * x - sine * z, rest * y * y + cosine, rest * y * z + sine * x, 0,
        rest * z * x + sine * y, rest * z * y - sine * x, rest * z * z + cosine, 0,
        0, 0, 0, 1,
    ];
}
