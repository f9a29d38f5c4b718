//VTK::System::Dec
#ifdef GL_ARB_texture_gather
#extension GL_ARB_texture_gather : enable
#ifndef SOFT_SHADOW_NO_GATHER
#define SOFT_SHADOW_GATHER
#endif
#endif
//VTK::Output::Dec

// A cascade's part of the visibility, weighted by how much of the receiver's depth is the cascade's: the
// mean of hard shadows, each filtered over a box of fixed width.

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowDepthMap
//SoftShadows::Include vtkShadowCrease
//SoftShadows::Include vtkShadowSamples

uniform vec2 fadeIn;     // depths over which the cascade's weight rises
uniform vec2 fadeOut;    // and falls
uniform float litWeight; // of the points that see everything

void main()
{
  Receiver receiver;
  loadReceiver(ivec2(gl_FragCoord.xy), receiver);
  float depth = -receiver.positionVs.z;
  float share = smoothstep(fadeIn.x, fadeIn.y, depth) * (1.0 - smoothstep(fadeOut.x, fadeOut.y, depth));
  float visibility = 0.0;
  if (share > 0.0)
  {
    visibility = litWeight;
    if (sampleCount > 0)
    {
      visibility += sampledVisibility(receiver);
    }
    visibility *= share;
  }
  gl_FragData[0] = vec4(visibility);
}
