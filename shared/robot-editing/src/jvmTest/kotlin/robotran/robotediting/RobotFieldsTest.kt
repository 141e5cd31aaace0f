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
                val fields = RobotEditing.of(robot).fieldsOf(element)
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
            for (field in begun.fieldsOf(element).filterIsInstance<Field.Number<RobotEdit>>()) {
                val wanted = if (field.value < field.spec.range.endInclusive) field.value + STEP else field.value - STEP
                val edit = field.with(wanted) ?: continue
                val changed = begun.after(RobotEdit.Choose(element)).after(edit)
                val now = changed.fieldsOf(element).filterIsInstance<Field.Number<RobotEdit>>().first {
                    it.tag ==
                        field.tag
                }
                assertEquals(wanted, now.value, TOLERANCE, "${field.tag} of $element")
            }
        }
    }

    @Test
    fun `what a real robot did on paper puts wheels and track right, in whatever order it is typed`() {
        val begun = RobotEditing.of(ReadyRobots.NXT_PENBOT)
        for (order in listOf(listOf(WAY to 45.0, TURN to 400.0), listOf(TURN to 400.0, WAY to 45.0))) {
            val measured = order.fold(begun) { editing, (tag, value) -> editing.typed(tag, value) }
            val (was, now) = begun.robot.drive to measured.robot.drive
            assertEquals(was.wheelDiameter * 0.9, now.wheelDiameter, TOLERANCE)
            assertEquals(was.track * 0.9 * 0.9, now.track, TOLERANCE)
            assertEquals(45.0, measured.number(WAY).value, TOLERANCE)
            assertEquals(400.0, measured.number(TURN).value, 0.5)
        }
    }

    @Test
    fun `measuring begins anew with another robot, and goes on after an undo`() {
        val measured = RobotEditing.of(ReadyRobots.NXT_PENBOT).typed(WAY, 45.0)
        val other = measured.after(RobotEdit.Replace(ReadyRobots.SUMO))
        assertEquals(50.0, other.number(WAY).value, TOLERANCE)
        assertEquals(45.0, other.after(RobotEdit.Undo).number(WAY).value, TOLERANCE)
    }

    @Test
    fun `motors that run for a time are not measured`() {
        assertTrue(RobotEditing.of(ReadyRobots.RCX_PENBOT).fieldsOf(RobotElement.Wheels).none { it.tag == WAY })
    }

    private fun RobotEditing.number(tag: String) =
        fieldsOf(RobotElement.Wheels).filterIsInstance<Field.Number<RobotEdit>>().single { it.tag == tag }

    private fun RobotEditing.typed(tag: String, value: Double) = after(checkNotNull(number(tag).with(value)))

    private companion object {
        const val WAY = "robot-measured-way"
        const val TURN = "robot-measured-turn"
        const val STEP = 0.5
        const val TOLERANCE = 0.02
    }
}
