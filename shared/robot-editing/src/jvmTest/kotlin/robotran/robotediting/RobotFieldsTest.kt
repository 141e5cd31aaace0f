package robotran.robotediting

import robotran.editing.Field
import robotran.world.ReadyRobots
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class RobotFieldsTest {
    @Test
    fun `each field of each element of the ready robots has a tag of its own and a valid value`() {
        for ((name, robot) in ReadyRobots.all) {
            for (element in robot.elements() + RobotElement.Corner(0)) {
                val fields = robot.fieldsOf(element)
                val tags = fields.map { it.tag }.filter { it.isNotEmpty() }
                assertEquals(tags.distinct(), tags, "$element of $name")
                assertTrue(fields.all { it.isValid }, "$element of $name")
            }
            assertTrue(robot.wholeFields().all { it.isValid }, name)
        }
    }

    @Test
    fun `a changed number reaches the robot`() {
        val begun = RobotEditing.of(ReadyRobots.SUMO)
        for (element in begun.robot.elements()) {
            for (field in begun.robot.fieldsOf(element).filterIsInstance<Field.Number<RobotEdit>>()) {
                val wanted = if (field.value < field.spec.range.endInclusive) field.value + STEP else field.value - STEP
                val edit = field.with(wanted) ?: continue
                val changed = begun.after(RobotEdit.Choose(element)).after(edit).robot
                val now = changed.fieldsOf(element).filterIsInstance<Field.Number<RobotEdit>>().first {
                    it.tag ==
                        field.tag
                }
                assertEquals(wanted, now.value, TOLERANCE, "${field.tag} of $element")
            }
        }
    }

    private companion object {
        const val STEP = 0.5
        const val TOLERANCE = 0.02
    }
}
