// As gluPerspective: the angle is vertical, in degrees.
function perspective(angle, aspect, nearest, farthest) {
    const top = nearest * Math.tan((angle * Math.PI) / 360);
    const depth = farthest - nearest;
    return [
        nearest / (top * aspect), 0, 0, 0, 0, nearest / top, 0, 0,
        0, 0, -(farthest + nearest) / depth, -1, 0, 0, (-2 * farthest * nearest) / depth, 0,
    ];
}
