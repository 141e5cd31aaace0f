package robotran.rom

/** The routines of the timer that drives motors, sounds and sensors. */
internal class TimerRoutines(
    private val hardware: Hardware,
    private val messages: BrickMessages,
) {
    val routines: Map<Int, RomRoutine> = mapOf(
        RomAddress.INIT_TIMER to ::init,
        RomAddress.SHUTDOWN_TIMER to { shutdown() },
        RomAddress.RESET_MINUTE_TIMER to { resetMinuteTimer() },
        RomAddress.CONTROL_OUTPUT to ::controlOutput,
        RomAddress.CLEAR_OUTPUT to ::clearOutput,
    )

    private fun init(arguments: List<Int>): RomEffect {
        val (timers, flags) = arguments
        hardware.motors.shutdown()
        hardware.sensors.setActive(SensorCode.ALL_PORT_BITS, active = false)
        hardware.speaker.silence()
        hardware.timers.begin(timers, flags)
        hardware.memory.setBits(Registers.PORT_6_DIRECTIONS, Registers.SPEAKER_PIN, on = true)
        hardware.timerRuns = true
        return RomEffect(messages.startTimer())
    }

    private fun shutdown(): RomEffect {
        hardware.motors.shutdown()
        hardware.speaker.silence()
        hardware.memory.setBits(Registers.PORT_6_DIRECTIONS, Registers.SPEAKER_PIN, on = false)
        hardware.timerRuns = false
        return RomEffect(messages.stopTimer())
    }

    private fun resetMinuteTimer(): RomEffect {
        hardware.timers.resetMinute()
        return RomEffect(messages.resetMinuteTimer())
    }

    private fun controlOutput(arguments: List<Int>): RomEffect {
        val (code, first) = arguments
        return when (code) {
            RomCode.OUTPUT_SENSORS -> setSensors(first, active = true)

            RomCode.OUTPUT_SOUND -> hardware.sounds.queue(sound(arguments) ?: return tooFew("control output", ALL_ARGUMENTS, arguments))

            RomCode.OUTPUT_SOUND_NOW -> hardware.sounds.playNow(sound(arguments) ?: return tooFew("control output", ALL_ARGUMENTS, arguments))

            else -> refused(messages.unknownCode(code))
        }
    }

    private fun clearOutput(arguments: List<Int>): RomEffect = when (val code = arguments[0]) {
        RomCode.OUTPUT_SENSORS -> setSensors(arguments.getOrNull(1) ?: return tooFew("clear output", needed = 2, arguments), active = false)
        RomCode.OUTPUT_MINUTE_TIMER -> resetMinuteTimer()
        else -> refused(messages.unknownCode(code))
    }

    private fun setSensors(bits: Int, active: Boolean): RomEffect {
        hardware.sensors.setActive(bits, active)
        return RomEffect(messages.sensorPowers((0..<SensorCode.PORTS).filter { bits and Sensors.portBit(it) != 0 }.map { it + 1 }, active))
    }

    private fun sound(arguments: List<Int>): Sound? {
        if (arguments.size < ALL_ARGUMENTS) return null
        val (kind, value, control) = arguments.drop(1).map { it and BYTE }
        return if (kind == Sound.SYSTEM_SOUND) Sound.system(value) else Sound(kind, value, control)
    }

    private fun tooFew(routine: String, needed: Int, arguments: List<Int>) =
        refused(messages.tooFewArguments(routine, needed, arguments.size))

    private companion object {
        const val ALL_ARGUMENTS = 4
        const val BYTE = 0xFF
    }
}
