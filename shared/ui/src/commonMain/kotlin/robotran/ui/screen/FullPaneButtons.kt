package robotran.ui.screen

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.selection.toggleable
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.unit.dp
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.screen.texts.ScreenTexts
import robotran.uikit.*
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.Pane

/** Gives the program, or the world, all the room; a second touch shows both again. */
@Composable
internal fun FullPaneButtons(full: Pane?, onEvent: (WorkshopEvent) -> Unit) {
    val put = { pane: Pane, isFull: Boolean -> onEvent(ScreenEvent.PaneFilled(pane.takeIf { isFull })) }
    FullPaneButton(
        PaneIcons.PROGRAM_FULL,
        ScreenTexts.fullProgram(spoken),
        ScreenTags.FULL_PROGRAM,
        full == Pane.PROGRAM,
    ) {
        put(Pane.PROGRAM, it)
    }
    FullPaneButton(PaneIcons.WORLD_FULL, ScreenTexts.fullWorld(spoken), ScreenTags.FULL_WORLD, full == Pane.WORLD) {
        put(Pane.WORLD, it)
    }
}

@Composable
private fun FullPaneButton(icon: Icon, label: String, tag: String, on: Boolean, onFull: (Boolean) -> Unit) {
    val colours = LocalRobotranColours.current
    val shape = RoundedCornerShape(CORNER)
    Box(
        Modifier
            .testTag(tag)
            .size(Dimensions.TARGET)
            .focusRing()
            .padding(INSET)
            .clip(shape)
            .background(if (on) colours.onPane else colours.pane)
            .toggleable(on, role = Role.Switch, onValueChange = onFull)
            .named(label),
        Alignment.Center,
    ) {
        val colour = if (on) colours.pane else colours.onPane
        IconView(icon, colour)
    }
}

private val CORNER = Corners.SMALL
private val INSET = 4.dp
