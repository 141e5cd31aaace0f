package robotran.robolang.outline

import robotran.brick.kind.BrickKind
import robotran.language.source.SourceSpan
import robotran.robolang.syntax.AssignTarget
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Name
import robotran.robolang.syntax.Token
import robotran.robolang.syntax.TokenKind
import robotran.robolang.words.MOTORS
import robotran.robolang.words.PORTS
import robotran.robolang.words.ValueForm
import robotran.robolang.words.ValueUse

/** A part that begins at [column] of the line and is more than a word. */
internal class Claim(val column: Int, val endColumn: Int, val part: (PhraseBuilder) -> PhrasePart)

/** The parts of a line: what is claimed, and words and choices between. */
internal class PhraseBuilder(
    private val tokens: List<Token>,
    private val offsets: LineOffsets,
    private val brick: BrickKind,
) {
    private var position = 0

    /** The parts of the whole line; null if it does not have all that is claimed, because of a mistake. */
    fun line(choices: List<List<String>>, claims: List<Claim>): List<PhrasePart>? {
        if (claims.any { it.column >= it.endColumn }) return null
        val parts = until(Int.MAX_VALUE, choices, claims)
        return parts.takeIf { found ->
            found.count { it !is PhrasePart.Word && it !is PhrasePart.Choice } == claims.size
        }
    }

    private fun until(endColumn: Int, choices: List<List<String>>, claims: List<Claim>): List<PhrasePart> {
        val parts = mutableListOf<PhrasePart>()
        var next = 0
        while (position < tokens.size && tokens[position].range.column < endColumn) {
            val token = tokens[position]
            val claim = claims.getOrNull(next)?.takeIf { it.column == token.range.column }
            if (claim == null) {
                position++
                parts += wordOrChoice(token, choices)
            } else {
                next++
                parts += claim.part(this)
            }
        }
        return parts
    }

    private fun wordOrChoice(token: Token, choices: List<List<String>>): PhrasePart {
        val span = offsets.span(token.range)
        val spelling = token.keyword?.text ?: if (token.kind == TokenKind.WORD) token.text.uppercase() else token.text
        // Inputs have their numbers on several bricks.
        val options = choices.firstOrNull { it === PORTS[brick] && spelling in it }
            ?: choices.firstOrNull { spelling in it }
            ?: return PhrasePart.Word(span)
        return PhrasePart.Choice(span, if (options === MOTORS) motorsFor(spelling) else options)
    }

    /** The letters of the motors that the brick has; all if it lacks this one. */
    private fun motorsFor(letter: String): List<String> =
        brick.motorPorts.map { it.name }.takeIf { letter in it } ?: MOTORS

    /** The next token as a part of its own. */
    fun single(part: (SourceSpan) -> PhrasePart): PhrasePart = part(offsets.span(tokens[position++].range))

    fun value(expression: Expression, use: ValueUse): PhrasePart.Value {
        val parts = until(expression.range.endColumn, expression.choices, expression.claims(use))
        return PhrasePart.Value(use, OutlineValue(expression.form, offsets.span(expression.range), parts))
    }
}

internal fun claim(name: Name, role: NameRole) =
    Claim(name.range.column, name.range.endColumn) { builder -> builder.single { PhrasePart.NamePart(it, role) } }

internal fun claim(value: Expression, use: ValueUse) =
    Claim(value.range.column, value.range.endColumn) { it.value(value, use) }

internal fun claims(target: AssignTarget): List<Claim> = when (target) {
    is AssignTarget.Variable -> listOf(claim(target.name, NameRole.ASSIGNS))
    is AssignTarget.ListElement -> listOf(claim(target.list, NameRole.READS), claim(target.index, ValueUse.INDEX))
}

private val Expression.form: ValueForm
    get() = when (this) {
        is Expression.Number -> ValueForm.NUMBER
        is Expression.BooleanLiteral -> ValueForm.TRUTH
        is Expression.ColourLiteral -> ValueForm.COLOUR_NAME
        is Expression.ListOf -> ValueForm.LIST
        is Expression.Variable -> ValueForm.NAME
        is Expression.ListElement -> ValueForm.ELEMENT
        is Expression.Unary -> operator.form
        is Expression.Binary -> operator.form
        is Expression.Call -> if (BuiltIn.of(name.key) == null) ValueForm.CALL else ValueForm.BUILT_IN
        is Expression.Sense -> sense.form
        is Expression.Brackets -> ValueForm.BRACKETS
    }

private fun Expression.claims(use: ValueUse): List<Claim> = when (this) {
    is Expression.Number, is Expression.BooleanLiteral, is Expression.ColourLiteral, is Expression.Sense -> emptyList()
    is Expression.ListOf -> elements.map { claim(it, ValueUse.NUMBER) }
    is Expression.Variable -> listOf(claim(name, NameRole.READS))
    is Expression.ListElement -> listOf(claim(list, ValueUse.LIST), claim(index, ValueUse.INDEX))
    is Expression.Unary -> listOf(claim(operand, operator.operandUse))
    is Expression.Binary -> listOf(claim(left, operator.operandUse), claim(right, operator.operandUse))
    is Expression.Call -> listOf(claim(name, NameRole.CALLS_FUNCTION)) + arguments.map { claim(it, argumentUse(name)) }
    is Expression.Brackets -> listOf(claim(inner, use))
}

private fun argumentUse(function: Name): ValueUse = when (BuiltIn.of(function.key)) {
    null -> ValueUse.ANY
    BuiltIn.LENGTH -> ValueUse.LIST
    else -> ValueUse.NUMBER
}
