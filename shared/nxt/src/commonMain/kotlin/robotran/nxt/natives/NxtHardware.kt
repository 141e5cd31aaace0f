package robotran.nxt.natives

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorState
import robotran.brick.log.CallLog
import robotran.brick.log.CallOutcome
import robotran.nxt.bluetooth.BluetoothNetwork
import robotran.nxt.hardware.Battery
import robotran.nxt.hardware.Buttons
import robotran.nxt.hardware.Clock
import robotran.nxt.hardware.MotorPorts
import robotran.nxt.hardware.SensorPort
import robotran.nxt.log.CallOrigin
import robotran.nxt.log.NxtLogEntry
import robotran.nxt.messages.NxtMessages
import robotran.nxt.program.NxtCall
import robotran.nxt.regulator.MotorRegulator
import robotran.nxt.regulator.RegulatedMotor
import robotran.nxt.sound.NxtSpeaker
import robotran.nxt.storage.FlashMemory
import robotran.nxt.storage.NxtFile

/** The parts of a brick, without an active shell. */
internal class NxtHardware(
    network: BluetoothNetwork,
    name: String,
    private val messages: NxtMessages,
    files: List<NxtFile> = emptyList(),
) {
    /** Virtual time, which passes only in [tick]. */
    var milliseconds = 0L
        private set

    private val clock = Clock { milliseconds }
    val motors = MotorPorts()
    val sensors = List(SensorPort.PORTS) { SensorPort(it + 1, clock) }
    val buttons = Buttons()
    val battery = Battery()
    val display = DisplayPart(clock)
    val speaker = NxtSpeaker(clock, display::drawn)
    val radio = network.join(name, clock)
    val flash = FlashMemory(files)
    val log = CallLog()
    val expectations = NxtExpectations()
    private val loggedMotors = List(MotorPorts.PORTS) { LoggedMotor(it) }
    val regulators = loggedMotors.map { MotorRegulator(it) }

    /** Whether a program has switched the brick off; the shell does it. */
    var isToShutDown = false

    /** Called when ENTER and ESCAPE are pressed together. */
    var onStopRequest: (() -> Unit)? = null

    private var owedSteps = 0
    private var regulatorsAreHeard = true

    /** Advances time by one millisecond. */
    fun tick() {
        milliseconds++
        if (milliseconds % MotorPorts.EXCHANGE_MILLISECONDS == 0L) motors.exchange()
        val isSample = milliseconds % SensorPort.SAMPLE_MILLISECONDS == 0L
        for (port in sensors.indices) {
            if (isSample) sensors[port].sample()
            sensors[port].i2c.tick()
        }
        if (milliseconds % Buttons.LOOK_MILLISECONDS == 0L) buttons.look()
        speaker.tick()
        display.tick()
        radio.tick()
        if (milliseconds % MotorRegulator.PERIOD == 0L) regulate()
    }

    private fun regulate() {
        for (regulator in regulators) {
            if (regulator.isActive) owedSteps += REGULATOR_STEPS
            regulator.tick()
        }
    }

    /** How many of [steps] in a millisecond are left to the program, since the regulators take their share. */
    fun stepsLeft(steps: Int): Int {
        val taken = minOf(steps, owedSteps)
        owedSteps -= taken
        return steps - taken
    }

    /** Does what a call says. What a regulator does to its motor meanwhile is part of that call. */
    fun withoutRegulatorsInLog(call: () -> Int?): Int? {
        regulatorsAreHeard = false
        return call().also { regulatorsAreHeard = true }
    }

    /** Whether a motor is driven: by its regulator's move, or without regulation. */
    val isDriving: Boolean
        get() = regulators.indices.any { port ->
            val mode = motors.commanded(port).mode
            if (regulators[port].isActive) regulators[port].isDriving else mode in DRIVING
        }

    /** Makes everything but the display as a program finds it when it starts; motors roll. */
    fun reset(tellMotor: (port: Int) -> Unit) {
        for (port in 0..<MotorPorts.PORTS) {
            regulators[port].reset()
            loggedMotors[port].forget()
            if (motors.commanded(port).mode != MotorMode.FLOAT) tellMotor(port)
            motors.control(port, 0, brakes = false)
            motors.resetTachoCount(port)
        }
        for (port in sensors) port.reset()
        speaker.stop()
        radio.reset()
        onStopRequest = null
        isToShutDown = false
        owedSteps = 0
    }

    fun record(call: NxtCall, result: Int?, origin: CallOrigin, sourceLine: Int = 0, sourceFile: String? = null) {
        val outcome = if (result == null) CallOutcome.WRONG_ARGUMENTS else CallOutcome.DONE
        log.add(NxtLogEntry(milliseconds, call, result ?: 0, outcome, origin, sourceLine, sourceFile, messages))
    }

    /** A motor whose regulator is heard in the log when it does something else than before, or with other power. */
    private inner class LoggedMotor(private val port: Int) : RegulatedMotor {
        private var command: MotorState? = null

        override val tachoCount: Int get() = motors.tachoCount(port)

        override fun control(power: Int, brakes: Boolean) {
            val before = motors.commanded(port)
            motors.control(port, power, brakes)
            val now = motors.commanded(port)
            if (now === before || !isNews(now)) return
            command = now
            if (regulatorsAreHeard) record(NxtCall.controlMotor(port, power, brakes), 0, CallOrigin.LIBRARY)
        }

        /** Tells the next command in any case. */
        fun forget() {
            command = null
        }

        private fun isNews(now: MotorState): Boolean {
            val last = command ?: return true
            val change = now.power - last.power
            return now.mode != last.mode || change >= NEWS || change <= -NEWS
        }
    }

    private companion object {
        /** 340 byte codes, of which a step is ten: what leJOS NXJ needs for one motor every four milliseconds. */
        const val REGULATOR_STEPS = 34

        val DRIVING = setOf(MotorMode.FORWARD, MotorMode.BACKWARD)

        /** A change of a regulator's power that the log tells. */
        const val NEWS = 10
    }
}
