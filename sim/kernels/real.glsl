// The words in which a kernel text is written, for a shader. C++ has its own: sim/kernels/real.hpp.
#ifndef WATERLIGHT_REAL_GLSL
#define WATERLIGHT_REAL_GLSL
#define KERNEL
#define real float
#define real2 vec2
#define real3 vec3
#define int2 ivec2
#define cbrt(x) pow(x, 1.0 / 3.0)
#endif
