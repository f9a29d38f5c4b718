//VTK::System::Dec
#ifdef GL_ARB_texture_gather
#extension GL_ARB_texture_gather : enable
#ifndef SOFT_SHADOW_NO_GATHER
#define SOFT_SHADOW_GATHER
#endif
#endif
//VTK::Output::Dec

// What a level of refinement adds, for the pixels whose visibility still changes. The others are
// discarded, so an occlusion query over the draw counts those that need the level.

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowDepthMap
//SoftShadows::Include vtkShadowCrease
//SoftShadows::Include vtkShadowSamples

uniform sampler2DArray state; // (visibility, 1 if it has settled) after the level before
uniform int level;
uniform vec2 fadeIn;
uniform vec2 fadeOut;
uniform float litWeight; // of the points that see everything

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (level > 0 && texelFetch(state, ivec3(pixel, 0), 0).g > 0.0)
  {
    discard;
  }
  Receiver receiver;
  loadReceiver(pixel, receiver);
  float depth = -receiver.positionVs.z;
  if (depth < fadeIn.x || depth > fadeOut.y)
  {
    discard;
  }
  gl_FragData[0] = vec4(litWeight + sampledVisibility(receiver), 1.0, 0.0, 0.0);
}
