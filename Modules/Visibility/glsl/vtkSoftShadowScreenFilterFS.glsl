//VTK::System::Dec
//VTK::Output::Dec

// One step of a bilateral filter of the visibility on the screen: along an axis, or over a square.
//
// A step reads a Pixel and writes it; the first one reads the sums over the points of the emitter, the
// last one writes the visibility times the emitter's weight.

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowSurface

uniform sampler2DArray source;
uniform sampler2DArray known; // visibility where the source has no value; -1 if there is none
uniform int firstStep; // the source are sums: of points in front, of those seen, of reaches...
uniform int lastStep;
uniform float weight;  // of the emitter
uniform float rangeDeviation; // h_r, in units of visibility

// What rounding leaves of a mean of 0 or 1.
const float visibilityRounding = 1e-4;

struct Pixel
{
  float visibility; // what is filtered; negative where there is no value
  float guide;      // negative: not to be filtered. Else the reach, if the kernel follows it
  float facing;     // the share of the emitter in front of the receiver's plane, if not filtered
};

#ifdef SOFT_SHADOW_CELL
uniform vec3 lightVs;     // the emitter's centre, or a vector towards it
uniform float positional; // 1; 0 if the emitter is directional
uniform vec3 lightAxesVs[2]; // the emitter's half extents
uniform int lightKind;    // 0: rectangle, 1: disk, 2: weighted by its points

// The share of the emitter in front of the receiver's plane: of window coordinates e with a + b . e > 0.
float facingShare(Receiver receiver, float sampled)
{
  float a = dot(receiver.normalVs, lightVs - positional * receiver.positionVs);
  vec2 b = abs(
    vec2(dot(receiver.normalVs, lightAxesVs[0]), dot(receiver.normalVs, lightAxesVs[1])));
  if (lightKind == 1)
  {
    float t = clamp(a / max(length(b), 1e-30), -1.0, 1.0);
    return 1.0 - (acos(t) - t * sqrt(1.0 - t * t)) / 3.14159265;
  }
  if (lightKind == 2)
  {
    return sampled;
  }
  b = max(b, max(0.01 * max(b.x, b.y), 1e-30));
  if (abs(a) >= b.x + b.y)
  {
    return a > 0.0 ? 1.0 : 0.0;
  }
  // A square under a half plane is a box filtered by a box: second differences of max(x, 0)^2.
  a /= b.x + b.y;
  b /= b.x + b.y;
  vec4 x = max(a + vec4(b.x + b.y, b.x - b.y, b.y - b.x, -b.x - b.y), 0.0);
  return dot(x * x, vec4(1.0, -1.0, -1.0, 1.0)) / (8.0 * b.x * b.y);
}
#endif

Pixel fetchPixel(ivec2 pixel)
{
  vec4 value = texelFetch(source, ivec3(pixel, 0), 0);
  if (firstStep == 0 || value.r < -0.5)
  {
    return Pixel(value.r, value.g, value.b);
  }
#ifdef SOFT_SHADOW_CELL
  // What the receiver's own plane hides is known; the points tell what else blocks the rest.
  float visibility = value.r > 0.0 ? value.g / value.r : value.a;
  return Pixel(visibility, value.b / max(value.r - value.g, 1e-6), value.r);
#else
  return Pixel(value.g, 0.0, 1.0);
#endif
}

// A pixel whose visibility is not estimated here may be known all the same.
Pixel fetchTap(ivec2 pixel)
{
  Pixel tap = fetchPixel(pixel);
  return tap.visibility < -0.5 ? Pixel(texelFetch(known, ivec3(pixel, 0), 0).r, 0.0, 1.0) : tap;
}

// Adds a tap of the domain weight given. What differs by no more than a step is not a shadow's edge.
void addTap(Receiver receiver, float visibility, ivec2 pixel, float domainWeight, float bandStep,
  inout vec2 sum)
{
  if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, textureSize(source, 0).xy)))
  {
    return;
  }
  Pixel other = fetchTap(pixel);
  if (other.visibility < -0.5)
  {
    return;
  }
  float range = max(abs(other.visibility - visibility) - bandStep, 0.0) / rangeDeviation;
  // A pixel that few points of the light are in front of knows little.
  float tapWeight =
    domainWeight * exp(-0.5 * range * range) * other.facing * surfaceWeight(receiver, pixel);
  sum += tapWeight * vec2(other.visibility, 1.0);
}

#ifdef SOFT_SHADOW_CELL

uniform sampler2DArray tiles; // least and greatest visibility
uniform int tileSize;
uniform mat4 viewToClip;
const int maximumCells = 4;
uniform int cellCount;
uniform vec3 cellAxesVs[maximumCells]; // an edge of the cell of a point of the light
uniform float bandSteps[maximumCells];  // how much its bands differ
uniform vec2 fadeIns[maximumCells];    // view depths over which a cell's weight rises
uniform vec2 fadeOuts[maximumCells];   // and falls
uniform float maximumWidth; // pixels
const int maximumTaps = 33;

// Whether the visibility changes anywhere near.
bool isVaried(ivec2 pixel)
{
  ivec2 tile = pixel / tileSize;
  ivec2 last = textureSize(tiles, 0).xy - 1;
  vec2 range = vec2(2.0, -2.0);
  for (int y = max(tile.y - 1, 0); y <= min(tile.y + 1, last.y); ++y)
  {
    for (int x = max(tile.x - 1, 0); x <= min(tile.x + 1, last.x); ++x)
    {
      vec2 other = texelFetch(tiles, ivec3(x, y, 0), 0).rg;
      range = vec2(min(range.x, other.x), max(range.y, other.y));
    }
  }
  return range.y - range.x > visibilityRounding;
}

// The reach of the nearest shadow on the same surface; -1 if there is none near.
float searchReach(Receiver receiver, ivec2 pixel)
{
  ivec2 size = textureSize(source, 0).xy;
  for (float radius = 1.0; radius <= float(tileSize); radius *= 2.0)
  {
    float sum = 0.0;
    float count = 0.0;
    for (int i = 0; i < 8; ++i)
    {
      float angle = 0.785398 * float(i) + radius;
      ivec2 tap = pixel + ivec2(floor(radius * vec2(cos(angle), sin(angle)) + 0.5));
      if (any(lessThan(tap, ivec2(0))) || any(greaterThanEqual(tap, size)))
      {
        continue;
      }
      Pixel other = fetchPixel(tap);
      if (other.visibility > -0.5 && other.visibility < 1.0 - visibilityRounding &&
        surfaceWeight(receiver, tap) > 0.0)
      {
        sum += other.guide;
        count += 1.0;
      }
    }
    if (count > 0.0)
    {
      return sum / count;
    }
  }
  return -1.0;
}

float findGuide(Receiver receiver, ivec2 pixel, Pixel value)
{
  if (!isVaried(pixel))
  {
    return -1.0;
  }
  return value.visibility < 1.0 - visibilityRounding ? value.guide : searchReach(receiver, pixel);
}

struct Cell
{
  vec3 axisVs;
  float bandStep;
};

// The cell at the receiver's depth.
Cell cellAt(float depth)
{
  Cell cell = Cell(vec3(0.0), 0.0);
  for (int i = 0; i < cellCount; ++i)
  {
    float share = smoothstep(fadeIns[i].x, fadeIns[i].y, depth) *
      (1.0 - smoothstep(fadeOuts[i].x, fadeOuts[i].y, depth));
    share = cellCount == 1 ? 1.0 : share;
    cell.axisVs += share * cellAxesVs[i];
    cell.bandStep += share * bandSteps[i];
  }
  return cell;
}

// How far, in pixels, the shadow moves when the point of the light moves by the edge of its cell.
//
// A blocker's shadow on the receiver's plane moves against the light, reach times as far, and along
// the ray so as to stay on the plane.
vec2 shadowMotion(Receiver receiver, vec3 cellAxisVs, float reach)
{
  vec3 ray = positional * receiver.positionVs - lightVs;
  float slant = dot(receiver.normalVs, ray);
  float least = 0.05 * length(ray);
  slant = abs(slant) < least ? (slant < 0.0 ? -least : least) : slant;
  vec3 motion = reach * (cellAxisVs - ray * (dot(receiver.normalVs, cellAxisVs) / slant));
  vec4 clip = viewToClip * vec4(receiver.positionVs, 1.0);
  vec4 change = viewToClip * vec4(motion, 0.0);
  vec2 size = vec2(textureSize(source, 0).xy);
  vec2 pixels = 0.5 * size * (change.xy - clip.xy / clip.w * change.w) / clip.w;
  return pixels * min(1.0, maximumWidth / max(length(pixels), 1e-6));
}

// A box as wide as the cell of a point of the light: the bands become a ramp.
float filterVisibility(Receiver receiver, ivec2 pixel, float visibility, float guide)
{
  Cell cell = cellAt(-receiver.positionVs.z);
  vec2 axis = shadowMotion(receiver, cell.axisVs, guide);
  // Along the longer component a tap per pixel, or as many as allowed; those that the box's ends cut
  // count by the part inside.
  float width = max(max(abs(axis.x), abs(axis.y)), 1.0);
  float taps = min(width, float(maximumTaps));
  int reach = int(ceil(0.5 * (taps - 1.0)));
  vec2 sum = vec2(0.0);
  for (int i = -reach; i <= reach; ++i)
  {
    float inside = clamp(0.5 * taps - abs(float(i)) + 0.5, 0.0, 1.0);
    vec2 offset = float(i) / taps * axis;
    addTap(receiver, visibility, pixel + ivec2(floor(offset + 0.5)), inside, cell.bandStep, sum);
  }
  return sum.y > 0.0 ? sum.x / sum.y : visibility;
}

#else

uniform ivec2 stepAxis;        // from tap to tap of a row, in pixels
uniform ivec2 rowAxis;         // from row to row
uniform int halfTaps;          // taps on either side
uniform int halfRows;          // rows on either side
uniform float domainDeviation; // h_d, in taps

// Umbra and lit pixels stay as they are.
float findGuide(Receiver receiver, ivec2 pixel, Pixel value)
{
  return value.visibility > visibilityRounding && value.visibility < 1.0 - visibilityRounding
    ? 1.0
    : -1.0;
}

float filterVisibility(Receiver receiver, ivec2 pixel, float visibility, float guide)
{
  vec2 sum = vec2(0.0);
  for (int y = -halfRows; y <= halfRows; ++y)
  {
    for (int x = -halfTaps; x <= halfTaps; ++x)
    {
      vec2 domain = vec2(x, y) / domainDeviation;
      addTap(receiver, visibility, pixel + x * stepAxis + y * rowAxis,
        exp(-0.5 * dot(domain, domain)), 0.0, sum);
    }
  }
  return sum.x / sum.y;
}

#endif

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  Pixel value = fetchPixel(pixel);
  if (value.visibility < -0.5)
  {
    discard;
  }
  Receiver receiver;
  loadReceiver(pixel, receiver);
  if (firstStep == 1)
  {
    value.guide = findGuide(receiver, pixel, value);
  }
  if (value.guide >= 0.0)
  {
    value.visibility = filterVisibility(receiver, pixel, value.visibility, value.guide);
  }
#ifdef SOFT_SHADOW_CELL
  float share = lastStep == 1 ? facingShare(receiver, value.facing) : 1.0;
#else
  float share = 1.0;
#endif
  gl_FragData[0] = lastStep == 1 ? vec4(weight * share * value.visibility)
                                 : vec4(value.visibility, value.guide, value.facing, 0.0);
}
