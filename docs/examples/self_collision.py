"""A study's [check] that refuses answers with which links of the arm touch each other, and gives the smallest distance of
two links. pinocchio and coal (pip install pin) compute it from the collision geometry of the arm's URDF file. Packages are
looked for in the folders of ROS_PACKAGE_PATH. The argument is the arm's SRDF file, as MoveIt has it; it lists the links
that may touch."""
import os, sys

import ikbench, pinocchio


def prepare(robot):
    robot.require(bounded=True)
    model = pinocchio.buildModelFromUrdf(robot.file)
    geometry = pinocchio.buildGeomFromUrdf(model, robot.file, pinocchio.COLLISION, None,
                                           os.environ.get("ROS_PACKAGE_PATH", ".").split(":"))
    geometry.addAllCollisionPairs()
    pinocchio.removeCollisionPairs(model, geometry, sys.argv[1])
    places = [model.joints[model.getJointId(name)].idx_q for name in robot.names]
    return model, model.createData(), geometry, geometry.createData(), places


def self_collision(arm, answer):
    model, data, geometry, distances, places = arm
    q = pinocchio.neutral(model)  # a gripper's joints stay there
    q[places] = answer.q
    pinocchio.computeDistances(model, data, geometry, distances, q)
    clearance = 1000 * min(result.min_distance for result in distances.distanceResults)
    return clearance > 0 or "self-collision", {"clearance_mm": clearance}


ikbench.check(self_collision, prepare, version=pinocchio.__version__)
