package robotran.ui.world

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.SemanticsNodeInteraction
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import kotlinx.coroutines.runBlocking
import robotran.projects.Project
import robotran.simulation.physics.loadPhysicsEngine
import robotran.ui.screen.onScreenOf
import robotran.ui.screen.pass
import robotran.ui.sheet.SheetTransform
import robotran.ui.sheet.transform
import robotran.ui.world.tags.WorldTags
import robotran.workshop.Workshop
import robotran.workshop.state.SheetCamera
import robotran.world.Barrier
import robotran.world.Goal
import robotran.world.GoalCondition.Reach
import robotran.world.Lamp
import robotran.world.MovableBlock
import robotran.world.Paper
import robotran.world.PortSensor
import robotran.world.ReadyRobots
import robotran.world.RobotColour
import robotran.world.RobotPlacement
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape

/** A world with one of each movable element. */
internal val handyWorld = World(
    title = "Handy",
    paper = Paper(100.0, 80.0),
    robots = listOf(
        RobotPlacement(
            Pose(30.0, 40.0, 0.0),
            description = ReadyRobots.penbotWith(
                listOf(PortSensor.LEFT_BUMPER, PortSensor.LIGHT, PortSensor.TEMPERATURE).map { listOf(it) },
            ),
        ),
        RobotPlacement(Pose(80.0, 60.0, 90.0), "red", RobotColour.RED),
    ),
    barriers = listOf(Barrier(Shape.Rectangle(Point(60.0, 10.0), 10.0, 4.0))),
    blocks = listOf(MovableBlock(Shape.Rectangle(Point(60.0, 30.0), 6.0, 6.0))),
    lamps = listOf(Lamp(Point(20.0, 70.0))),
    goals = listOf(Goal(Reach(Shape.Circle(Point(90.0, 20.0), 6.0)))),
)

/** The world pane of a tablet. */
@OptIn(ExperimentalTestApi::class)
internal fun onSheet(world: World = handyWorld, width: Int = 1280, height: Int = 800, check: SheetOnScreen.() -> Unit) {
    val workshop = runBlocking { Workshop(Project(world), loadPhysicsEngine()) }
    onScreenOf(workshop, width, height) {
        pass(200)
        SheetOnScreen(this, workshop).check()
    }
}

@OptIn(ExperimentalTestApi::class)
internal class SheetOnScreen(private val test: ComposeUiTest, val workshop: Workshop) {
    val sheet: SemanticsNodeInteraction get() = onNodeWithTag(WorldTags.WORLD)
    val camera: SheetCamera get() = workshop.state.sheet.camera

    /** The current transform of the sheet, in pixels of its pane. */
    val view: SheetTransform
        get() {
            val size = sheet.fetchSemanticsNode().size
            val told = test.onAllNodesWithTag(WorldTags.WORDS).fetchSemanticsNodes().sumOf { it.size.height }
            val upright =
                size.width.toFloat() / (size.height + told) > workshop.state.world.paper.run { width / height }
            val width = size.width.toFloat()
            val height = size.height.toFloat()
            val window = if (upright) Rect(64f, 0f, width, height) else Rect(0f, 0f, width, height - 64f)
            return camera.transform(workshop.state.world.paper, window)
        }

    fun at(x: Double, y: Double): Offset = view.toPixels(x, y)

    fun onNodeWithTag(tag: String): SemanticsNodeInteraction = test.onNodeWithTag(tag)

    fun pass(milliseconds: Long) = test.pass(milliseconds)

    fun settle() = pass(300)
}
