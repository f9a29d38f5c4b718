//VTK::System::Dec
#ifdef GL_ARB_texture_gather
#extension GL_ARB_texture_gather : enable
#ifndef SOFT_SHADOW_NO_GATHER
#define SOFT_SHADOW_GATHER
#endif
#endif
//VTK::Output::Dec

// The weighted mean of hard shadows, one per depth map seen from a point of the light.

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowDepthMap
//SoftShadows::Include vtkShadowCrease
//SoftShadows::Include vtkShadowSamples

uniform float litWeight; // of the points that see everything

void main()
{
  Receiver receiver;
  loadReceiver(ivec2(gl_FragCoord.xy), receiver);
  gl_FragData[0] = vec4(litWeight + sampledVisibility(receiver));
}
