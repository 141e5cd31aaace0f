package robotran.brick.controls

/** The output ports of all bricks; [robotran.brick.kind.BrickKind.motorPorts] says which one has. */
enum class MotorPort { A, B, C, D, E, F }

/** The command for a motor; [code] is the number for it in the RCX's ROM and in leJOS NXJ. */
enum class MotorMode(val code: Int) { FORWARD(1), BACKWARD(2), BRAKE(3), FLOAT(4) }

/**
 * The command for an output port.
 *
 * @property power in the [PowerUnit] of the brick.
 * @property brakesInPauses whether the port brakes, rather than floats, while pulse-width modulation switches it off; an
 * RCX always floats.
 */
data class MotorState(val port: MotorPort, val mode: MotorMode, val power: Int, val brakesInPauses: Boolean = false)
