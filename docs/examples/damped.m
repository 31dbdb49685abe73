% A solver for ikbench in Octave: damped least squares, with its own kinematics. It solves for positions, on arms whose
% joints are revolute. The line of its entry in a study:
% process = ["octave-cli", "--quiet", "damped.m"]
1;

function say(message)
  puts([jsonencode(message) "\n"]);
  fflush(stdout);
end

function [tool, jacobian] = forward(arm, q)
  pose = reshape(arm.base, 4, 4)';
  n = numel(arm.joints);
  axes = zeros(3, n); origins = zeros(3, n);
  for j = 1:n
    joint = arm.joints(j);
    axes(:, j) = pose(1:3, 3); origins(:, j) = pose(1:3, 4);
    t = joint.theta + q(j); ca = cos(joint.alpha); sa = sin(joint.alpha);
    pose = pose * [cos(t) -sin(t)*ca sin(t)*sa joint.a*cos(t); sin(t) cos(t)*ca -cos(t)*sa joint.a*sin(t);
                   0 sa ca joint.d; 0 0 0 1];
  end
  pose = pose * reshape(arm.tool, 4, 4)';
  tool = pose(1:3, 4);
  jacobian = cross(axes, tool - origins);
end

function solve(arm, problem)
  began = tic;
  q = problem.start(:); most = problem.budget.iterations;
  if problem.budget.evaluations > 0, most = min(most, problem.budget.evaluations - 1); end
  for i = 0:most
    [tool, jacobian] = forward(arm, q);
    off = problem.target.position(:) - tool;
    late = problem.budget.seconds > 0 && toc(began) >= problem.budget.seconds;
    if late || norm(off) <= problem.tolerance.position || i == most, break; end
    move = jacobian' * ((jacobian * jacobian' + 1e-4 * eye(3)) \ off);
    q += move * min(1, 0.2 / max(abs(move)));
    q = min(max(q, problem.lower(:)), problem.upper(:));
  end
  say(struct("message", "solved", "q", {q'}, "error", norm(off), "iterations", i, "evaluations", i + 1));
end

say(struct("message", "hello", "ikbench", 2, "name", "octave_damped", "version", "2.0"));
while ischar(line = input("", "s"))  % fgetl waits for the line after
  told = jsondecode(line);
  if strcmp(told.message, "robot"), arm = told; continue; end
  if strcmp(arm.goal, "position") && all(strcmp({arm.joints.type}, "revolute")), solve(arm, told);
  else, say(struct("message", "declined", "why", "only positions of revolute joints are supported")); end
end
