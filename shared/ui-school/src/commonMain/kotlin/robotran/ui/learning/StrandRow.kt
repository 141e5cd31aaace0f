package robotran.ui.learning

import androidx.compose.foundation.gestures.Orientation
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.rememberScrollState
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import robotran.learning.Lessons
import robotran.learning.Strand
import robotran.ui.school.tags.LearningTags
import robotran.ui.school.texts.LearningTexts
import robotran.uikit.*
import robotran.workshop.state.LearningState

/** The strands with their signs. A touch goes to one. */
@Composable
internal fun StrandRow(state: LearningState, onGo: (Strand) -> Unit) {
    val scroll = rememberScrollState()
    Row(
        Modifier
            .testTag(LearningTags.STRANDS)
            .scrollHint(scroll, Orientation.Horizontal)
            .horizontalScroll(scroll)
            .padding(horizontal = Space.LARGE, vertical = Space.TINY),
        Arrangement.spacedBy(Space.SMALL),
    ) {
        for (strand in Lessons.strands) StrandButton(strand, state) { onGo(strand) }
    }
    HorizontalDivider()
}

@Composable
private fun StrandButton(strand: Strand, state: LearningState, onClick: () -> Unit) {
    val title = strand.title(state.language)
    val words = LearningTexts.mapGoTo(spoken, title)
    ButtonFrame(LearningTags.goTo(strand.name), ButtonKind.EDITOR, Modifier.named(words), onClick = onClick) {
        SmallIcon(iconOf(strand.name), LocalRobotranColours.current.onPane)
        Spacer(Modifier.width(Space.SMALL))
        Text(title, style = TextStyles.compact.medium, maxLines = 1)
    }
}
