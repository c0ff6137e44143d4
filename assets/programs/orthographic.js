// As glOrtho with the eye in the middle: what is behind it is in sight, too.
function orthographic(right, top, farthest) {
    return scaling(1 / right, 1 / top, -1 / farthest);
}
