// The arm going from target to target, two solvers side by side: the data of #motion-data drawn by three.js.
'use strict';
(() => {
  const data = JSON.parse(document.getElementById('motion-data').textContent);
  const stage = document.getElementById('stage');
  const arm = data.arm;
  const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
  const metal = 0x8a94a3, joint = 0x0072b2, way = 0xe69f00, goal = 0x009e73;

  const turnedAbout = {
    x: angle => new THREE.Matrix4().makeRotationX(angle),
    y: angle => new THREE.Matrix4().makeRotationY(angle),
    z: angle => new THREE.Matrix4().makeRotationZ(angle),
  };
  const moved = (x, y, z) => new THREE.Matrix4().makeTranslation(x, y, z);
  const enter = (frame, { position_m, rpy_rad: [roll, pitch, yaw] }) => frame.multiply(moved(...position_m))
    .multiply(turnedAbout.z(yaw)).multiply(turnedAbout.y(pitch)).multiply(turnedAbout.x(roll));

  const isMoved = frame => frame.position_m.some(x => x !== 0);

  // Forward kinematics: the corners of the arm from the base to the tool, each with the joint that moves there (or -1).
  function forward(q) {
    const frame = new THREE.Matrix4(), corners = [];
    const here = joint => corners.push({ at: new THREE.Vector3().setFromMatrixPosition(frame), joint });
    if (isMoved(arm.base)) here(-1);
    enter(frame, arm.base);
    arm.links.forEach((link, i) => {
      here(i);
      const slides = link.joint === 'slides', turned = turnedAbout[link.joint === 'coupled' ? 'y' : 'z'];
      const angle = link.offset_rad + (slides ? 0 : q[i]);
      frame.multiply(turned(angle)).multiply(moved(0, 0, link.d_m + (slides ? q[i] : 0)));
      if (link.a_m !== 0) {
        here(-1);
        frame.multiply(moved(link.a_m, 0, 0));
      }
      if (link.joint === 'coupled') frame.multiply(turned(-angle));  // it holds what comes after it in its direction
      frame.multiply(turnedAbout.x(link.alpha_rad)).multiply(turnedAbout.y(link.beta_rad));
    });
    here(-1);
    enter(frame, arm.tool);
    if (isMoved(arm.tool)) here(-1);
    return corners;
  }
  if (!document.createElement('canvas').getContext('webgl')) return;

  const known = list => Array.isArray(list) && list.every(Number.isFinite);

  // A solver's configurations: from where each step starts to what it came to; an answer that is none stays.
  function movesOf(solver) {
    let last = null;
    return solver.steps.map(step => {
      const start = known(step.start) ? step.start : last ?? step.answer;
      const answer = known(step.answer) ? step.answer : start;
      last = answer;
      return { ...step, start, end: answer };
    });
  }
  const between = (move, share) => move.start.map((x, i) => x + (move.end[i] - x) * share);

  // One time for both views: whole numbers are answers, the place between k - 1 and k is the way to answer k.
  const longest = Math.max(...data.solvers.map(solver => solver.steps.length));
  let time = 0, playing = false, before = 0;
  const stateAt = moves => {
    const index = Math.min(Math.max(Math.ceil(time), 1), moves.length);
    const share = time >= moves.length ? 1 : Math.max(0, time - (index - 1));
    const eased = share * share * (3 - 2 * share);
    return { index, move: moves[index - 1], q: between(moves[index - 1], still ? Math.round(share) : eased) };
  };

  const samples = 16;  // of the tool's way per step
  const up = new THREE.Vector3(0, 1, 0);

  const slides = data.arm.links.some(link => link.joint === 'slides');

  // All of every solver is seen, at rest and on its way, and both views look from the same place. But an answer may be
  // anywhere, so those beyond twice the distance of targets and of arms before their first move are out of sight.
  const moves = data.solvers.map(movesOf), all = moves.flat();
  const targets = all.filter(move => known(move.target)).map(move => new THREE.Vector3(...move.target));
  const first = moves.flatMap(each => forward(between(each[0], 0)).map(corner => corner.at));
  const furthest = 2 * Math.max(...[...targets, ...first].map(at => at.length()));
  const room = new THREE.Box3().setFromPoints(targets);
  for (const move of all) {
    for (const share of [0, 0.25, 0.5, 0.75, 1]) {
      for (const corner of forward(between(move, share))) {
        if (corner.at.length() <= furthest) room.expandByPoint(corner.at);
      }
    }
  }
  const size = Math.max(room.getSize(new THREE.Vector3()).length(), 0.1);
  const centre = room.getCenter(new THREE.Vector3());

  class View {
    constructor(place, chosen) {
      this.root = document.createElement('div');
      this.root.className = 'view';
      const label = document.createElement('label');
      const select = document.createElement('select');
      select.setAttribute('aria-label', `Solver of view ${place + 1}`);
      data.solvers.forEach((solver, i) => select.add(new Option(solver.name, i, false, i === chosen)));
      label.append(select);
      this.canvas = document.createElement('canvas');
      this.canvas.tabIndex = 0;
      this.canvas.setAttribute('role', 'img');
      this.text = document.createElement('p');
      this.root.append(label, this.canvas, this.text);

      this.renderer = new THREE.WebGLRenderer({ canvas: this.canvas, antialias: true, alpha: true });
      this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
      this.scene = new THREE.Scene();
      this.camera = new THREE.PerspectiveCamera(40, 1, size / 1000, size * 100);
      this.camera.up.set(0, 0, 1);
      this.scene.add(new THREE.HemisphereLight(0xffffff, 0x666677, 0.9));
      const light = new THREE.DirectionalLight(0xffffff, 0.6);
      light.position.set(1, -1, 2);
      this.scene.add(light);
      this.controls = new THREE.OrbitControls(this.camera, this.canvas);
      this.controls.enableKeys = false;
      this.controls.target.copy(centre);
      this.camera.position.copy(centre).add(new THREE.Vector3(0.75, -1.05, 0.45).multiplyScalar(size));
      this.controls.update();
      this.moving = new THREE.Group();
      this.fixed = new THREE.Group();
      this.scene.add(this.fixed, this.moving);
      this.choose(chosen);
      select.addEventListener('change', () => { this.choose(Number(select.value)); this.draw(); });
    }

    choose(index) {
      this.solver = data.solvers[index];
      this.moves = movesOf(this.solver);
      this.canvas.setAttribute('aria-label', `The arm, moved by ${this.solver.name}`);
      const targets = this.moves.filter(move => known(move.target)).map(move => new THREE.Vector3(...move.target));
      this.fixed.remove(...this.fixed.children);
      const grid = new THREE.GridHelper(size, 10, 0x888888, 0x888888);
      grid.material.transparent = true;
      grid.material.opacity = 0.35;
      grid.rotation.x = Math.PI / 2;
      this.fixed.add(grid);
      for (const target of targets) this.fixed.add(this.ball(target, 0.011, goal));
      const path = new THREE.BufferGeometry().setFromPoints(targets);
      if (data.is_path) this.fixed.add(new THREE.Line(path, new THREE.LineBasicMaterial({ color: goal })));

      const tools = [];
      for (const move of this.moves) {
        for (let i = 0; i <= samples; ++i) tools.push(forward(between(move, i / samples)).pop().at);
      }
      this.way = new THREE.Line(new THREE.BufferGeometry().setFromPoints(tools),
                                new THREE.LineBasicMaterial({ color: way, transparent: true, opacity: 0.9 }));
      this.way.frustumCulled = false;
      this.fixed.add(this.way);
    }

    ball(at, radius, color) {
      const mesh = new THREE.Mesh(new THREE.SphereBufferGeometry(radius * size, 16, 12),
                                  new THREE.MeshLambertMaterial({ color }));
      mesh.position.copy(at);
      return mesh;
    }

    bar(from, to) {
      const along = new THREE.Vector3().subVectors(to, from), length = along.length();
      const mesh = new THREE.Mesh(new THREE.CylinderBufferGeometry(0.014 * size, 0.014 * size, length, 16),
                                  new THREE.MeshLambertMaterial({ color: metal }));
      mesh.position.addVectors(from, to).multiplyScalar(0.5);
      mesh.quaternion.setFromUnitVectors(up, along.normalize());
      return mesh;
    }

    draw() {
      const side = this.canvas.clientWidth;
      if (side !== this.side) this.renderer.setSize(this.side = side, side, false);
      const { index, move, q } = stateAt(this.moves);
      for (const old of this.moving.children) {
        old.geometry.dispose();
        old.material.dispose();
      }
      this.moving.remove(...this.moving.children);
      const corners = forward(q);
      corners.forEach((corner, i) => {
        const last = i === corners.length - 1;
        this.moving.add(this.ball(corner.at, last ? 0.012 : 0.021, last ? way : joint));
        if (i > 0 && corners[i - 1].at.distanceTo(corner.at) > 1e-6) this.moving.add(this.bar(corners[i - 1].at, corner.at));
      });
      const done = Math.min(time, this.moves.length);
      this.way.geometry.setDrawRange(0, done <= 0 ? 0 : Math.floor((index - 1) * (samples + 1) + (done - index + 1) * samples) + 1);
      this.renderer.render(this.scene, this.camera);
      this.tell(index, move);
    }

    tell(index, move) {
      const digits = (value, count) => value === null ? 'none' : Number(value.toPrecision(count)).toString();
      const words = `Target ${move.point}: error ${digits(move.error, 2)} ${this.solver.unit}, joints move ${digits(move.variation_deg, 3)}\u00b0${
        slides ? ` and ${digits(move.variation_m, 3)} m` : ''}.`;
      if (this.told === index + words) return;
      this.told = index + words;
      this.text.textContent = words;
      const faults = [move.late && ' Late.', move.too_fast && ' Too fast for a joint.'].filter(Boolean);
      if (faults.length === 0) return;
      const warning = document.createElement('span');
      warning.className = 'fault';
      warning.textContent = faults.join('');
      this.text.append(warning);
    }
  }

  const second = data.solvers.findIndex((solver, i) => i > 0 && solver.name !== data.solvers[0].name);
  const views = (second < 0 ? [0] : [0, second]).map((chosen, place) => new View(place, chosen));

  const play = document.getElementById('play'), place = document.getElementById('place');
  const placeText = document.getElementById('place-text');
  const pause = 1.5;  // at the end, before it begins again [s]
  place.max = longest;
  place.hidden = placeText.hidden = longest === 1;
  let frame = 0;
  function show() {
    place.value = Math.min(time, longest);
    placeText.value = `${Math.min(Math.ceil(time), longest)} of ${longest}`;
    for (const view of views) view.draw();
  }
  function advance(now) {
    time = Math.max(0, time + Math.min(0.1, (now - before) / 1000));
    if (time > longest + pause) time = 0;
    before = now;
    show();
    frame = requestAnimationFrame(advance);
  }
  function run(on) {
    cancelAnimationFrame(frame);
    playing = on;
    play.textContent = on ? 'Pause' : 'Play';
    before = performance.now();
    if (on) frame = requestAnimationFrame(advance);
    else show();
  }
  function go(to) {
    time = Math.min(Math.max(to, 0), longest);
    run(false);
  }
  play.addEventListener('click', () => run(!playing));
  place.addEventListener('input', () => go(Number(place.value)));
  const keys = { ' ': () => run(!playing), ArrowRight: () => go(Math.floor(time) + 1), ArrowLeft: () => go(Math.ceil(time) - 1) };
  for (const view of views) {
    view.canvas.addEventListener('keydown', event => {
      if (!keys[event.key]) return;
      event.preventDefault();
      keys[event.key]();
    });
    // Both are looked at from the same side.
    view.controls.addEventListener('change', () => {
      for (const other of views) {
        if (other === view) continue;
        other.camera.position.copy(view.camera.position);
        other.camera.quaternion.copy(view.camera.quaternion);
        other.controls.target.copy(view.controls.target);
      }
      if (!playing) show();
    });
  }
  stage.querySelector('.views').append(...views.map(view => view.root));
  stage.querySelector('.note').append(data.which);
  stage.hidden = false;
  addEventListener('resize', show);
  time = Math.min(1, longest);
  run(!still);
})();
