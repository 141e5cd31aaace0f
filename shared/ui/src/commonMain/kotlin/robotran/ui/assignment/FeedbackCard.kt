package robotran.ui.assignment

import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.stringResource
import robotran.projects.Feedback
import robotran.projects.HandIn
import robotran.ui.learning.MarkedText
import robotran.ui.resources.*
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.Shapes

/**
 * The teacher's comment and the results in each world.
 *
 * @param isProgramHandedIn whether the program that is open came with it.
 */
@Composable
internal fun FeedbackCard(feedback: Feedback, isProgramHandedIn: Boolean) {
    Column(
        Modifier
            .fillMaxWidth()
            .testTag("assignment-feedback")
            .border(1.dp, LocalRobotranColours.current.line, Shapes.MEDIUM)
            .padding(12.dp),
        Arrangement.spacedBy(4.dp),
    ) {
        Line(stringResource(Res.string.assignment_feedback), "assignment-feedback-title", isStrong = true)
        val comment = feedback.comment.trim().ifEmpty { stringResource(Res.string.assignment_feedback_none) }
        MarkedText(comment, Modifier.testTag("assignment-comment"))
        for (result in feedback.results) {
            val world = worldName(result.world)
            Line(
                stringResource(Res.string.assignment_feedback_result, world, result.seedsMet, result.seeds),
                "assignment-result",
            )
        }
        if (isProgramHandedIn) {
            Line(stringResource(Res.string.assignment_feedback_program), "assignment-feedback-program")
        }
    }
}

/** Who has handed in what is open. */
@Composable
internal fun HandInLine(handIn: HandIn) {
    val words = when (handIn.tries) {
        0 -> stringResource(Res.string.assignment_is_hand_in_untried, handIn.name)
        1 -> stringResource(Res.string.assignment_is_hand_in_once, handIn.name)
        else -> stringResource(Res.string.assignment_is_hand_in, handIn.name, handIn.tries)
    }
    Line(words, "assignment-is-hand-in")
}
