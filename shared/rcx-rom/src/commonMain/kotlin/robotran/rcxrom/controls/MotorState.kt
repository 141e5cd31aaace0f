package robotran.rcxrom.controls

/** The output ports; [code] is the number the ROM knows the motor by. */
enum class MotorPort(val code: Int) { A(0x2000), B(0x2001), C(0x2002) }

/** What a motor is told to do; [code] is the ROM's number for it. */
enum class MotorMode(val code: Int) { FORWARD(1), BACKWARD(2), BRAKE(3), FLOAT(4) }

/**
 * What an output port is told to do.
 *
 * @property power 0..7; the port is switched on in power + 1 of 8 milliseconds.
 */
data class MotorState(val port: MotorPort, val mode: MotorMode, val power: Int)
