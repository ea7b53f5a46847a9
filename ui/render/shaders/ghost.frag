out vec4 colour;

uniform vec4 ink;

void main() { colour = ink; }
