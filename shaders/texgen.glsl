// Texture coordinates that OpenGL makes itself: OpenGL 2.1, section 2.11.4. COORD stands for s, t, r or q, and
// MEMBER for what GLSL calls it: r is p there, because r is red.

//@ plane
uniform vec4 planeUNITCOORD;
//@ reflection vector

// The direction in which a surface mirrors the eye's ray; the eye is at the origin.
vec3 reflectionVector(vec3 eyePosition, vec3 n) {
    vec3 u = direction(eyePosition);
    return u - 2.0 * n * dot(n, u);
}
//@ sphere map

// Where that direction falls on the photograph of a mirror ball. Straight away from the eye is all of its rim,
// and has no place: the middle is taken.
vec2 sphereMap(vec3 r) {
    float m = 2.0 * length(vec3(r.xy, r.z + 1.0));
    return m > 0.0 ? r.xy / m + 0.5 : vec2(0.5);
}
//@ GL_OBJECT_LINEAR
    coordUNIT.MEMBER = dot(planeUNITCOORD, vec4(position, 1.0));
//@ GL_EYE_LINEAR
    coordUNIT.MEMBER = dot(planeUNITCOORD, vec4(eyePosition, 1.0));
//@ GL_SPHERE_MAP
    coordUNIT.MEMBER = sphereMap(reflectionVector(eyePosition, eyeNormal)).MEMBER;
//@ GL_REFLECTION_MAP
    coordUNIT.MEMBER = vec4(reflectionVector(eyePosition, eyeNormal), 0.0).MEMBER;
//@ GL_NORMAL_MAP
    coordUNIT.MEMBER = vec4(eyeNormal, 0.0).MEMBER;
