package robotran.ui.program.blocks

import kotlinx.coroutines.runBlocking
import robotran.blockediting.BlockId
import robotran.brick.program.StepKind
import robotran.language.Language
import robotran.projects.ProgramView
import robotran.robolang.words.BlockGroup
import robotran.ui.program.write
import robotran.ui.screen.keepAs
import robotran.ui.screen.photograph
import robotran.uikit.*
import robotran.workshop.Workshop
import robotran.workshop.blocks.BlockCursor
import robotran.workshop.blocks.BlockDialog
import robotran.workshop.blocks.BlockPalette
import robotran.workshop.blocks.editableParts
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.AppTheme
import robotran.workshop.state.Pane
import kotlin.test.Test

/** Writes pictures of programs in blocks to build/pictures for review. */
class BlocksPictures {
    @Test
    fun `a program with mistakes and notes can be photographed`() = photograph("program") {
        it.handle(ProgramEvent.BreakpointToggled(4))
        it.handle(RunEvent.RunPressed)
    }

    @Test
    fun `a longer program can be photographed`() = photograph("long", text = LONG) { workshop ->
        workshop.at("repeat until")
    }

    @Test
    fun `a program without blocks can be photographed`() = photograph("empty", text = "") { }

    @Test
    fun `folded blocks and a running line can be photographed`() = photograph("folded", text = LONG) { workshop ->
        val blocks = checkNotNull(workshop.state.programs.blocks)
        workshop.handle(BlockEvent.Folded(checkNotNull(blocks.program.blockOfLine(3)).id))
        workshop.handle(ProgramEvent.BreakpointToggled(2))
        workshop.handle(RunEvent.StepPressed(StepKind.INTO))
    }

    @Test
    fun `what the search has found can be photographed`() = photograph("found", text = LONG) { workshop ->
        val start = LONG.indexOf("turn")
        workshop.write(LONG, caret = start + "turn".length, anchor = start)
        workshop.handle(ProgramEvent.SearchRequested)
    }

    @Test
    fun `blocks beside the text can be photographed`() = photograph("both", ProgramView.BOTH) { }

    @Test
    fun `the palette can be photographed`() = photograph("palette") {
        it.handle(BlockEvent.PaletteGroupSelected(BlockPalette(BlockGroup.CONTROL)))
        it.handle(BlockEvent.DialogShown(BlockDialog.Palette))
    }

    @Test
    fun `the sheet of an angle can be photographed`() = photograph("angle") { it.openSheetAt("turn") }

    @Test
    fun `the sheet of a length can be photographed`() = photograph("length", text = LONG) { it.openSheetAt("forward") }

    @Test
    fun `the sheet of a condition can be photographed`() = photograph("condition") { it.openSheetAt("if left") }

    @Test
    fun `the sheet of a condition of a robot with a sonar can be photographed`() = photograph("condition-nxt") {
        it.handle(LearningEvent.WorldChosen("nxt-wall"))
        it.openSheetAt("if left")
    }

    @Test
    fun `what senses on a robot with a sonar can be photographed`() = photograph("sense-nxt") {
        it.handle(LearningEvent.WorldChosen("nxt-wall"))
        it.handle(BlockEvent.PaletteGroupSelected(BlockPalette(BlockGroup.SENSE)))
        it.handle(BlockEvent.DialogShown(BlockDialog.Palette))
    }

    @Test
    fun `the menu of a choice can be photographed`() = photograph("choice") { it.openSheetAt("turn", part = 0) }

    @Test
    fun `the menu of a name can be photographed`() = photograph("name", text = LONG) {
        it.openSheetAt("steps =", part = 0)
    }

    @Test
    fun `what can be done to a block can be photographed`() = photograph("actions") { workshop ->
        val block = workshop.at("turn")
        workshop.handle(BlockEvent.DialogShown(BlockDialog.Actions(block)))
    }

    private fun Workshop.at(label: String): BlockId {
        val blocks = checkNotNull(state.programs.blocks)
        val line = blocks.program.outline.lines.first { label in it.span.textIn(blocks.program.text) }
        val block = checkNotNull(blocks.program.blockOfLine(line.index)).id
        handle(BlockEvent.CursorPut(BlockCursor.At(block)))
        return block
    }

    /** Opens the sheet of a part of the first line with [label], the last one if [part] is not given. */
    private fun Workshop.openSheetAt(label: String, part: Int? = null) {
        at(label)
        val blocks = checkNotNull(state.programs.blocks)
        val line = blocks.program.outline.lines.first { label in it.span.textIn(blocks.program.text) }
        val parts = line.editableParts
        handle(BlockEvent.DialogShown(BlockDialog.Part(parts[part ?: parts.lastIndex].span)))
    }

    private fun photograph(
        name: String,
        view: ProgramView = ProgramView.BLOCKS,
        text: String = PROGRAM,
        prepare: (Workshop) -> Unit,
    ) {
        for (screen in Screen.entries) {
            val workshop = runBlocking { openWorkshop() }
            val settings = workshop.state.settings
                .copy(language = screen.language, textScale = screen.scale, theme = screen.theme)
            workshop.handle(SettingsEvent.SettingsChanged(settings))
            workshop.write(text, caret = 0)
            workshop.handle(BlockEvent.ViewChosen(view))
            prepare(workshop)
            workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
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
        PHONE_SMALL(360, 640, false),
        PHONE_ACROSS(891, 411, false),
        PHONE_ACROSS_SMALL(640, 360, false, Language.GERMAN),
        PHONE_ACROSS_LARGE(740, 360, false, Language.GERMAN, 2f),
        TABLET(1280, 800, true),
        TABLET_UPRIGHT(820, 1180, false),
        LAPTOP_GERMAN(1440, 900, false, Language.GERMAN),
        TABLET_CONTRAST(1280, 800, false, theme = AppTheme.HIGH_CONTRAST),
        PHONE_CONTRAST(411, 891, true, theme = AppTheme.HIGH_CONTRAST_DARK),
        PHONE_LARGE(411, 891, true, Language.SPANISH, 2f),
        TABLET_LARGE(1280, 800, false, Language.GERMAN, 2f),
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
        val LONG = """
            // finds the way out of the maze
            var steps = 0
            var found = [3, 5, 8]
            repeat until light < 40
              forward 25
              steps = steps + 1
              if left bumper
                backward 5
                turn right 90
              else if right bumper
                backward 5
                turn left 90
              else
                pen down
              end
            end
            dance(4)

            procedure dance(rounds)
              repeat rounds times
                turn right 360
                play 523 for 0.5 seconds
              end
            end
        """.trimIndent()
    }
}
