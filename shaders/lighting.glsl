// Lighting at each vertex: OpenGL 2.1, section 2.14.1, for one light without attenuation and spot, and a
// material whose ambient and diffuse reflectance is glColor (GL_COLOR_MATERIAL).

//@ uniforms
uniform vec4 lightPosition; // in eye coordinates; w = 0: a direction towards the light
uniform vec3 lightAmbient;
uniform vec3 lightDiffuse;
uniform vec3 lightSpecular;
uniform vec3 modelAmbient;
uniform vec3 materialSpecular;
uniform float shininess;
//@ directional light

    vec3 toLight = direction(lightPosition.xyz);
//@ positional light

    vec3 toLight = direction(lightPosition.xyz / lightPosition.w - eyePosition);
//@ infinite viewer
    vec3 toViewer = vec3(0.0, 0.0, 1.0);
//@ local viewer
    vec3 toViewer = direction(-eyePosition);
//@ terms
    vec3 halfway = direction(toLight + toViewer);
    float diffuse = max(dot(eyeNormal, toLight), 0.0);
    float cosine = max(dot(eyeNormal, halfway), 0.0);
    // No highlight on the side that looks away from the light. 0 to the power of 0 is 1 here, as in the
    // specification; GLSL leaves it undefined.
    float highlight = diffuse > 0.0 ? (shininess == 0.0 ? 1.0 : pow(cosine, shininess)) : 0.0;
    vec3 lit = color.rgb * (modelAmbient + lightAmbient + diffuse * lightDiffuse);
    vec3 specular = highlight * materialSpecular * lightSpecular;
//@ GL_SINGLE_COLOR
    primaryColor = clamp(vec4(lit + specular, color.a), 0.0, 1.0);
//@ GL_SEPARATE_SPECULAR_COLOR
    // The highlight waits until texturing is done.
    primaryColor = clamp(vec4(lit, color.a), 0.0, 1.0);
    secondaryColor = clamp(specular, 0.0, 1.0);
