package robotran.robotediting

import robotran.editing.Field
import robotran.world.ReadyRobots
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotEquals
import kotlin.test.assertTrue

class MeasuredTest {
    private val begun = RobotEditing.of(ReadyRobots.SPIKE_PENBOT).after(RobotEdit.Choose(RobotElement.Wheels))

    private fun RobotEditing.typed(tag: String, value: Double): RobotEditing {
        val field = measuredFields().filterIsInstance<Field.Number<RobotEdit>>().single { it.tag == tag }
        return after(checkNotNull(field.with(value)))
    }

    @Test
    fun `a robot that drove too far has larger wheels and turns as before`() {
        val drive = begun.typed("robot-drove", 52.5).robot.drive
        assertEquals(5.88, drive.wheelDiameter, 0.001)
        assertEquals(11.76, drive.track, 0.001)
    }

    @Test
    fun `a robot that turned too little has its wheels farther apart`() {
        val drive = begun.typed("robot-turned", 345.6).robot.drive
        assertEquals(5.6, drive.wheelDiameter, 0.001)
        assertEquals(11.2 * 360 / 345.6, drive.track, 0.001)
    }

    @Test
    fun `what is typed one after the other counts from the wheels before, is shown, and is one undo step`() {
        val once = begun.typed("robot-drove", 48.0).typed("robot-turned", 350.0)
        val again = begun.typed("robot-drove", 90.0).typed("robot-drove", 48.0).typed("robot-turned", 350.0)
        assertEquals(once.robot, again.robot)
        val shown = again.measuredFields().filterIsInstance<Field.Number<RobotEdit>>().map { it.value }
        assertEquals(listOf(48.0, 350.0), shown)
        assertEquals(begun.robot, again.after(RobotEdit.Undo).robot)
    }

    @Test
    fun `who comes back later measures anew`() {
        val measured = begun.typed("robot-drove", 48.0)
        val back = measured.after(RobotEdit.Choose(RobotElement.Mass)).after(RobotEdit.Choose(RobotElement.Wheels))
        assertEquals(50.0, back.measuredFields().filterIsInstance<Field.Number<RobotEdit>>().first().value)
        assertNotEquals(begun.robot, back.robot)
        assertTrue(back.after(RobotEdit.Choose(RobotElement.Mass)).measuredFields().isEmpty())
    }
}
