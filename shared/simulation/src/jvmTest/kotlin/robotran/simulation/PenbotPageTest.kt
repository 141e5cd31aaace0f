package robotran.simulation

import robotran.simulation.noise.Realism
import robotran.world.Light
import robotran.world.Penbot
import java.lang.reflect.Modifier
import kotlin.math.abs
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** The tables of docs/penbot.md agree with the code. */
class PenbotPageTest {
    private val rows = Regex("^\\| `(\\w+\\.\\w+)` \\| ([0-9.-]+) \\|", RegexOption.MULTILINE)
        .findAll(penbotPages.getValue("penbot.md"))
        .associate { it.groupValues[1] to it.groupValues[2].toDouble() }

    private val constants = listOf(Penbot::class.java, Light::class.java, Realism::class.java)
        .flatMap { holder ->
            holder.declaredFields.filter { it.isFigure() }.map {
                "${holder.simpleName}.${it.name}" to
                    (it.get(null) as Number).toDouble()
            }
        }
        .toMap()

    @Test
    fun `every figure of the robot is on the page and none that it does not have`() {
        assertTrue(constants.size > 50)
        assertEquals(constants.keys.sorted(), rows.keys.sorted())
    }

    @Test
    fun `the page tells the figures as they are`() {
        for ((name, value) in constants) assertTrue(abs(rows.getValue(name) - value) < 0.00006, "$name is $value")
    }

    private fun java.lang.reflect.Field.isFigure() =
        Modifier.isPublic(modifiers) && Modifier.isStatic(modifiers) && type.isPrimitive
}
