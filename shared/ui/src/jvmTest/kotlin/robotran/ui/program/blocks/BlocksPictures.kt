package robotran.ui.program.blocks

import kotlinx.coroutines.runBlocking
import robotran.blockediting.BlockGroup
import robotran.language.Language
import robotran.projects.ProgramView
import robotran.ui.program.write
import robotran.ui.screen.keepAs
import robotran.ui.screen.photograph
import robotran.workshop.Workshop
import robotran.workshop.blocks.BlockCursor
import robotran.workshop.blocks.BlockPalette
import robotran.workshop.blocks.BlockSheet
import robotran.workshop.blocks.editableParts
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.AppTheme
import robotran.workshop.state.Pane
import kotlin.test.Test

/** Writes pictures of programs in blocks to build/pictures for review. */
class BlocksPictures {
    @Test
    fun `a program with mistakes and notes can be photographed`() = photograph("program", ProgramView.BLOCKS) {
        it.handle(ProgramEvent.BreakpointToggled(4))
        it.handle(RunEvent.RunPressed)
    }

    @Test
    fun `blocks beside the text can be photographed`() = photograph("both", ProgramView.BOTH) { }

    @Test
    fun `the palette can be photographed`() = photograph("palette", ProgramView.BLOCKS) {
        it.handle(BlockEvent.PaletteTurned(BlockPalette(BlockGroup.CONTROL)))
        it.handle(BlockEvent.SheetShown(BlockSheet.Palette))
    }

    @Test
    fun `the sheet of an angle can be photographed`() = photograph("angle", ProgramView.BLOCKS) { workshop ->
        val blocks = checkNotNull(workshop.state.programs.blocks)
        val line = blocks.program.outline.lines.first { "turn" in it.span.textIn(blocks.program.text) }
        val block = checkNotNull(blocks.program.blockOfLine(line.index))
        workshop.handle(BlockEvent.CursorPut(BlockCursor.At(block.id)))
        workshop.handle(BlockEvent.SheetShown(BlockSheet.Part(line.editableParts.last().span)))
    }

    private fun photograph(name: String, view: ProgramView, prepare: (Workshop) -> Unit) {
        for (screen in Screen.entries) {
            val workshop = runBlocking { openWorkshop() }
            val settings = workshop.state.settings
                .copy(language = screen.language, textScale = screen.scale, theme = screen.theme)
            workshop.handle(SettingsEvent.SettingsChanged(settings))
            workshop.write(PROGRAM, caret = 0)
            workshop.handle(BlockEvent.ViewChosen(view))
            prepare(workshop)
            workshop.handle(WorkshopEvent.PaneChosen(Pane.PROGRAM))
            photograph(workshop, screen.width, screen.height, screen.dark)
                .keepAs("blocks/$name-${screen.name.lowercase()}")
            workshop.close()
        }
    }

    private enum class Screen(
        val width: Int,
        val height: Int,
        val dark: Boolean,
        val language: Language = Language.ENGLISH,
        val scale: Float = 1f,
        val theme: AppTheme = AppTheme.SYSTEM,
    ) {
        PHONE(411, 891, false),
        TABLET(1280, 800, true),
        LAPTOP_GERMAN(1440, 900, false, Language.GERMAN),
        LAPTOP_CONTRAST(1440, 900, false, theme = AppTheme.HIGH_CONTRAST),
        PHONE_LARGE(411, 891, true, Language.SPANISH, 2f),
    }

    private companion object {
        val PROGRAM = """
            // draws a square
            const side = 20
            repeat 4 times
              forward side + 5 // one edge
              turn left 90
              if left bumper and not right bumper
                beep
              else
              end
            end
            forwrd 10
            play 440 for 1 second
            show "HELLO"
        """.trimIndent()
    }
}
