//VTK::System::Dec
//VTK::Output::Dec

// The mean over the block of the pattern's size around a pixel: there every subset of the rays comes
// once. Pixels of other surfaces are left out, and those that differ by more than few rays explain.

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowLight
//SoftShadows::Include vtkShadowSurface

// Per pixel, -1 where nothing was estimated: the share of the rays in front of the receiver's plane that
// meet nothing; and the share of all rays that are in front.
uniform sampler2DArray source;
uniform int pattern;     // edge of the pattern in pixels
uniform float tolerance; // what few rays explain, in units of visibility
uniform float weight;    // of the emitter

// Pixels in one plane, but for the rounding of their normals.
const float planeCosine = 0.999999;

// Where the light reaches a receiver and nothing was estimated, it was proved lit. (-1, 0): no light.
vec2 fetchEstimate(ivec2 pixel)
{
  vec2 estimate = texelFetch(source, ivec3(pixel, 0), 0).rg;
  Receiver receiver;
  if (estimate.x >= -0.5)
  {
    return estimate;
  }
  bool isLit = loadReceiver(pixel, receiver) && lightReaches(receiver.positionVs);
  return isLit ? vec2(1.0) : vec2(-1.0, 0.0);
}

// A block of even width cuts its outermost pixels in half; they have the same rays as those opposite.
float blockShare(int offset)
{
  return 2 * abs(offset) == pattern ? 0.5 : 1.0;
}

// Whether the mean can differ from the pixel's own estimate. Most pixels of an umbra end here.
bool isVaried(ivec2 pixel, ivec2 size, vec2 own)
{
  int reach = pattern / 2;
  ivec2 low = max(pixel - reach, ivec2(0));
  ivec2 high = min(pixel + reach, size - 1);
  for (int y = low.y; y <= high.y; ++y)
  {
    for (int x = low.x; x <= high.x; ++x)
    {
      vec2 other = texelFetch(source, ivec3(x, y, 0), 0).rg;
      if ((other.x < -0.5 ? vec2(1.0) : other) != own)
      {
        return true;
      }
    }
  }
  return false;
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 size = textureSize(source, 0).xy;
  vec2 own = texelFetch(source, ivec3(pixel, 0), 0).rg;
  if (own.x < -0.5)
  {
    gl_FragData[0] = vec4(weight);
    return;
  }
  if (!isVaried(pixel, size, own))
  {
    gl_FragData[0] = vec4(weight * own.x * own.y);
    return;
  }
  Receiver receiver;
  loadReceiver(pixel, receiver);
  vec2 seen = vec2(own.x * own.y, own.y);
  // What the plane hides differs from facet to facet and is not smoothed over them.
  vec2 facing = vec2(own.y, 1.0);
  int reach = pattern / 2;
  for (int y = -reach; y <= reach; ++y)
  {
    for (int x = -reach; x <= reach; ++x)
    {
      ivec2 tap = pixel + ivec2(x, y);
      bool isInside = all(greaterThanEqual(tap, ivec2(0))) && all(lessThan(tap, size));
      vec2 other = isInside && tap != pixel ? fetchEstimate(tap) : vec2(-1.0, 0.0);
      // All of it up to the tolerance, nothing from twice the tolerance on.
      vec2 range = clamp(2.0 - abs(other - own) / tolerance, 0.0, 1.0);
      if (other.x < -0.5 || range.x + range.y == 0.0)
      {
        continue;
      }
      float share = blockShare(x) * blockShare(y) * surfaceWeight(receiver, tap);
      seen += share * range.x * other.y * vec2(other.x, 1.0);
      if (own.y < 1.0)
      {
        Receiver neighbour;
        loadReceiver(tap, neighbour);
        share *= dot(receiver.normalVs, neighbour.normalVs) > planeCosine ? range.y : 0.0;
        facing += share * vec2(other.y, 1.0);
      }
    }
  }
  float visibility = seen.y > 0.0 ? seen.x / seen.y : 0.0;
  gl_FragData[0] = vec4(weight * visibility * facing.x / facing.y);
}
