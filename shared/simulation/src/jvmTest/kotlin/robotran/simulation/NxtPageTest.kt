package robotran.simulation

import robotran.simulation.noise.NxtRealism
import robotran.world.NxtLight
import robotran.world.NxtMotorParameters
import robotran.world.Sonar
import java.lang.reflect.Modifier
import kotlin.math.abs
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** The tables of docs/nxt.md agree with the code. */
class NxtPageTest {
    private val rows = Regex("^\\| `(\\w+\\.\\w+)` \\| ([0-9.-]+) \\|", RegexOption.MULTILINE)
        .findAll(nxtPages.getValue("nxt.md"))
        .associate { it.groupValues[1] to it.groupValues[2].toDouble() }

    private val constants = listOf(NxtMotorParameters, NxtLight, Sonar, NxtRealism)
        .map { it::class.java }
        .flatMap { holder ->
            holder.declaredFields.filter { it.isFigure() }.map {
                "${holder.simpleName}.${it.name}" to (it.get(null) as Number).toDouble()
            }
        }
        .toMap()

    @Test
    fun `every figure is on the page and none that does not exist`() {
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
