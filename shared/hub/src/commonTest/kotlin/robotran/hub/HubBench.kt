package robotran.hub

import robotran.brick.controls.MotorPort
import robotran.brick.program.BrickProgram
import robotran.hub.messages.HubMessages
import robotran.hub.model.HubDeviceKind
import robotran.hub.model.HubModel
import robotran.hub.model.HubMotorKind
import robotran.hub.model.HubPort
import robotran.hub.program.HubCall
import robotran.hub.program.HubError
import robotran.hub.program.HubNative
import robotran.language.Language

/** The line of calls that a test makes. */
internal const val TEST_LINE = 7

/** A SPIKE Prime on a bench, with medium motors that turn nothing, at first on all ports but the last. */
internal class HubBench(
    model: HubModel = HubModel.SPIKE_PRIME,
    kind: HubMotorKind = model.motor,
    programs: List<BrickProgram?> = emptyList(),
) {
    val brick = HubBrick(model, programs, HubMessages.of(Language.ENGLISH))
    private val motors = model.motorPorts.dropLast(if (model.motorPorts.size > 2) 1 else 0).mapNotNull { it.motorPort }
        .associateWith { TestMotor(it) }.toMutableMap()

    init {
        for (port in motors.keys) brick.plugMotor(port, kind)
    }

    val hub get() = brick.hub
    val base get() = checkNotNull(hub.driveBase)
    val milliseconds: Long get() = brick.state.milliseconds

    /** Puts a motor that runs between stops on [port]. */
    fun stops(port: MotorPort, lower: Double, upper: Double) {
        motors[port] = TestMotor(port, lower, upper)
    }

    fun motor(port: HubPort) = checkNotNull(hub.motor(port))

    fun wait(milliseconds: Int) = repeat(milliseconds) {
        for (motor in motors.values) motor.tick(brick)
        brick.tick()
    }

    fun call(native: HubNative, vararg numbers: Int): HubError? = hub.call(HubCall.of(native, *numbers), TEST_LINE)

    fun call(native: HubNative, text: String): HubError? = hub.call(HubCall.of(native, text), TEST_LINE)

    fun on(native: HubNative, port: HubPort, vararg numbers: Int): HubError? =
        hub.call(HubCall.on(native, port, *numbers), TEST_LINE)

    fun make(port: HubPort, isReversed: Boolean = false): HubError? =
        hub.call(HubCall.device(HubDeviceKind.MOTOR, port, isReversed), TEST_LINE)

    /** Makes the usual driving base of motors A and B. */
    fun makeBase(wheel: Int = 56_000, track: Int = 112_000) {
        make(HubPort.A, isReversed = true)
        make(HubPort.B)
        hub.call(HubCall.driveBase(HubPort.A, HubPort.B, wheel, track), TEST_LINE)
    }

    /** Waits until [isDone] and returns how long that took, milliseconds. */
    fun until(longest: Int = 20_000, isDone: () -> Boolean): Int {
        val begin = milliseconds
        while (!isDone() && milliseconds < begin + longest) wait(1)
        return (milliseconds - begin).toInt()
    }
}

/** The numbers of a line that Pybricks printed, without those of its first [words]. */
internal fun numbersOf(line: String, words: Int = 0): List<Double> {
    val rest = line.split(' ').drop(words).joinToString(" ")
    return Regex("-?[0-9]+(\\.[0-9]+)?").findAll(rest).map { it.value.toDouble() }.toList()
}

/** The lines that Pybricks' own virtual hub printed, of the program with this number. */
internal fun recorded(name: String): List<String> =
    recordedRuns.getValue("$name.txt").lines().filter { it.isNotBlank() }
