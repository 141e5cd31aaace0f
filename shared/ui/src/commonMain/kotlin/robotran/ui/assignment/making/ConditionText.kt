package robotran.ui.assignment.making

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.*

/** What went wrong, in the author's language; the phrase itself for a condition that the page does not offer. */
@Composable
internal fun conditionText(phrase: String?): String {
    val words = when (phrase) {
        null -> Res.string.make_when_any
        "nothing changed" -> Res.string.make_when_nothing_changed
        "program failed" -> Res.string.make_when_program_failed
        "never moved" -> Res.string.make_when_never_moved
        "pen never down" -> Res.string.make_when_pen_never_down
        "wrong port" -> Res.string.make_when_wrong_port
        "too short" -> Res.string.make_when_too_short
        "too far" -> Res.string.make_when_too_far
        "touched something" -> Res.string.make_when_touched_something
        "hit a wall" -> Res.string.make_when_hit_a_wall
        "left the paper" -> Res.string.make_when_left_the_paper
        "left its place" -> Res.string.make_when_left_its_place
        "went where it must not" -> Res.string.make_when_went_where_it_must_not
        "left the line" -> Res.string.make_when_left_the_line
        "wrong text" -> Res.string.make_when_wrong_text
        "no sound" -> Res.string.make_when_no_sound
        "never stops" -> Res.string.make_when_never_stops
        "too slow" -> Res.string.make_when_too_slow
        "ended too early" -> Res.string.make_when_ended_too_early
        "word missing" -> Res.string.make_when_word_missing
        "word used" -> Res.string.make_when_word_used
        else -> return phrase
    }
    return stringResource(words)
}
