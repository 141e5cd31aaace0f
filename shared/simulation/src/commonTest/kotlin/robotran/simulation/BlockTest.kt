package robotran.simulation

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.state.SessionState
import robotran.world.Barrier
import robotran.world.MovableBlock
import robotran.world.Penbot
import robotran.world.TouchKind
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class BlockTest {
    private fun world(block: MovableBlock) =
        BuiltInWorlds.plain.copy(walls = emptyList(), blocks = listOf(block)).withStart(Pose(20.0, 40.0, 0.0))

    private fun box(mass: Double, friction: Double = 0.3, y: Double = 40.0) =
        MovableBlock(Shape.Rectangle(Point(40.0, y), 6.0, 6.0), mass, friction)

    private suspend fun drivenInto(block: MovableBlock, power: Int = 3): SessionState {
        val program = ScriptedProgram {
            motors(ScriptedProgram.FORWARD, power)
            pause(2_000)
            motors(ScriptedProgram.BRAKE, 7)
        }
        return runToEnd(program, world(block)).state
    }

    @Test
    fun `a light block is pushed ahead and lies still when the robot does`() = runTest {
        val state = drivenInto(box(mass = 0.1))
        assertEquals(60.0, state.robot.pose.x, 1.0)
        assertEquals(state.robot.pose.x + Penbot.BUMPER_FRONT - 37.0, state.blocks.single().x, 1.0)
        assertEquals(0.0, state.blocks.single().y, 0.5)
        assertEquals(setOf(TouchKind.BLOCKS), state.robot.touched)
        assertEquals(1, state.bumps)
    }

    @Test
    fun `a heavy block does not move and stops the robot`() = runTest {
        val state = drivenInto(box(mass = 3.0, friction = 0.8), power = 7)
        assertEquals(0.0, state.blocks.single().x, 0.05)
        assertEquals(37.0 - Penbot.BUMPER_FRONT, state.robot.pose.x, 0.1)
    }

    @Test
    fun `the heavier a block is the slower it is pushed`() = runTest {
        val ways = listOf(0.1, 0.5, 0.9).map { drivenInto(box(mass = it, friction = 0.4)).blocks.single().x }
        assertEquals(ways.sortedDescending(), ways)
        assertTrue(ways.first() > ways.last() + 1, ways.toString())
    }

    @Test
    fun `a block that is met beside its middle turns`() = runTest {
        val block = drivenInto(box(mass = 0.1, y = 46.0)).blocks.single()
        assertTrue(block.heading > 5, block.toString())
    }

    @Test
    fun `a block that nobody touches stays to the last bit where it is`() = runTest {
        assertEquals(Pose(0.0, 0.0, 0.0), drivenInto(box(mass = 0.1, y = 70.0)).blocks.single())
    }

    private suspend fun session(world: World) =
        Session(world, emptyList<RobotProgramSet>(), loadPhysicsEngine(), Language.ENGLISH)

    @Test
    fun `a block is put down with its middle where it is put, turned and at rest`() = runTest {
        val session =
            session(world(MovableBlock(Shape.Polygon(listOf(Point(60.0, 40.0), Point(66.0, 40.0), Point(60.0, 46.0))))))
        session.apply(SessionInput.PlaceBlock(0, Pose(82.0, 22.0, -90.0)))
        val put = Pose(20.0, -20.0, -90.0)
        assertNear(put, session.state.blocks.single())
        session.advance(2_000)
        assertNear(put, session.state.blocks.single())
    }

    @Test
    fun `a block that is put beside the paper lies at its edge, and one that is not there does nothing`() = runTest {
        val session = session(world(box(mass = 0.1)))
        session.apply(SessionInput.PlaceBlock(0, Pose(-500.0, 500.0, 0.0)))
        session.apply(SessionInput.PlaceBlock(1, Pose(50.0, 40.0, 0.0)))
        session.apply(SessionInput.PlaceBlock(-1, Pose(50.0, 40.0, 0.0)))
        assertNear(Pose(-40.0, 40.0, 0.0), session.state.blocks.single())
    }

    @Test
    fun `a block that is put on something comes to lie beside it`() = runTest {
        val barrier = Barrier(Shape.Rectangle(Point(70.0, 40.0), 10.0, 10.0))
        val session = session(world(box(mass = 0.1)).copy(barriers = listOf(barrier)))
        session.apply(SessionInput.PlaceBlock(0, Pose(67.0, 41.0, 0.0)))
        val out = session.state.blocks.single()
        assertTrue(out.x + 40 + 3 < 65, "the block is still in the barrier: $out")
        assertEquals(61.5, out.x + 40, 1.0)
        session.apply(SessionInput.PlaceBlock(0, Pose(27.0, 40.0, 0.0)))
        val beside = session.state.blocks.single()
        assertTrue(beside.x + 40 - 3 > 20 + Penbot.BUMPER_FRONT, "the block is still in the robot: $beside")
        assertEquals(beside.x + 40, 33.0, 1.5)
        session.advance(1_000)
        assertNear(beside, session.state.blocks.single())
    }

    @Test
    fun `a run in which blocks are put about is the same run on every target, and after it was saved`() = runTest {
        val session =
            session(world(box(mass = 0.1)).copy(barriers = listOf(Barrier(Shape.Circle(Point(60.0, 44.0), 6.0)))))
        for (place in 0..40) {
            session.apply(SessionInput.PlaceBlock(0, Pose(20.0 + place * 1.2345678, 38.0 + place / 7.0, place * 11.1)))
            session.advance(16)
        }
        session.advance(1_000)
        assertEquals("43f1a1a6c60087a6", session.traceHash)
        val again = Session.replay(
            session.world,
            emptyList(),
            loadPhysicsEngine(),
            session.inputs,
            session.state.milliseconds,
            language = Language.ENGLISH,
        )
        assertEquals(session.traceHash, again.traceHash)
        assertEquals(session.state.blocks, again.state.blocks)
    }

    private fun assertNear(expected: Pose, pose: Pose) {
        assertEquals(expected.x, pose.x, 1e-6)
        assertEquals(expected.y, pose.y, 1e-6)
        assertEquals(expected.heading, pose.heading, 1e-6)
    }
}
