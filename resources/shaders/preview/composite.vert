// One triangle that covers the screen, with the direction that each pixel sees.
uniform mat3 cameraToWorld;
uniform vec3 halfExtent; // tan of half the field of view across and up
out vec3 direction;      // from the eye, not normalized: linear on the screen

void main()
{
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    direction = cameraToWorld * vec3(corner * halfExtent.xy, -1.0);
    gl_Position = vec4(corner, 0.0, 1.0);
}
