package robotran.ui.learning

import androidx.compose.foundation.BorderStroke
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
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Surface
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.stringResource
import robotran.projects.ProgramView
import robotran.ui.parts.RadioMark
import robotran.ui.resources.Res
import robotran.ui.resources.blocks_view_blocks
import robotran.ui.resources.blocks_view_text
import robotran.ui.resources.learning_view
import robotran.ui.resources.learning_view_again
import robotran.ui.resources.learning_view_blocks
import robotran.ui.resources.learning_view_text
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.focusRing

/** Chooses between blocks and text, each with a picture of the same program. [view] is how programs are shown now. */
@Composable
internal fun ViewChoice(view: ProgramView, onView: (ProgramView) -> Unit) {
    val colours = LocalRobotranColours.current
    Column(verticalArrangement = Arrangement.spacedBy(12.dp)) {
        Text(
            stringResource(Res.string.learning_view),
            Modifier.semantics { heading() },
            color = colours.onPane,
            fontSize = 18.sp,
            lineHeight = 24.sp,
            fontWeight = FontWeight.SemiBold,
        )
        BoxWithConstraints {
            if (maxWidth / LocalDensity.current.fontScale >= BESIDE_WIDTH) {
                Row(Modifier.height(IntrinsicSize.Max).selectableGroup(), Arrangement.spacedBy(GAP)) {
                    Views(view, onView, Modifier.weight(1f).fillMaxHeight())
                }
            } else {
                Column(Modifier.selectableGroup(), Arrangement.spacedBy(GAP)) {
                    Views(view, onView, Modifier.fillMaxWidth())
                }
            }
        }
        Text(
            stringResource(Res.string.learning_view_again),
            color = colours.quiet,
            fontSize = 16.sp,
            lineHeight = 22.sp,
        )
    }
}

@Composable
private fun Views(view: ProgramView, onView: (ProgramView) -> Unit, modifier: Modifier) {
    OneView(
        view == ProgramView.BLOCKS,
        stringResource(Res.string.blocks_view_blocks),
        stringResource(Res.string.learning_view_blocks),
        "first-blocks",
        { onView(ProgramView.BLOCKS) },
        modifier,
    ) { BlocksPicture() }
    OneView(
        view == ProgramView.TEXT,
        stringResource(Res.string.blocks_view_text),
        stringResource(Res.string.learning_view_text),
        "first-text",
        { onView(ProgramView.TEXT) },
        modifier,
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
    picture: @Composable ColumnScope.() -> Unit,
) {
    val colours = LocalRobotranColours.current
    Surface(
        modifier
            .testTag(tag)
            .focusRing(CORNER)
            .clip(RoundedCornerShape(CORNER))
            .selectable(isChosen, role = Role.RadioButton, onClick = onClick),
        shape = RoundedCornerShape(CORNER),
        color = colours.pane,
        border = if (isChosen) BorderStroke(3.dp, colours.focus) else BorderStroke(1.dp, colours.quiet),
    ) {
        Column(Modifier.padding(12.dp), Arrangement.spacedBy(8.dp)) {
            Column(
                Modifier.height(VIEW_PICTURE_HEIGHT).clearAndSetSemantics {
                },
                Arrangement.spacedBy(2.dp),
                content = picture,
            )
            Row(verticalAlignment = Alignment.CenterVertically, horizontalArrangement = Arrangement.spacedBy(8.dp)) {
                RadioMark(isChosen)
                Text(title, color = colours.onPane, fontSize = 18.sp, fontWeight = FontWeight.SemiBold)
            }
            Text(help, color = colours.onPane, fontSize = 16.sp, lineHeight = 22.sp)
        }
    }
}

/** From this width on, at default font size, the two are side by side, also on a phone. */
private val BESIDE_WIDTH = 320.dp
private val GAP = 12.dp
private val CORNER = 16.dp
