package robotran.workshop.blocks

import kotlinx.coroutines.runBlocking
import robotran.language.ProgramLanguage
import robotran.projects.ProgramView
import robotran.projects.Project
import robotran.workshop.Workshop
import robotran.workshop.documents.Machine
import robotran.workshop.documents.keep
import robotran.workshop.documents.projectFile
import robotran.workshop.documents.projects
import robotran.workshop.documents.write
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.openWorkshop
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.platform.MemoryStore
import robotran.workshop.platform.OpenRequest
import robotran.workshop.platform.OpenedFile
import robotran.world.RobotColour
import robotran.world.RobotPlacement
import robotran.world.geometry.Pose
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull

class RememberedViewTest {
    private val machine = Machine()
    private val Workshop.view: ProgramView get() = state.programs.view

    private fun Workshop.show(view: ProgramView) = handle(BlockEvent.ViewChosen(view))

    private fun Workshop.choose(program: Int) = handle(ProgramEvent.ProgramChosen(program))

    private fun Workshop.addProgram(language: ProgramLanguage = ProgramLanguage.ROBOLANG) =
        handle(ProgramEvent.NewProgramRequested(language))

    private fun Workshop.closedAndOpenedAgain(): Workshop {
        runBlocking { closeDocument() }
        return machine.window()
    }

    @Test
    fun `each program is shown at the next start as it was shown at the end of the last one`() {
        val first = machine.window()
        first.write("forward 7")
        first.addProgram()
        first.show(ProgramView.BLOCKS)
        first.addProgram()
        first.show(ProgramView.BOTH)
        first.keep()
        val second = first.closedAndOpenedAgain()
        val views = (0..2).map {
            second.choose(it)
            second.view
        }
        assertEquals(listOf(ProgramView.TEXT, ProgramView.BLOCKS, ProgramView.BOTH), views)
        assertNotNull(second.state.programs.blocks)
    }

    @Test
    fun `the programs of each robot are remembered in their own view`() {
        val first = machine.window()
        val world = first.state.world
        val red = RobotPlacement(Pose(20.0, 20.0, 0.0), "red", RobotColour.RED)
        first.services.editor.openProject(Project(world.copy(robots = world.robots + red)))
        first.handle(ProgramEvent.RobotChosen("red"))
        first.write("beep")
        first.show(ProgramView.BLOCKS)
        first.handle(ProgramEvent.RobotChosen(world.robots.first().name))
        first.write("buzz")
        first.show(ProgramView.BOTH)
        first.keep()
        val second = first.closedAndOpenedAgain()
        assertEquals(ProgramView.BOTH, second.view)
        second.handle(ProgramEvent.RobotChosen("red"))
        assertEquals("beep", second.state.programText)
        assertEquals(ProgramView.BLOCKS, second.view)
    }

    @Test
    fun `choosing a view is work that is saved`() {
        val first = machine.window()
        first.write("forward 7")
        first.show(ProgramView.BLOCKS)
        first.show(ProgramView.TEXT)
        first.show(ProgramView.BOTH)
        assertEquals(ProgramView.BOTH, first.closedAndOpenedAgain().view)
    }

    @Test
    fun `a view that was chosen where nothing was made yet is no work, and is remembered all the same`() {
        val first = machine.window()
        first.show(ProgramView.BLOCKS)
        first.keep()
        assertEquals(emptyList(), first.projects())
        assertEquals(ProgramView.BLOCKS, first.closedAndOpenedAgain().view)
    }

    @Test
    fun `worlds that were only looked at do not fill My work because of a view`() {
        val workshop = machine.window()
        workshop.write("forward 7")
        for (world in listOf("square", "maze", "slalom")) {
            workshop.handle(LearningEvent.WorldChosen(world))
            workshop.show(if (world == "maze") ProgramView.TEXT else ProgramView.BLOCKS)
            workshop.keep()
        }
        assertEquals(2, workshop.projects().size)
    }

    @Test
    fun `a new program is shown as was chosen last, also after a program in Java`() {
        val workshop = machine.window()
        workshop.show(ProgramView.BLOCKS)
        workshop.addProgram(ProgramLanguage.JAVA)
        assertEquals(ProgramView.TEXT, workshop.view)
        workshop.addProgram()
        assertEquals(ProgramView.BLOCKS, workshop.view)
    }

    @Test
    fun `a shared program comes in blocks if it was shared in blocks`() {
        val teacher = machine.window()
        teacher.write("forward 7")
        teacher.show(ProgramView.BLOCKS)
        teacher.handle(DocumentEvent.LinkRequested)
        teacher.handle(DocumentEvent.LinkCopied)
        val link = assertNotNull(machine.clipboard.text)
        val pupil = Machine().window(OpenRequest.OfLink(link.substring(link.indexOf('#'))))
        assertEquals("forward 7", pupil.state.programText)
        assertEquals(ProgramView.BLOCKS, pupil.view)
        assertEquals(ProgramView.TEXT, pupil.state.settings.programView)
    }

    @Test
    fun `a file that says nothing of a view is shown as its reader is used to`() {
        for (view in ProgramView.entries) {
            val workshop = machine.window()
            workshop.show(view)
            workshop.handle(DocumentEvent.FilesBrought(listOf(projectFile("forward 9"))))
            assertEquals("forward 9", workshop.state.programText)
            assertEquals(view, workshop.view)
        }
    }

    @Test
    fun `a view of a later Robotran is shown as the reader is used to`() {
        val file = projectFile("forward 9")
        val later = file.bytes.decodeToString().replace("\"robolang\"", "\"robolang\", \"view\": \"flowchart\"")
        val workshop = machine.window()
        workshop.show(ProgramView.BOTH)
        workshop.handle(DocumentEvent.FilesBrought(listOf(OpenedFile(file.name, later.encodeToByteArray(), null))))
        assertEquals("forward 9", workshop.state.programText)
        assertEquals(ProgramView.BOTH, workshop.view)
    }

    @Test
    fun `the first program is in blocks where there are only fingers, and text where there is a keyboard`() {
        assertEquals(ProgramView.BLOCKS, onMachine(isForFingers = true).view)
        assertEquals(ProgramView.TEXT, onMachine(isForFingers = false).view)
    }

    @Test
    fun `what was chosen once counts more than what the machine is like`() {
        val store = MemoryStore()
        val first = onMachine(isForFingers = true, store)
        first.show(ProgramView.TEXT)
        runBlocking { first.saveDocumentNow() }
        assertEquals(ProgramView.TEXT, onMachine(isForFingers = true, store).view)
    }

    @Test
    fun `a setting that is unknown costs no other setting`() {
        val store = MemoryStore()
        runBlocking { store.write("settings", """{ "programView": "FLOWCHART", "lessMotion": true }""") }
        val workshop = onMachine(isForFingers = false, store)
        assertEquals(ProgramView.TEXT, workshop.view)
        assertEquals(true, workshop.state.settings.lessMotion)
    }

    @Test
    fun `the tutorial's programs and its words are in the view that was chosen last`() {
        val workshop = onMachine(isForFingers = true)
        workshop.handle(LearningEvent.TutorialStarted)
        assertEquals(ProgramView.BLOCKS, workshop.view)
        assertEquals(true, workshop.state.learning.isInBlocks)
        workshop.show(ProgramView.TEXT)
        assertEquals(false, workshop.state.learning.isInBlocks)
        workshop.handle(LearningEvent.StepChosen(1))
        assertEquals(ProgramView.TEXT, workshop.view)
    }

    private fun onMachine(isForFingers: Boolean, store: MemoryStore = MemoryStore()): Workshop =
        runBlocking { openWorkshop(platform = MemoryPlatform(store = store, isForFingers = isForFingers)) }
}
