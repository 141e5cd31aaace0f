package robotran.rom

/** The routine of the output ports. */
internal class MotorRoutines(private val motors: Motors) {
    val routines: Map<Int, RomRoutine> = mapOf(RomAddress.CONTROL_MOTOR to ::control)

    private fun control(arguments: List<Int>): RomEffect {
        val (code, modeCode, powerWord) = arguments
        val port = MotorPort.entries.find { it.code == code } ?: return unknownCode(code)
        val mode = MotorMode.entries.find { it.code == modeCode }
        val power = powerWord % POWERS
        motors.control(port, mode, power)
        val remark = buildString {
            if (mode == null) append(", mode ${modeCode.toShort()} is ignored")
            if (powerWord != power) append(", power ${powerWord.toShort()} counts as $power")
        }
        return RomEffect("motor ${port.name} ${motors.states[port.ordinal].mode.name.lowercase()} $power$remark")
    }

    private companion object {
        const val POWERS = 8
    }
}
