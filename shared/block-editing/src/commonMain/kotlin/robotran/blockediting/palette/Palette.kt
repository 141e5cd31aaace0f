package robotran.blockediting.palette

import robotran.blockediting.BlockPlace
import robotran.blockediting.BlockProgram
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.robolang.RobolangWords
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.outline.DeclaredName
import robotran.robolang.outline.NameKind
import robotran.robolang.outline.PhrasePart
import robotran.robolang.outline.ProgramOutline
import robotran.robolang.outline.outlineRobolang
import robotran.robolang.words.BlockGroup
import robotran.robolang.words.LineForm
import robotran.robolang.words.ValueForm
import robotran.robolang.words.ValueKind
import robotran.robolang.words.ValueUse

/** The palette: a block for each form of the language, made from its own tables. */
object Palette {
    private val byBrick: Map<BrickKind, List<PaletteBlock>> by lazy {
        BrickKind.entries.associateWith { brick ->
            val lines = LineForm.entries.mapNotNull { form -> form.exampleOn(brick)?.let { line(form, it) } }
            val values = ValueForm.entries.flatMap { form -> form.examplesOn(brick).map { value(form, it) } }
            (lines + values).sortedWith(compareBy({ it.group }, { it.rankInGroup }))
        }
    }

    /** All blocks for a robot with the [BrickKind.default], as [blocksFor] has them. */
    val blocks: List<PaletteBlock> get() = blocksFor(BrickKind.default)

    /**
     * All blocks for a robot with [brick], by group; in a group lines come before values. In [BlockGroup.SENSE] what
     * reads sensors comes first.
     */
    fun blocksFor(brick: BrickKind): List<PaletteBlock> = byBrick.getValue(brick)

    /** The blocks of [group] for a robot with [brick]. */
    fun blocksOf(group: BlockGroup, brick: BrickKind): List<PaletteBlock> =
        blocksFor(brick).filter { it.group == group }

    private fun line(form: LineForm, template: String): PaletteBlock {
        val source = if (form.isSetting) "robot\n$template\nend" else template
        val lines = outlineRobolang(source, messages = RobolangMessages.of(Language.ENGLISH)).lines.let {
            if (form.isSetting) it.drop(1).dropLast(1) else it
        }
        return PaletteBlock(
            idOf(form),
            form.group,
            isValue = false,
            template,
            wordsOf(lines.flatMap { it.parts }, source),
            form,
        )
    }

    private fun value(form: ValueForm, template: String): PaletteBlock {
        val group = if (form == ValueForm.BUILT_IN && isAboutLists(template)) BlockGroup.LISTS else form.group
        val outline = outlineRobolang(VALUE_LINE + template, messages = RobolangMessages.of(Language.ENGLISH))
        val part = outline.lines.first().parts.last() as PhrasePart.Value
        return PaletteBlock(
            idOf(part, outline.source),
            group,
            isValue = true,
            template,
            wordsOf(listOf(part), outline.source),
        )
    }

    private fun isAboutLists(call: String): Boolean =
        valuesIn(call).first().value.parts.any { it is PhrasePart.Value && it.use == ValueUse.LIST }
}

/**
 * The blocks with the names that the pupil has declared and that are visible at [place]: variables, elements of lists,
 * and calls of own commands.
 */
fun ownBlocks(program: BlockProgram, place: BlockPlace): List<PaletteBlock> =
    program.namesAt(place).orEmpty().flatMap(::ownBlocks)

private fun ownBlocks(name: DeclaredName): List<PaletteBlock> {
    val call = name.parameters.joinToString(prefix = "${name.text}(", postfix = ")") { ValueUse.ANY.example }
    return when (name.kind) {
        NameKind.PROCEDURE -> listOf(own(LineForm.CALL, call))
        NameKind.FUNCTION -> listOf(own(ValueForm.CALL, call))
        NameKind.VARIABLE, NameKind.PARAMETER -> listOf(own(ValueForm.NAME, name.text)) + changesOf(name)
        NameKind.CONSTANT -> listOf(own(ValueForm.NAME, name.text)) + elementsOf(name)
        NameKind.LOOP_VARIABLE -> listOf(own(ValueForm.NAME, name.text))
    }
}

private fun changesOf(name: DeclaredName): List<PaletteBlock> = when (name.type) {
    ValueKind.LIST -> elementsOf(name) + own(LineForm.ASSIGN_ELEMENT, "${name.text}[0] = 5")
    ValueKind.CONDITION -> listOf(own(LineForm.ASSIGN, "${name.text} = true"))
    ValueKind.COLOUR -> listOf(own(LineForm.ASSIGN, "${name.text} = red"))
    ValueKind.NUMBER, ValueKind.UNKNOWN -> listOf(own(LineForm.ASSIGN, "${name.text} = ${name.text} + 1"))
}

private fun elementsOf(name: DeclaredName): List<PaletteBlock> =
    if (name.type == ValueKind.LIST) listOf(own(ValueForm.ELEMENT, "${name.text}[0]")) else emptyList()

private fun own(form: LineForm, template: String) =
    PaletteBlock(idOf(form), form.group, isValue = false, template, emptySet(), form)

private fun own(form: ValueForm, template: String) =
    PaletteBlock(idOf(form), form.group, isValue = true, template, emptySet())

internal const val VALUE_LINE = "var x = "

internal fun idOf(form: LineForm): String = form.name.lowercase().replace('_', '-')

internal fun idOf(form: ValueForm): String = "value-" + form.name.lowercase().replace('_', '-')

/** The id of the palette block that has a value like [part]; each built-in function has its own, and so has `or`. */
internal fun idOf(part: PhrasePart.Value, source: String): String = when (val form = part.value.form) {
    ValueForm.BUILT_IN -> "function-" + part.value.parts.first().span.textIn(source).lowercase()
    ValueForm.LOGIC -> if (part.value.parts.any { it is PhrasePart.Choice && it.isOr(source) }) OR else idOf(form)
    else -> idOf(form)
}

private fun PhrasePart.isOr(source: String) = span.textIn(source).equals("or", ignoreCase = true)

internal const val OR = "value-logic-or"

/** The words of the language in [parts], also those that menus offer and units that need not be written. */
private fun wordsOf(parts: List<PhrasePart>, source: String): Set<String> = parts.flatMap(::withInner).flatMap { part ->
    when (part) {
        is PhrasePart.Word, is PhrasePart.NamePart -> listOf(part.span.textIn(source).lowercase())
        is PhrasePart.Choice -> part.options
        is PhrasePart.Value -> listOfNotNull(part.use.unit)
        is PhrasePart.Text -> emptyList()
    }
}.filterTo(mutableSetOf()) { it in RobolangWords.keywords || it in RobolangWords.functions }

/** All parts of a program's lines, also those inside values. */
internal fun partsOf(outline: ProgramOutline): Sequence<PhrasePart> =
    outline.lines.asSequence().flatMap { it.parts }.flatMap(::withInner)

private fun withInner(part: PhrasePart): Sequence<PhrasePart> {
    val inner = (part as? PhrasePart.Value)?.value?.parts.orEmpty()
    return sequenceOf(part) + inner.asSequence().flatMap(::withInner)
}
