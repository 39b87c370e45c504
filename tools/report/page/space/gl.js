// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces by WebGL 2: one context for the page, whose pictures are copied to where they are seen.

const vertexShader = `#version 300 es
in vec3 place; in vec3 normal; in float value;
uniform mat3 copy; uniform mat3 turn; uniform vec3 middle; uniform vec3 scale; uniform vec2 shift;
out float shown; out vec3 facing;
void main() {
  vec3 at = turn * (copy * place - middle);
  facing = turn * (copy * normal);
  shown = value;
  gl_Position = vec4(at.xy * scale.xy + shift, -at.z * scale.z, 1.0);
}`;

const fragmentShader = `#version 300 es
precision highp float;
in float shown; in vec3 facing;
uniform sampler2D colours; uniform vec2 range; uniform vec4 line;
out vec4 colour;
void main() {
  if (line.a > 0.0) { colour = line; return; }
  float share = clamp((shown - range.x) / (range.y - range.x), 0.0, 1.0);
  vec3 towards = normalize(facing);
  float light = 0.6 + 0.4 * abs(dot(towards, normalize(vec3(-0.25, 0.45, 1.0))));
  colour = vec4(texture(colours, vec2(share * 255.0 / 256.0 + 0.5 / 256.0, 0.5)).rgb * light, 1.0);
}`;

/** Throws where the browser cannot. */
class GlPainter {
  constructor() {
    this.canvas = element("canvas");
    const gl = this.canvas.getContext("webgl2", { antialias: true, alpha: true, preserveDrawingBuffer: true });
    if (!gl) throw new Error("no WebGL 2");
    this.gl = gl;
    this.program = gl.createProgram();
    for (const [kind, text] of [
      [gl.VERTEX_SHADER, vertexShader],
      [gl.FRAGMENT_SHADER, fragmentShader],
    ]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(this.program, shader);
    }
    ["place", "normal", "value"].forEach((name, i) => gl.bindAttribLocation(this.program, i, name));
    gl.linkProgram(this.program);
    if (!gl.getProgramParameter(this.program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(this.program));
    this.at = (name) => gl.getUniformLocation(this.program, name);
    this.buffers = [0, 1, 2].map(() => gl.createBuffer());
    this.indices = gl.createBuffer();
    this.texture = gl.createTexture();
  }

  /** Draws copies of a frame into a picture of the view's size, by way of the canvas, which only grows. */
  paint(context, frame, view, options) {
    const { gl, canvas } = this,
      { width, height } = view;
    if (gl.isContextLost()) throw new Error("the display card gave up");
    if (canvas.width < width) canvas.width = width;
    if (canvas.height < height) canvas.height = height;
    gl.viewport(0, 0, width, height);
    gl.scissor(0, 0, width, height);
    gl.enable(gl.SCISSOR_TEST);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.useProgram(this.program);
    this.setView(view);
    this.setColours(options);
    const nodes = frame.mesh.nodes,
      values = frame.values(options.field) || new Float32Array(nodes);
    frame.places ??= Float32Array.from(
      { length: 3 * nodes },
      (_, i) => [frame.x, frame.y, frame.z][i % 3][(i / 3) | 0],
    );
    this.send(0, 3, frame.places);
    this.send(2, 1, values);
    for (const side of sideNames.keys()) this.paintSide(frame, side, options);
    context.drawImage(canvas, 0, canvas.height - height, width, height, 0, 0, width, height);
  }

  setView({ width, height, turn, middle, pixels, shift, reach }) {
    const { gl, at } = this;
    gl.uniformMatrix3fv(at("turn"), true, turn);
    gl.uniform3fv(at("middle"), middle);
    gl.uniform3f(at("scale"), (2 * pixels) / width, (2 * pixels) / height, 1 / (2 * reach));
    gl.uniform2f(at("shift"), (2 * shift[0]) / width, (-2 * shift[1]) / height);
  }

  setColours({ field, range }) {
    const { gl, at } = this,
      colours = new Uint8Array(colourTables[spaceFields[field].colours].buffer);
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, 256, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, colours);
    for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.LINEAR);
    for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
    gl.uniform2fv(at("range"), range);
  }

  /** Gives one of the inputs of a node its values. */
  send(input, size, values) {
    const { gl } = this;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[input]);
    gl.bufferData(gl.ARRAY_BUFFER, values, gl.DYNAMIC_DRAW);
    gl.enableVertexAttribArray(input);
    gl.vertexAttribPointer(input, size, gl.FLOAT, false, 0, 0);
  }

  paintSide(frame, side, options) {
    const copies = options.copies.filter((copy) => isSeen(frame.film, side, copy, options.copies));
    if (!copies.length) return;
    const { gl, at } = this;
    this.send(1, 3, frame.normalsOf(side));
    gl.uniform4f(at("line"), 0, 0, 0, 0);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(1, 1);
    this.draw(frame, copies, gl.TRIANGLES, frame.mesh.triangles[side]);
    gl.disable(gl.POLYGON_OFFSET_FILL);
    if (options.mesh) {
      gl.uniform4f(at("line"), 0, 0, 0, 1);
      this.draw(frame, copies, gl.LINES, frame.mesh.linesOf(side, false));
    } else if (side >= firstPlane) {
      gl.uniform4f(at("line"), 0.1, 0.1, 0.1, 1);
      this.draw(frame, copies, gl.LINES, frame.mesh.linesOf(side, true));
    }
  }

  draw(frame, copies, kind, nodes) {
    const { gl, at } = this;
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.indices);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, nodes, gl.DYNAMIC_DRAW);
    for (const copy of copies) {
      const [a, b, c, d] = frame.film.copy(copy);
      gl.uniformMatrix3fv(at("copy"), true, [a, b, 0, c, d, 0, 0, 0, 1]);
      gl.drawElements(kind, nodes.length, gl.UNSIGNED_SHORT, 0);
    }
  }
}
