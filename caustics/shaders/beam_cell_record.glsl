// What a cell of two beams is to one camera, as the pass that views cells hands it to the one that draws them.
struct CellRecord {
    vec4 outline[4];  // eight corners, two each, in the order of a strip, pixels
    vec4 edge[4];     // at, and travel less the mean
    vec4 mean;        // travel (2), path, above
    vec4 power;       // of both beams times scattering, lowest lid, highest end
    vec4 top[2];      // outward (3), distance
    vec4 ground[2];
};
