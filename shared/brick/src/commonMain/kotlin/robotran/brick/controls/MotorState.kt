package robotran.brick.controls

/** The output ports; [code] is the ROM's code for the motor. */
enum class MotorPort(val code: Int) { A(0x2000), B(0x2001), C(0x2002) }

/** The command for a motor; [code] is the ROM's number for it. */
enum class MotorMode(val code: Int) { FORWARD(1), BACKWARD(2), BRAKE(3), FLOAT(4) }

/**
 * The command for an output port.
 *
 * @property power 0..7; the port is on in power + 1 of 8 milliseconds.
 */
data class MotorState(val port: MotorPort, val mode: MotorMode, val power: Int)
