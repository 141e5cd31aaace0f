package robotran.robolang.outline

import robotran.robolang.diagnostic.SourceRange
import robotran.robolang.syntax.Branch
import robotran.robolang.syntax.BrickSetting
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.LightSensorSetting
import robotran.robolang.syntax.MotorCommand
import robotran.robolang.syntax.NxtSensor
import robotran.robolang.syntax.PowerSide
import robotran.robolang.syntax.RobotSetting
import robotran.robolang.syntax.Routine
import robotran.robolang.syntax.SensorSetting
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.syntax.TimeUnit

/** What a line says: its form, and its parts that are more than words. */
internal class LinePhrase(val form: LineForm, val claims: List<Claim> = emptyList())

/** What each line of a tree says, by its number. */
internal class LinePhrases(tree: SyntaxTree) {
    private val byLine = mutableMapOf<Int, LinePhrase>()

    init {
        statements(tree.statements)
        tree.robot?.let { header ->
            put(header.range, LineForm.ROBOT)
            header.settings.forEach { put(it.range, formOf(it)) }
        }
        for (routine in tree.routines) {
            byLine[routine.range.line] = phraseOf(routine)
            statements(routine.body)
        }
        for (behaviour in tree.behaviours) {
            put(behaviour.range, LineForm.WHENEVER, claim(behaviour.condition, ValueUse.CONDITION))
            statements(behaviour.body)
        }
    }

    operator fun get(line: Int): LinePhrase? = byLine[line]

    private fun put(range: SourceRange, form: LineForm, vararg claims: Claim) {
        byLine[range.line] = LinePhrase(form, claims.toList())
    }

    private fun statements(statements: List<Statement>) {
        for (statement in statements) {
            if (statement is Statement.If) choice(statement) else byLine[statement.range.line] = phraseOf(statement)
            if (statement is Statement.Loop) statements(statement.body)
        }
    }

    private fun choice(choice: Statement.If) {
        choice.branches.forEachIndexed { index, branch ->
            put(branch.range, if (index == 0) LineForm.IF else LineForm.ELSE_IF, branch.claim())
            statements(branch.body)
        }
        choice.otherwise?.let {
            put(it.range, LineForm.ELSE)
            statements(it.body)
        }
    }
}

private fun formOf(setting: RobotSetting): LineForm = when (setting) {
    is BrickSetting -> LineForm.BRICK
    is LightSensorSetting -> LineForm.LIGHT_SENSOR

    is SensorSetting -> when (setting.sensor) {
        NxtSensor.SONAR -> LineForm.SONAR
        NxtSensor.COLOUR -> LineForm.COLOUR_SENSOR
        NxtSensor.SOUND -> LineForm.SOUND_SENSOR
    }
}

private fun Branch.claim(): Claim = claim(condition, ValueUse.CONDITION)

private fun phraseOf(routine: Routine) = LinePhrase(
    if (routine.isFunction) LineForm.FUNCTION else LineForm.PROCEDURE,
    listOf(claim(routine.name, NameRole.DECLARES_ROUTINE)) + routine.parameters.map { claim(it, NameRole.DECLARES) },
)

private fun phraseOf(form: LineForm, vararg claims: Claim) = LinePhrase(form, claims.toList())

private fun timed(timed: LineForm, duration: Expression?, other: LineForm, value: Expression?, use: ValueUse) =
    if (duration != null) {
        phraseOf(timed, claim(duration, ValueUse.SECONDS))
    } else {
        phraseOf(other, claim(checkNotNull(value), use))
    }

private fun phraseOf(statement: Statement): LinePhrase = when (statement) {
    is Command.Move -> {
        timed(LineForm.MOVE_FOR_TIME, statement.duration, LineForm.MOVE, statement.distance, ValueUse.DISTANCE)
    }

    is Command.Turn -> {
        timed(LineForm.TURN_FOR_TIME, statement.duration, LineForm.TURN, statement.angle, ValueUse.ANGLE)
    }

    is Command.StartMoving -> phraseOf(LineForm.START_MOVING)
    is Command.StartTurning -> phraseOf(LineForm.START_TURNING)
    is Command.StopDriving -> phraseOf(LineForm.STOP)

    is Command.Power -> {
        phraseOf(
            if (statement.side == PowerSide.BOTH) LineForm.POWER else LineForm.POWER_OF_SIDE,
            claim(statement.power, ValueUse.POWER),
        )
    }

    is Command.Motor -> phraseOf(statement.command)

    is Command.MotorTurn -> {
        phraseOf(
            if (statement.waits) LineForm.MOTOR_TURN else LineForm.START_MOTOR_TURN,
            claim(statement.angle, ValueUse.ANGLE),
        )
    }

    is Command.ResetMotor -> phraseOf(LineForm.RESET_MOTOR)
    is Command.Pen -> phraseOf(LineForm.PEN)
    is Command.Wait -> phraseOf(LineForm.WAIT, claim(statement.duration, statement.unit.use))
    is Command.WaitUntil -> phraseOf(LineForm.WAIT_UNTIL, claim(statement.condition, ValueUse.CONDITION))
    is Command.ResetTimer -> phraseOf(LineForm.RESET_TIMER)
    is Command.Beep -> phraseOf(LineForm.BEEP)
    is Command.Buzz -> phraseOf(LineForm.BUZZ)

    is Command.Play -> {
        phraseOf(
            LineForm.PLAY,
            claim(statement.frequency, ValueUse.FREQUENCY),
            claim(statement.duration, ValueUse.SECONDS),
        )
    }

    is Command.Show -> phraseOf(LineForm.SHOW, claim(statement.value, ValueUse.SHOWN))

    is Command.ShowText -> {
        phraseOf(
            LineForm.SHOW_TEXT,
            Claim(statement.textRange.column, statement.textRange.endColumn) { it.single(PhrasePart::Text) },
        )
    }

    is Command.ClearScreen -> phraseOf(LineForm.CLEAR_SCREEN)
    is Statement.Loop -> phraseOf(statement)
    is Statement.If -> phraseOf(LineForm.IF, statement.branches.first().claim())
    is Statement.Break -> phraseOf(LineForm.BREAK)
    is Statement.Continue -> phraseOf(LineForm.CONTINUE)
    is Statement.Halt -> phraseOf(LineForm.HALT)

    is Statement.Declare -> {
        phraseOf(
            if (statement.isConstant) LineForm.DECLARE_CONSTANT else LineForm.DECLARE_VARIABLE,
            claim(statement.name, NameRole.DECLARES),
            claim(statement.value, ValueUse.ANY),
        )
    }

    is Statement.Assign -> {
        val targets = claims(statement.target)
        val isElement = targets.size > 1
        LinePhrase(
            if (isElement) LineForm.ASSIGN_ELEMENT else LineForm.ASSIGN,
            targets + claim(statement.value, if (isElement) ValueUse.NUMBER else ValueUse.ANY),
        )
    }

    is Statement.Call -> {
        LinePhrase(
            LineForm.CALL,
            listOf(claim(statement.name, NameRole.CALLS_PROCEDURE)) +
                statement.arguments.map { claim(it, ValueUse.ANY) },
        )
    }

    is Statement.Return -> {
        val value = statement.value
        if (value == null) phraseOf(LineForm.RETURN) else phraseOf(LineForm.RETURN_VALUE, claim(value, ValueUse.ANY))
    }
}

private fun phraseOf(command: MotorCommand): LinePhrase = if (command is MotorCommand.Power) {
    phraseOf(LineForm.POWER_OF_MOTOR, claim(command.power, ValueUse.POWER))
} else {
    phraseOf(LineForm.MOTOR)
}

private fun phraseOf(loop: Statement.Loop): LinePhrase = when (loop) {
    is Statement.Repeat -> phraseOf(LineForm.REPEAT, claim(loop.count, ValueUse.COUNT))
    is Statement.RepeatForever -> phraseOf(LineForm.REPEAT_FOREVER)
    is Statement.RepeatWhile -> phraseOf(LineForm.REPEAT_WHILE, claim(loop.condition, ValueUse.CONDITION))
    is Statement.RepeatUntil -> phraseOf(LineForm.REPEAT_UNTIL, claim(loop.condition, ValueUse.CONDITION))

    is Statement.ForRange -> LinePhrase(
        if (loop.step == null) LineForm.FOR else LineForm.FOR_WITH_STEP,
        listOf(claim(loop.variable, NameRole.DECLARES)) +
            listOfNotNull(loop.from, loop.to, loop.step).map { claim(it, ValueUse.NUMBER) },
    )

    is Statement.ForEach -> phraseOf(
        LineForm.FOR_EACH,
        claim(loop.variable, NameRole.DECLARES),
        claim(loop.list, ValueUse.LIST),
    )
}

private val TimeUnit.use: ValueUse
    get() = when (this) {
        TimeUnit.SECONDS -> ValueUse.SECONDS
        TimeUnit.MILLISECONDS -> ValueUse.MILLISECONDS
    }
