package robotran.ui.robot

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.semantics.getOrNull
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.KeyInjectionScope
import androidx.compose.ui.test.assertTextEquals
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onRoot
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performTouchInput
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.test.withKeyDown
import robotran.robotediting.RobotEdit
import robotran.robotediting.RobotEditing
import robotran.robotediting.RobotElement
import robotran.robotediting.RobotItem
import robotran.ui.program.tags.ProgramTags
import robotran.ui.screen.onScreen
import robotran.ui.screen.pass
import robotran.ui.screen.scrollAndTouch
import robotran.ui.world.tags.WorldTags
import robotran.workshop.Workshop
import robotran.workshop.event.RobotEditEvent
import robotran.workshop.event.WorldEditEvent
import robotran.world.Facing
import robotran.world.ReadyRobots
import robotran.world.SensorPart
import robotran.world.geometry.Point
import robotran.world.robot.things
import robotran.worldediting.ElementKind
import robotran.worldediting.ElementRef
import robotran.worldediting.WorldEdit
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNull
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class RobotBenchTest {
    @Test
    fun `the world editor leads to the workbench, and Done leads back`() = onScreen(1280, 800) { workshop ->
        workshop.handle(WorldEditEvent.EditorOpened)
        workshop.handle(WorldEditEvent.Edited(WorldEdit.Select(ElementRef(ElementKind.ROBOT, 0))))
        pass(200)
        scrollAndTouch(WorldTags.BUILD_ROBOT)
        pass(200)
        onNodeWithTag(ProgramTags.robot("done")).performClick()
        pass(200)
        assertNull(workshop.state.robotEdit)
        assertTrue(isThere(WorldTags.WORLD_EDIT))
    }

    @Test
    fun `a tap on the palette adds a part, and a drag puts it anywhere`() = onBench {
        tap(WorldTags.robotItem(RobotItem.COLOUR))
        assertEquals(4, robot.things.size)
        val item = screen.onNodeWithTag(WorldTags.robotItem(RobotItem.SOUND)).fetchSemanticsNode().boundsInRoot
        val target = place(2.0, 3.0) + plan.topLeft
        screen.onRoot().performTouchInput {
            down(item.center)
            for (step in 1..STEPS) moveTo(item.center + (target - item.center) * (step / STEPS.toFloat()))
            up()
        }
        screen.pass(100)
        assertEquals(Point(2.0, 3.0), (robot.things.last() as SensorPart).at)
    }

    @Test
    fun `a mistake moves no button of the panel`() = onBench {
        make(RobotEdit.Choose(RobotElement.Part(2)))
        val before = placeOf(WorldTags.ROBOT_TURN_LEFT)
        make(RobotEdit.SetPort(1))
        assertTrue(isThere(WorldTags.ROBOT_CHOSEN_TROUBLE))
        assertEquals(before, placeOf(WorldTags.ROBOT_TURN_LEFT))
    }

    @Test
    fun `a sensor is dragged and turned by its handle`() = onBench {
        drag(place(8.0, 0.0), place(8.0, 3.0))
        val moved = robot.things[2] as SensorPart
        assertEquals(Point(8.0, 3.0), moved.at)
        val handle = handle(0)
        drag(handle, place(8.0, 3.0) + Offset(-200f, 0f))
        assertEquals(Facing.Ahead(90.0), (robot.things[2] as SensorPart).facing)
    }

    @Test
    fun `a robot that was rebuilt is no ready one any more`() {
        for (isRebuilt in listOf(false, true)) {
            onBench {
                if (isRebuilt) tap(WorldTags.robotItem(RobotItem.COLOUR))
                tap(ProgramTags.robot("done"))
                select(ElementRef(ElementKind.ROBOT, 0))
                val chosen = (0..<ReadyRobots.all.size).filter { isChosen("robot-kind-$it") }
                assertEquals(if (isRebuilt) emptyList() else listOf(SUMO), chosen)
            }
        }
    }

    @Test
    fun `a finger on the brick pushes the plan and moves nothing`() = onBench {
        drag(place(-4.0, 0.5), place(-4.0, 0.5) + Offset(60f, 0f))
        assertEquals(ReadyRobots.SUMO, robot)
    }

    @Test
    fun `the plan stays where it is while parts are changed`() = onBench {
        val before = screen.onNodeWithTag(WorldTags.ROBOT_PLAN).fetchSemanticsNode().boundsInRoot
        tap(WorldTags.robotItem(RobotItem.COLOUR))
        make(RobotEdit.Choose(RobotElement.Part(1)), RobotEdit.SetPort(4))
        assertTrue(isThere(WorldTags.ROBOT_HINTS))
        assertEquals(before, screen.onNodeWithTag(WorldTags.ROBOT_PLAN).fetchSemanticsNode().boundsInRoot)
    }

    @Test
    fun `keys move by half a centimetre, turn by 15 degrees, delete and undo`() = onBench {
        make(RobotEdit.Choose(RobotElement.Part(2)))
        key(Key.DirectionUp)
        key(Key.DirectionLeft)
        assertEquals(Point(8.5, 0.5), (robot.things[2] as SensorPart).at)
        key(Key.R)
        assertEquals(Facing.Ahead(15.0), (robot.things[2] as SensorPart).facing)
        key(Key.Delete)
        assertEquals(2, robot.things.size)
        control(Key.Z)
        assertEquals(3, robot.things.size)
        key(Key.Escape)
        assertNull(editing.chosen)
        key(Key.Tab)
        assertEquals(RobotElement.Part(0), editing.chosen)
    }

    @Test
    fun `an impossible robot is told at its part, and to screen readers`() = onBench {
        make(RobotEdit.Choose(RobotElement.Part(1)))
        tap(ProgramTags.robot("port-4"))
        screen.onNodeWithTag(ProgramTags.robot("port-4")).assertTextEquals("4 (Ultrasonic sensor)")
        assertFalse(editing.isPossible)
        assertTrue(isThere(WorldTags.ROBOT_HINTS))
        tap(WorldTags.ROBOT_SHOW_TROUBLE)
        assertTrue(isThere(WorldTags.ROBOT_CHOSEN_TROUBLE))
        val described = screen.onNodeWithTag(WorldTags.ROBOT_PLAN)
            .fetchSemanticsNode().config[SemanticsProperties.StateDescription]
        assertContains(described, "port 4")
        assertContains(described, "Two things")
    }

    @Test
    fun `what has no cable says so, also after the hint was closed once`() = onBench {
        make(RobotEdit.Replace(ReadyRobots.NXT_PENBOT))
        repeat(2) {
            tap(WorldTags.robotItem(RobotItem.LIGHT))
            assertTrue(isThere(WorldTags.ROBOT_HINTS))
            tap(ProgramTags.robot("hints-close"))
            assertFalse(isThere(WorldTags.ROBOT_HINTS))
        }
    }

    @Test
    fun `screen readers hear where a sensor looks`() = onBench {
        make(RobotEdit.Choose(RobotElement.Part(2)), RobotEdit.TurnBy(-30.0))
        val described = screen.onNodeWithTag(WorldTags.ROBOT_PLAN)
            .fetchSemanticsNode().config[SemanticsProperties.StateDescription]
        assertContains(described, "Looks 30° to the right.")
    }

    @Test
    fun `a ready robot is taken, and the robot is shown on the sheet`() = onBench {
        tap(WorldTags.robotTab(RobotTab.ROBOT))
        tap(WorldTags.robotReady("both-sides"))
        assertEquals(ReadyRobots.BOTH_SIDES, robot)
        tap(WorldTags.ROBOT_ON_SHEET)
        assertTrue(isThere(WorldTags.ROBOT_SHEET))
    }

    @Test
    fun `what is touched is as large as a finger on a phone`() = onBench(411, 891) {
        tap(WorldTags.robotTab(RobotTab.PARTS))
        val tags =
            listOf(
                ProgramTags.robot("undo"),
                WorldTags.ROBOT_ON_SHEET,
                WorldTags.ROBOT_FIT,
                ProgramTags.robot("done"),
                WorldTags.robotItem(RobotItem.BUMPER),
                WorldTags.robotElement(0),
            )
        for (tag in tags) {
            val box = screen.onNodeWithTag(tag).fetchSemanticsNode().boundsInRoot
            assertTrue(box.width >= 48 && box.height >= 40, "$tag is $box")
        }
    }

    private fun onBench(width: Int = 1280, height: Int = 800, check: BenchTest.() -> Unit) =
        onScreen(width, height) { workshop ->
            workshop.handle(RobotEditEvent.BenchOpened())
            workshop.handle(RobotEditEvent.Edited(RobotEdit.Replace(ReadyRobots.SUMO)))
            pass(200)
            BenchTest(this, workshop).check()
        }

    private fun ComposeUiTest.isThere(tag: String) = onAllNodesWithTag(tag).fetchSemanticsNodes().isNotEmpty()

    /** User actions in the workbench. */
    private inner class BenchTest(val screen: ComposeUiTest, private val workshop: Workshop) {
        val editing: RobotEditing get() = checkNotNull(workshop.state.robotEdit).editing
        val robot get() = editing.robot
        val plan: Rect get() = screen.onNodeWithTag(WorldTags.ROBOT_PLAN).fetchSemanticsNode().boundsInRoot

        private val view = PlanView(ReadyRobots.SUMO)

        fun place(x: Double, y: Double): Offset {
            view.window = plan
            return view.transform.ofRobot(Point(x, y))
        }

        fun handle(number: Int): Offset {
            view.window = plan
            return placedHandles(editing, view.transform, density = 1f)[number].at
        }

        fun isThere(tag: String) = screen.isThere(tag)

        fun isChosen(tag: String) =
            screen.onNodeWithTag(tag).fetchSemanticsNode().config.getOrNull(SemanticsProperties.Selected) == true

        fun select(element: ElementRef) {
            workshop.handle(WorldEditEvent.EditorOpened)
            workshop.handle(WorldEditEvent.Edited(WorldEdit.Select(element)))
            screen.pass(300)
        }

        fun placeOf(tag: String) = screen.onNodeWithTag(tag).fetchSemanticsNode().boundsInRoot

        fun make(vararg edits: RobotEdit) {
            edits.forEach { workshop.handle(RobotEditEvent.Edited(it)) }
            screen.pass(200)
        }

        fun tap(tag: String) {
            screen.onNodeWithTag(tag).performClick()
            screen.pass(200)
        }

        fun drag(from: Offset, to: Offset) {
            screen.onNodeWithTag(WorldTags.ROBOT_PLAN).performTouchInput {
                down(from)
                for (step in 1..STEPS) moveTo(from + (to - from) * (step / STEPS.toFloat()))
                up()
            }
            screen.pass(200)
        }

        fun key(key: Key) = keys { pressKey(key) }

        fun control(key: Key) = keys { withKeyDown(Key.CtrlLeft) { pressKey(key) } }

        private fun keys(press: KeyInjectionScope.() -> Unit) {
            screen.onRoot().performKeyInput(press)
            screen.pass(60)
        }
    }

    private companion object {
        const val STEPS = 8
        val SUMO = ReadyRobots.all.values.indexOf(ReadyRobots.SUMO)
    }
}
