/**
 * The stage's shaders (GLSL ES 3). In: the cone texture (cone-texture.ts), colours and lights. Out:
 * matte figures that darken themselves and the ground, by formula, without a shadow map.
 */

/** Cones of a figure that a pixel looks at; further ones are drawn but darken nothing. */
const MOST_OCCLUDERS = 200;

/** Figures whose cones the ground looks at; the others get a soft spot each. */
export const NEAR_FIGURES = 3;
export const MOST_SPOTS = 24;

const CONES = /* glsl */ `
uniform highp sampler2D cones;
vec4 coneStart(int i) { return texelFetch(cones, ivec2(0, i), 0); }
vec4 coneEnd(int i) { return texelFetch(cones, ivec2(1, i), 0); }
vec4 coneKind(int i) { return texelFetch(cones, ivec2(2, i), 0); }
`;

const OCCLUSION = /* glsl */ `
uniform vec3 sunDirection;

// Part of the sky over p (normal n) that a cone leaves open. A ball of radius r at distance l covers
// cos(angle) r² / l² of the cosine-weighted sky; a cone covers more than its nearest ball: power 1.5.
float openSky(vec3 p, vec3 n, vec4 start, vec4 end) {
  vec3 axis = end.xyz - start.xyz;
  float along = clamp(dot(p - start.xyz, axis) / max(dot(axis, axis), 1e-8), 0., 1.);
  float radius = mix(start.w, end.w, along);
  vec3 toward = start.xyz + along * axis - p;
  float l = max(length(toward), radius * 1.02);
  float open = 1. - max(dot(toward, n), 0.) * radius * radius / (l * l * l);
  return open * sqrt(open);
}

// Part of the sun seen from p: how wide the ray to the sun passes by the cone, seen from p.
float openSun(vec3 p, vec4 start, vec4 end, float sharpness) {
  vec3 axis = end.xyz - start.xyz;
  vec3 from = p - start.xyz;
  float axisSun = dot(axis, sunDirection);
  float fromSun = dot(from, sunDirection);
  float bend = max(dot(axis, axis) - axisSun * axisSun, 1e-7);
  float along = clamp((dot(from, axis) - fromSun * axisSun) / bend, 0., 1.);
  float ray = max(along * axisSun - fromSun, 1e-5);
  float gap = length(from + ray * sunDirection - along * axis) - .78 * mix(start.w, end.w, along);
  return smoothstep(0., 1., clamp(sharpness * gap / ray + .5, 0., 1.));
}
`;

/**
 * position = (cos θ, sin θ, ring 0 … 1); one instance is one cone. A cone is convex, so each vertex
 * lies where the surface has its normal: ring 0 faces the eye, ring 1 is the outline as the eye sees it.
 */
export const figureVertex = /* glsl */ `
${CONES}
uniform int firstCone;
uniform vec3 sideColours[3];
uniform vec3 restColour;
uniform float resting;
// A ghost is drawn twice, for its depth and for its colour: both must lie in the same place.
invariant gl_Position;
out vec3 worldPosition;
flat out vec3 colour;
flat out int cone;

vec3 anyAcross(vec3 v) {
  return normalize(cross(v, abs(v.y) < .9 ? vec3(0., 1., 0.) : vec3(1., 0., 0.)));
}

// The vertex' normal on a ball: turned from the eye towards the outline, θ counted from "along".
vec3 normalOn(vec4 ball, vec3 along) {
  vec3 toEye = cameraPosition - ball.xyz;
  float far = length(toEye);
  vec3 v = toEye / far;
  vec3 u = normalize(along - dot(along, v) * v);
  float turn = acos(clamp(ball.w / far, 0., .98)) * position.z;
  return cos(turn) * v + sin(turn) * (position.x * u + position.y * cross(v, u));
}

void main() {
  cone = firstCone + gl_InstanceID;
  vec4 a = coneStart(cone), b = coneEnd(cone), kind = coneKind(cone);
  vec3 axis = b.xyz - a.xyz;
  vec3 v = normalize(cameraPosition - .5 * (a.xyz + b.xyz));
  vec3 along = axis - dot(axis, v) * v;
  float alongLength = length(along);
  along = alongLength > 1e-5 ? along / alongLength : anyAcross(v);
  vec3 n = normalOn(a, along);
  vec4 ball = a;
  // The ball that reaches farther that way.
  if (dot(n, axis) + b.w - a.w > 0.) {
    n = normalOn(b, along);
    ball = b;
  }
  worldPosition = ball.xyz + ball.w * n;
  colour = mix(sideColours[int(kind.y + .5)], restColour, resting);
  gl_Position = projectionMatrix * viewMatrix * vec4(worldPosition, 1.);
  // The trunk wins where a limb begins inside it with nearly its radius.
  vec3 toEye = normalize(cameraPosition - worldPosition);
  vec4 nearer = projectionMatrix * viewMatrix * vec4(worldPosition + .005 * kind.z * toEye, 1.);
  gl_Position.z = nearer.z / nearer.w * gl_Position.w;
}
`;

export const figureFragment = /* glsl */ `
${CONES}
${OCCLUSION}
uniform int firstCone;
uniform int occluderCount;
uniform float opacity;
uniform vec3 sky, ground, sun, rim;
in vec3 worldPosition;
flat in vec3 colour;
flat in int cone;
out vec4 pixel;

void main() {
  vec4 a = coneStart(cone), b = coneEnd(cone);
  float limb = coneKind(cone).x;
  // The ball of the cone that touches here: the mesh is coarse, the surface is not.
  vec3 axis = b.xyz - a.xyz;
  float len = max(length(axis), 1e-6);
  vec3 w = axis / len;
  vec3 from = worldPosition - a.xyz;
  float y = dot(from, w);
  float slope = clamp((a.w - b.w) / len, -.999, .999);
  float centre = clamp(y - length(from - y * w) * slope * inversesqrt(1. - slope * slope), 0., len);
  vec3 middle = a.xyz + centre * w;
  vec3 n = normalize(worldPosition - middle);
  vec3 p = middle + n * mix(a.w, b.w, centre / len);

  vec3 toEye = normalize(cameraPosition - p);
  float open = 1., lit = 1.;
  for (int i = 0; i < min(occluderCount, ${MOST_OCCLUDERS}); i++) {
    int other = firstCone + i;
    if (abs(coneKind(other).x - limb) < .5) continue;
    vec4 start = coneStart(other), end = coneEnd(other);
    open *= mix(1., openSky(p, n, start, end), .62);
    lit = min(lit, openSun(p + n * .014, start, end, 5.));
  }
  open *= mix(.62, 1., smoothstep(0., .2, p.y + n.y * .05));
  float upward = n.y * .5 + .5;
  float facing = dot(n, sunDirection);
  float sunlight = mix(max(facing + .35, 0.) / 1.35 * .35, max(facing, 0.), .7) * mix(.35, 1., lit);
  float edge = pow(1. - max(dot(n, toEye), 0.), 3.);
  vec3 light = mix(ground, sky, upward) * open + sun * sunlight;
  pixel = linearToOutputTexel(vec4(colour * light + rim * edge * (.4 + .6 * upward) * open, opacity));
}
`;

/** Leaves nothing but its depth. */
export const depthFragment = /* glsl */ `
out vec4 pixel;
void main() { pixel = vec4(0.); }
`;

/** Tubes of trail-geometry.ts: strongest at the figure, fading towards both ends. */
export const trailVertex = /* glsl */ `
uniform vec3 sideColours[3];
uniform float now;
in float time;
in float side;
out vec3 colour;
out float alpha;
void main() {
  vec4 place = viewMatrix * vec4(position, 1.);
  float facing = dot(mat3(viewMatrix) * normal, normalize(-place.xyz));
  colour = sideColours[int(side + .5)] * (.72 + .28 * facing);
  alpha = time <= now
    ? .9 * time / max(now, 1e-6)
    : .35 * (1. - time) / max(1. - now, 1e-6);
  gl_Position = projectionMatrix * place;
}
`;

export const trailFragment = /* glsl */ `
in vec3 colour;
in float alpha;
out vec4 pixel;
void main() { pixel = linearToOutputTexel(vec4(colour, alpha)); }
`;

export const groundVertex = /* glsl */ `
out vec2 place;
void main() {
  vec4 world = modelMatrix * vec4(position, 1.);
  place = world.xz;
  gl_Position = projectionMatrix * viewMatrix * world;
}
`;

export const groundFragment = /* glsl */ `
${CONES}
${OCCLUSION}
uniform ivec2 figures[${NEAR_FIGURES}];
uniform vec3 figureBounds[${NEAR_FIGURES}];
uniform float figureWeights[${NEAR_FIGURES}];
uniform int figureCount;
uniform vec4 spots[${MOST_SPOTS}];
uniform int spotCount;
uniform vec2 centre;
uniform float cell, fade, pixelRatio, gridStrength, shadowStrength;
uniform vec3 gridColour, shadowColour;
in vec2 place;
out vec4 pixel;

// Lines of a width in CSS pixels; they fade where they would come closer than a few pixels.
float lines(float size, float width) {
  vec2 at = place / size;
  vec2 pixelSize = fwidth(at);
  vec2 off = abs(fract(at - .5) - .5) / pixelSize;
  float line = 1. - min(min(off.x, off.y) / (width * pixelRatio), 1.);
  return line * clamp(1. - max(pixelSize.x, pixelSize.y) * 1.6, 0., 1.);
}

void main() {
  float open = 1., lit = 1.;
  vec3 p = vec3(place.x, 0., place.y);
  for (int f = 0; f < figureCount; f++) {
    if (distance(place, figureBounds[f].xy) > figureBounds[f].z) continue;
    int last = figures[f].x + min(figures[f].y, ${MOST_OCCLUDERS});
    float sky = 1., sun = 1.;
    for (int cone = figures[f].x; cone < last; cone++) {
      vec4 a = coneStart(cone), b = coneEnd(cone);
      sky *= openSky(p, vec3(0., 1., 0.), a, b);
      sun = min(sun, openSun(p, a, b, 2.6));
    }
    open *= mix(1., sky, figureWeights[f]);
    lit = min(lit, mix(1., sun, figureWeights[f]));
  }
  for (int s = 0; s < spotCount; s++) {
    vec2 off = (place - spots[s].xy) / spots[s].z;
    open *= 1. - spots[s].w * exp(-dot(off, off));
  }
  float away = distance(place, centre);
  float grid = max(lines(cell, .7) * .6, lines(cell * 2., .8))
    * gridStrength * (1. - smoothstep(fade * .25, fade, away));
  float shadow = (1. - open * mix(.62, 1., lit)) * shadowStrength;
  float alpha = 1. - (1. - grid) * (1. - shadow);
  if (alpha < .002) discard;
  pixel = linearToOutputTexel(vec4(mix(gridColour, shadowColour, clamp(shadow / alpha, 0., 1.)), alpha));
}
`;

export const backgroundVertex = /* glsl */ `
out float height;
void main() {
  height = position.y * .5 + .5;
  gl_Position = vec4(position.xy, 1., 1.);
}
`;

/** Colours are sRGB already, mixed as CSS mixes them; half a step of noise hides the bands. */
export const backgroundFragment = /* glsl */ `
uniform vec3 top, bottom;
in float height;
out vec4 pixel;
void main() {
  float noise = fract(sin(dot(gl_FragCoord.xy, vec2(12.9898, 78.233))) * 43758.5453) - .5;
  pixel = vec4(mix(bottom, top, height) + noise / 255., 1.);
}
`;
