package robotran.ui.screen

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.material3.DropdownMenu
import androidx.compose.material3.DropdownMenuItem
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.stringResource
import robotran.ui.documents.WorkMenuItems
import robotran.ui.parts.Icon
import robotran.ui.parts.IconTouch
import robotran.ui.resources.Res
import robotran.ui.resources.edit_world
import robotran.ui.resources.first_page
import robotran.ui.resources.learn
import robotran.ui.resources.learning_examples
import robotran.ui.resources.learning_help
import robotran.ui.resources.menu
import robotran.ui.resources.settings_title
import robotran.ui.resources.sound_switch_off
import robotran.ui.resources.sound_switch_on
import robotran.ui.resources.worlds
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.Measures
import robotran.ui.workshop.LearningEvent
import robotran.ui.workshop.LearningPage
import robotran.ui.workshop.SettingsEvent
import robotran.ui.workshop.WorkshopEvent
import robotran.ui.workshop.WorkshopState
import robotran.ui.workshop.WorldEditEvent

/** The button with three lines: what is done seldom, and [withWork] what is done with the work as a whole. */
@Composable
internal fun MainMenu(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit, withWork: Boolean = false) {
    var open by remember { mutableStateOf(false) }
    val choose = { event: WorkshopEvent ->
        open = false
        onEvent(event)
    }
    Box {
        IconTouch(Icon.MENU, stringResource(Res.string.menu), "menu", { open = true })
        DropdownMenu(
            expanded = open,
            onDismissRequest = { open = false },
            modifier = Modifier.widthIn(min = 260.dp),
            containerColor = LocalRobotranColours.current.pane,
        ) {
            if (withWork) {
                WorkMenuItems(state.document, onEvent, { open = false })
                MenuDivider()
            }
            MenuItem(stringResource(Res.string.learn), "menu-learn") { choose(LearningEvent.PageWanted(LearningPage.TUTORIAL)) }
            MenuItem(stringResource(Res.string.worlds), "menu-worlds") { choose(LearningEvent.PageWanted(LearningPage.WORLDS)) }
            MenuItem(stringResource(Res.string.learning_examples), "menu-examples") {
                choose(LearningEvent.PageWanted(LearningPage.EXAMPLES))
            }
            MenuItem(stringResource(Res.string.learning_help), "menu-words") { choose(LearningEvent.PageWanted(LearningPage.HELP)) }
            if (state.worldEdit == null) {
                MenuItem(stringResource(Res.string.edit_world), "menu-edit-world") { choose(WorldEditEvent.EditorOpened) }
            }
            MenuItem(stringResource(Res.string.first_page), "menu-first-page") { choose(LearningEvent.PageWanted(LearningPage.FIRST_RUN)) }
            MenuDivider()
            val sound = if (state.soundOn) Res.string.sound_switch_off else Res.string.sound_switch_on
            MenuItem(stringResource(sound), "menu-sound") { choose(SettingsEvent.SoundSwitched(!state.soundOn)) }
            MenuItem(stringResource(Res.string.settings_title), "menu-settings") { choose(SettingsEvent.SettingsShown(true)) }
        }
    }
}

/** One thing that can be done, large enough for a finger. */
@Composable
internal fun MenuItem(text: String, tag: String, onClick: () -> Unit) = DropdownMenuItem(
    text = { Text(text, color = LocalRobotranColours.current.onPane, fontSize = 16.sp) },
    onClick = onClick,
    modifier = Modifier.testTag(tag).heightIn(min = Measures.TARGET),
)

@Composable
internal fun MenuDivider() = HorizontalDivider(Modifier.padding(vertical = 4.dp), color = LocalRobotranColours.current.line)
