//VTK::System::Dec
//VTK::Output::Dec

// Step 1: each receiver's map coordinates, its hard shadow, and the middle row of its blocker search.

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowLight
//SoftShadows::Include vtkShadowDepthMap
//SoftShadows::Include vtkShadowCrease
//SoftShadows::Include vtkShadowKernel
//SoftShadows::Include vtkShadowBlocker
//Separable::Rows

uniform mat4 viewToMap;
uniform int provedByFootprint; // 1: the pixels of this draw were proved lit or blocked

// Sum and number of the row's blockers, up to the node and beyond it.
vec4 searchRow(MapPoint point, float reach)
{
  vec4 row = vec4(0.0);
  vec2 halfRow = rowAxis * (scaleAlong(rowAxis) * reach);
  for (int i = 0; i < searchWidth; ++i)
  {
    float x = tapCoordinate(i, searchWidth);
    vec2 st = point.std.xy + x * halfRow;
    float depth = mapDepth(st, mapLayer);
    if (isBlocker(point, st, depth) && reaches(point, x * halfRow, depth))
    {
      vec2 blocker = lineWeight(x, rowAxis) * vec2(linearDepth(depth), 1.0);
      row += abs(x) < searchNode ? vec4(blocker, 0.0, 0.0) : vec4(0.0, 0.0, blocker);
    }
  }
  return row;
}

void main()
{
  Receiver receiver;
  if (!loadReceiver(ivec2(gl_FragCoord.xy), receiver) || !lightReaches(receiver.positionVs))
  {
    discard;
  }
  MapPoint point = toMap(viewToMap, receiver);
  bool blocked = isBlocked(point, point.std.xy, mapLayer) ||
    isInCrease(point, kernelScale, creaseReach, mapLayer);
  // No ray to the light meets a blocker where a pixel was proved lit. A plane that turns its back on
  // the light's centre has rows for nobody, itself included.
  bool lit = provedByFootprint == 1 && !blocked;
  float reach = point.facesCenter && !lit ? searchReach(point) : 0.0;
  float side = point.facesCenter ? (blocked ? -1.0 : 1.0) : 0.0;
  gl_FragData[0] = vec4(point.std, side * max(reach, leastReach));
  gl_FragData[1] = reach > 0.0 ? searchRow(point, reach) : vec4(0.0);
}
