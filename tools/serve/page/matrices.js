// SPDX-License-Identifier: Apache-2.0
// The matrices of the viewing model, from the numbers of a view: the steps, names and equations of seed document 003, as
// src/view/projection/matrices.cpp has them. A matrix is a list of 16 numbers, row by row; column vectors: p'=M p.

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = a => {
  const length = Math.sqrt(dot(a, a));
  return a.map(x => x / length);
};

const product = (a, b) => {
  const result = [];
  for (let row = 0; row < 4; ++row)
    for (let column = 0; column < 4; ++column) {
      let sum = 0;
      for (let k = 0; k < 4; ++k) sum += a[4 * row + k] * b[4 * k + column];
      result.push(sum);
    }
  return result;
};

// VOM (3.36): world to view reference coordinates.
const viewOrientation = ({VRP, VPN, VUP}) => {
  const u = unit(cross(VUP, VPN)), n = unit(VPN), v = cross(n, u);
  const row = axis => [...axis, -dot(axis, VRP)];
  return [...row(u), ...row(v), ...row(n), 0, 0, 0, 1];
};

// (3.48), which (3.58) uses, too.
const normalisation = (view, dr, ds, [sx, sy, sz]) => {
  const [left, low, right, high] = view.window, {PRP, VPD, B} = view;
  const dop = [PRP[0] - (left + right) / 2, PRP[1] - (low + high) / 2, PRP[2] - VPD];
  const shu = -dop[0] / dop[2], shv = -dop[1] / dop[2];
  return [sx, 0, sx * shu, -sx * (B * shu + dr), 0, sy, sy * shv, -sy * (B * shv + ds), 0, 0, sz, -sz * B, 0, 0, 0, 1];
};

// N_par (3.48): view volume to unit cube.
const nPar = view => {
  const [left, low, right, high] = view.window, {PRP, VPD, F, B} = view;
  const dop = [PRP[0] - (left + right) / 2, PRP[1] - (low + high) / 2, PRP[2] - VPD];
  const dr = left - (VPD - B) * dop[0] / dop[2], ds = low - (VPD - B) * dop[1] / dop[2];
  return normalisation(view, dr, ds, [1 / (right - left), 1 / (high - low), 1 / (F - B)]);
};

// N_per (3.58): view volume to unit pyramid.
const nPer = view => {
  const [left, low, right, high] = view.window, {PRP, VPD, B} = view;
  const height = PRP[2] - B, grown = height / (PRP[2] - VPD), toPlane = VPD - PRP[2];
  const dr = (-height * left + PRP[0] * (VPD - B)) / toPlane, ds = (-height * low + PRP[1] * (VPD - B)) / toPlane;
  return normalisation(view, dr, ds, [1 / ((right - left) * grown), 1 / ((high - low) * grown), 1 / height]);
};

const planeInNpc = ({PRP, VPD, B}) => (VPD - B) / (PRP[2] - B);

// M_per (3.60): onto the view plane, in normalised coordinates.
const mPer = view => {
  const dt = planeInNpc(view);
  return [dt - 1, 0, 0.5, -dt / 2, 0, dt - 1, 0.5, -dt / 2, 0, 0, dt, -dt, 0, 0, 1, -1];
};

// M_wv (3.63): window in normalised coordinates to viewport.
const windowToViewport = view => {
  const dt = view.central ? planeInNpc(view) : 0, from = [dt / 2, dt / 2, 1 - dt / 2, 1 - dt / 2];
  const [left, low, right, high] = view.viewport;
  const sx = (right - left) / (from[2] - from[0]), sy = (high - low) / (from[3] - from[1]);
  return [sx, 0, 0, left - from[0] * sx, 0, sy, 0, low - from[1] * sy, 0, 0, 1, 0, 0, 0, 0, 1];
};

const stepsOf = view => [
  ['VOM', viewOrientation(view)],
  ...(view.central ? [['N_per', nPer(view)], ['M_per', mPer(view)]] : [['N_par', nPar(view)]]),
  ['M_wv', windowToViewport(view)],
];

const productOf = steps => steps.reduce((all, [, matrix]) => all ? product(matrix, all) : matrix, null);
