package robotran.world

import kotlinx.coroutines.test.runTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class BlockTest {
    private fun world(block: Block) =
        BuiltInWorlds.plain.copy(walls = emptyList(), blocks = listOf(block)).withStart(Pose(20.0, 40.0, 0.0))

    private fun box(mass: Double, friction: Double = 0.3, y: Double = 40.0) =
        Block(Shape.Rectangle(Point(40.0, y), 6.0, 6.0), mass, friction)

    private suspend fun drivenInto(block: Block, power: Int = 3): SessionState {
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
}
