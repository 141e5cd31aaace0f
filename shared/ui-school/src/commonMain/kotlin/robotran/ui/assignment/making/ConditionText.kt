package robotran.ui.assignment.making

import androidx.compose.runtime.Composable
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*

/** What went wrong, in the author's language; the phrase itself for a condition that the page does not offer. */
@Composable
internal fun conditionText(phrase: String?): String {
    val words = when (phrase) {
        null -> SchoolTexts::makeWhenAny
        "nothing changed" -> SchoolTexts::makeWhenNothingChanged
        "program failed" -> SchoolTexts::makeWhenProgramFailed
        "never moved" -> SchoolTexts::makeWhenNeverMoved
        "pen never down" -> SchoolTexts::makeWhenPenNeverDown
        "wrong port" -> SchoolTexts::makeWhenWrongPort
        "too short" -> SchoolTexts::makeWhenTooShort
        "too far" -> SchoolTexts::makeWhenTooFar
        "touched something" -> SchoolTexts::makeWhenTouchedSomething
        "hit a wall" -> SchoolTexts::makeWhenHitAWall
        "left the paper" -> SchoolTexts::makeWhenLeftThePaper
        "left its place" -> SchoolTexts::makeWhenLeftItsPlace
        "went where it must not" -> SchoolTexts::makeWhenWentWhereItMustNot
        "left the line" -> SchoolTexts::makeWhenLeftTheLine
        "wrong text" -> SchoolTexts::makeWhenWrongText
        "no sound" -> SchoolTexts::makeWhenNoSound
        "never stops" -> SchoolTexts::makeWhenNeverStops
        "too slow" -> SchoolTexts::makeWhenTooSlow
        "ended too early" -> SchoolTexts::makeWhenEndedTooEarly
        "word missing" -> SchoolTexts::makeWhenWordMissing
        "word used" -> SchoolTexts::makeWhenWordUsed
        else -> return phrase
    }
    return words(spoken)
}
