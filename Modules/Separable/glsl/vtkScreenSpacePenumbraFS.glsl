//VTK::System::Dec
//VTK::Output::Dec

// Step 2: the blocker search and how far the penumbra reaches on the screen.

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowDepthMap
//SoftShadows::Include vtkShadowKernel
//SoftShadows::Include vtkShadowBlocker
//Separable::Rows

uniform mat4 viewToMap;
uniform mat4 mapToScreen; // homogeneous map coordinates to texture coordinates of the screen

// Half extents of the kernel on the screen along its x and y, in texture coordinates. The kernel is an
// affine image of the window; the standard deviations along both axes are those of that image.
vec2 screenExtent(MapPoint point, vec2 halfWidth)
{
  vec4 center = mapToScreen * vec4(point.std, 1.0);
  vec4 alongS = mapToScreen * vec4(1.0, 0.0, point.gradient.x, 0.0);
  vec4 alongT = mapToScreen * vec4(0.0, 1.0, point.gradient.y, 0.0);
  vec2 screen = center.xy / center.w;
  vec2 s = halfWidth.x * (alongS.xy - screen * alongS.w) / center.w;
  vec2 t = halfWidth.y * (alongT.xy - screen * alongT.w) / center.w;
  return sqrt(s * s + t * t);
}

void main()
{
  Receiver receiver;
  loadReceiver(ivec2(gl_FragCoord.xy), receiver);
  MapPoint point = toMap(viewToMap, receiver);
  vec2 halfSearch = kernelScale * searchReach(point);
  vec2 blockers = vec2(0.0);
  for (int j = 0; j < searchWidth; ++j)
  {
    addSearchRow(point, tapCoordinate(j, searchWidth), halfSearch, searchWidth, blockers);
  }
  vec2 extent = vec2(-1.0);
  if (blockers.y > 0.0)
  {
    float gap = max(point.std.z - mapDepthOfLinear(blockers.x / blockers.y), 0.0);
    extent = screenExtent(point, kernelScale * gap);
  }
  gl_FragData[0] = vec4(extent, 0.0, 0.0);
}
