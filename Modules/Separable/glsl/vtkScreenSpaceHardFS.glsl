//VTK::System::Dec
//VTK::Output::Dec

// Step 1: the hard shadow of every receiver.

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowLight
//SoftShadows::Include vtkShadowDepthMap
//SoftShadows::Include vtkShadowCrease

uniform mat4 viewToMap;
uniform float mapLayer;

void main()
{
  Receiver receiver;
  if (!loadReceiver(ivec2(gl_FragCoord.xy), receiver) || !lightReaches(receiver.positionVs))
  {
    discard;
  }
  MapPoint point = toMap(viewToMap, receiver);
  bool blocked = !point.facesCenter || isBlocked(point, point.std.xy, mapLayer) ||
    isInCrease(point, vec2(0.0), creaseReach, mapLayer);
  gl_FragData[0] = vec4(blocked ? 0.0 : 1.0);
}
