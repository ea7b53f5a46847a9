// A picture as it is; how much of it counts may be said where it is blended.
out vec4 colour;

uniform sampler2D picture_colours;
uniform vec2 into_place;  // the target's left and bottom

void main() { colour = texelFetch(picture_colours, ivec2(gl_FragCoord.xy - into_place), 0); }
