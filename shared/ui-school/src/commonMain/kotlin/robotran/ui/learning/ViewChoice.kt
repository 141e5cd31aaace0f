package robotran.ui.learning

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ColumnScope
import androidx.compose.foundation.layout.IntrinsicSize
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.selection.selectable
import androidx.compose.foundation.selection.selectableGroup
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.unit.dp
import robotran.projects.ProgramView
import robotran.ui.school.tags.LearningTags
import robotran.ui.school.texts.LearningTexts
import robotran.ui.texts.CommonTexts
import robotran.uikit.*

/**
 * Chooses between blocks and text.
 *
 * @param view how programs are shown now.
 * @param withPictures whether there is room for a picture of the same program in both.
 */
@Composable
internal fun ViewChoice(view: ProgramView, withPictures: Boolean, onView: (ProgramView) -> Unit) {
    val colours = LocalRobotranColours.current
    Column(verticalArrangement = Arrangement.spacedBy(Space.SMALL)) {
        Text(LearningTexts.view(spoken), Modifier.heading(), TextStyles.cardTitle.strong)
        BoxWithConstraints {
            if (maxWidth / LocalDensity.current.fontScale >= BESIDE_WIDTH) {
                Row(Modifier.height(IntrinsicSize.Max).selectableGroup(), Arrangement.spacedBy(GAP)) {
                    Views(view, withPictures, onView, Modifier.weight(1f).fillMaxHeight())
                }
            } else {
                Column(Modifier.selectableGroup(), Arrangement.spacedBy(GAP)) {
                    Views(view, withPictures, onView, Modifier.fillMaxWidth())
                }
            }
        }
        if (withPictures) {
            Text(LearningTexts.viewAgain(spoken), style = TextStyles.smallLines, color = colours.quiet)
        }
    }
}

@Composable
private fun Views(view: ProgramView, withPictures: Boolean, onView: (ProgramView) -> Unit, modifier: Modifier) {
    OneView(
        view == ProgramView.BLOCKS,
        CommonTexts.viewBlocks(spoken),
        LearningTexts.viewBlocks(spoken),
        LearningTags.FIRST_BLOCKS,
        { onView(ProgramView.BLOCKS) },
        modifier,
        withPictures,
    ) { BlocksPicture() }
    OneView(
        view == ProgramView.TEXT,
        CommonTexts.viewText(spoken),
        LearningTexts.viewText(spoken),
        LearningTags.FIRST_TEXT,
        { onView(ProgramView.TEXT) },
        modifier,
        withPictures,
    ) { TextPicture() }
}

@Composable
private fun OneView(
    isChosen: Boolean,
    title: String,
    help: String,
    tag: String,
    onClick: () -> Unit,
    modifier: Modifier,
    withPicture: Boolean,
    picture: @Composable ColumnScope.() -> Unit,
) {
    val colours = LocalRobotranColours.current
    Surface(
        modifier
            .testTag(tag)
            .focusRing(Corners.LARGE)
            .clip(Shapes.LARGE)
            .selectable(isChosen, role = Role.RadioButton, onClick = onClick),
        Shapes.LARGE,
        border = if (isChosen) edge(colours.focus, 3.dp) else edge(colours.quiet),
    ) {
        Column(Modifier.padding(Space.MEDIUM), Arrangement.spacedBy(Space.SMALL)) {
            if (withPicture) {
                Column(
                    Modifier.height(VIEW_PICTURE_HEIGHT).clearAndSetSemantics { },
                    Arrangement.spacedBy(Space.HAIR),
                    content = picture,
                )
            }
            Row(verticalAlignment = Alignment.CenterVertically, horizontalArrangement = Arrangement.spacedBy(8.dp)) {
                RadioMark(isChosen)
                Text(title, style = TextStyles.lead.strong)
            }
            if (withPicture) {
                Text(help, style = TextStyles.label)
            }
        }
    }
}

/** From this width on, at default font size, the two are side by side, also on a phone. */
private val BESIDE_WIDTH = 320.dp
private val GAP = 12.dp
