package robotran.robolang.syntax

import robotran.brick.kind.BrickKind
import robotran.languagesupport.ParsedSource
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.words.Vocabulary
import robotran.robolang.words.vocabularyOf

/**
 * A Robolang text as the scanner and the parser have read it, once for all who need it: the outline, which blocks are made
 * of, and the compiler. Immutable.
 */
class ParsedText internal constructor(
    private val source: String,
    internal val program: ParsedProgram,
    private val namedBrick: BrickKind?,
    private val found: DiagnosticSink,
) : ParsedSource {
    /** The words that it is written in. */
    val vocabulary: Vocabulary get() = found.vocabulary

    /** The mistakes of the scanner and the parser, to which the checker may add its own, as those of the file [name]. */
    internal fun diagnostics(name: String = ""): DiagnosticSink = found.copied(name)

    /** Whether [source], for a robot with [brick] and with mistakes told by [messages], would be read the same. */
    internal fun isOf(source: String, brick: BrickKind, messages: RobolangMessages): Boolean =
        source == this.source && (namedBrick ?: brick) == found.brick && messages === found.messages
}

/** Reads [source], in the words of [vocabulary], for a robot with [brick], unless its header names another one. */
internal fun parse(
    source: String,
    brick: BrickKind,
    messages: RobolangMessages,
    vocabulary: Vocabulary = vocabularyOf(source),
): ParsedText {
    val diagnostics = DiagnosticSink(messages)
    val lines = scan(source, diagnostics, vocabulary)
    val named = brickIn(lines)
    diagnostics.brick = named ?: brick
    return ParsedText(source, Parser(lines, diagnostics).program(), named, diagnostics)
}
