package robotran.robolang.python.pybricks

import robotran.robolang.check.ValueType
import robotran.robolang.python.writer.PythonContext
import robotran.robolang.python.writer.pythonString
import robotran.robolang.robot.HubFigures
import robotran.robolang.robot.RobotTarget
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.PenPosition
import robotran.robolang.syntax.TimeUnit

/** Writes the commands to the robot; in a task each that takes time is awaited. */
internal class PybricksCommands(
    private val robot: RobotTarget.Hub,
    context: PythonContext,
    private val awaiting: PybricksAwaiting,
    private val devices: PybricksDevices,
    private val speeds: PybricksSpeeds,
) {
    private val expressions by lazy(LazyThreadSafetyMode.NONE) { context.expressions }
    private val uses = context.uses
    private val notes = context.notes
    private val hub = robot.model
    private val messages = notes.messages
    private val motors = PybricksMotors(robot, context, awaiting, devices, speeds)
    private val numbers = PybricksNumbers(context)

    /** The figures at the top of a program. */
    val constants: List<String> get() = motors.constants

    /** The names of those, and of the variables with speeds. */
    val names: Set<String> get() = motors.names

    /** Whether the wheels may turn when the program ends. */
    val mayTurnAtEnd: Boolean get() = speeds.mayTurnAtEnd

    /** Stops the wheels. */
    fun stop(): List<String> = motors.stop()

    fun linesOf(command: Command): List<String> = when (command) {
        is Command.Move -> move(command)
        is Command.Turn -> turn(command)
        is Command.StartMoving -> motors.start(command, ahead = signOf(command.direction), turn = 0)
        is Command.StartTurning -> motors.start(command, ahead = 0, turn = signOf(command.direction))
        is Command.StopDriving -> motors.stop()
        is Command.Power -> motors.power(command)
        is Command.Motor -> motors.command(command)
        is Command.MotorTurn -> motors.turn(command)
        is Command.ResetMotor -> motors.reset(command)
        is Command.Pen -> pen(command)
        is Command.Wait -> listOf(wait(numbers.milliseconds(command.duration, command.unit)))
        is Command.WaitUntil -> waitUntil(command)
        is Command.ResetTimer -> listOf("${devices.timer()}.reset()")
        is Command.Beep -> sound(command, "", "${HubFigures.BEEP_MILLISECONDS}")
        is Command.Buzz -> sound(command, "$BUZZ", "${HubFigures.BUZZ_MILLISECONDS}")
        is Command.Play -> play(command)
        is Command.Show -> show(command)
        is Command.ShowText -> showText(command)
        is Command.ClearScreen -> clearScreen(command)
    }

    /** `wait(500)`, also in a task. */
    fun wait(milliseconds: String): String = waiting("${uses.tool("wait")}($milliseconds)")

    private fun waiting(call: String): String = awaiting.waiting(call).text

    private fun move(command: Command.Move): List<String> {
        val sign = signOf(command.direction)
        val distance =
            command.distance ?: return motors.forTime(command, ahead = sign, turn = 0, time(command.duration))
        notes.tell(command.range, messages.wheelDegrees())
        val millimetres = numbers.times(distance, sign * HubFigures.MILLIMETRES_PER_CENTIMETRE)
        return motors.remembered(command) + waiting("${devices.base()}.straight($millimetres)")
    }

    private fun turn(command: Command.Turn): List<String> {
        val sign = signOf(command.direction)
        val angle = command.angle ?: return motors.forTime(command, ahead = 0, turn = sign, time(command.duration))
        notes.tell(command.range, messages.wheelDegrees())
        val fraction = (expressions.literal(angle) as? NumberValue.Decimal)?.decimal
        if (fraction != null && fraction != fraction.toInt().toFloat()) {
            notes.tell(angle.range, messages.wholeDegrees())
        }
        return motors.remembered(command) + waiting("${devices.base()}.turn(${numbers.times(angle, sign)})")
    }

    private fun time(duration: Expression?): String {
        val time = checkNotNull(duration) { "A move has a measure or a duration." }
        return wait(numbers.milliseconds(time, TimeUnit.SECONDS))
    }

    private fun pen(command: Command.Pen): List<String> {
        val pen = robot.pen
        if (pen == null) {
            notes.tell(command.range, messages.noPen())
            return emptyList()
        }
        devices.pen(pen)
        val helper = if (command.position == PenPosition.DOWN) PybricksHelper.PEN_DOWN else PybricksHelper.PEN_UP
        return listOf(waiting("${uses.use(helper)}()"))
    }

    private fun waitUntil(command: Command.WaitUntil): List<String> = listOf(
        "while ${expressions.opposite(command.condition)}:",
        "    ${wait("$PAUSE")}",
    )

    /** A tone; without a [hertz] the usual one. */
    private fun sound(command: Command, hertz: String, milliseconds: String): List<String> {
        if (!hub.hasSpeaker) {
            notes.tell(command.range, messages.noSpeaker())
            devices.hub()
            return listOf(waiting("${uses.use(PybricksHelper.BLINK)}($milliseconds)"))
        }
        val arguments = if (hertz.isEmpty()) "" else "$hertz, $milliseconds"
        return listOf(waiting("${devices.hub()}.speaker.beep($arguments)"))
    }

    private fun play(command: Command.Play): List<String> {
        val time = numbers.milliseconds(command.duration, TimeUnit.SECONDS)
        return sound(command, numbers.whole(command.frequency), time)
    }

    private fun show(command: Command.Show): List<String> {
        val value = expressions.text(command.value)
        if (expressions.typeOf(command.value) == ValueType.COLOUR ||
            !hasDisplay(command)
        ) {
            return listOf("print($value)")
        }
        if (hub.hasMatrix && !isShort(command.value)) notes.tell(command.range, messages.smallDisplay())
        devices.hub()
        return listOf("${uses.use(PybricksHelper.SHOW)}($value)")
    }

    private fun hasDisplay(command: Command): Boolean {
        if (!hub.hasMatrix && !hub.hasScreen) notes.tell(command.range, messages.noDisplay())
        return hub.hasMatrix || hub.hasScreen
    }

    private fun isShort(value: Expression): Boolean =
        (expressions.known(value) as? NumberValue.Whole)?.value in -LARGEST_SHOWN..LARGEST_SHOWN

    private fun showText(command: Command.ShowText): List<String> {
        val text = pythonString(command.text)
        val printed = "print($text)"
        if (!hasDisplay(command)) return listOf(printed)
        val display = devices.hub()
        return when {
            hub.hasScreen -> listOf(printed, "$display.screen.print($text)")
            command.text.length == 1 -> listOf(printed, "$display.display.char($text)")

            else -> {
                notes.tell(command.range, messages.oneLetterAtATime())
                listOf(printed, waiting("$display.display.text($text)"))
            }
        }
    }

    private fun clearScreen(command: Command): List<String> = when {
        hub.hasMatrix -> listOf("${devices.hub()}.display.off()")
        hub.hasScreen -> listOf("${devices.hub()}.screen.clear()")

        else -> {
            notes.tell(command.range, messages.noDisplay())
            emptyList()
        }
    }

    companion object {
        /** How long a loop that does nothing else waits, in milliseconds. */
        const val PAUSE = 10
        private const val BUZZ = HubFigures.BUZZ_HERTZ

        /** Two digits have room on the display. */
        private const val LARGEST_SHOWN = 99
    }
}
