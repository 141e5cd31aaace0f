package robotran.ui.program

import androidx.compose.ui.ImageComposeScene
import androidx.compose.ui.InternalComposeUiApi
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import kotlinx.coroutines.runBlocking
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.textediting.EditKind
import robotran.textediting.text.TextDocument
import robotran.ui.screen.keepAs
import robotran.ui.screen.photograph
import robotran.workshop.Workshop
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.examples.examples
import robotran.workshop.openWorkshop
import robotran.workshop.state.Pane
import kotlin.test.Test

/** Writes pictures of the program pane to build/pictures for review. */
@OptIn(InternalComposeUiApi::class)
class ProgramPictures {
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
        workshop.handle(ProgramEvent.DraftChanged(draft.withCaret(draft.text.indexOf("turn")), EditKind.OTHER))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(2_000)
        workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
    }

    @Test
    fun `what is offered can be photographed`() = photograph("offered", List(12) { Key.Tab }) { workshop ->
        val text = ProgramLanguage.JAVA.examples.getValue("WallBouncer.java")
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("WallBouncer.java", text)))
        val draft = workshop.state.programs.draft
        val place = draft.text.indexOf("Motor.A.") + "Motor.A.".length
        workshop.handle(ProgramEvent.DraftChanged(TextDocument(draft.text).withCaret(place), EditKind.OTHER))
    }

    @Test
    fun `lines in several rows, with a mistake, a selection and a breakpoint, can be photographed`() =
        photograph("rows") { workshop ->
            workshop.handle(ProgramEvent.ProgramEdited(LONG))
            workshop.write(LONG, caret = 70, anchor = 20)
            workshop.handle(ProgramEvent.BreakpointToggled(3))
        }

    private fun photograph(name: String, keys: List<Key> = emptyList(), prepare: (Workshop) -> Unit) {
        for (screen in Screen.entries) {
            val workshop = runBlocking { openWorkshop() }
            val settings = workshop.state.settings.copy(language = screen.language, textScale = screen.scale)
            workshop.handle(SettingsEvent.SettingsChanged(settings))
            prepare(workshop)
            workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
            photograph(workshop, screen.width, screen.height, screen.dark) { press(keys, it) }
                .keepAs("program/$name-${screen.name.lowercase()}")
            workshop.close()
        }
    }

    /** Presses the keys in order, then requests completions. */
    private fun press(keys: List<Key>, scene: ImageComposeScene) {
        keys.forEachIndexed { index, key ->
            scene.sendKeyEvent(KeyEvent(key, KeyEventType.KeyDown))
            scene.sendKeyEvent(KeyEvent(key, KeyEventType.KeyUp))
            scene.render(1_000_000_000L + (index + 1) * 50_000_000L)
        }
        if (keys.isEmpty()) return
        scene.sendKeyEvent(KeyEvent(Key.Spacebar, KeyEventType.KeyDown, isCtrlPressed = true))
        scene.render(2_000_000_000L + keys.size * 50_000_000L)
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

        val LONG = """
            wait until left bumper or right bumper or left bumper
            repeat 4 times
              if 20 > 10 and (left bumper or right bumper or not left bumper)
                forwrd 20 // a long remark that goes on and on until it needs a second row
              end
            end
        """.trimIndent()
    }
}
