package robotran.blockediting

import robotran.language.source.Diagnostic
import robotran.language.source.SourceSpan
import robotran.textediting.TextEdit

/** The result of a [BlockEdit]. */
sealed interface BlockEditResult {
    /**
     * The edit is possible.
     *
     * @property program the blocks afterwards.
     * @property changes the changes of the text, from its start to its end, each as small as possible. The offsets are
     * those of the text before all changes.
     * @property change all changes as one, for the history of the text; null if the text stays as it is.
     * @property selection what to select in the text afterwards: the lines or the value that were put there, otherwise
     * a caret.
     * @property selected the blocks to select afterwards.
     */
    class Success internal constructor(
        val program: BlockProgram,
        val changes: List<TextEdit>,
        val change: TextEdit?,
        val selection: SourceSpan,
        val selected: List<BlockId>,
    ) : BlockEditResult

    /** The edit is impossible; the text stays as it is. */
    data class Failure(val reason: BlockEditError) : BlockEditResult
}

/** Why an edit is impossible. `BlockMessages` has a sentence for each. */
sealed interface BlockEditError {
    /** The program has no such block, place or part; it has changed since. */
    data object NotFound : BlockEditError

    /** Blocks cannot move into themselves, nor values. */
    data object IntoItself : BlockEditError

    /** Procedures, functions, `whenever` and `robot` stand outside all blocks. */
    data object OnlyOutermost : BlockEditError

    /** A setting stands in a `robot` block. */
    data object SettingOutsideRobot : BlockEditError

    /** A `robot` block has settings only. */
    data object OnlySettings : BlockEditError

    /** A program has one `robot` block. */
    data object SecondRobot : BlockEditError

    /** The blocks would be nested too deeply. */
    data object TooDeep : BlockEditError

    /** The program would be too long. */
    data object TooLong : BlockEditError

    /** An `end` or `else` that belongs to no block would change what is inside which block. */
    data object LooseEnd : BlockEditError

    /** The construct is no `if`, or no construct. */
    data object NoSuchConstruct : BlockEditError

    /** The `if` has an `else` already. */
    data object ElseExists : BlockEditError

    /** [text] is no value; [error] says why, if the parser knows. */
    data class NoValue(val text: String, val error: Diagnostic?) : BlockEditError

    /** A number is needed here. */
    data object NumberNeeded : BlockEditError

    /** A condition is needed here. */
    data object ConditionNeeded : BlockEditError

    /** A list is needed here. */
    data object ListNeeded : BlockEditError

    /** A list has at least one element. */
    data object LastItem : BlockEditError

    /** The line cannot take this form. */
    data object NoSuchForm : BlockEditError

    /** The choice does not have this word. */
    data class NoChoice(val options: List<String>) : BlockEditError

    /** [name] cannot be a name. */
    data class NoName(val name: String) : BlockEditError

    /** [name] is the name of something else. */
    data class NameTaken(val name: String) : BlockEditError

    /** A text on the display has neither quotation marks nor line breaks. */
    data object NoText : BlockEditError

    /** The line has no mistake with a fix. */
    data object NoFix : BlockEditError

    /** The line cannot have a comment, because its text would swallow it. */
    data object NoNote : BlockEditError

    /** There is nothing to insert. */
    data object NothingToInsert : BlockEditError

    /** A value goes into a block, but the pupil has not said into which place of which one. */
    data object NoPlaceForValue : BlockEditError

    /** Tried alone, the blocks do nothing. */
    data object NothingToTry : BlockEditError

    /** The blocks cannot be tried alone: [name] has a value only while the lines around them run. */
    data class ValueUnknown(val name: String) : BlockEditError

    /** The blocks cannot be tried: the [line], from 1, has a mistake; [message] says which one. */
    data class CompileError(val line: Int, val message: String) : BlockEditError
}
