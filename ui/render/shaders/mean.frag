// One sample of a picture at rest; how much of it counts is said where it is blended.
out vec4 colour;

uniform sampler2D sample_picture;

void main() { colour = texelFetch(sample_picture, ivec2(gl_FragCoord.xy), 0); }
