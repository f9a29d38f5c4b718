//VTK::System::Dec
//VTK::Output::Dec

// Visibilities that the processor has found, a texel per pixel.

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowLight

uniform sampler2DArray visibilities;
uniform float weight; // of the emitter

void main()
{
  Receiver receiver;
  if (!loadReceiver(ivec2(gl_FragCoord.xy), receiver) || !lightReaches(receiver.positionVs))
  {
    discard;
  }
  gl_FragData[0] =
    vec4(weight * texelFetch(visibilities, ivec3(ivec2(gl_FragCoord.xy), 0), 0).r);
}
