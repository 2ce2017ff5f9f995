// Pass 0 where objects stop light.
#version 460
#extension GL_GOOGLE_include_directive : require

#define SHADOWS
#include "caustics/shaders/floor_land.glsl"
