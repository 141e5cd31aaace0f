package robotran.robolang.nqc

import robotran.robolang.check.ValueType
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.MotorCommand
import robotran.robolang.syntax.MoveDirection
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.PenPosition
import robotran.robolang.syntax.PowerSide
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.TimeUnit
import robotran.robolang.syntax.TurnDirection

/** Writes the commands to the robot. */
internal class NqcCommands(
    private val expressions: NqcExpressions,
    private val helpers: UsedNqcHelpers,
    private val notes: TranslationNotes,
) {
    private val messages = notes.messages

    fun linesOf(command: Command): List<String> = when (command) {
        is Command.Move -> listOf(move(command))
        is Command.Turn -> listOf(turn(command))
        is Command.StartMoving -> listOf(wheels("LEFT + RIGHT", command.direction == MoveDirection.FORWARD))

        is Command.StartTurning -> {
            val isLeft = command.direction == TurnDirection.LEFT
            listOf(wheels("LEFT", !isLeft), wheels("RIGHT", isLeft))
        }

        is Command.StopDriving -> listOf("Off(${both()});")
        is Command.Power -> listOf("SetPower(${side(command.side)}, ${whole(command.power)});")
        is Command.Motor -> listOf(motor(command))

        is Command.Pen -> {
            val helper = if (command.position == PenPosition.DOWN) NqcHelper.PEN_DOWN else NqcHelper.PEN_UP
            listOf("${helpers.use(helper)}();")
        }

        is Command.Wait -> listOf("Wait(${duration(command.duration, command.unit)});")
        is Command.WaitUntil -> waitUntil(command)
        is Command.ResetTimer -> listOf("ClearTimer(0);")
        is Command.Beep -> listOf("PlaySound(SOUND_CLICK);")
        is Command.Buzz -> listOf("PlaySound(SOUND_LOW_BEEP);")
        is Command.Play -> play(command)
        is Command.Show -> listOf(show(command.value))
        is Command.ShowText -> lost(command, messages.text())

        is Command.ClearScreen -> {
            notes.changed(command.range, messages.clearScreen())
            listOf("SelectDisplay(DISPLAY_WATCH);")
        }

        is Command.MotorTurn, is Command.ResetMotor -> lost(command, messages.otherBrick())
    }

    private fun lost(command: Command, message: String): List<String> {
        notes.lost(command.range, message)
        return emptyList()
    }

    private fun both(): String {
        helpers.use(NqcHelper.WHEELS)
        return "LEFT + RIGHT"
    }

    private fun wheels(wheels: String, isForward: Boolean): String {
        both()
        return if (isForward != helpers.robot.isReversed) "OnFwd($wheels);" else "OnRev($wheels);"
    }

    private fun side(side: PowerSide): String = when (side) {
        PowerSide.BOTH -> both()
        PowerSide.LEFT -> "LEFT".also { both() }
        PowerSide.RIGHT -> "RIGHT".also { both() }
    }

    private fun move(statement: Command.Move): String {
        val isForward = statement.direction == MoveDirection.FORWARD
        return moveOf(
            statement.distance,
            statement.duration,
            if (isForward) NqcHelper.FORWARD else NqcHelper.BACKWARD,
            if (isForward) NqcHelper.BACKWARD else NqcHelper.FORWARD,
            if (isForward) NqcHelper.FORWARD_BY else NqcHelper.BACKWARD_BY,
            NqcHelper.CENTIMETRES,
        )
    }

    private fun turn(statement: Command.Turn): String {
        val isLeft = statement.direction == TurnDirection.LEFT
        return moveOf(
            statement.angle,
            statement.duration,
            if (isLeft) NqcHelper.LEFT_TURN else NqcHelper.RIGHT_TURN,
            if (isLeft) NqcHelper.RIGHT_TURN else NqcHelper.LEFT_TURN,
            if (isLeft) NqcHelper.LEFT_BY else NqcHelper.RIGHT_BY,
            NqcHelper.DEGREES,
        )
    }

    /** A move of a [measure] or a [duration]; a written measure is computed by the compiler, any other by the brick. */
    private fun moveOf(
        measure: Expression?,
        duration: Expression?,
        move: NqcHelper,
        opposite: NqcHelper,
        by: NqcHelper,
        unit: NqcHelper,
    ): String {
        if (measure == null) {
            val time = checkNotNull(duration) { "A move has a measure or a duration." }
            return "${helpers.use(move)}(${duration(time, TimeUnit.SECONDS)});"
        }
        val written = expressions.bare(measure) as? Expression.Number ?: return "${helpers.use(by)}(${whole(measure)});"
        val helper = if (written.value.isNegative) opposite else move
        return "${helpers.use(helper)}(${measureOf(written, unit)});"
    }

    /** `CM(20)`, or `CM(125) / 10` for 12.5. */
    private fun measureOf(number: Expression.Number, unit: NqcHelper): String {
        val figure = if (unit == NqcHelper.CENTIMETRES) {
            helpers.robot.millisecondsPerCentimetre
        } else {
            helpers.robot.millisecondsPerDegree
        }
        if (magnitude(number) * figure > LONGEST_WAIT) notes.lost(number.range, messages.tooLong())
        val name = helpers.use(unit)
        return when (val value = number.value) {
            is NumberValue.Whole -> "$name(${if (value.value < 0) -value.value else value.value})"
            is NumberValue.Decimal -> "$name(${(magnitude(number) * TENTHS + HALF).toInt()}) / 10"
        }
    }

    private fun magnitude(number: Expression.Number): Double =
        number.value.decimal.toDouble().let { if (it < 0) -it else it }

    /** A duration in hundredths of a second. */
    private fun duration(expression: Expression, unit: TimeUnit): String {
        val bare = expressions.bare(expression)
        if (unit == TimeUnit.SECONDS) return expressions.times(bare, NqcExpressions.HUNDREDTHS)
        if (bare !is Expression.Number) return "${expressions.text(bare, TIGHT)} / 10"
        val hundredths = (magnitude(bare) / TENTHS + HALF).toInt()
        if (hundredths > LONGEST_WAIT / TENTHS) notes.lost(bare.range, messages.tooLong())
        return "$hundredths"
    }

    private fun motor(statement: Command.Motor): String {
        val port = "OUT_${statement.port.name}"
        return when (val command = statement.command) {
            MotorCommand.Forward -> "OnFwd($port);"
            MotorCommand.Backward -> "OnRev($port);"
            MotorCommand.Stop -> "Off($port);"
            MotorCommand.Float -> "Float($port);"
            is MotorCommand.Power -> "SetPower($port, ${whole(command.power)});"
        }
    }

    /** [value], rounded if it is a written decimal number. */
    private fun whole(value: Expression): String {
        val bare = expressions.bare(value)
        val isDecimal = bare is Expression.Number && bare.value is NumberValue.Decimal
        return if (isDecimal) expressions.times(bare, 1) else expressions.text(value)
    }

    private fun waitUntil(statement: Command.WaitUntil): List<String> {
        val (condition, calls) = expressions.withCalls { expressions.text(statement.condition) }
        if (calls.isEmpty()) return listOf("until ($condition);")
        return listOf("while (true) {") + calls.map { "    $it" } + listOf("    if ($condition) break;", "}")
    }

    private fun play(statement: Command.Play): List<String> {
        val frequency = whole(statement.frequency)
        val time = expressions.bare(statement.duration)
        if (time !is Expression.Number) {
            // The brick plays only constant times: one tone after the other.
            val rounds = "${expressions.text(time, TIGHT)} * $PARTS_PER_SECOND"
            return listOf("repeat ($rounds) ${helpers.use(NqcHelper.PLAY)}($frequency, $PART);")
        }
        var left = expressions.times(time, NqcExpressions.HUNDREDTHS).toInt()
        val lines = mutableListOf<String>()
        val whole = left / LONGEST_TONE
        if (whole > 1) lines += "repeat ($whole) ${helpers.use(NqcHelper.PLAY)}($frequency, $LONGEST_TONE);"
        if (whole > 1) left -= whole * LONGEST_TONE
        if (left > LONGEST_TONE) {
            lines += "${helpers.use(NqcHelper.PLAY)}($frequency, $LONGEST_TONE);"
            left -= LONGEST_TONE
        }
        if (left > 0) lines += "${helpers.use(NqcHelper.PLAY)}($frequency, $left);"
        return lines
    }

    private fun show(value: Expression): String {
        val bare = expressions.bare(value)
        val show = helpers.use(NqcHelper.SHOW)
        if (bare is Expression.Number && bare.value is NumberValue.Decimal) {
            return "$show(${expressions.times(bare, TENTHS)}, 1);"
        }
        if (bare is Expression.Sense &&
            expressions.typeOf(bare) == ValueType.DECIMAL
        ) {
            showMeasured(bare)?.let { return it }
        }
        return "$show(${expressions.text(value)}, 0);"
    }

    /** Shows the timer in tenths of a second, or the battery in hundredths of a volt. */
    private fun showMeasured(value: Expression.Sense): String? = when (value.sense) {
        Sense.Timer -> "${helpers.use(NqcHelper.SHOW)}(Timer(0), 1);"
        Sense.Battery -> "${helpers.use(NqcHelper.SHOW)}(BatteryLevel() / 10, 2);"
        else -> null
    }

    private companion object {
        /** In milliseconds: 32767 hundredths of a second. */
        const val LONGEST_WAIT = 327_670

        /** In hundredths of a second. */
        const val LONGEST_TONE = 255
        const val PART = 50
        const val PARTS_PER_SECOND = 2
        const val TENTHS = 10
        const val HALF = 0.5

        /** How tightly an operand of a product must bind. */
        const val TIGHT = 10
    }
}
