package robotran.ui.handins

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.ui.learning.DONE_ICON
import robotran.ui.parts.Icon
import robotran.ui.parts.SmallIcon
import robotran.ui.resources.*
import robotran.ui.theme.LineHeights
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.RobotranColours
import robotran.ui.theme.Shapes
import robotran.ui.theme.Space
import robotran.ui.theme.TextSizes
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
                color = colour,
                fontSize = TextSizes.COMPACT,
                lineHeight = LineHeights.TIGHT,
                fontWeight = FontWeight.Bold,
            )
        }
        Text(
            stringResource(if (count == null || count == 1) verdict.words else verdict.wordsOfSeveral),
            color = colour,
            fontSize = TextSizes.COMPACT,
            lineHeight = LineHeights.TIGHT,
            fontWeight = FontWeight.SemiBold,
        )
    }
}

/** As [words], behind a number greater than one. */
private val HandInVerdict.wordsOfSeveral: StringResource
    get() = when (this) {
        HandInVerdict.UNUSABLE -> Res.string.hand_ins_verdicts_unusable
        HandInVerdict.HAS_MISTAKES -> Res.string.hand_ins_verdicts_mistakes
        HandInVerdict.PARTLY -> Res.string.hand_ins_verdicts_partly
        HandInVerdict.PASSED -> Res.string.hand_ins_verdicts_passed
        HandInVerdict.WAITING -> Res.string.hand_ins_verdicts_waiting
        HandInVerdict.NOT_GRADED, HandInVerdict.MISSED -> words
    }

internal val HandInVerdict.words: StringResource
    get() = when (this) {
        HandInVerdict.UNUSABLE -> Res.string.hand_ins_verdict_unusable
        HandInVerdict.NOT_GRADED -> Res.string.hand_ins_verdict_not_graded
        HandInVerdict.HAS_MISTAKES -> Res.string.hand_ins_verdict_mistakes
        HandInVerdict.MISSED -> Res.string.hand_ins_verdict_missed
        HandInVerdict.PARTLY -> Res.string.hand_ins_verdict_partly
        HandInVerdict.PASSED -> Res.string.hand_ins_verdict_passed
        HandInVerdict.WAITING -> Res.string.hand_ins_verdict_waiting
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
