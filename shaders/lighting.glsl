// Lighting at each vertex: OpenGL 2.1, section 2.14.1, for one light without attenuation and spot.

//@ uniforms
uniform vec4 lightPosition; // in eye coordinates; w = 0: a direction towards the light
uniform vec3 lightAmbient;
uniform vec3 lightDiffuse;
uniform vec3 lightSpecular;
uniform vec3 modelAmbient;
uniform vec3 materialSpecular;
uniform float shininess;
//@ material uniforms
uniform bool colorMaterial; // GL_COLOR_MATERIAL: glColor is the ambient and diffuse reflectance
uniform vec3 materialAmbient;
uniform vec4 materialDiffuse;
uniform vec3 materialEmission;
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
    vec3 specular = highlight * materialSpecular * lightSpecular;
//@ color material
    vec4 reflectance = color; // GL_COLOR_MATERIAL: both the ambient and the diffuse one
    vec3 lit = reflectance.rgb * (modelAmbient + lightAmbient + diffuse * lightDiffuse);
//@ material
    vec3 ambientReflectance = colorMaterial ? color.rgb : materialAmbient;
    vec4 reflectance = colorMaterial ? color : materialDiffuse; // the diffuse one; its alpha is the fragment's
    vec3 lit = materialEmission + ambientReflectance * (modelAmbient + lightAmbient) +
               diffuse * reflectance.rgb * lightDiffuse;
//@ GL_SINGLE_COLOR
    primaryColor = clamp(vec4(lit + specular, reflectance.a), 0.0, 1.0);
//@ GL_SEPARATE_SPECULAR_COLOR
    // The highlight waits until texturing is done.
    primaryColor = clamp(vec4(lit, reflectance.a), 0.0, 1.0);
    secondaryColor = clamp(specular, 0.0, 1.0);
//@ begin back

    // GL_LIGHT_MODEL_TWO_SIDE: the same with the opposite normal, for faces that are seen from behind.
    {
    vec3 eyeNormal = -eyeNormal;
//@ back GL_SINGLE_COLOR
    backPrimaryColor = clamp(vec4(lit + specular, reflectance.a), 0.0, 1.0);
//@ back GL_SEPARATE_SPECULAR_COLOR
    backPrimaryColor = clamp(vec4(lit, reflectance.a), 0.0, 1.0);
    backSecondaryColor = clamp(specular, 0.0, 1.0);
//@ end back
    }
