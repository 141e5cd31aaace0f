package robotran.ui.learning

import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.toPixelMap
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.ui.program.tags.ProgramTags
import robotran.ui.programlanguages.ExampleSet
import robotran.ui.school.tags.LearningTags
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.sheet.PictureBounds
import robotran.ui.sheet.SheetColours
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.LearningPage
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class ExamplesPageTest {
    @Test
    fun `an example is found in the menu and comes into a tab of its own`() = onTablet { workshop ->
        onNodeWithTag(ScreenTags.MENU).performClick()
        pass(300)
        onNodeWithTag(ScreenTags.MENU_EXAMPLES).performClick()
        pass(300)
        onNodeWithTag(LearningTags.example("countdown.robo")).performClick()
        pass(300)
        assertNull(workshop.state.learning.page)
        assertEquals(listOf("square.robo", "countdown.robo"), workshop.state.programs.programs.map { it.name })
        onNodeWithTag(ProgramTags.PROGRAM).assertIsDisplayed()
    }

    @Test
    fun `who works in Java finds the examples in Java first`() = onTablet { workshop ->
        workshop.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.JAVA))
        onNodeWithTag(ProgramTags.ADD_PROGRAM).performClick()
        pass(300)
        onNodeWithTag(ProgramTags.EXAMPLES).performClick()
        pass(300)
        onNodeWithTag(LearningTags.example("Countdown.java")).assertIsDisplayed().performClick()
        pass(300)
        assertEquals("Countdown.java", workshop.state.programName)
    }

    @Test
    fun `who works in NQC finds the examples in NQC first`() = onTablet { workshop ->
        workshop.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.NQC))
        workshop.handle(LearningEvent.PageRequested(LearningPage.EXAMPLES))
        pass(300)
        onNodeWithTag(LearningTags.example("countdown.nqc")).assertIsDisplayed().performClick()
        pass(300)
        assertEquals("countdown.nqc", workshop.state.programName)
        assertEquals(emptyList(), workshop.state.programs.diagnostics)
    }

    @Test
    fun `a robot with an NXT has its examples in Java first, and they run there`() = onTablet { workshop ->
        workshop.handle(DocumentEvent.NewWithBrick(BrickKind.NXT))
        workshop.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.JAVA))
        workshop.handle(LearningEvent.PageRequested(LearningPage.EXAMPLES))
        pass(300)
        onNodeWithTag(LearningTags.example("nxj/Hello.java")).assertIsDisplayed().performClick()
        pass(300)
        assertEquals("Hello.java", workshop.state.programName)
        runBlocking { workshop.compilePrograms() }
        assertEquals(emptyList(), workshop.state.programs.diagnostics)
        assertNull(workshop.state.programs.otherBrick)
    }

    @Test
    fun `an example that is there as it came is not put there twice, and a full brick is told`() {
        val workshop = runBlocking { openWorkshop() }
        workshop.handle(LearningEvent.ExampleChosen(ProgramLanguage.ROBOLANG, "square.robo", brick = BrickKind.RCX))
        assertEquals(1, workshop.state.programs.programs.size)
        repeat(4) { workshop.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.ROBOLANG)) }
        workshop.handle(LearningEvent.ExampleChosen(ProgramLanguage.ROBOLANG, "star.robo", brick = BrickKind.RCX))
        assertEquals(5, workshop.state.programs.programs.size)
        assertNotNull(workshop.state.notice)
        workshop.close()
    }

    @Test
    fun `pictures show what the examples draw, those in Java as their twins in Robolang`() = runBlocking {
        val square = ExamplePictures.of("square.robo", SheetColours.LIGHT, ROOM)
        val other = ExamplePictures.of("tree.robo", SheetColours.LIGHT, ROOM)
        assertTrue(square.pixels() != other.pixels())
        assertEquals(square.pixels(), ExamplePictures.of("Square.java", SheetColours.LIGHT, ROOM).pixels())
        val inNqc = ExamplePictures.of("square.nqc", SheetColours.LIGHT, ROOM)
        assertTrue(inNqc.pixels() != ExamplePictures.of("melody.nqc", SheetColours.LIGHT, ROOM).pixels())
        val empty = ExamplePictures.of("none.java", SheetColours.LIGHT, ROOM).pixels()
        for (name in listOf(
            "Spiral.java",
            "WallBouncer.java",
            "FirstDrive.java",
            "Patrol.java",
            "Shapes.java",
            "TwoThings.java",
        )) {
            assertTrue(ExamplePictures.of(name, SheetColours.LIGHT, ROOM).pixels() != empty, name)
        }
    }

    @Test
    fun `every example says what it does in every language, in English as its note does`() {
        for (set in ExampleSet.entries) {
            for ((name, text) in set.programs) {
                val note = text.lineSequence().takeWhile { it.startsWith("//") }
                    .joinToString(" ") { it.removePrefix("//").trim() }
                val said = Language.entries.map { aboutExample(set, name, it) }
                assertEquals(note.substringBefore(". ").removeSuffix("."), said.first(), name)
                assertEquals(said.size, said.distinct().size, name)
            }
        }
    }

    @Test
    fun `the page speaks the language that is chosen`() = onTablet { workshop ->
        workshop.handle(SettingsEvent.SettingsChanged(workshop.settings.copy(language = Language.GERMAN)))
        workshop.handle(LearningEvent.PageRequested(LearningPage.EXAMPLES))
        pass(300)
        onNodeWithText("Zählt von zehn rückwärts und hebt ab").assertExists()
    }

    private fun ImageBitmap.pixels(): List<Int> = toPixelMap().buffer.toList()

    private companion object {
        val ROOM = PictureBounds.of(320, 240, density = 1f)
    }
}
