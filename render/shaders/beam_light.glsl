// Light of beams: a picture of another size, bilinear. Its one colour is that of the fields' extinction; what the
// water's further absorption takes from each is that of flat water's scattered light on the same way.

float beam_light(vec2 fragment) {
    ivec2 size = ivec2(p.columns, p.rows), most = size - 1;
    vec2 at = clamp(fragment * vec2(size) / vec2(p.u1, p.v1) - 0.5, vec2(0), vec2(most));
    ivec2 low = min(ivec2(at), max(most - 1, ivec2(0))), high = min(low + 1, most);
    vec2 w = at - vec2(low);
    return bilinear(beam_value(low.y * size.x + low.x), beam_value(low.y * size.x + high.x),
                    beam_value(high.y * size.x + low.x), beam_value(high.y * size.x + high.x), w.x, w.y);
}

float flat_light(float colour, float way, float depth, float fall) {
    float taken = s.extinction + colour;
    return exp(-taken * s.path * depth) * scattered_once(taken, taken * s.path * fall, way);
}

vec3 beam_tint(Sight a) {
    float entry = entry_way(a.d), way = meet(eye() + entry * a.d, a.d).way;
    if (a.d.z > 1e-5) way = min(way, max(0, -(p.eye_z + entry * a.d.z)) / a.d.z);
    float depth = max(0, -(p.eye_z + entry * a.d.z)), fall = -a.d.z;
    float grey = max(1e-20, flat_light(0, way, depth, fall));
    vec3 tint = vec3(flat_light(s.colour_r, way, depth, fall), flat_light(s.colour_g, way, depth, fall),
                     flat_light(s.colour_b, way, depth, fall)) / grey;
    return clamp(tint, vec3(0), vec3(1));
}
