// GL_COMBINE: OpenGL 2.1, section 3.8.13, tables 3.23 to 3.25. INDEX is the number of an argument, SOURCE the
// colour that it comes from.

//@ begin

    // Unit UNIT, GL_COMBINE
    {
//@ undefined

    // Unit UNIT, GL_COMBINE with the texture of a unit that has none, which is undefined: the colour is passed on.
//@ rgb GL_SRC_COLOR
        vec3 rgbINDEX = SOURCE.rgb;
//@ rgb GL_ONE_MINUS_SRC_COLOR
        vec3 rgbINDEX = 1.0 - SOURCE.rgb;
//@ rgb GL_SRC_ALPHA
        vec3 rgbINDEX = SOURCE.aaa;
//@ rgb GL_ONE_MINUS_SRC_ALPHA
        vec3 rgbINDEX = 1.0 - SOURCE.aaa;
//@ rgb GL_REPLACE
        vec3 rgb = rgb0;
//@ rgb GL_MODULATE
        vec3 rgb = rgb0 * rgb1;
//@ rgb GL_ADD
        vec3 rgb = rgb0 + rgb1;
//@ rgb GL_ADD_SIGNED
        vec3 rgb = rgb0 + rgb1 - 0.5;
//@ rgb GL_INTERPOLATE
        vec3 rgb = rgb0 * rgb2 + rgb1 * (1.0 - rgb2);
//@ rgb GL_SUBTRACT
        vec3 rgb = rgb0 - rgb1;
//@ rgb GL_DOT3_RGB | rgb GL_DOT3_RGBA
        vec3 rgb = vec3(4.0 * dot(rgb0 - 0.5, rgb1 - 0.5));
//@ rgb scale 2
        rgb *= 2.0; // GL_RGB_SCALE
//@ rgb scale 4
        rgb *= 4.0; // GL_RGB_SCALE
//@ alpha GL_SRC_ALPHA
        float alphaINDEX = SOURCE.a;
//@ alpha GL_ONE_MINUS_SRC_ALPHA
        float alphaINDEX = 1.0 - SOURCE.a;
//@ alpha GL_REPLACE
        float alpha = alpha0;
//@ alpha GL_MODULATE
        float alpha = alpha0 * alpha1;
//@ alpha GL_ADD
        float alpha = alpha0 + alpha1;
//@ alpha GL_ADD_SIGNED
        float alpha = alpha0 + alpha1 - 0.5;
//@ alpha GL_INTERPOLATE
        float alpha = alpha0 * alpha2 + alpha1 * (1.0 - alpha2);
//@ alpha GL_SUBTRACT
        float alpha = alpha0 - alpha1;
//@ alpha of the dot product
        float alpha = 4.0 * dot(rgb0 - 0.5, rgb1 - 0.5); // GL_DOT3_RGBA; its scale is alpha's own
//@ alpha scale 2
        alpha *= 2.0; // GL_ALPHA_SCALE
//@ alpha scale 4
        alpha *= 4.0; // GL_ALPHA_SCALE
//@ end
        color = clamp(vec4(rgb, alpha), 0.0, 1.0);
    }
