package robotran.blockediting.messages

import robotran.blockediting.BlockDeed
import robotran.blockediting.BlockEditError
import robotran.language.listed
import robotran.language.quoted
import robotran.robolang.words.BlockGroup
import robotran.robolang.words.ValueKind

/** The messages in English. */
object EnglishBlockMessages : BlockMessages {
    override fun group(group: BlockGroup) = when (group) {
        BlockGroup.DRIVE -> "Drive"
        BlockGroup.PEN -> "Pen"
        BlockGroup.SENSE -> "Sense"
        BlockGroup.CONTROL -> "Control"
        BlockGroup.NUMBERS -> "Numbers"
        BlockGroup.LISTS -> "Lists"
        BlockGroup.OWN_COMMANDS -> "Own commands"
        BlockGroup.SHOW_AND_SOUND -> "Show and sound"
    }

    override fun editError(error: BlockEditError) = when (error) {
        BlockEditError.NotFound -> "This block is no longer there. Try again."
        BlockEditError.IntoItself -> "A block cannot go into itself. Put it somewhere else."

        BlockEditError.OnlyOutermost -> {
            "This block cannot stand inside another block. Put it above or below the other blocks."
        }

        BlockEditError.SettingOutsideRobot -> "This block belongs into a \"robot\" block. Put it there."

        BlockEditError.OnlySettings -> {
            "In a \"robot\" block there are only lines about the brick and its sensors. Put the block below it."
        }

        BlockEditError.SecondRobot -> "The program already has a \"robot\" block. Change that one."
        BlockEditError.TooDeep -> "Too many blocks would be inside each other. Make an own command of some of them."
        BlockEditError.TooLong -> "The program would be too long. Delete something first."

        BlockEditError.LooseEnd -> {
            "There is an \"end\" or \"else\" that belongs to no block. Delete it or put it right, then try again."
        }

        BlockEditError.NoSuchConstruct -> "This works only with a block that has others inside. Choose another one."
        BlockEditError.ElseExists -> "This \"if\" already has an \"else\". Put your blocks in there."

        is BlockEditError.NoValue -> {
            error.mistake?.message ?: "${quoted(error.text)} is no value. Write a number, such as \"20\"."
        }

        BlockEditError.NumberNeeded -> "A number goes here, such as \"20\" or \"light\"."
        BlockEditError.ConditionNeeded -> "A condition goes here, such as \"left bumper\" or \"light < 40\"."
        BlockEditError.ListNeeded -> "A list goes here, such as \"[1, 2, 3]\"."
        BlockEditError.LastItem -> "A list has at least one number. Change it or delete the whole block."
        BlockEditError.NoSuchForm -> "This block cannot become that one. Take a new block from the palette."
        is BlockEditError.NoChoice -> "Choose ${listed(error.options.map(::quoted), "or")}."

        is BlockEditError.NoName -> {
            "${quoted(
                error.name,
            )} cannot be a name. Take letters and digits, with a letter first, and no word of Robolang."
        }

        is BlockEditError.NameTaken -> "Something else is called ${quoted(error.name)}. Take another name."
        BlockEditError.NoText -> "A text is one line without quotation marks. Leave them out."
        BlockEditError.NoFix -> "Nothing can be put right here automatically. Change the line yourself."
        BlockEditError.NoNote -> "Put the line right before you write a note on it."
        BlockEditError.NothingToInsert -> "There is nothing to paste. Copy a block first."

        BlockEditError.NoPlaceForValue -> {
            "This is a value. Touch the place in a block where it goes, then take it again, or carry it there."
        }

        BlockEditError.NothingToTry -> {
            "Alone, this block does nothing. Choose one that does something, such as \"forward 20\"."
        }

        is BlockEditError.ValueUnknown -> {
            "${quoted(error.name)} has a value only in the whole program. Press Run, or put a number there."
        }

        is BlockEditError.Mistaken -> "Line ${error.line}: ${error.message}"
    }

    override fun level(level: Int) = "level $level"

    override fun inside(count: Int) = when (count) {
        0 -> "nothing inside"
        1 -> "1 block inside"
        else -> "$count blocks inside"
    }

    override fun isIn(line: String) = "in $line"

    override fun position(position: Int, count: Int) = "$position of $count"

    override fun blocks(count: Int) = if (count == 1) "1 block" else "$count blocks"

    override fun deed(deed: BlockDeed, what: String) = when (deed) {
        BlockDeed.ADDED -> "Added: $what"
        BlockDeed.MOVED -> "Moved: $what"
        BlockDeed.DOUBLED -> "Doubled: $what"
        BlockDeed.DELETED -> "Deleted: $what"
        BlockDeed.CHANGED -> "Now: $what"
    }

    override fun gone(what: String) = "Gone: $what"

    override fun undone(change: String?) = listOfNotNull("Undone.", change).joinToString(" ")

    override fun redone(change: String?) = listOfNotNull("Redone.", change).joinToString(" ")

    override fun note(text: String) = "note: $text"

    override fun emptyLine() = "empty line"

    override fun mistake(line: String, message: String?) =
        "line with a mistake: $line." + message?.let { " $it" }.orEmpty()

    override fun kind(kind: ValueKind) = when (kind) {
        ValueKind.NUMBER -> "number"
        ValueKind.CONDITION -> "condition"
        ValueKind.LIST -> "list"
        ValueKind.COLOUR -> "colour"
        ValueKind.UNKNOWN -> "value"
    }

    override fun choice(options: List<String>) = "choose ${listed(options, "or")}"
}
