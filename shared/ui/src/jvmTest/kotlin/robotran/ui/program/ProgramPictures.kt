package robotran.ui.program

import androidx.compose.ui.ImageComposeScene
import androidx.compose.ui.InternalComposeUiApi
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.unit.Density
import kotlinx.coroutines.runBlocking
import org.jetbrains.skia.EncodedImageFormat
import robotran.editing.Draft
import robotran.editing.EditKind
import robotran.language.Language
import robotran.ui.RobotranApp
import robotran.ui.lejosExampleTexts
import robotran.ui.openWorkshop
import robotran.ui.screen.onEventThread
import robotran.ui.workshop.Pane
import robotran.ui.workshop.ProgramEvent
import robotran.ui.workshop.PupilProgram
import robotran.ui.workshop.RunEvent
import robotran.ui.workshop.SettingsEvent
import robotran.ui.workshop.Workshop
import robotran.ui.workshop.WorkshopEvent
import java.io.File
import kotlin.test.Test
import kotlin.test.assertTrue

/** Writes pictures of the program pane into build/pictures, to be looked at. */
@OptIn(InternalComposeUiApi::class)
class ProgramPictures {
    private val folder = File(System.getProperty("robotran.pictures")).apply { mkdirs() }

    @Test
    fun `mistakes, doubts and a breakpoint can be photographed`() = photograph("notes") { workshop ->
        workshop.handle(ProgramEvent.ProgramEdited(MISTAKEN))
        workshop.handle(ProgramEvent.BreakpointToggled(4))
        workshop.handle(RunEvent.RunPressed)
    }

    @Test
    fun `a translation and the line that runs can be photographed`() = photograph("translation") { workshop ->
        workshop.handle(ProgramEvent.TranslationShown(true))
        workshop.handle(ProgramEvent.BreakpointToggled(4))
        val draft = workshop.state.programs.draft
        workshop.handle(ProgramEvent.Written(draft.withCaret(draft.text.indexOf("turn")), EditKind.OTHER))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(2_000)
        workshop.handle(WorkshopEvent.PaneChosen(Pane.PROGRAM))
    }

    @Test
    fun `what is offered can be photographed`() = photograph("offered", List(12) { Key.Tab }) { workshop ->
        workshop.handle(ProgramEvent.ProgramAdded(PupilProgram("WallBouncer.java", lejosExampleTexts.getValue("WallBouncer.java"))))
        val draft = workshop.state.programs.draft
        val place = draft.text.indexOf("Motor.A.") + "Motor.A.".length
        workshop.handle(ProgramEvent.Written(Draft(draft.text).withCaret(place), EditKind.OTHER))
    }

    private fun photograph(name: String, keys: List<Key> = emptyList(), prepare: (Workshop) -> Unit) = onEventThread {
        for (screen in Screen.entries) {
            val workshop = runBlocking { openWorkshop() }
            val settings = workshop.state.settings.copy(language = screen.language, textScale = screen.scale)
            workshop.handle(SettingsEvent.SettingsChanged(settings))
            prepare(workshop)
            workshop.handle(WorkshopEvent.PaneChosen(Pane.PROGRAM))
            val scene = ImageComposeScene(screen.width, screen.height, Density(1f)) { RobotranApp(workshop, screen.dark) }
            try {
                scene.render()
                scene.render(nanoTime = 1_000_000_000)
                var time = 1_000_000_000L
                for (key in keys) {
                    scene.sendKeyEvent(KeyEvent(key, KeyEventType.KeyDown))
                    scene.sendKeyEvent(KeyEvent(key, KeyEventType.KeyUp))
                    time += 50_000_000
                    scene.render(time)
                }
                if (keys.isNotEmpty()) scene.sendKeyEvent(KeyEvent(Key.Spacebar, KeyEventType.KeyDown, isCtrlPressed = true))
                scene.render(time + 500_000_000)
                val image = scene.render(time + 1_000_000_000)
                val bytes = checkNotNull(image.encodeToData(EncodedImageFormat.PNG)).bytes
                File(folder, "program-$name-${screen.name.lowercase()}.png").writeBytes(bytes)
                assertTrue(bytes.size > 1000, "$name is empty")
            } finally {
                scene.close()
                workshop.close()
            }
        }
    }

    private enum class Screen(
        val width: Int,
        val height: Int,
        val dark: Boolean,
        val language: Language = Language.ENGLISH,
        val scale: Float = 1f,
    ) {
        PHONE(411, 891, false),
        TABLET(1280, 800, true),
        LAPTOP_GERMAN(1440, 900, false, Language.GERMAN),
        PHONE_LARGE(411, 891, true, Language.SPANISH, 2f),
    }

    private companion object {
        val MISTAKEN = """
            // draws a square
            const side = 20
            repeat 4 times
              forwrd side
              turn left 90
              wait 0 seconds
            end
            beep beep
            var x = 3.7
            show x
        """.trimIndent()
    }
}
