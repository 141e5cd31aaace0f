package robotran.blockediting

import robotran.language.source.SourceSpan
import robotran.robolang.words.LineForm

/**
 * What a pupil does to blocks. [apply] makes it a change of the text. Blocks are named by their ids, values and other
 * parts of a line by their place in the text of the program.
 */
sealed interface BlockEdit {
    /**
     * Puts the lines of [text] at [place]: blocks of the palette, or copied ones. Their indentation follows the place.
     */
    data class Insert(val text: String, val place: BlockPlace) : BlockEdit

    /** Moves [run] to [place]. */
    data class Move(val run: BlockRun, val place: BlockPlace) : BlockEdit

    /** Puts a copy of [run] behind it. */
    data class Duplicate(val run: BlockRun) : BlockEdit

    /** Deletes blocks with all that is inside them. */
    data class Delete(val blocks: Set<BlockId>) : BlockEdit

    /**
     * Puts [run] inside a construct.
     *
     * @property construct the lines of the construct, such as `repeat 4 times` and `end`. The blocks go into its first
     * branch, in place of what is there.
     */
    data class Wrap(val run: BlockRun, val construct: String) : BlockEdit

    /** Deletes a construct, but keeps what is inside, and its comments. */
    data class Unwrap(val construct: BlockId) : BlockEdit

    /** Adds an `else if` with [condition] to an `if`, or its `else` if that is null. */
    data class AddElse(val construct: BlockId, val condition: String? = null) : BlockEdit

    /** Deletes the branch [slot] of an `if`, from 1, with what is inside. */
    data class RemoveElse(val construct: BlockId, val slot: Int) : BlockEdit

    /**
     * Puts another word, number, name, text or value at [part].
     *
     * @property part the place of the part, see [robotran.robolang.outline.PhrasePart].
     * @property text for a text on the display without its quotation marks.
     */
    data class Replace(val part: SourceSpan, val text: String) : BlockEdit

    /** Moves the value at [from] to [to]. A value that fits is left behind. */
    data class MoveValue(val from: SourceSpan, val to: SourceSpan) : BlockEdit

    /** Replaces the value at [part] with one that fits. */
    data class ClearValue(val part: SourceSpan) : BlockEdit

    /**
     * Puts a new name at [part], a value or a name, and declares it: a variable above its first use, a procedure or
     * function at the end of the program.
     */
    data class UseNewName(val part: SourceSpan, val name: String) : BlockEdit

    /** Makes a line one of another form, such as `forward for 2 seconds` of `forward 20`; see [formsFor]. */
    data class ChangeForm(val line: Int, val form: LineForm) : BlockEdit

    /** Adds the number [item] to the list at [list], before the element [index]. */
    data class AddItem(val list: SourceSpan, val index: Int, val item: String) : BlockEdit

    /** Deletes the element [index] of the list at [list]. */
    data class RemoveItem(val list: SourceSpan, val index: Int) : BlockEdit

    /**
     * Adds the parameter [name] behind those of a procedure or function. All its calls get a value.
     *
     * @property routine where the procedure or function is declared.
     */
    data class AddParameter(val routine: SourceSpan, val name: String) : BlockEdit

    /** Deletes the parameter [index] of the procedure or function declared at [routine], and its value in all calls. */
    data class RemoveParameter(val routine: SourceSpan, val index: Int) : BlockEdit

    /**
     * Writes the comment of a line; null deletes it, and the line if it has nothing else.
     *
     * @property line the index of the line.
     * @property note the comment without `//`. Its line breaks become spaces.
     */
    data class SetNote(val line: Int, val note: String?) : BlockEdit

    /**
     * Writes another line, or several, in place of a line, as a pupil types them.
     *
     * @property line the index of the line.
     * @property text the lines without the indentation of the first one.
     */
    data class ReplaceLine(val line: Int, val text: String) : BlockEdit

    /** Applies the fix of the mistake of a line. */
    data class ApplyFix(val line: Int) : BlockEdit

    /** Gives the name that is declared at [declaredAt] another spelling, wherever it is used. */
    data class Rename(val declaredAt: SourceSpan, val name: String) : BlockEdit
}

/**
 * Neighbouring blocks of one branch.
 *
 * @property first the first of them.
 * @property count how many they are, at least 1. A larger number means all to the end of the branch.
 */
data class BlockRun(val first: BlockId, val count: Int = 1) {
    companion object {
        /** The block [first] and all behind it in its branch. */
        fun stack(first: BlockId): BlockRun = BlockRun(first, Int.MAX_VALUE)
    }
}
