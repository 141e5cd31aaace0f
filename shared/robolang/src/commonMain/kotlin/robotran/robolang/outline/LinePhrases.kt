package robotran.robolang.outline

import robotran.language.source.SourceRange
import robotran.robolang.syntax.Branch
import robotran.robolang.syntax.BrickSetting
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.LightSensorSetting
import robotran.robolang.syntax.NxtSensor
import robotran.robolang.syntax.RobotSetting
import robotran.robolang.syntax.Routine
import robotran.robolang.syntax.SensorSetting
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.words.LineForm
import robotran.robolang.words.ValueUse

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

private fun phraseOf(statement: Statement): LinePhrase = when (statement) {
    is Command -> LinePhrase(
        statement.form,
        statement.values.map { (value, use) -> claim(value, use) } + statement.texts,
    )
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

private val Command.texts: List<Claim>
    get() = if (this is Command.ShowText) {
        listOf(Claim(textRange.column, textRange.endColumn) { it.single(PhrasePart::Text) })
    } else {
        emptyList()
    }
