//VTK::System::Dec
//VTK::Output::Dec

// Step 5: a level of the pyramid, the least of 2 x 2 cells of the level below.

uniform sampler2DArray cells; // the level below is its base level

void main()
{
  ivec2 first = 2 * ivec2(gl_FragCoord.xy);
  vec4 least = texelFetch(cells, ivec3(first, 0), 0);
  least = min(least, texelFetch(cells, ivec3(first + ivec2(1, 0), 0), 0));
  least = min(least, texelFetch(cells, ivec3(first + ivec2(0, 1), 0), 0));
  least = min(least, texelFetch(cells, ivec3(first + ivec2(1, 1), 0), 0));
  gl_FragData[0] = least;
}
