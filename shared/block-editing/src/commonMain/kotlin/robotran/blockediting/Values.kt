package robotran.blockediting

import robotran.language.source.SourceSpan
import robotran.robolang.outline.DeclaredName
import robotran.robolang.outline.NameKind
import robotran.robolang.outline.NameRole
import robotran.robolang.outline.OutlineValue
import robotran.robolang.outline.PhrasePart
import robotran.robolang.words.LineForm
import robotran.robolang.words.ValueForm
import robotran.robolang.words.ValueKind
import robotran.robolang.words.ValueUse

/** The type of a value of this form; null if that depends on what it names or has inside. */
internal fun literalKind(form: ValueForm): ValueKind? = when (form) {
    ValueForm.NUMBER, ValueForm.ELEMENT, ValueForm.NEGATION, ValueForm.ARITHMETIC, ValueForm.BUILT_IN, ValueForm.LIGHT,
    ValueForm.SENSOR, ValueForm.TIMER, ValueForm.BATTERY, ValueForm.DISTANCE, ValueForm.LOUDNESS, ValueForm.TURNED,
    -> {
        ValueKind.NUMBER
    }

    ValueForm.TRUTH, ValueForm.NOT, ValueForm.LOGIC, ValueForm.COMPARISON, ValueForm.BUMPER, ValueForm.BUTTON -> {
        ValueKind.CONDITION
    }

    ValueForm.LIST -> ValueKind.LIST
    ValueForm.COLOUR, ValueForm.COLOUR_NAME -> ValueKind.COLOUR
    ValueForm.NAME, ValueForm.CALL, ValueForm.BRACKETS -> null
}

/** The type of [value] in this program, as far as it is known. */
fun BlockProgram.kindOf(value: OutlineValue): ValueKind = when (value.form) {
    ValueForm.BRACKETS -> value.parts.firstNotNullOfOrNull { it as? PhrasePart.Value }?.let { kindOf(it.value) }

    ValueForm.NAME, ValueForm.CALL -> {
        value.parts.firstNotNullOfOrNull { it as? PhrasePart.NamePart }?.let { nameAt(it.span)?.type }
    }

    // It is a colour if a colour sensor is on its port.
    ValueForm.SENSOR -> ValueKind.NUMBER.takeIf { outline.lines.none { it.form == LineForm.COLOUR_SENSOR } }
    else -> literalKind(value.form)
} ?: ValueKind.UNKNOWN

/** The declaration of the name that stands at [span]; null if it has none. */
fun BlockProgram.nameAt(span: SourceSpan): DeclaredName? = outline.names.firstOrNull { span in it.uses }

/**
 * The names that may stand at [part], a value or a name of this program: those that are visible there and, as far as is
 * known, of the right type.
 */
fun BlockProgram.namesFor(part: PhrasePart): List<DeclaredName> {
    val visible = outline.namesBefore(lineAt(part.span.start).index)
    return when (part) {
        is PhrasePart.Value -> visible.filter { it.isValue && fits(it.type, part.use) }

        is PhrasePart.NamePart -> visible.filter {
            when (part.role) {
                NameRole.READS -> !it.isRoutine
                NameRole.ASSIGNS -> it.kind == NameKind.VARIABLE || it.kind == NameKind.PARAMETER
                NameRole.CALLS_PROCEDURE -> it.kind == NameKind.PROCEDURE
                NameRole.CALLS_FUNCTION -> it.kind == NameKind.FUNCTION
                NameRole.DECLARES, NameRole.DECLARES_ROUTINE -> false
            }
        }

        is PhrasePart.Word, is PhrasePart.Choice, is PhrasePart.Text -> emptyList()
    }
}

private val DeclaredName.isValue: Boolean get() = kind != NameKind.PROCEDURE

/** Whether a value of type [kind] may stand where [needed] is needed, as far as is known. */
fun fits(kind: ValueKind, needed: ValueKind): Boolean =
    kind == needed || kind == ValueKind.UNKNOWN || needed == ValueKind.UNKNOWN

/** Whether a value of type [kind] may stand where it is for [use], as far as is known. */
fun fits(kind: ValueKind, use: ValueUse): Boolean =
    fits(kind, use.kind) || (use == ValueUse.SHOWN && kind == ValueKind.COLOUR)

internal fun errorOf(needed: ValueKind): BlockEditError? = when (needed) {
    ValueKind.NUMBER -> BlockEditError.NumberNeeded
    ValueKind.CONDITION -> BlockEditError.ConditionNeeded
    ValueKind.LIST -> BlockEditError.ListNeeded
    ValueKind.COLOUR, ValueKind.UNKNOWN -> null
}
