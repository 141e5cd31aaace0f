package robotran.robolang.nqc

import robotran.robolang.check.ValueType
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.MotorCommand
import robotran.robolang.syntax.MoveDirection
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.PenPosition
import robotran.robolang.syntax.PowerSide
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.TimeUnit
import robotran.robolang.syntax.TurnDirection

/** Writes the commands to the robot. */
internal class NqcCommands(
    private val expressions: NqcExpressions,
    private val helpers: UsedNqcHelpers,
    private val remarks: Remarks,
) {
    private val messages = remarks.messages

    fun linesOf(statement: Statement): List<String> = when (statement) {
        is Statement.Move -> listOf(move(statement))
        is Statement.Turn -> listOf(turn(statement))
        is Statement.StartMoving -> listOf(wheels("LEFT + RIGHT", statement.direction == MoveDirection.FORWARD))

        is Statement.StartTurning -> {
            val isLeft = statement.direction == TurnDirection.LEFT
            listOf(wheels("LEFT", !isLeft), wheels("RIGHT", isLeft))
        }

        is Statement.StopDriving -> listOf("Off(${both()});")
        is Statement.Power -> listOf("SetPower(${side(statement.side)}, ${whole(statement.power)});")
        is Statement.Motor -> listOf(motor(statement))

        is Statement.Pen -> {
            val helper = if (statement.position == PenPosition.DOWN) NqcHelper.PEN_DOWN else NqcHelper.PEN_UP
            listOf("${helpers.use(helper)}();")
        }

        is Statement.Wait -> listOf("Wait(${duration(statement.duration, statement.unit)});")
        is Statement.WaitUntil -> waitUntil(statement)
        is Statement.ResetTimer -> listOf("ClearTimer(0);")
        is Statement.Beep -> listOf("PlaySound(SOUND_CLICK);")
        is Statement.Buzz -> listOf("PlaySound(SOUND_LOW_BEEP);")
        is Statement.Play -> play(statement)
        is Statement.Show -> listOf(show(statement.value))
        is Statement.ShowText -> lost(statement, messages.text())

        is Statement.ClearScreen -> {
            remarks.changed(statement.range, messages.clearScreen())
            listOf("SelectDisplay(DISPLAY_WATCH);")
        }

        else -> lost(statement, messages.otherBrick())
    }

    private fun lost(statement: Statement, message: String): List<String> {
        remarks.lost(statement.range, message)
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

    private fun move(statement: Statement.Move): String {
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

    private fun turn(statement: Statement.Turn): String {
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
        if (magnitude(number) * figure > LONGEST_WAIT) remarks.lost(number.range, messages.tooLong())
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
        if (hundredths > LONGEST_WAIT / TENTHS) remarks.lost(bare.range, messages.tooLong())
        return "$hundredths"
    }

    private fun motor(statement: Statement.Motor): String {
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

    private fun waitUntil(statement: Statement.WaitUntil): List<String> {
        val (condition, calls) = expressions.withCalls { expressions.text(statement.condition) }
        if (calls.isEmpty()) return listOf("until ($condition);")
        return listOf("while (true) {") + calls.map { "    $it" } + listOf("    if ($condition) break;", "}")
    }

    private fun play(statement: Statement.Play): List<String> {
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
