package robotran.workshop.blocks

import robotran.robolang.outline.OutlineLine
import robotran.robolang.words.LineForm

/**
 * The word of Robolang that explains this line of [text]. For a line that begins with a name of the pupil's it is the
 * word that declares such names. Null if there is nothing to explain, as in a comment.
 */
fun OutlineLine.helpWord(text: String): String? = when (form) {
    LineForm.ASSIGN, LineForm.ASSIGN_ELEMENT -> VARIABLE
    LineForm.CALL -> PROCEDURE
    else -> FIRST_WORD.find(span.textIn(text).substringBefore(NOTE))?.value
}

private const val VARIABLE = "var"
private const val PROCEDURE = "procedure"
private const val NOTE = "//"
private val FIRST_WORD = Regex("[\\p{L}_][\\p{L}\\p{N}_]*")
