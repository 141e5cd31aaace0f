package robotran.blockediting.messages

import robotran.blockediting.BlockDeed
import robotran.blockediting.BlockEditError
import robotran.language.Language
import robotran.language.choose
import robotran.robolang.words.BlockGroup
import robotran.robolang.words.ValueKind

/** All messages to the pupil about blocks, implemented once per language. Words of Robolang are not translated. */
interface BlockMessages {
    fun group(group: BlockGroup): String

    /** Why an edit is impossible, and what to do. */
    fun editError(error: BlockEditError): String

    /** How deeply a block is nested, from 1. */
    fun level(level: Int): String

    /** How many blocks are inside a construct. */
    fun inside(count: Int): String

    /** In which block another one is, by the [line] of that block. */
    fun isIn(line: String): String

    /** The place of a block among its neighbours, from 1, of which there are [count] with itself. */
    fun position(position: Int, count: Int): String

    /** So many blocks; [count] is at least 1. */
    fun blocks(count: Int): String

    /** What has been done, and to [what]: a block with its place, or several blocks. */
    fun deed(deed: BlockDeed, what: String): String

    /** That [what] is no longer there: a block, or several. */
    fun gone(what: String): String

    /** That the last edit was undone; [change] says what is different now, if it is known. */
    fun undone(change: String?): String

    /** That the edit that was undone last was made again; [change] as in [undone]. */
    fun redone(change: String?): String

    fun note(text: String): String

    fun emptyLine(): String

    /** A line with a mistake; [message] says which one, if that is known. */
    fun mistake(line: String, message: String?): String

    fun kind(kind: ValueKind): String

    /** The words of a menu. */
    fun choice(options: List<String>): String

    companion object {
        fun of(language: Language): BlockMessages =
            language.choose(EnglishBlockMessages, SpanishBlockMessages, GermanBlockMessages)
    }
}
