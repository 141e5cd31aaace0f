package robotran.simulation

import kotlinx.coroutines.test.runTest
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Pose
import robotran.world.geometry.length
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertSame
import kotlin.test.assertTrue

class DrawingTest {
    @Test
    fun `a pen that is down leaves ink`() = runTest {
        val ink = runToEnd(
            ScriptedProgram {
                penDown()
                forward(20.0)
            },
        ).state.ink
        assertEquals(20.0, ink.lengthCentimetres, 0.2)
        assertEquals(1, ink.strokes.size)
    }

    @Test
    fun `a pen that is up leaves none`() = runTest {
        val session = runToEnd(
            ScriptedProgram {
                forward(20.0)
                pause(500)
                penDown()
                penUp()
                forward(10.0)
            },
        )
        assertEquals(0.0, session.state.ink.lengthCentimetres)
        assertEquals(false, session.state.robot.penDown)
    }

    @Test
    fun `a square is 80 centimetres of ink`() = runTest {
        val ink = runToEnd(ScriptedProgram.square).state.ink
        assertEquals(80.0, ink.lengthCentimetres, 1.0)
    }

    @Test
    fun `the drawn line of a square is as long as the pen's way and has few points`() = runTest {
        val ink = runToEnd(ScriptedProgram.square).state.ink
        val drawn = ink.strokes.sumOf { stroke ->
            stroke.points.zipWithNext { from, to ->
                length(
                    to.x - from.x,
                    to.y - from.y,
                )
            }.sum()
        }
        assertEquals(ink.lengthCentimetres, drawn, 0.1)
        assertTrue(ink.strokes.single().points.size < 60, "${ink.strokes.single().points.size} points")
    }

    @Test
    fun `a straight line needs two points`() = runTest {
        assertEquals(
            2,
            runToEnd(
                ScriptedProgram {
                    penDown()
                    forward(20.0)
                },
            ).state.ink.strokes.single().points.size,
        )
    }

    @Test
    fun `each time the pen is put down begins a stroke`() = runTest {
        val program = ScriptedProgram {
            repeat(3) {
                penDown()
                forward(5.0)
                penUp()
                forward(2.0)
            }
        }
        val ink = runToEnd(program).state.ink
        assertEquals(3, ink.strokes.size)
        assertEquals(15.0, ink.lengthCentimetres, 0.6)
    }

    @Test
    fun `the ink stays the same object while nothing is drawn`() = runTest {
        val session = runToEnd(
            ScriptedProgram {
                penDown()
                forward(5.0)
                penUp()
            },
        )
        val before = session.state.ink
        session.advance(100)
        assertSame(before, session.state.ink)
    }

    @Test
    fun `a snapshot does not change when more is drawn`() = runTest {
        val session = startRun(ScriptedProgram.square)
        session.advance(2000)
        val ink = session.state.ink
        val points = ink.strokes.flatMap { it.points }
        session.advance(5000)
        assertEquals(points, ink.strokes.flatMap { it.points })
    }

    @Test
    fun `beside the paper there is nothing to draw on`() = runTest {
        val world = BuiltInWorlds.plain.copy(walls = emptyList()).withStart(Pose(95.0, 40.0, 0.0))
        val ink = runToEnd(
            ScriptedProgram {
                penDown()
                forward(20.0)
            },
            world,
        ).state.ink
        assertEquals(5.0, ink.lengthCentimetres, 0.2)
    }
}
