package robotran.ui.screen

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.dp
import robotran.ui.documents.ProjectMenu
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.screen.texts.ScreenTexts
import robotran.ui.world.texts.SheetTexts
import robotran.uikit.*
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.DocumentState
import robotran.workshop.state.LearningPage
import robotran.workshop.state.Pane

/**
 * The top of a screen with several panes: the menu, the project's name, the buttons that give one pane all the room, and
 * those for the other pages.
 */
@Composable
internal fun TopStrip(
    document: DocumentState,
    isEditingWorld: Boolean,
    fullPane: Pane?,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
) {
    val colours = LocalRobotranColours.current
    BoxWithConstraints(modifier.fillMaxWidth().background(colours.pane)) {
        val withWords = maxWidth >= WORDS_WIDTH * LocalDensity.current.fontScale
        Row(
            Modifier.fillMaxWidth().defaultMinSize(minHeight = Dimensions.TARGET),
            verticalAlignment = Alignment.CenterVertically,
        ) {
            MainMenu(document, isEditingWorld, onEvent)
            Box(Modifier.weight(1f)) { ProjectMenu(document, onEvent) }
            FullPaneButtons(fullPane, onEvent)
            IconButton(
                Icon.BOOK,
                ScreenTexts.learnHelp(spoken),
                ScreenTags.LEARN,
                label = ScreenTexts.learn(spoken).takeIf { withWords },
            ) {
                onEvent(LearningEvent.PageRequested(LearningPage.TUTORIAL))
            }
            IconButton(
                Icon.WORLDS,
                ScreenTexts.worldsHelp(spoken),
                ScreenTags.WORLDS,
                label = ScreenTexts.worlds(spoken).takeIf { withWords },
            ) {
                onEvent(LearningEvent.PageRequested(LearningPage.WORLDS))
            }
            if (!isEditingWorld) {
                IconButton(
                    Icon.SHEET_EDIT,
                    ScreenTexts.editWorldHelp(spoken),
                    ScreenTags.EDIT_WORLD,
                    label = SheetTexts.editWorld(spoken).takeIf { withWords },
                ) {
                    onEvent(WorldEditEvent.EditorOpened)
                }
            }
        }
    }
}

/** From this width on, at default font size, the buttons have labels. */
private val WORDS_WIDTH = 816.dp
