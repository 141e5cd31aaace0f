package robotran.ui.screen

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.widthIn
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawWithContent
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.ui.unit.dp
import robotran.editing.RobotTexts
import robotran.ui.documents.MoreProjectItems
import robotran.ui.documents.MoreSign
import robotran.ui.documents.ProjectMenuEntry
import robotran.ui.documents.ProjectMenuItems
import robotran.ui.documents.conditionOf
import robotran.ui.school.texts.LearningTexts
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.screen.texts.ScreenTexts
import robotran.ui.world.texts.SheetTexts
import robotran.uikit.*
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.RobotEditEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.DocumentState
import robotran.workshop.state.LearningPage

/**
 * The menu button: at most nine entries, among them, [withProject], that of the project. A few open a list of their own in
 * its place.
 */
@Composable
internal fun MainMenu(
    document: DocumentState,
    isEditingWorld: Boolean,
    onEvent: (WorkshopEvent) -> Unit,
    withProject: Boolean = false,
) {
    var open by remember { mutableStateOf(false) }
    var list by remember { mutableStateOf(MenuList.MAIN) }
    val choose = { event: WorkshopEvent ->
        open = false
        onEvent(event)
    }
    Box {
        MenuButton(document, withProject) {
            list = MenuList.MAIN
            open = true
        }
        AppMenu(open, {
            open = false
        }, Modifier.widthIn(min = 260.dp).testTag(ScreenTags.MENU_ITEMS), page = list) {
            // First, so that a double tap returns instead of changing the project.
            if (list != MenuList.MAIN) {
                BackItem { list = if (list == MenuList.MORE) MenuList.PROJECT else MenuList.MAIN }
                MenuDivider()
            }
            when (list) {
                MenuList.MAIN -> {
                    if (withProject) {
                        ProjectMenuEntry(document) { list = MenuList.PROJECT }
                        MenuDivider()
                    }
                    MainMenuItems(isEditingWorld, choose) { list = MenuList.BUILD }
                }

                MenuList.BUILD -> BuildItems(choose)
                MenuList.PROJECT -> ProjectMenuItems(document, choose) { list = MenuList.MORE }
                MenuList.MORE -> MoreProjectItems(document, choose)
            }
        }
    }
}

/** What the menu shows. */
private enum class MenuList {
    MAIN,

    /** What can be built: a world, a robot. */
    BUILD,
    PROJECT,

    /** More of the project. */
    MORE,
}

@Composable
private fun MainMenuItems(isEditingWorld: Boolean, choose: (WorkshopEvent) -> Unit, onBuild: () -> Unit) {
    MenuItem(LearningTexts.map(spoken), ScreenTags.MENU_MAP) {
        choose(LearningEvent.PageRequested(LearningPage.MAP))
    }
    MenuItem(ScreenTexts.worlds(spoken), ScreenTags.MENU_WORLDS) {
        choose(LearningEvent.PageRequested(LearningPage.WORLDS))
    }
    MenuItem(LearningTexts.examples(spoken), ScreenTags.MENU_EXAMPLES) {
        choose(LearningEvent.PageRequested(LearningPage.EXAMPLES))
    }
    MenuItem(LearningTexts.help(spoken), ScreenTags.MENU_WORDS) {
        choose(LearningEvent.PageRequested(LearningPage.HELP))
    }
    if (!isEditingWorld) {
        MenuItem(ScreenTexts.buildMenu(spoken), ScreenTags.MENU_BUILD, trailing = { MoreSign() }, onClick = onBuild)
    }
    MenuItem(ScreenTexts.firstPage(spoken), ScreenTags.MENU_FIRST_PAGE) {
        choose(LearningEvent.PageRequested(LearningPage.FIRST_RUN))
    }
    MenuDivider()
    MenuItem(ScreenTexts.settingsTitle(spoken), ScreenTags.MENU_SETTINGS) { choose(SettingsEvent.SettingsShown(true)) }
    MenuItem(LearningTexts.teachers(spoken), ScreenTags.MENU_TEACHERS) {
        choose(LearningEvent.PageRequested(LearningPage.TEACHERS))
    }
}

@Composable
private fun BuildItems(choose: (WorkshopEvent) -> Unit) {
    MenuItem(SheetTexts.editWorld(spoken), ScreenTags.MENU_EDIT_WORLD) { choose(WorldEditEvent.EditorOpened) }
    MenuItem(RobotTexts.buildMenu(spoken), ScreenTags.MENU_BUILD_ROBOT) { choose(RobotEditEvent.BenchOpened()) }
}

/** Marked if the menu contains the project and autosave fails. */
@Composable
private fun MenuButton(document: DocumentState, withProject: Boolean, onClick: () -> Unit) {
    val sign = LocalRobotranColours.current.error
    val condition = conditionOf(document).takeIf { withProject && document.error != null }
    val modifier = if (condition == null) {
        Modifier
    } else {
        Modifier.semantics { stateDescription = condition }.drawWithContent {
            drawContent()
            drawCircle(sign, SIGN.toPx() / 2, Offset(size.width - SIGN.toPx(), SIGN.toPx()))
        }
    }
    IconButton(Icon.MENU, ScreenTexts.menu(spoken), ScreenTags.MENU, modifier = modifier, onClick = onClick)
}

/** Returns from a submenu to the main list. */
@Composable
private fun BackItem(onClick: () -> Unit) = MenuItem(
    ScreenTexts.menu(spoken),
    ScreenTags.MENU_BACK,
    leading = { SmallIcon(Icon.BACK, LocalRobotranColours.current.onPane) },
    onClick = onClick,
)

private val SIGN = 10.dp
