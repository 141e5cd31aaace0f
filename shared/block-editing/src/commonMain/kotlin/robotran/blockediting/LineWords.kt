package robotran.blockediting

import robotran.robolang.outline.PhrasePart
import robotran.robolang.words.KeywordPlaces
import robotran.robolang.words.Vocabulary

/** The words of a line of [text] with [parts], which has the words [from], in the words [to]. */
internal fun keywordPlaces(text: String, parts: List<PhrasePart>, from: Vocabulary, to: Vocabulary) =
    KeywordPlaces(text, leavesOf(parts).map { it.span }, from, to)

/** The parts that have no others inside, in the order of the text. */
private fun leavesOf(parts: List<PhrasePart>): List<PhrasePart> =
    parts.flatMap { if (it is PhrasePart.Value) leavesOf(it.value.parts) else listOf(it) }
