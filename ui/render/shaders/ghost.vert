layout(location = 0) in vec3 point_mm;

uniform mat4 clip_from_ghost;

void main() { gl_Position = clip_from_ghost * vec4(point_mm, 1.0); }
