// The flat floor, the four walls, or the deck around them: strips of four corners, each instance one rectangle.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "render/shaders/includes.glsl"

layout(location = 0) flat out int part;

const float reach = 3e4;  // of what has no end, m

float at(float low, float high, int upper) { return upper == 1 ? high : low; }

void main() {
    int i = gl_VertexIndex & 1, j = gl_VertexIndex >> 1;
    float x0 = wall_x ? s.x0 : p.eye_x - reach, x1 = wall_x ? s.x1 : p.eye_x + reach;
    float y0 = wall_y ? s.y0 : p.eye_y - reach, y1 = wall_y ? s.y1 : p.eye_y + reach;
    part = p.first_copy + gl_InstanceIndex;
    vec3 place = vec3(at(x0, x1, i), at(y0, y1, j), -s.depth);
    if (kind == KIND_WALLS) {
        place.z = at(-s.depth, s.freeboard, j);
        if (part < 2) {
            place.xy = vec2(part == 0 ? s.x0 : s.x1, at(y0, y1, i));
        } else {
            place.xy = vec2(at(x0, x1, i), part == 2 ? s.y0 : s.y1);
        }
    }
    if (kind == KIND_DECK) {  // west, east as wide as the pool, south, north beyond
        place.z = s.freeboard;
        if (part < 2) {
            place.xy = vec2(part == 0 ? at(x0 - reach, x0, i) : at(x1, x1 + reach, i), at(y0, y1, j));
        } else {
            float beyond = wall_x ? reach : 0;
            place.xy = vec2(at(x0 - beyond, x1 + beyond, i), part == 2 ? at(y0 - reach, y0, j) : at(y1, y1 + reach, j));
        }
    }
    gl_Position = seen(place);
}
