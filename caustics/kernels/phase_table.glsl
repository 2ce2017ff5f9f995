// A phase function in a table: nodes over the logarithm of sin^2(angle / 2), 32 an octave over 24 octaves, where the
// exponent and the first bits of the number are the node. Needs floatBitsToInt.

const int phase_first_bits = 0x33800000;  // of 2^-24
const int phase_node_shift = 18;          // bits of the mantissa below those of a node

struct PhaseNode {
    int index;
    real part;  // of the way to the next node
};

KERNEL PhaseNode phase_node(real cosine) {
    int bits = floatBitsToInt(clamp(real(0.5) - real(0.5) * cosine, real(5.9604645e-8), real(1))) - phase_first_bits;
    PhaseNode node;
    node.index = bits >> phase_node_shift;
    node.part = real(bits & ((1 << phase_node_shift) - 1)) * real(3.814697265625e-6);
    return node;
}
