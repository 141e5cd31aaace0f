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
import robotran.projects.Feedback
import robotran.projects.HandIn
import robotran.ui.learning.MarkedText
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*

/**
 * The teacher's comment and the results in each world.
 *
 * @param isProgramHandedIn whether the program that is open came with it.
 */
@Composable
fun FeedbackCard(feedback: Feedback, isProgramHandedIn: Boolean) {
    Column(
        Modifier
            .fillMaxWidth()
            .testTag(AssignmentTags.ASSIGNMENT_FEEDBACK)
            .border(1.dp, LocalRobotranColours.current.line, Shapes.MEDIUM)
            .padding(12.dp),
        Arrangement.spacedBy(4.dp),
    ) {
        Line(SchoolTexts.assignmentFeedback(spoken), AssignmentTags.ASSIGNMENT_FEEDBACK_TITLE, isStrong = true)
        val comment = feedback.comment.trim().ifEmpty { SchoolTexts.assignmentFeedbackNone(spoken) }
        MarkedText(comment, Modifier.testTag(AssignmentTags.ASSIGNMENT_COMMENT))
        for (result in feedback.results) {
            val world = worldName(result.world)
            Line(
                SchoolTexts.assignmentFeedbackResult(spoken, world, result.seedsMet, result.seeds),
                AssignmentTags.ASSIGNMENT_RESULT,
            )
        }
        if (isProgramHandedIn) {
            Line(SchoolTexts.assignmentFeedbackProgram(spoken), AssignmentTags.ASSIGNMENT_FEEDBACK_PROGRAM)
        }
    }
}

/** Who has handed in what is open. */
@Composable
fun HandInLine(handIn: HandIn) {
    val words = when (handIn.tries) {
        0 -> SchoolTexts.assignmentIsHandInUntried(spoken, handIn.name)
        1 -> SchoolTexts.assignmentIsHandInOnce(spoken, handIn.name)
        else -> SchoolTexts.assignmentIsHandIn(spoken, handIn.name, handIn.tries)
    }
    Line(words, AssignmentTags.ASSIGNMENT_IS_HAND_IN)
}
