// WebGL: one program for cells and sections, one for lines, one for solid shapes, one for points.
const kCommon = `
precision highp float;
uniform mat4 view; uniform vec3 shift; uniform float shrink; uniform vec4 plane; uniform float sliced;`;
const kSources = {
  cells: [`${kCommon}
attribute vec3 corner; attribute vec3 middle; attribute vec3 normal; attribute float shade; attribute float flag;
varying vec3 at; varying vec3 n; varying float tint; varying float marked;
void main() {
  at = mix(middle, corner, shrink) + shift; n = normal; tint = shade; marked = flag;
  gl_Position = view * vec4(at, 1.0);
}`, `${kCommon}
varying vec3 at; varying vec3 n; varying float tint; varying float marked;
uniform vec3 light; uniform vec3 low; uniform vec3 high; uniform vec3 accent; uniform float flat_;
void main() {
  if (sliced > 0.5 && dot(plane.xyz, at) > plane.w) discard;
  vec3 colour = mix(low, high, tint);
  float stripe = step(0.5, fract((gl_FragCoord.x + gl_FragCoord.y) / 14.0));
  if (marked > 0.5) colour = mix(mix(colour, accent, 0.35), accent, stripe * 0.75);
  float lit = flat_ > 0.5 ? 1.0 : 0.62 + 0.38 * abs(dot(normalize(n), light));
  gl_FragColor = vec4(colour * lit, 1.0);
}`],
  lines: [`${kCommon}
attribute vec3 corner; attribute vec3 middle;
varying vec3 at;
void main() { at = mix(middle, corner, shrink) + shift; gl_Position = view * vec4(at, 1.0); gl_Position.z -= 0.0006 * gl_Position.w; }`,
  `${kCommon}
varying vec3 at; uniform vec4 ink;
void main() {
  if (sliced > 0.5 && dot(plane.xyz, at) > plane.w) discard;
  gl_FragColor = vec4(ink.rgb * ink.a, ink.a);
}`],
  solid: [`${kCommon}
attribute vec3 corner; attribute vec3 normal; attribute float hatching;
varying vec3 n; varying float kind;
void main() { n = normal; kind = hatching; gl_Position = view * vec4(corner + shift, 1.0); }`, `${kCommon}
varying vec3 n; varying float kind; uniform vec3 light; uniform vec3 accent; uniform vec3 paper;
void main() {
  float a = step(0.5, fract((gl_FragCoord.x + gl_FragCoord.y) / 14.0));
  float b = step(0.5, fract((gl_FragCoord.x - gl_FragCoord.y) / 14.0));
  float pattern = kind < 0.5 ? 1.0 : kind < 1.5 ? a : a * b;
  float lit = 0.7 + 0.3 * abs(dot(normalize(n), light));
  gl_FragColor = vec4(mix(mix(accent, paper, 0.55), accent, pattern) * lit, 1.0);
}`],
  points: [`${kCommon}
attribute vec3 corner; uniform float size; varying vec3 at;
void main() { at = corner + shift; gl_Position = view * vec4(at, 1.0); gl_Position.z -= 0.001 * gl_Position.w; gl_PointSize = size; }`,
  `${kCommon}
varying vec3 at; uniform vec4 ink;
void main() {
  vec2 d = gl_PointCoord - 0.5;
  if (dot(d, d) > 0.25 || (sliced > 0.5 && dot(plane.xyz, at) > plane.w)) discard;
  gl_FragColor = vec4(ink.rgb, 1.0);
}`],
};
const kLayouts = {
  cells: [["corner", 3], ["middle", 3], ["normal", 3], ["shade", 1], ["flag", 1]],
  solid: [["corner", 3], ["normal", 3], ["hatching", 1]],
  lines: [["corner", 3]],
};

class Painter {
  constructor(gl) {
    this.gl = gl;
    this.programs = {};
    for (const [name, [vertex, fragment]] of Object.entries(kSources)) this.programs[name] = this.program(vertex, fragment);
  }
  program(vertex, fragment) {
    const gl = this.gl, program = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    return program;
  }
  buffer(values, layout) {
    const gl = this.gl, id = gl.createBuffer(), stride = kLayouts[layout].reduce((s, [, n]) => s + n, 0);
    gl.bindBuffer(gl.ARRAY_BUFFER, id);
    gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
    return { id, layout, stride, count: values.length / stride };
  }
  release(buffer) { this.gl.deleteBuffer(buffer.id); }
  // Draws the first `count` vertices; uniforms by name: numbers or arrays.
  draw(name, mode, buffer, uniforms, count = buffer.count) {
    const gl = this.gl, program = this.programs[name];
    if (count === 0) return;
    gl.useProgram(program);
    for (const [key, value] of Object.entries(uniforms)) {
      const where = gl.getUniformLocation(program, key);
      if (where === null) continue;
      if (typeof value === "number") gl.uniform1f(where, value);
      else if (value.length === 16) gl.uniformMatrix4fv(where, false, value);
      else gl[`uniform${value.length}fv`](where, value);
    }
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer.id);
    let offset = 0;
    const used = [];
    for (const [key, size] of kLayouts[buffer.layout]) {
      const where = gl.getAttribLocation(program, key);
      if (where >= 0) {
        gl.enableVertexAttribArray(where);
        gl.vertexAttribPointer(where, size, gl.FLOAT, false, 4 * buffer.stride, 4 * offset);
        used.push(where);
      }
      offset += size;
    }
    gl.drawArrays(mode, 0, count);
    for (const where of used) gl.disableVertexAttribArray(where);
  }
}

