package robotran.robotediting

import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind
import robotran.brick.kind.BuggyKind
import robotran.brick.kind.PlainDrive
import robotran.brick.kind.WheelTrim
import robotran.editing.Field
import robotran.language.Language
import robotran.world.PenMount
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
    fun `three test drives of a buggy put speed, track and trim right, in whatever order they are typed`() {
        val begun = RobotEditing.of(ReadyRobots.CUTEBOT)
        val typed = listOf(WAY to 60.0, TURN to 320.0, SIDE to 4.0)
        val orders = typed.flatMap { first ->
            (typed - first).flatMap { second -> listOf(listOf(first, second) + (typed - first - second)) }
        }
        assertEquals(6, orders.size)
        val gear = 50.0 / 60.0
        val track = begun.robot.drive.track * 360.0 / (320.0 * gear)
        for (order in orders) {
            val measured = order.fold(begun) { editing, (tag, value) -> editing.typed(tag, value) }
            assertEquals(gear, measured.robot.drive.gear, TOLERANCE)
            assertEquals(track, measured.robot.drive.track, TOLERANCE)
            assertEquals(WheelTrim(1.0, 1 - 2 * 4.0 * track / (60.0 * 60.0)).right, measured.trim.right, TRIM_TOLERANCE)
            assertEquals(1.0, measured.trim.left)
            for ((tag, value) in typed) assertEquals(value, measured.number(tag).value, 0.5, "$tag in $order")
        }
    }

    @Test
    fun `a second trim is added to the first, and only one wheel is slowed down`() {
        val begun = RobotEditing.of(
            ReadyRobots.CUTEBOT.let {
                it.copy(buggy = it.buggy?.copy(trim = WheelTrim(1.0, 0.97)))
            },
        )
        val right = begun.typed(SIDE, -3.0)
        val factor = 1 - 2 * 3.0 * 7.6 / 2500
        assertEquals(0.97 / factor, right.trim.right / right.trim.left, TRIM_TOLERANCE)
        assertEquals(1.0, maxOf(right.trim.left, right.trim.right))
        assertEquals(WheelTrim(1.0, 0.97), begun.typed(SIDE, 3.0).typed(SIDE, 0.0).trim)
    }

    @Test
    fun `another buggy is that ready robot, and a plain one has its pins and the sensors on them`() {
        val begun = RobotEditing.of(ReadyRobots.CUTEBOT_V1)
        val maqueen = begun.chosen("robot-buggy", BuggyKind.MAQUEEN)
        assertEquals(ReadyRobots.MAQUEEN.copy(brick = BrickKind.MICROBIT_V1), maqueen.robot)
        val plain = maqueen.chosen("robot-buggy", BuggyKind.PLAIN)
        val sensing = plain.chosen("robot-pin-line-1", 13).chosen("robot-pin-line-2", 14).chosen("robot-pin-trigger", 8)
        assertEquals(listOf(1, 2, 3), sensing.robot.parts.map { it.port })
        assertEquals(listOf(13, 14), sensing.robot.buggy?.pins?.lines)
        val motors = sensing.chosen("robot-pins-drive", PlainDrive.BRIDGE)
        assertEquals(motors.robot.buggy?.pins?.all?.distinct(), motors.robot.buggy?.pins?.all)
        assertEquals(emptyList(), motors.errors)
        val offered = motors.choice("robot-pin-pen").options.map { it.value }
        assertTrue(13 !in offered && 0 in offered && null in offered, "$offered")
        val blind = motors.chosen("robot-pin-trigger", null)
        assertEquals(listOf(1, 2), blind.robot.parts.map { it.port })
    }

    @Test
    fun `another micro-bit stays on its buggy, and what was measured stays, too`() {
        val measured = RobotEditing.of(ReadyRobots.MAQUEEN).typed(WAY, 60.0).typed(SIDE, 4.0)
        val older = measured.withBrick(BrickKind.MICROBIT_V1)
        assertEquals(measured.robot.copy(brick = BrickKind.MICROBIT_V1), older.robot)
        assertEquals(measured.number(WAY).value, older.number(WAY).value)
    }

    @Test
    fun `a robot whose motors are on ports of a hub gets those of a buggy with a micro-bit`() {
        val hub = ReadyRobots.SPIKE_PENBOT.let {
            it.copy(drive = it.drive.copy(left = MotorPort.E, right = MotorPort.F), pen = PenMount(MotorPort.D))
        }
        val buggy = RobotEditing.of(hub).withBrick(BrickKind.MICROBIT)
        assertEquals(ReadyRobots.CUTEBOT.buggy, buggy.robot.buggy)
        assertEquals(listOf(MotorPort.A, MotorPort.C), buggy.robot.drive.let { listOf(it.left, it.right) })
        assertEquals(PenMount(MotorPort.B), buggy.robot.pen)
    }

    @Test
    fun `motors that run for a time are not measured`() {
        assertTrue(RobotEditing.of(ReadyRobots.RCX_PENBOT).fieldsOf(RobotElement.Wheels).none { it.tag == WAY })
    }

    private fun RobotEditing.number(tag: String) =
        fieldsOf(RobotElement.Wheels).filterIsInstance<Field.Number<RobotEdit>>().single { it.tag == tag }

    private val RobotEditing.trim get() = checkNotNull(robot.buggy).trim

    @Suppress("UNCHECKED_CAST")
    private fun RobotEditing.choice(tag: String) =
        fieldsOf(RobotElement.Brick).single { it.tag == tag } as Field.Choice<Any?, RobotEdit>

    private fun RobotEditing.chosen(tag: String, value: Any?): RobotEditing =
        after(checkNotNull(choice(tag).with(value, Language.ENGLISH)))

    @Suppress("UNCHECKED_CAST")
    private fun RobotEditing.withBrick(kind: BrickKind): RobotEditing {
        val bricks = robot.wholeFields().single { it.tag == "robot-brick" } as Field.Choice<Any?, RobotEdit>
        return after(checkNotNull(bricks.with(kind, Language.ENGLISH)))
    }

    private fun RobotEditing.typed(tag: String, value: Double) = after(checkNotNull(number(tag).with(value)))

    private companion object {
        const val WAY = "robot-measured-way"
        const val TURN = "robot-measured-turn"
        const val SIDE = "robot-measured-side"
        const val TRIM_TOLERANCE = 0.0015
        const val STEP = 0.5
        const val TOLERANCE = 0.02
    }
}
