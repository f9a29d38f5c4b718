//VTK::System::Dec
//VTK::Output::Dec

// Adds the hard shadow from a point of the light to a running sum.

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowLight
//SoftShadows::Include vtkShadowDepthMap
//SoftShadows::Include vtkShadowCrease
//SoftShadows::Include vtkShadowSamples

uniform float litWeight; // of a point that sees everything

void main()
{
  Receiver receiver;
  if (!loadReceiver(ivec2(gl_FragCoord.xy), receiver) || !lightReaches(receiver.positionVs))
  {
    discard;
  }
  gl_FragData[0] = vec4(litWeight + sampledVisibility(receiver));
}
