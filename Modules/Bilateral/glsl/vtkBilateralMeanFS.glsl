//VTK::System::Dec
//VTK::Output::Dec

// The sums over points of the emitter that the filter takes.

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowDepthMap
//SoftShadows::Include vtkShadowCrease
//SoftShadows::Include vtkShadowSamples
//SoftShadows::Include vtkShadowPointSums

uniform float litWeight; // of the points that see everything
uniform float madeUp;    // what -1, no value, is made up by

void main()
{
  Receiver receiver;
  loadReceiver(ivec2(gl_FragCoord.xy), receiver);
  MapFrame frame = toFrame(viewToBase, receiver);
  gl_FragData[0] = pointSums(frame) + vec4(madeUp + litWeight, litWeight, 0.0, 0.0);
}
