// Pass 0 where nothing is in the way of the light.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "caustics/shaders/floor_land.glsl"
