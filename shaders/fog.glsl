// Fog: OpenGL 2.1, section 3.10. The distance is that from the eye's plane, which the specification allows in
// the place of the one from the eye itself.

//@ output
out float fogDistance;
//@ output GL_FASTEST
float fogDistance;
out float fogDistanceTimesW;
//@ distance

    fogDistance = abs(eyePosition.z);
//@ distance GL_FASTEST

    fogDistance = abs(eyePosition.z);
    fogDistanceTimesW = fogDistance * w;
//@ input
in float fogDistance;
//@ input GL_FASTEST
in float fogDistanceTimesW;
//@ uniforms GL_LINEAR
uniform vec3 fogColor;
uniform float fogStart;
uniform float fogEnd;
//@ uniforms GL_EXP | uniforms GL_EXP2
uniform vec3 fogColor;
uniform float fogDensity;
//@ begin

    // Section 3.10: what the fog leaves of the colour. Alpha stays.
//@ begin GL_FASTEST

    // Section 3.10: what the fog leaves of the colour. Alpha stays.
    float fogDistance = fogDistanceTimesW / w;
//@ GL_LINEAR
    float clear = (fogEnd - fogDistance) / (fogEnd - fogStart);
//@ GL_EXP
    float clear = exp(-fogDensity * fogDistance);
//@ GL_EXP2
    float clear = exp(-(fogDensity * fogDistance) * (fogDensity * fogDistance));
//@ end
    color.rgb = mix(fogColor, color.rgb, clamp(clear, 0.0, 1.0));
