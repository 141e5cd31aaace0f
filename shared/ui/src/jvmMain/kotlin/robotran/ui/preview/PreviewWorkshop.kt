package robotran.ui.preview

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.DisposableEffect
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import kotlinx.coroutines.runBlocking
import robotran.language.Language
import robotran.learning.WorldGallery
import robotran.ui.language.InLanguage
import robotran.ui.theme.RobotranTheme
import robotran.uikit.*
import robotran.workshop.Workshop
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.WorkshopState

/** Shows [content] in the light theme and below it in the dark theme, with the state after [prepare]. */
@Composable
internal fun PreviewWorkshop(prepare: Workshop.() -> Unit = {}, content: @Composable (WorkshopState) -> Unit) {
    val workshop = remember { runBlocking { openWorkshop() }.apply(prepare) }
    DisposableEffect(workshop) { onDispose { workshop.close() } }
    InLanguage(Language.ENGLISH) {
        Column {
            for (dark in listOf(false, true)) {
                RobotranTheme(dark) {
                    Box(Modifier.background(LocalRobotranColours.current.desk).padding(16.dp)) {
                        content(workshop.state)
                    }
                }
            }
        }
    }
}

/** Opens the world [name] of the gallery. */
internal fun Workshop.openGalleryWorld(name: String) {
    val world = checkNotNull(WorldGallery.named(name)) { "There is no world $name" }
    services.editor.changeWorld(world.world(Language.ENGLISH), isAnother = true)
}

/** Replaces the program by [text] and runs it for [milliseconds] of virtual time. */
internal fun Workshop.run(text: String, milliseconds: Int) {
    handle(ProgramEvent.ProgramEdited(text))
    handle(RunEvent.RunPressed)
    advance(milliseconds)
}
