package robotran.blockediting

import robotran.language.Language
import robotran.language.source.SourceSpan
import robotran.robolang.messages.RobolangMessages

/** A program with a comment, an empty line and odd spaces, which no edit may lose. */
internal const val SQUARE =
    "pen down // start\n\nrepeat 4 times   // sides\n    forward  20\n    turn left 90\nend\nbeep\n"

/** The place of the first [text] in the program. */
internal fun BlockProgram.span(text: String): SourceSpan =
    this.text.indexOf(text).let { SourceSpan(it, it + text.length) }

/** The text that a possible edit makes of [text]. */
internal fun after(text: String, edit: BlockProgram.() -> BlockEdit): String =
    blocksOf(text, messages = RobolangMessages.of(Language.ENGLISH)).let { it.done(it.edit()).program.text }

/** Why an edit of [text] is refused. */
internal fun editError(text: String, edit: BlockProgram.() -> BlockEdit): BlockEditError =
    blocksOf(text, messages = RobolangMessages.of(Language.ENGLISH)).let { it.editError(it.edit()) }
