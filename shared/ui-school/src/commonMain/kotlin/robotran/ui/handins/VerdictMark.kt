package robotran.ui.handins

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import robotran.ui.learning.DONE_ICON
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.state.HandInVerdict

/** A verdict with its sign and its word. @param count how many have it; null for the verdict of one hand-in. */
@Composable
internal fun VerdictMark(verdict: HandInVerdict, modifier: Modifier = Modifier, count: Int? = null) {
    val colours = LocalRobotranColours.current
    val colour = verdict.colour(colours)
    Row(
        modifier
            .background(verdict.ground(colours), Shapes.SMALL)
            .border(1.dp, if (colours.isHighContrast) colours.line else verdict.ground(colours), Shapes.SMALL)
            .padding(horizontal = Space.SMALL, vertical = Space.TINY),
        Arrangement.spacedBy(6.dp),
        Alignment.CenterVertically,
    ) {
        SmallIcon(verdict.icon, colour, size = 18.dp)
        if (count != null) {
            Text(
                "$count",
                style = TextStyles.compact.copy(lineHeight = LineHeights.TIGHT, fontWeight = FontWeight.Bold),
                color = colour,
            )
        }
        Text(
            (if (count == null || count == 1) verdict.words else verdict.wordsOfSeveral)(spoken),
            style = TextStyles.compact.strong.copy(lineHeight = LineHeights.TIGHT),
            color = colour,
        )
    }
}

/** As [words], behind a number greater than one. */
private val HandInVerdict.wordsOfSeveral: Label
    get() = when (this) {
        HandInVerdict.UNUSABLE -> SchoolTexts::handInsVerdictsUnusable
        HandInVerdict.HAS_MISTAKES -> SchoolTexts::handInsVerdictsMistakes
        HandInVerdict.PARTLY -> SchoolTexts::handInsVerdictsPartly
        HandInVerdict.PASSED -> SchoolTexts::handInsVerdictsPassed
        HandInVerdict.WAITING -> SchoolTexts::handInsVerdictsWaiting
        HandInVerdict.NOT_GRADED, HandInVerdict.MISSED -> words
    }

internal val HandInVerdict.words: Label
    get() = when (this) {
        HandInVerdict.UNUSABLE -> SchoolTexts::handInsVerdictUnusable
        HandInVerdict.NOT_GRADED -> SchoolTexts::handInsVerdictNotGraded
        HandInVerdict.HAS_MISTAKES -> SchoolTexts::handInsVerdictMistakes
        HandInVerdict.MISSED -> SchoolTexts::handInsVerdictMissed
        HandInVerdict.PARTLY -> SchoolTexts::handInsVerdictPartly
        HandInVerdict.PASSED -> SchoolTexts::handInsVerdictPassed
        HandInVerdict.WAITING -> SchoolTexts::handInsVerdictWaiting
    }

/** Each has a shape of its own, so that nobody needs the colours. */
private val HandInVerdict.icon: Icon
    get() = when (this) {
        HandInVerdict.UNUSABLE, HandInVerdict.NOT_GRADED -> UNUSABLE_ICON
        HandInVerdict.HAS_MISTAKES -> MISTAKES_ICON
        HandInVerdict.MISSED -> Icon.CLOSE
        HandInVerdict.PARTLY -> PARTLY_ICON
        HandInVerdict.PASSED -> DONE_ICON
        HandInVerdict.WAITING -> Icon.MORE
    }

private fun HandInVerdict.colour(colours: RobotranColours): Color = when (this) {
    HandInVerdict.PASSED -> colours.good
    HandInVerdict.PARTLY, HandInVerdict.WAITING -> colours.onPane
    else -> colours.error
}

private fun HandInVerdict.ground(colours: RobotranColours): Color = when (this) {
    HandInVerdict.PASSED -> colours.goodPane
    HandInVerdict.PARTLY -> colours.invite
    HandInVerdict.WAITING -> colours.pane
    else -> colours.errorPane
}

/** A circle with a line through it. */
private val UNUSABLE_ICON = Icon.strokes("M8 4H16L20 8V16L16 20H8L4 16V8L8 4", "M7 17L17 7")

/** A triangle with an exclamation mark. */
private val MISTAKES_ICON = Icon.strokes("M12 4L21 20H3L12 4", "M12 10V14", "M12 17V17")

/** Half of a way. */
private val PARTLY_ICON = Icon.strokes("M4 12H20", "M12 6V18", "M4 8V16", "M20 8V16")
