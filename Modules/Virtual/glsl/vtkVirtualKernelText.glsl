// The filter of one pixel; the same as vtkVirtualKernel in C++, which says what it is.
// Lengths are texels of the map at hand. A texel is the square [i, i + 1] x [j, j + 1].

const float leastHalfExtent = 2e-3; // a point is looked up, not integrated

struct Kernel
{
  bool transposed; // strips are rows, not columns
  float along;     // half extent across the strips
  float lean;      // how far the end at +along leans
  float across;    // half extent of a strip
  bool gaussian;   // weights exp(-2 w^2) over the light's window, else the same everywhere
  vec4 window;     // what of the light's window the kernel stands for: middles, half sizes along, across
};

struct Strip
{
  float width;
  float low;
  float high;
  bool gaussian;
  float middle;
  float windowMiddle; // in the window, and how much of it a texel is
  float windowSlope;
};

// The integral of exp(-2 x^2) from 0 to x: the error function by Abramowitz and Stegun's 7.1.26, whose
// error is below 1.5e-7.
float gaussianIntegral(float x)
{
  float z = 1.41421356 * abs(x);
  float t = 1.0 / (1.0 + 0.3275911 * z);
  float series = ((((1.061405429 * t - 1.453152027) * t + 1.421413741) * t - 0.284496736) * t +
                   0.254829592) * t;
  return sign(x) * 0.626657069 * (1.0 - series * exp(-z * z));
}

// Variance (ss, st, tt) of half axes u and v.
vec3 varianceOf(vec2 u, vec2 v)
{
  return vec3(u.x * u.x + v.x * v.x, u.x * u.y + v.x * v.y, u.y * u.y + v.y * v.y);
}

// A disk's half extent stands for 1/4 of its square, a parallelogram's for 1/3.
vec3 convolve(vec2 lightHalfExtent, bool disk, vec3 footprint)
{
  float share = disk ? 4.0 / 3.0 : 1.0;
  return vec3(lightHalfExtent * lightHalfExtent, 0.0).xzy + share * footprint;
}

// Cholesky, along the longer side. window: middle and half size in (s, t).
Kernel kernelOf(vec3 variance, vec2 texelsPerUnit, bool gaussian, vec4 window)
{
  vec3 scaled = variance * vec3(texelsPerUnit, 1.0).xxy * vec3(texelsPerUnit, 1.0).xyy;
  Kernel kernel;
  kernel.transposed = scaled.z > scaled.x;
  vec2 squares = kernel.transposed ? scaled.zx : scaled.xz;
  kernel.along = max(sqrt(squares.x), leastHalfExtent);
  kernel.lean = scaled.y / kernel.along;
  kernel.across = max(sqrt(max(squares.y - kernel.lean * kernel.lean, 0.0)), leastHalfExtent);
  kernel.gaussian = gaussian;
  kernel.window = kernel.transposed ? window.yxwz : window;
  return kernel;
}

// The integral of sqrt(1 - x^2) from 0 to x. asin is atan(x, cos) here: its own precision is loose.
float chordIntegral(float x)
{
  float clamped = clamp(x, -1.0, 1.0);
  float cosine = sqrt(1.0 - clamped * clamped);
  return 0.5 * (clamped * cosine + atan(clamped, cosine));
}

// Strip index of the kernel around center (along the strips' axis, across it): a box.
Strip stripOf(Kernel kernel, bool disk, vec2 center, float index)
{
  float from = max(index - center.x, -kernel.along);
  float to = min(index + 1.0 - center.x, kernel.along);
  float width = max(to - from, 0.0);
  float halfHeight = kernel.across;
  if (disk && width > 0.0)
  {
    halfHeight *=
      (chordIntegral(to / kernel.along) - chordIntegral(from / kernel.along)) * kernel.along / width;
  }
  // A leaning strip is a box smeared by its lean: a box of that variance, and of the strip's area.
  float slope = kernel.lean / kernel.along;
  float smeared = length(vec2(halfHeight, 0.5 * slope * width));
  float middle = center.y + slope * 0.5 * (from + to);
  float weight = width;
  if (kernel.gaussian && width > 0.0)
  {
    float perTexel = kernel.window.z / kernel.along;
    weight = (gaussianIntegral(kernel.window.x + to * perTexel) -
               gaussianIntegral(kernel.window.x + from * perTexel)) / perTexel;
  }
  // A sliver whose chord rounds to nothing still has a slope in the window.
  float share = max(halfHeight / max(smeared, 1e-20), 1e-6);
  return Strip(weight * share, middle - smeared, middle + smeared, kernel.gaussian, middle,
    kernel.window.y, kernel.window.w * share / kernel.across);
}

// Length of the strip within the texel at this index, weighted.
float texelOverlap(Strip strip, float index)
{
  float from = max(strip.low, index);
  float to = min(strip.high, index + 1.0);
  if (!strip.gaussian)
  {
    return max(to - from, 0.0);
  }
  return (gaussianIntegral(strip.windowMiddle + strip.windowSlope * (max(to, from) - strip.middle)) -
           gaussianIntegral(strip.windowMiddle + strip.windowSlope * (from - strip.middle))) /
    strip.windowSlope;
}
