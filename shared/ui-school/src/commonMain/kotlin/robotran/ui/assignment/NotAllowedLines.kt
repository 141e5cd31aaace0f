package robotran.ui.assignment

import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.assignments.doing.NotAllowed
import robotran.ui.learning.MarkedText
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*

/**
 * What the programs have that the assignment does not allow, a warning each.
 *
 * @param onShow shows one in its program; null if the lines are only to be read.
 */
@Composable
internal fun NotAllowedLines(all: List<NotAllowed>, onShow: ((NotAllowed) -> Unit)? = null) {
    for (found in all) {
        val touch = if (onShow == null) {
            Modifier.padding(vertical = 2.dp)
        } else {
            Modifier
                .fillMaxWidth()
                .focusRing()
                .clickable(role = Role.Button) { onShow(found) }
                .heightIn(min = Dimensions.TARGET)
                .padding(vertical = 10.dp)
        }
        Row(
            Modifier.testTag(AssignmentTags.ASSIGNMENT_NOT_ALLOWED).then(touch).semantics(mergeDescendants = true) {
                liveRegion = LiveRegionMode.Polite
            },
            Arrangement.spacedBy(8.dp),
        ) {
            MarkedText("⚠", colour = LocalRobotranColours.current.error)
            MarkedText(notAllowedText(found))
        }
    }
}

@Composable
private fun notAllowedText(found: NotAllowed): String = when (found) {
    is NotAllowed.HasWord -> {
        SchoolTexts.assignmentNotAllowedWord(spoken, found.program, found.line, found.word)
    }

    is NotAllowed.InLanguage -> {
        SchoolTexts.assignmentNotAllowedLanguage(spoken, found.program, found.language.ownName)
    }
}

/** All that is not allowed in [program], below its text, at most [maxHeight] high; the rest scrolls. */
@Composable
fun NotAllowedStrip(all: List<NotAllowed>, program: String, maxHeight: Dp, onShow: (NotAllowed) -> Unit) {
    val own = all.filter { it.program == program }.ifEmpty { return }
    val colours = LocalRobotranColours.current
    val scroll = rememberScrollState()
    Column(
        Modifier
            .fillMaxWidth()
            .heightIn(max = maxHeight)
            .background(colours.errorPane)
            .testTag(AssignmentTags.PROGRAM_NOT_ALLOWED)
            .scrollHint(scroll, ground = colours.errorPane)
            .verticalScroll(scroll)
            .padding(horizontal = 16.dp),
    ) { NotAllowedLines(own, onShow) }
}
