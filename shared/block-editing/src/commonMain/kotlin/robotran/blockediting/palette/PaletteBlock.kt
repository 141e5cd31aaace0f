package robotran.blockediting.palette

import robotran.blockediting.BlockEdit
import robotran.blockediting.BlockEditResult
import robotran.blockediting.BlockProgram
import robotran.blockediting.apply
import robotran.blockediting.blocksOf
import robotran.blockediting.freeName
import robotran.language.Language
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.words.BlockGroup
import robotran.robolang.words.LineForm
import robotran.robolang.words.ValueForm

/**
 * A block that a pupil can take from the palette.
 *
 * @property id what it says, such as `move` or `value-timer`. A tutorial step introduces it by this name.
 * @property isValue whether [template] is a value that goes into a line, not whole lines.
 * @property template its text, with values that make sense.
 * @property words the words of the language that it has, also those that its menus offer.
 * @property form what its line says; null for a value.
 */
class PaletteBlock internal constructor(
    val id: String,
    val group: BlockGroup,
    val isValue: Boolean,
    val template: String,
    val words: Set<String>,
    val form: LineForm? = null,
) {
    /** The words that explain it, the best one first. */
    val explained: List<String>
        get() = listOfNotNull(MAIN_WORDS[id]) + words

    /** Whether a pupil sees or hears what this block does if it runs alone. */
    val canBeTried: Boolean get() = !isValue && id in SHOWN_ALONE

    /** The [template] for [program]: the names that it declares differ from all that are there. */
    fun textFor(program: BlockProgram): String {
        if (isValue) return template
        var lines = blocksOf(template, messages = RobolangMessages.of(Language.ENGLISH))
        for (index in lines.outline.names.indices) {
            val name = lines.outline.names[index]
            val free = program.freeName(name.text)
            if (free == name.text) continue
            val renamed = apply(lines, BlockEdit.Rename(name.declaredAt, free))
            if (renamed is BlockEditResult.Success) lines = renamed.program
        }
        return lines.text
    }
}

private val SHOWN_ALONE = LineForm.entries.filter { it.showsAlone }.mapTo(mutableSetOf()) { idOf(it) }

/** Words that explain blocks better than their first word, which also means something else. */
private val MAIN_WORDS = mapOf(
    idOf(LineForm.LIGHT_SENSOR) to "on",
    idOf(LineForm.COLOUR_SENSOR) to "on",
    idOf(ValueForm.BUMPER) to "bumper",
    idOf(ValueForm.LOGIC) to "and",
    OR to "or",
)
