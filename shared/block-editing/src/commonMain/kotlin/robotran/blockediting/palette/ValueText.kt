package robotran.blockediting.palette

import robotran.blockediting.BlockProgram
import robotran.blockediting.blocksOf
import robotran.blockediting.kindOf
import robotran.language.Language
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.outline.PhrasePart
import robotran.robolang.words.ValueForm
import robotran.robolang.words.ValueKind
import robotran.robolang.words.ValueUse
import robotran.robolang.words.inEnglish

/** What kind of value this is. */
val PaletteBlock.valueForm: ValueForm get() = valuesIn(template).first().value.form

/** The type of this value; [ValueKind.UNKNOWN] for a name of the pupil's, whose program is not known here. */
val PaletteBlock.valueKind: ValueKind get() = blocksOf(
    VALUE_LINE + template,
    messages = RobolangMessages.of(Language.ENGLISH),
).kindOf(valuesIn(template).first().value)

/**
 * The text that puts this value at [part] of [program]. A sum, `and`, `or` and `not` keep what is there now; if that is
 * in the block already, it is what the block says.
 */
fun PaletteBlock.textAt(part: PhrasePart.Value, program: BlockProgram): String {
    val text = program.vocabulary.inEnglish(part.span.textIn(program.text))
    if (valueForm != ValueForm.LOGIC) return textsAt(part, program).first()
    val operands = valuesIn(template).first().value.parts.filterIsInstance<PhrasePart.Value>()
    if (operands.any { it.span.textIn(VALUE_LINE + template).equals(text, ignoreCase = true) }) return template
    return textsAt(part, program)[if (isOr) 1 else 0]
}

private val PaletteBlock.isOr: Boolean get() = " or " in template

/** The texts that put such a value at [part] of [program]: `and` as well as `or`. */
internal fun PaletteBlock.textsAt(part: PhrasePart.Value, program: BlockProgram): List<String> {
    val text = part.span.textIn(program.text)
    val now = if (part.value.form in COMPOSED) "($text)" else text
    return when (valueForm) {
        ValueForm.ARITHMETIC -> listOf("$now + ${ValueUse.NUMBER.example}")
        ValueForm.LOGIC ->
            otherCondition(program.vocabulary.inEnglish(text)).let { listOf("$now and $it", "$now or $it") }
        ValueForm.NOT -> listOf("not $now")
        else -> listOf(template)
    }
}

/** A condition that is not in [text], which is in English words, already: twice the same would say nothing new. */
private fun otherCondition(text: String): String =
    CONDITIONS.firstOrNull { !text.contains(it, ignoreCase = true) } ?: CONDITIONS.first()

private val CONDITIONS = listOf("left bumper", "right bumper")

/** Values that need brackets inside of others. */
private val COMPOSED = setOf(ValueForm.ARITHMETIC, ValueForm.LOGIC, ValueForm.COMPARISON, ValueForm.NOT)
