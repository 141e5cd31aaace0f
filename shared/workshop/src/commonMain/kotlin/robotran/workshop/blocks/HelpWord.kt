package robotran.workshop.blocks

import robotran.robolang.outline.OutlineLine
import robotran.robolang.words.LineForm
import robotran.robolang.words.inEnglish
import robotran.robolang.words.vocabularyOf

/**
 * The word of Robolang that explains this line of [text]. For a line that begins with a name of the pupil's it is the
 * word that declares such names. Null if there is nothing to explain, as in a comment.
 */
fun OutlineLine.helpWord(text: String): String? = when (form) {
    LineForm.ASSIGN, LineForm.ASSIGN_ELEMENT -> VARIABLE
    LineForm.CALL -> PROCEDURE
    else -> FIRST_WORD.find(span.textIn(text).substringBefore(NOTE))?.value?.let { vocabularyOf(text).inEnglish(it) }
}

private const val VARIABLE = "var"
private const val PROCEDURE = "procedure"
private const val NOTE = "//"
private val FIRST_WORD = Regex("[\\p{L}_][\\p{L}\\p{N}_]*")
