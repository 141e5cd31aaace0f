package robotran.workshop.documents

import kotlinx.coroutines.runBlocking
import robotran.brick.program.StepKind
import robotran.language.Language
import robotran.learning.Lessons
import robotran.learning.WorldGallery
import robotran.programs.Program
import robotran.projects.LinkCreation
import robotran.projects.linkOf
import robotran.workshop.Workshop
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.platform.OpenedFile
import robotran.workshop.state.Notice
import robotran.workshop.state.Pane
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import robotran.world.file.writeWorld
import robotran.world.geometry.Point
import robotran.worldediting.PaletteItem
import robotran.worldediting.WorldEdit
import robotran.worldediting.piece
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** Loads another world from the gallery, a file or a link. */
class AnotherWorldTest {
    private val machine = Machine()

    /** A teacher's world. */
    private val corner = BuiltInWorlds.plain.copy(title = "Corner", task = "Drive into the corner.\nThen beep.")

    @Test
    fun `a world of one's own is kept when one of the gallery is chosen, and one touch brings it back`() {
        val workshop = machine.window()
        val own = workshop.build()
        workshop.handle(LearningEvent.WorldChosen("square"))
        assertEquals("square", WorldGallery.find(workshop.state.world)?.name)
        assertIs<Notice.EarlierProjectSaved>(workshop.state.notice)
        assertEquals(listOf("A square", "My first work"), workshop.projects().map { it.entry.name }.sorted())
        workshop.handle(WorkshopEvent.NoticeTaken)
        assertEquals(own, workshop.state.world)
        assertEquals("My first work", workshop.state.document.name)
    }

    @Test
    fun `the programs come along into the world that was chosen, and stay in the work before as well`() {
        val workshop = machine.window()
        workshop.write("forward 7")
        workshop.handle(LearningEvent.WorldChosen("maze"))
        assertEquals("forward 7", workshop.state.programText)
        workshop.write("forward 8")
        workshop.handle(DocumentEvent.SavedProjectChosen(workshop.projects().single { !it.isOpen }.entry.id))
        assertEquals("forward 7", workshop.state.programText)
        workshop.handle(DocumentEvent.SavedProjectChosen(workshop.projects().single { !it.isOpen }.entry.id))
        assertEquals("forward 8", workshop.state.programText)
    }

    @Test
    fun `the way back is offered until the pupil runs or changes the new project`() {
        val goingOn = mapOf<String, Workshop.() -> Unit>(
            "Run" to { handle(RunEvent.RunPressed) },
            "a step" to { handle(RunEvent.StepPressed(StepKind.entries.first())) },
            "the button of the brick" to { handle(RunEvent.ButtonPressed(state.run.brick.kind.startButton)) },
            "writing" to { handle(ProgramEvent.ProgramEdited("beep")) },
            "another program" to { handle(ProgramEvent.ProgramAdded(Program.of("other.robo", "beep"))) },
            "building" to { putBlock() },
        )
        for ((described, goOn) in goingOn) {
            val workshop = Machine().window()
            workshop.write("forward 7")
            workshop.handle(LearningEvent.WorldChosen("maze"))
            workshop.handle(ScreenEvent.TaskShown(false))
            workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
            assertIs<Notice.EarlierProjectSaved>(workshop.state.notice, "before $described")
            workshop.goOn()
            assertNull(workshop.state.notice, "after $described")
            workshop.close()
        }
    }

    @Test
    fun `no way back to a work before leads out of a lesson, a work of the list, or a new one`() {
        val leaving = mapOf<String, Workshop.() -> Unit>(
            "a lesson" to { handle(LearningEvent.TutorialStarted) },
            "a work of the list" to {
                handle(DocumentEvent.SavedProjectChosen(projects().single { !it.isOpen }.entry.id))
            },
            "a new one" to { handle(DocumentEvent.NewRequested) },
        )
        for ((described, leave) in leaving) {
            val workshop = Machine().window()
            workshop.write("forward 7")
            workshop.handle(LearningEvent.WorldChosen("maze"))
            workshop.leave()
            assertNull(workshop.state.notice, described)
            workshop.close()
        }
    }

    @Test
    fun `a lesson that is begun in a world that was only looked at leads back to the work before`() {
        val workshop = machine.window()
        val own = workshop.build()
        workshop.handle(LearningEvent.WorldChosen("maze"))
        workshop.handle(LearningEvent.TutorialStarted)
        workshop.handle(LearningEvent.TutorialClosed)
        assertEquals(own, workshop.state.world)
        assertEquals("My first work", workshop.state.document.name)
    }

    @Test
    fun `worlds that were only looked at do not fill My work, and the way back leads past them`() {
        val workshop = machine.window()
        val own = workshop.build()
        for (name in listOf("square", "maze", "slalom")) workshop.handle(LearningEvent.WorldChosen(name))
        assertEquals(2, workshop.projects().size)
        workshop.handle(WorkshopEvent.NoticeTaken)
        assertEquals(own, workshop.state.world)
        assertEquals(1, workshop.projects().size)
    }

    @Test
    fun `who has made nothing yet is told of nothing that is kept`() {
        val workshop = machine.window()
        workshop.handle(LearningEvent.WorldChosen("square"))
        assertNull(workshop.state.notice)
        assertEquals("A square", workshop.state.document.name)
    }

    @Test
    fun `a world file and a link to a world begin a work of their own, with the world before kept`() {
        val workshop = machine.window()
        val own = workshop.build()
        workshop.handle(
            DocumentEvent.FilesBrought(listOf(OpenedFile("corner.world.json", writeWorld(corner).encodeToByteArray()))),
        )
        assertEquals(corner, workshop.state.world)
        assertEquals("Corner", workshop.state.document.name)
        workshop.handle(WorkshopEvent.NoticeTaken)
        assertEquals(own, workshop.state.world)
        workshop.handle(DocumentEvent.LinkOpened(linkTo(corner)))
        assertEquals(corner, workshop.state.world)
        workshop.handle(WorkshopEvent.NoticeTaken)
        assertEquals(own, workshop.state.world)
    }

    @Test
    fun `a link that comes while the world is changed closes the editor, and what was built is kept`() {
        val workshop = machine.window()
        workshop.putBlock()
        val own = assertNotNull(workshop.state.worldEdit).world
        workshop.handle(DocumentEvent.LinkOpened(linkTo(corner)))
        assertNull(workshop.state.worldEdit)
        assertEquals(corner, workshop.state.world)
        workshop.handle(WorkshopEvent.NoticeTaken)
        assertEquals(own, workshop.state.world)
    }

    @Test
    fun `the task of a world that is opened is shown until it is put away, and folds when the program runs`() {
        val workshop = machine.window()
        assertFalse(workshop.state.taskShown)
        workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
        workshop.handle(DocumentEvent.LinkOpened(linkTo(corner)))
        assertTrue(workshop.state.taskShown)
        assertEquals(Pane.WORLD, workshop.state.pane)
        workshop.handle(RunEvent.RunPressed)
        assertTrue(workshop.state.taskShown && workshop.state.taskFolded)
        workshop.handle(LearningEvent.WorldChosen("square"))
        assertTrue(workshop.state.taskShown && !workshop.state.taskFolded)
        workshop.handle(ScreenEvent.TaskShown(false))
        workshop.handle(DocumentEvent.NewRequested)
        assertFalse(workshop.state.taskShown)
    }

    @Test
    fun `the tutorial folds when another world comes, and is there again with its step`() {
        val workshop = machine.window()
        workshop.handle(LearningEvent.TutorialStarted)
        workshop.handle(LearningEvent.StepChosen(2))
        workshop.write("forward 3")
        workshop.handle(DocumentEvent.LinkOpened(linkTo(corner)))
        val folded = assertNotNull(workshop.state.learning.tutorial)
        assertTrue(folded.isFolded && !folded.isLoaded)
        assertTrue(workshop.state.taskShown)
        workshop.handle(WorkshopEvent.NoticeTaken)
        val back = assertNotNull(workshop.state.learning.tutorial)
        assertTrue(back.isLoaded && !back.isFolded)
        assertEquals(Lessons.all[2], back.current)
        assertEquals("forward 3", workshop.state.programText)
    }

    @Test
    fun `what was written in a step comes back with the step, whatever came in between`() {
        val workshop = machine.window()
        workshop.handle(LearningEvent.TutorialStarted)
        workshop.write("forward 3")
        workshop.handle(DocumentEvent.LinkOpened(linkTo(corner)))
        workshop.handle(LearningEvent.StepTried)
        assertEquals("forward 3", workshop.state.programText)
    }

    @Test
    fun `the solution of a step is not taken for the pupil's program`() {
        val workshop = machine.window()
        workshop.handle(LearningEvent.TutorialStarted)
        workshop.write("forward 3")
        workshop.handle(LearningEvent.SolutionRequested(true))
        workshop.handle(DocumentEvent.LinkOpened(linkTo(corner)))
        workshop.handle(WorkshopEvent.NoticeTaken)
        assertEquals(true, workshop.state.learning.tutorial?.solutionShown)
        workshop.handle(LearningEvent.SolutionRequested(false))
        assertEquals("forward 3", workshop.state.programText)
    }

    /** Builds a world and returns it. */
    private fun Workshop.build(): World {
        putBlock()
        handle(WorldEditEvent.EditorClosed)
        keep()
        return state.world
    }

    private fun Workshop.putBlock() {
        handle(WorldEditEvent.EditorOpened)
        handle(WorldEditEvent.Edited(WorldEdit.Put(PaletteItem.BLOCK.piece(state.world), Point(30.0, 30.0))))
    }

    private fun linkTo(world: World): String = (
        runBlocking {
            linkOf(world, Language.ENGLISH)
        } as LinkCreation.Made
    ).fragment
}
