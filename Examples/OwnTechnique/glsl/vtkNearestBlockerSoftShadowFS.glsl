//VTK::System::Dec
//VTK::Output::Dec

// The share of lit taps in the light's image on the near plane of its depth map.

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowDepthMap
//SoftShadows::Include vtkShadowKernel

uniform mat4 viewToMap;
// Half extent of the light's image, per map depth between it and the receiver.
uniform vec2 kernelScale;
uniform float mapLayer;
uniform int filterWidth; // taps along an edge
uniform float weight;    // of this emitter

void main()
{
  Receiver receiver;
  loadReceiver(ivec2(gl_FragCoord.xy), receiver);
  MapPoint point = toMap(viewToMap, receiver);
  // The near plane is d = 0.
  vec2 halfWidth = kernelScale * max(point.std.z, 0.0);
  float lit = 0.0;
  float total = 0.0;
  for (int y = 0; y < filterWidth; ++y)
  {
    for (int x = 0; x < filterWidth; ++x)
    {
      // Each tap stands for a point of the light; the receiver's own plane may hide it.
      vec2 tap = vec2(tapCoordinate(x, filterWidth), tapCoordinate(y, filterWidth));
      float tapShare = tapWeight(tap);
      bool blocked = !facesPoint(point, kernelScale, tap) ||
        isBlocked(point, point.std.xy + tap * halfWidth, mapLayer);
      lit += blocked ? 0.0 : tapShare;
      total += tapShare;
    }
  }
  gl_FragData[0] = vec4(weight * lit / total);
}
