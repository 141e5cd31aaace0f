package robotran.rcxrom.routines

import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.memory.Registers
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.sensors.SensorCode
import robotran.rcxrom.sensors.Sensors
import robotran.rcxrom.sound.Sound

/** The routines for the timer that drives motors, sounds and sensors. */
internal class TimerRoutines(private val hardware: Hardware, private val messages: BrickMessages) {
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

    private fun controlOutput(arguments: List<Int>): RomEffect = when (val code = arguments[0]) {
        RomCode.OUTPUT_SENSORS -> setSensors(arguments[1], active = true)
        RomCode.OUTPUT_SOUND -> play(arguments, hardware.sounds::queue)
        RomCode.OUTPUT_SOUND_NOW -> play(arguments, hardware.sounds::playNow)
        else -> refused(messages.unknownCode(code))
    }

    private fun clearOutput(arguments: List<Int>): RomEffect = when (val code = arguments[0]) {
        RomCode.OUTPUT_SENSORS -> clearSensors(arguments)
        RomCode.OUTPUT_MINUTE_TIMER -> resetMinuteTimer()
        else -> refused(messages.unknownCode(code))
    }

    private fun clearSensors(arguments: List<Int>): RomEffect = if (arguments.size < 2) {
        tooFew("clear output", needed = 2, arguments)
    } else {
        setSensors(arguments[1], active = false)
    }

    private fun setSensors(bits: Int, active: Boolean): RomEffect {
        hardware.sensors.setActive(bits, active)
        return RomEffect(
            messages.sensorPowers(
                (0..<SensorCode.PORTS).filter { bits and Sensors.portBit(it) != 0 }.map {
                    it +
                        1
                },
                active,
            ),
        )
    }

    private fun play(arguments: List<Int>, play: (Sound) -> RomEffect): RomEffect {
        if (arguments.size < SOUND_ARGUMENTS) return tooFew("control output", SOUND_ARGUMENTS, arguments)
        val (kind, value, control) = arguments.drop(1).map { it and BYTE }
        return play(if (kind == Sound.SYSTEM_SOUND) Sound.system(value) else Sound(kind, value, control))
    }

    private fun tooFew(routine: String, needed: Int, arguments: List<Int>) =
        refused(messages.tooFewArguments(routine, needed, arguments.size))

    private companion object {
        const val SOUND_ARGUMENTS = 4
        const val BYTE = 0xFF
    }
}
