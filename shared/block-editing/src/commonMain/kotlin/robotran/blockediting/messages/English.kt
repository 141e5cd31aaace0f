package robotran.blockediting.messages

import robotran.blockediting.BlockDeed
import robotran.blockediting.BlockGroup
import robotran.blockediting.BlockRefusal
import robotran.language.listed
import robotran.language.quoted
import robotran.robolang.outline.ValueKind

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

    override fun refusal(refusal: BlockRefusal) = when (refusal) {
        BlockRefusal.NotFound -> {
            "This block is no longer there. Try again."
        }

        BlockRefusal.IntoItself -> {
            "A block cannot go into itself. Put it somewhere else."
        }

        BlockRefusal.OnlyOutermost -> {
            "This block cannot stand inside another block. Put it above or below the other blocks."
        }

        BlockRefusal.SettingOutsideRobot -> {
            "This block belongs into a \"robot\" block. Put it there."
        }

        BlockRefusal.OnlySettings -> {
            "In a \"robot\" block there are only lines about the light sensor. Put the block below it."
        }

        BlockRefusal.SecondRobot -> {
            "The program already has a \"robot\" block. Change that one."
        }

        BlockRefusal.TooDeep -> {
            "Too many blocks would be inside each other. Make an own command of some of them."
        }

        BlockRefusal.TooLong -> {
            "The program would be too long. Delete something first."
        }

        BlockRefusal.LooseEnd -> {
            "There is an \"end\" or \"else\" that belongs to no block. Delete it or put it right, then try again."
        }

        BlockRefusal.NoSuchConstruct -> {
            "This works only with a block that has others inside. Choose another one."
        }

        BlockRefusal.ElseExists -> {
            "This \"if\" already has an \"else\". Put your blocks in there."
        }

        is BlockRefusal.NoValue -> {
            refusal.mistake?.message ?: "${quoted(refusal.text)} is no value. Write a number, such as \"20\"."
        }

        BlockRefusal.NumberNeeded -> {
            "A number goes here, such as \"20\" or \"light\"."
        }

        BlockRefusal.ConditionNeeded -> {
            "A condition goes here, such as \"left bumper\" or \"light < 40\"."
        }

        BlockRefusal.ListNeeded -> {
            "A list goes here, such as \"[1, 2, 3]\"."
        }

        BlockRefusal.LastItem -> {
            "A list has at least one number. Change it or delete the whole block."
        }

        BlockRefusal.NoSuchForm -> {
            "This block cannot become that one. Take a new block from the palette."
        }

        is BlockRefusal.NoChoice -> {
            "Choose ${listed(refusal.options.map(::quoted), "or")}."
        }

        is BlockRefusal.NoName -> {
            "${quoted(
                refusal.name,
            )} cannot be a name. Take letters and digits, with a letter first, and no word of Robolang."
        }

        is BlockRefusal.NameTaken -> {
            "Something else is called ${quoted(refusal.name)}. Take another name."
        }

        BlockRefusal.NoText -> {
            "A text is one line without quotation marks. Leave them out."
        }

        BlockRefusal.NoFix -> {
            "Nothing can be put right here automatically. Change the line yourself."
        }

        BlockRefusal.NoNote -> {
            "Put the line right before you write a note on it."
        }

        BlockRefusal.NothingToInsert -> {
            "There is nothing to paste. Copy a block first."
        }

        BlockRefusal.NoPlaceForValue -> {
            "This is a value. Touch the place in a block where it goes, then take it again, or carry it there."
        }

        BlockRefusal.NothingToTry -> {
            "Alone, this block does nothing. Choose one that does something, such as \"forward 20\"."
        }

        is BlockRefusal.ValueUnknown -> {
            "${quoted(refusal.name)} has a value only in the whole program. Press Run, or put a number there."
        }

        is BlockRefusal.Mistaken -> {
            "Line ${refusal.line}: ${refusal.message}"
        }
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

    override fun note(text: String) = "note: $text"

    override fun emptyLine() = "empty line"

    override fun mistake(line: String, message: String?) =
        "line with a mistake: $line." + message?.let { " $it" }.orEmpty()

    override fun kind(kind: ValueKind) = when (kind) {
        ValueKind.NUMBER -> "number"
        ValueKind.CONDITION -> "condition"
        ValueKind.LIST -> "list"
        ValueKind.UNKNOWN -> "value"
    }

    override fun choice(options: List<String>) = "choose ${listed(options, "or")}"
}
