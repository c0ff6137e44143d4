// What turns or scales about the origin does so about a point.
function about(x, y, z, matrix) {
    return multiply(multiply(translation(x, y, z), matrix), translation(-x, -y, -z));
}
