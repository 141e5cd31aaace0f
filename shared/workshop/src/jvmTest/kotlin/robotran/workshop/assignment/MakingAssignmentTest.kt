package robotran.workshop.assignment

import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.platform.OpenedFile
import robotran.workshop.state.EditOrigin
import robotran.workshop.state.PictureError
import robotran.workshop.state.SolutionCheck
import robotran.worldediting.Element
import robotran.worldediting.ElementKind
import robotran.worldediting.ElementRef
import robotran.worldediting.WorldEdit
import kotlin.io.encoding.Base64
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** Task, text, pictures, variations and what becomes of an assignment on the page of its author. */
class MakingAssignmentTest : MakingAssignments() {
    @Test
    fun `title, task and text are kept at once and can be undone`() {
        val workshop = making()
        workshop.handle(AssignmentEvent.TaskChanged("Another title", "Another task."))
        assertEquals("Another title", workshop.project.world.title)
        machine.clock.now += 10_000
        workshop.handle(AssignmentEvent.Changed(workshop.making.assignment.copy(text = "Read this.")))
        assertEquals("Read this.", workshop.project.assignment?.text)
        workshop.handle(AssignmentEvent.UndoRequested)
        assertEquals("", workshop.project.assignment?.text)
        workshop.handle(AssignmentEvent.UndoRequested)
        assertEquals("Into the circle", workshop.making.title)
        assertTrue(!workshop.making.canUndo)
        workshop.handle(AssignmentEvent.MakingClosed)
        assertEquals("Into the circle", workshop.state.world.title)
    }

    @Test
    fun `an empty title is not kept`() {
        val workshop = making()
        workshop.handle(AssignmentEvent.TaskChanged("", "Task."))
        assertEquals("", workshop.making.title)
        assertEquals("Into the circle", workshop.project.world.title)
    }

    @Test
    fun `a picture gets a mark in the text, and what is none is refused`() {
        val workshop = making()
        machine.files.chosen = listOf(OpenedFile("robot [1].png", Base64.decode(AnyAssignment.DOT)))
        workshop.handle(AssignmentEvent.PictureRequested)
        assertEquals("![robot 1](robot 1)\n", workshop.making.assignment.text)
        workshop.handle(AssignmentEvent.PictureRequested)
        assertEquals(listOf("robot 1", "robot 1 2"), workshop.making.assignment.pictures.map { it.name })
        machine.files.chosen = listOf(OpenedFile("a.png", "not a picture".encodeToByteArray()))
        workshop.handle(AssignmentEvent.PictureRequested)
        assertEquals(PictureError.NOT_A_PICTURE, workshop.making.pictureError)
        machine.files.chosen = listOf(OpenedFile("a.png", Base64.decode(AnyAssignment.DOT) + ByteArray(200_000)))
        workshop.handle(AssignmentEvent.PictureRequested)
        assertEquals(PictureError.TOO_LARGE, workshop.making.pictureError)
    }

    @Test
    fun `a variation is edited in the world editor, and the world stays as it is`() {
        val workshop = making()
        val world = workshop.project.world
        workshop.handle(AssignmentEvent.VariationAdded("Further away"))
        assertNull(workshop.state.making)
        assertEquals(EditOrigin("Into the circle", "Further away"), workshop.state.worldEdit?.origin)
        val edited = checkNotNull(workshop.state.worldEdit).editing.world
        val robot = edited.robots.first()
        val moved = robot.copy(start = robot.start.copy(x = robot.start.x + 5))
        workshop.handle(
            WorldEditEvent.Edited(WorldEdit.Change(ElementRef(ElementKind.ROBOT, 0), Element.OfRobot(moved))),
        )
        workshop.handle(WorldEditEvent.TriedOut)
        assertEquals(world, workshop.project.world)
        val variation = checkNotNull(workshop.making.assignment.checks).variations.single()
        assertEquals("Further away", variation.name)
        assertEquals(moved.start, variation.world.robots.first().start)
        assertTrue(!workshop.state.running)
        workshop.handle(AssignmentEvent.VariationOpened(0))
        assertEquals(variation.world, checkNotNull(workshop.state.worldEdit).editing.world)
        workshop.handle(WorldEditEvent.EditorClosed)
        assertNotNull(workshop.state.making)
    }

    @Test
    fun `the world editor leads back to the page`() {
        val workshop = making()
        workshop.handle(AssignmentEvent.WorldRequested)
        assertEquals(EditOrigin("Into the circle", null), workshop.state.worldEdit?.origin)
        workshop.handle(WorldEditEvent.EditorClosed)
        assertNotNull(workshop.state.making)
        workshop.handle(AssignmentEvent.WorldRequested)
        workshop.handle(WorldEditEvent.TriedOut)
        assertNull(workshop.state.making)
        assertTrue(workshop.state.running)
        workshop.handle(WorldEditEvent.EditorOpened)
        assertNull(workshop.state.worldEdit?.origin)
        workshop.handle(WorldEditEvent.EditorClosed)
        assertNull(workshop.state.making)
    }

    @Test
    fun `the solution is run with all seeds and variations`() {
        val workshop = making(AnyAssignment.teachers)
        workshop.handle(AssignmentEvent.CheckRequested(on = true))
        assertEquals(SolutionCheck.Passed(runs = 6), workshop.making.check)
        val wrong = workshop.making.assignment.copy(solution = listOf(AnyAssignment.program("forward 5\n")))
        workshop.handle(AssignmentEvent.Changed(wrong))
        assertNull(workshop.making.check)
        workshop.handle(AssignmentEvent.CheckRequested(on = true))
        assertEquals(SolutionCheck.Failed(failed = 6, runs = 6, world = "", seed = 1), workshop.making.check)
        val begun = workshop.making.assignment.copy(
            start = listOf(AnyAssignment.program("beep\n" + AnyAssignment.SOLUTION)),
            solution = AnyAssignment.assignment.solution,
        )
        workshop.handle(AssignmentEvent.Changed(begun))
        workshop.handle(AssignmentEvent.CheckRequested(on = true))
        assertEquals(SolutionCheck.Passed(runs = 6, startPassed = 6), workshop.making.check)
        workshop.handle(AssignmentEvent.Changed(wrong.copy(solution = listOf(AnyAssignment.program("forwrad\n")))))
        workshop.handle(AssignmentEvent.CheckRequested(on = true))
        assertIs<SolutionCheck.HasErrors>(workshop.making.check)
    }

    @Test
    fun `the link for pupils opens without checks`() {
        val workshop = making(AnyAssignment.teachers)
        workshop.handle(AssignmentEvent.PupilLinkRequested)
        workshop.handle(AssignmentEvent.PupilLinkCopied)
        assertEquals(true, workshop.making.link?.isCopied)
        val pupils = machine.window()
        pupils.handle(DocumentEvent.LinkOpened(checkNotNull(machine.clipboard.text)))
        assertNull(checkNotNull(pupils.state.assignment).assignment.checks)
    }

    @Test
    fun `the solution comes into the editor, and removing makes a project like any other`() {
        val workshop = making(AnyAssignment.teachers)
        workshop.handle(AssignmentEvent.SolutionShown)
        assertEquals(AnyAssignment.SOLUTION, workshop.state.programText)
        workshop.handle(AssignmentEvent.MakingRequested)
        workshop.handle(AssignmentEvent.Removed)
        assertNull(workshop.state.assignment)
        assertNull(workshop.state.making)
    }
}
