package robotran.workshop

import kotlinx.coroutines.runBlocking
import robotran.workshop.documents.Machine
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.SheetEvent
import robotran.workshop.state.CameraKind
import robotran.workshop.state.SpaceCamera
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class SpaceViewTest {
    private val machine = Machine()

    @Test
    fun `a window shows worlds as the last one of this machine did`() {
        val first = machine.window()
        assertEquals(false, first.state.sheet.isIn3D)
        first.handle(SheetEvent.SpaceSwitched(true))
        first.handle(SheetEvent.CameraKindChosen(CameraKind.FOLLOW, 0))
        runBlocking { first.closeDocument() }
        val second = machine.window()
        assertTrue(second.state.sheet.isIn3D)
        assertEquals(CameraKind.FOLLOW, second.state.sheet.cameraKind)
    }

    @Test
    fun `another world is seen in 3D, too, and as a whole`() {
        val workshop = machine.window()
        workshop.handle(SheetEvent.SpaceSwitched(true))
        workshop.handle(SheetEvent.SpaceCameraMoved(SpaceCamera(heading = 10.0, zoom = 3.0)))
        workshop.handle(LearningEvent.WorldChosen("maze"))
        assertTrue(workshop.state.sheet.isIn3D)
        assertEquals(SpaceCamera(), workshop.state.sheet.spaceCamera)
    }
}
