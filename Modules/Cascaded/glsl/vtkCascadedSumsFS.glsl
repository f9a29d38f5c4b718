//VTK::System::Dec
#ifdef GL_ARB_texture_gather
#extension GL_ARB_texture_gather : enable
#ifndef SOFT_SHADOW_NO_GATHER
#define SOFT_SHADOW_GATHER
#endif
#endif
//VTK::Output::Dec

// A cascade's part of the sums over points of the emitter that the filter on the screen takes, weighted
// by how much of the receiver's depth is the cascade's.

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowDepthMap
//SoftShadows::Include vtkShadowCrease
//SoftShadows::Include vtkShadowSamples
//SoftShadows::Include vtkShadowPointSums

uniform vec2 fadeIn;     // depths over which the cascade's weight rises
uniform vec2 fadeOut;    // and falls
uniform float litWeight; // of the points that see everything
uniform float madeUp;    // what -1, no value, is made up by

void main()
{
  Receiver receiver;
  loadReceiver(ivec2(gl_FragCoord.xy), receiver);
  float depth = -receiver.positionVs.z;
  float share = smoothstep(fadeIn.x, fadeIn.y, depth) * (1.0 - smoothstep(fadeOut.x, fadeOut.y, depth));
  vec4 sums = vec4(madeUp, 0.0, 0.0, 0.0);
  if (share > 0.0)
  {
    sums += share * vec4(litWeight, litWeight, 0.0, 0.0);
    if (sampleCount > 0)
    {
      sums += share * pointSums(toFrame(viewToBase, receiver));
    }
  }
  gl_FragData[0] = sums;
}
