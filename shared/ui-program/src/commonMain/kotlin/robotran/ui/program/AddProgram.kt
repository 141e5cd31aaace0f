package robotran.ui.program

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.runtime.staticCompositionLocalOf
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.programs.support
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.EditorTexts
import robotran.ui.programlanguages.texts
import robotran.ui.texts.NqcTexts
import robotran.uikit.*
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.LearningPage
import robotran.workshop.state.ProgramsState

/** The plus button: a new program in any language, an example, or another file of a program. */
@Composable
internal fun AddProgram(state: ProgramsState, onEvent: (WorkshopEvent) -> Unit) {
    var open by remember { mutableStateOf(false) }
    val choose = { event: WorkshopEvent ->
        open = false
        onEvent(event)
    }
    Box {
        IconButton(ThinIcons.PLUS, EditorTexts.programAdd(spoken), ProgramTags.ADD_PROGRAM, IconButtonKind.SMALL) {
            open =
                true
        }
        AppMenu(
            expanded = open,
            onDismissRequest = { open = false },
            modifier = Modifier.widthIn(min = 300.dp),
        ) {
            if (state.hasRoom) NewPrograms(state.brick, choose) else Note(EditorTexts.programNoRoom(spoken))
            state.program.language.texts.newFile?.let { words ->
                MenuItem(words(spoken), ProgramTags.NEW_CLASS) { choose(ProgramEvent.FileAdded) }
            }
            state.closed?.takeIf { state.canReopen }?.let { closed ->
                MenuItem(EditorTexts.programReopenNamed(spoken, closed), ProgramTags.REOPEN_CLOSED) {
                    choose(ProgramEvent.ProgramReopened)
                }
            }
            if (state.hasRoom) {
                HorizontalDivider()
                MenuItem(EditorTexts.programExamples(spoken), ProgramTags.EXAMPLES) {
                    choose(LearningEvent.PageRequested(LearningPage.EXAMPLES))
                }
            }
        }
    }
}

/** The languages in which an assignment lets pupils write; null for all. */
val LocalAllowedLanguages = staticCompositionLocalOf<List<ProgramLanguage>?> { null }

/** What is for experts is for the few who ask for more. */
@Composable
private fun NewPrograms(brick: BrickKind, onEvent: (WorkshopEvent) -> Unit) {
    var hasMore by remember { mutableStateOf(false) }
    val allowed = LocalAllowedLanguages.current ?: ProgramLanguage.entries
    val languages = ProgramLanguage.entries.filter { it in allowed && brick in it.support.bricks }
    for (language in languages) {
        if (language.support.isForExperts && languages.size > 1 && !hasMore) {
            MenuItem(NqcTexts.programNewMore(spoken), ProgramTags.NEW_MORE) { hasMore = true }
        } else {
            MenuItem(language.texts.newProgram(spoken), ProgramTags.new(language)) {
                onEvent(ProgramEvent.NewProgramRequested(language))
            }
        }
    }
}

@Composable
private fun Note(text: String) {
    val colour = LocalRobotranColours.current.quiet
    Text(text, Modifier.padding(12.dp).widthIn(max = 300.dp), TextStyles.small.medium, color = colour)
}
