//! k (Rust): its JacobianIkSolver, as it comes but for the tolerance and the number of steps; from random starts.
use k::nalgebra::{Isometry3, Matrix3, Rotation3, Translation3, UnitQuaternion};
use k::{InverseKinematicsSolver, JacobianIkSolver, SerialChain};
use serde_json::{json, Value};
use std::{io, io::BufRead, time::Instant};

// Returns the version of k, from what Cargo locked.
fn version() -> &'static str {
    let lock = include_str!("../Cargo.lock");
    lock.split("name = \"k\"\nversion = \"").nth(1).and_then(|rest| rest.split('"').next()).unwrap_or("")
}

fn numbers(list: &Value) -> Vec<f64> {
    list.as_array().map_or(vec![], |all| all.iter().map(|x| x.as_f64().unwrap_or(0.0)).collect())
}

struct Arm {
    chain: SerialChain<f64>,
    steps: usize,
}

fn prepare(message: &Value) -> Result<Arm, String> {
    if message["joints"].as_array().unwrap().iter().any(|joint| joint["type"] == "coupled") {
        return Err("coupled joints".into());
    }
    let urdf = urdf_rs::read_from_string(message["urdf"].as_str().unwrap()).map_err(|error| error.to_string())?;
    let tree: k::Chain<f64> = (&urdf).into();
    let tip = tree.find_link(message["tip_link"].as_str().unwrap()).ok_or("no tip")?.clone();
    let base = tree.find_link(message["base_link"].as_str().unwrap()).ok_or("no base")?.clone();
    let chain = SerialChain::from_end_to_root(&tip, &base);
    Ok(Arm { chain, steps: message["options"]["steps"].as_f64().unwrap() as usize })
}

fn solve(arm: &Arm, problem: &Value) -> Vec<f64> {
    let began = Instant::now();
    let place = numbers(&problem["target"]["position"]);
    let turn = Rotation3::from_matrix_unchecked(Matrix3::from_row_slice(&numbers(&problem["target"]["rotation"])));
    let target = Isometry3::from_parts(
        Translation3::new(place[0], place[1], place[2]),
        UnitQuaternion::from_rotation_matrix(&turn),
    );
    let near = |key: &str| problem["tolerance"][key].as_f64().unwrap();
    let solver = JacobianIkSolver::new(near("position"), near("rotation"), 0.5, arm.steps);
    let (lower, upper) = (numbers(&problem["lower"]), numbers(&problem["upper"]));
    let mut start = numbers(&problem["start"]);
    let mut state = problem["seed"].as_u64().unwrap_or(0).wrapping_add(0x9E37_79B9_7F4A_7C15);
    while began.elapsed().as_secs_f64() < problem["budget"]["seconds"].as_f64().unwrap() {
        if arm.chain.set_joint_positions(&start).is_ok() && solver.solve(&arm.chain, &target).is_ok() {
            break;
        }
        for (q, (low, high)) in start.iter_mut().zip(lower.iter().zip(&upper)) {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407); // Knuth's
            *q = low + (high - low) * (state >> 11) as f64 / (1u64 << 53) as f64;
        }
    }
    arm.chain.joint_positions()
}

// In a warm study it solves twice, and the second counts.
fn answer(arm: &Arm, message: &Value) -> Value {
    let first = (message["state"] == "warm").then(|| solve(arm, message));
    let began = Instant::now();
    let q = solve(arm, message);
    let seconds = began.elapsed().as_secs_f64();
    let mut answer = json!({"message": "solved", "q": q, "seconds": seconds, "seed": message["seed"]});
    if let Some(first) = first {
        answer["timed"] = json!("second");
        answer["same"] = json!(first == q);
    }
    answer
}

fn main() {
    println!("{}", json!({"message": "hello", "ikbench": 2, "name": "k", "version": version(), "goals": ["pose"], "options": [
        {"name": "steps", "type": "integer", "default": 60, "low": 1, "high": 100000, "meaning": "steps before the next start"}]}));
    let mut arm = Err(String::new());
    for line in io::stdin().lock().lines() {
        let message: Value = serde_json::from_str(&line.unwrap()).unwrap();
        if message["message"] == "robot" {
            arm = prepare(&message);
            continue;
        }
        println!("{}", match &arm {
            Ok(arm) => answer(arm, &message),
            Err(why) => json!({"message": "declined", "why": why}),
        });
    }
}
