// The graph of visible spaces. The page holds positions in units of one edge length; this file scales, draws and labels.
class SpaceGraph {
  constructor(box, data) {
    Object.assign(this, { data, everyFrame: false, index: 0, zoom: 1, pan: { x: 0, y: 0 }, chosen: null });
    this.root = box.querySelector(".graph");
    this.info = box.querySelector(".graphinfo");
    this.select = box.querySelector("select");
    this.neighbours = data.nodes.map(() => new Set());
    for (const [a, b] of data.edges) { this.neighbours[a].add(b); this.neighbours[b].add(a); }
    this.make();
    this.listen(box);
    new ResizeObserver(() => this.place()).observe(this.root);
    this.show(0);
  }

  make() {
    this.edges = this.data.edges.map(() => svg("line", { class: "edge" }, this.root));
    this.nodes = this.data.nodes.map((node, i) => {
      const shape = svg(node.outside ? "rect" : "circle", { class: "node", "data-node": i }, this.root);
      svg("title", {}, shape).textContent = node.name;
      return shape;
    });
    this.names = svg("g", { "aria-hidden": "true" }, this.root);
    const order = this.data.nodes.map((node, i) => i).sort((a, b) => this.data.nodes[a].name.localeCompare(this.data.nodes[b].name));
    for (const i of order) this.select.append(new Option(this.data.nodes[i].name, i));
  }

  listen(box) {
    this.root.addEventListener("click", (event) => {
      const node = event.target.closest("[data-node]");
      if (!this.dragged) this.choose(node ? Number(node.dataset.node) : null);
    });
    this.select.addEventListener("change", () => this.choose(this.select.value === "" ? null : Number(this.select.value)));
    const zoomBy = (factor) => () => { this.zoom = Math.min(20, Math.max(0.5, this.zoom * factor)); this.place(); };
    box.querySelector("[data-zoom=in]").addEventListener("click", zoomBy(1.4));
    box.querySelector("[data-zoom=out]").addEventListener("click", zoomBy(1 / 1.4));
    box.querySelector("[data-zoom=fit]").addEventListener("click", () => { this.zoom = 1; this.pan = { x: 0, y: 0 }; this.place(); });
    const every = box.querySelector("[data-every]");
    every.addEventListener("click", () => {
      this.everyFrame = !this.everyFrame;
      every.setAttribute("aria-pressed", String(this.everyFrame));
      this.show(this.index);
    });
    let from = null;
    this.root.addEventListener("pointerdown", (event) => { from = { x: event.clientX, y: event.clientY }; this.dragged = false; });
    this.root.addEventListener("pointermove", (event) => {
      if (!from || event.buttons === 0) return;
      const dx = event.clientX - from.x, dy = event.clientY - from.y;
      if (!this.dragged && Math.hypot(dx, dy) < 4) return;
      this.dragged = true;
      this.pan = { x: this.pan.x + dx, y: this.pan.y + dy };
      from = { x: event.clientX, y: event.clientY };
      this.place();
    });
    this.root.addEventListener("pointerup", () => { from = null; });
  }

  place() {
    const width = this.root.clientWidth, height = this.root.clientHeight;
    if (width === 0) return;
    this.root.setAttribute("viewBox", `0 0 ${width} ${height}`);
    let x0 = Infinity, x1 = -Infinity, y0 = Infinity, y1 = -Infinity;
    for (const node of this.data.nodes) {
      x0 = Math.min(x0, node.x); x1 = Math.max(x1, node.x);
      y0 = Math.min(y0, node.y); y1 = Math.max(y1, node.y);
    }
    const fit = Math.min((width - 120) / Math.max(0.1, x1 - x0), (height - 70) / Math.max(0.1, y1 - y0), 130);
    const scale = fit * this.zoom, size = Math.min(11, Math.max(3, scale * 0.16));
    this.at = this.data.nodes.map((node) => ({
      x: width / 2 + this.pan.x + (node.x - (x0 + x1) / 2) * scale,
      y: height / 2 + this.pan.y + (node.y - (y0 + y1) / 2) * scale,
    }));
    this.data.edges.forEach(([a, b], i) => {
      const p = this.at[a], q = this.at[b];
      for (const [key, value] of [["x1", p.x], ["y1", p.y], ["x2", q.x], ["y2", q.y]]) this.edges[i].setAttribute(key, value.toFixed(1));
    });
    this.nodes.forEach((shape, i) => {
      const { x, y } = this.at[i], half = size * 1.25;
      const values = this.data.nodes[i].outside ? { x: x - half, y: y - half, width: 2 * half, height: 2 * half, rx: 3 } : { cx: x, cy: y, r: size };
      for (const key in values) shape.setAttribute(key, Number(values[key].toFixed(1)));
    });
    this.size = size;
    this.label();
  }

  /** Names the most important nodes, as many as fit without overlap. */
  label() {
    if (!this.at) return;
    this.names.replaceChildren();
    const frame = this.data.frames[this.index] || [0, [], []];
    const rank = (i) => (i === this.chosen ? 4e9 : 0) + (i === frame[0] ? 2e9 : 0) + (this.now.has(i) ? 1e9 : 0) + this.data.nodes[i].frames;
    const order = this.data.nodes.map((node, i) => i).sort((a, b) => rank(b) - rank(a));
    const taken = this.at.map((p) => ({ x0: p.x - this.size, x1: p.x + this.size, y0: p.y - this.size, y1: p.y + this.size }));
    for (const i of order) {
      const wide = this.data.nodes[i].name.length * 6.4 + 4, gap = this.size + 3, p = this.at[i];
      const places = [
        { x: p.x + gap, anchor: "start", x0: p.x + gap, y: p.y + 4 }, { x: p.x - gap, anchor: "end", x0: p.x - gap - wide, y: p.y + 4 },
        { x: p.x, anchor: "middle", x0: p.x - wide / 2, y: p.y - gap - 2 }, { x: p.x, anchor: "middle", x0: p.x - wide / 2, y: p.y + gap + 10 },
      ];
      for (const place of places) {
        const box = { x0: place.x0, x1: place.x0 + wide, y0: place.y - 10, y1: place.y + 3 };
        if (taken.some((t) => t.x0 < box.x1 && t.x1 > box.x0 && t.y0 < box.y1 && t.y1 > box.y0)) continue;
        taken.push(box);
        svg("text", { class: "name", x: place.x, y: place.y, "text-anchor": place.anchor }, this.names).textContent = this.data.nodes[i].name;
        break;
      }
    }
  }

  choose(node) {
    this.chosen = node;
    this.select.value = node === null ? "" : String(node);
    this.show(this.index);
  }

  describe() {
    const frame = this.data.frames[this.index];
    if (this.chosen === null) {
      this.info.textContent = frame
        ? `This frame sees ${frame[1].length} of ${this.data.nodes.length} spaces, from ${this.data.nodes[frame[0]].name}. Choose a space for its openings.`
        : "No frame was recorded.";
      return;
    }
    const node = this.data.nodes[this.chosen], doors = [...this.neighbours[this.chosen]].map((i) => this.data.nodes[i].name);
    const shown = doors.slice(0, 24).join(", ") + (doors.length > 24 ? `, and ${doors.length - 24} more` : "");
    this.info.textContent = `${node.name}: seen in ${node.frames} of ${this.data.frames.length} frames. Openings to: ${shown || "none that a frame saw"}.`;
  }

  show(index) {
    this.index = index;
    const frame = this.data.frames[index] || [0, [], []];
    this.now = new Set(frame[1]);
    const edgesNow = new Set(frame[2]);
    this.nodes.forEach((shape, i) => {
      const isNow = this.now.has(i), isRoot = frame[1].length > 0 && i === frame[0];
      shape.classList.toggle("now", !this.everyFrame && isNow && !isRoot);
      shape.classList.toggle("root", !this.everyFrame && isRoot);
      shape.classList.toggle("dim", !this.everyFrame && !isNow);
      shape.classList.toggle("chosen", i === this.chosen);
    });
    this.edges.forEach((line, i) => {
      const [a, b] = this.data.edges[i];
      line.classList.toggle("now", (!this.everyFrame && edgesNow.has(i)) || (this.chosen !== null && (a === this.chosen || b === this.chosen)));
    });
    this.describe();
    this.label();
  }
}
