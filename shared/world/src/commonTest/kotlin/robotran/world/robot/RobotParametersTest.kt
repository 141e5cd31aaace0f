package robotran.world.robot

import robotran.brick.controls.MotorPort
import robotran.world.Penbot
import robotran.world.ReadyRobots
import robotran.world.geometry.Bounds
import robotran.world.geometry.Point
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotEquals
import kotlin.test.assertSame

class RobotParametersTest {
    private val penbot = ReadyRobots.RCX_PENBOT

    @Test
    fun `the formulas give the constants of the penbot`() {
        val computed = RobotParameters.computed(penbot)
        val constants = RobotParameters.PENBOT

        fun same(figure: (RobotParameters) -> Double) =
            assertEquals(figure(constants), figure(computed), figure(constants) * 1e-9)
        same { it.wheelTrack }
        same { it.wheelDiameter }
        same { it.wheelCircumference }
        same { it.wheelWidth }
        same { it.topSpeed }
        same { it.calibratedSpeed }
        same { it.motorLag }
        same { it.unfeltLoad }
        same { it.rollingDeceleration }
        same { it.mass }
        same { it.massX }
        same { it.inertia }
        same { it.tyreFriction }
        same { it.wheelLoad }
        same { it.overallWidth }
        assertEquals(50.0, computed.millisecondsPerCentimetre)
        assertEquals(5.0, computed.millisecondsPerDegree)
        // The penbot's is rounded.
        assertEquals(Penbot.STALL_FORCE, computed.stallForce, 4.0)
    }

    @Test
    fun `what is plugged in where, and which motors drive, change no figure`() {
        val drive = penbot.drive.copy(left = MotorPort.C, right = MotorPort.B, reversed = true)
        assertSame(
            RobotParameters.PENBOT,
            RobotParameters.of(penbot.copy(parts = emptyList(), drive = drive, base = null)),
        )
        val heavy = penbot.copy(chassis = penbot.chassis.copy(mass = 0.7))
        assertNotEquals(RobotParameters.PENBOT.inertia, RobotParameters.of(heavy).inertia)
    }

    @Test
    fun `inertia and load of the ready robots`() {
        val expected = mapOf(
            "rcx-penbot" to (18.616 to 258.08),
            "nxt-penbot" to (27.12 to 295.80),
            "line-follower" to (17.99 to 251.49),
            "sumo" to (49.96 to 457.80),
            "both-sides" to (29.06 to 316.94),
            "spike-penbot" to (20.74 to 267.13),
            "spike-scout" to (20.74 to 267.13),
            "essential-rover" to (7.99 to 154.51),
            "technic-penbot" to (20.74 to 267.13),
            "ev3-penbot" to (30.13 to 316.94),
            "nxt-pybricks-penbot" to (27.12 to 295.80),
            "cutebot" to (2.05 to 66.01),
            "cutebot-pro" to (4.21 to 71.94),
            "maqueen" to (1.21 to 48.15),
            "maqueen-plus" to (3.17 to 76.37),
            "tiny-bit" to (2.46 to 65.33),
            "kitronik-penbot" to (3.92 to 98.10),
            "plain-buggy" to (3.02 to 78.48),
            "cutebot-v1" to (2.05 to 66.01),
        )
        assertEquals(expected.keys, ReadyRobots.all.keys)
        for ((name, pair) in expected) {
            val parameters = RobotParameters.of(ReadyRobots.all.getValue(name))
            assertEquals(pair.first, parameters.inertia, 0.01, name)
            assertEquals(pair.second, parameters.wheelLoad, 0.01, name)
        }
    }

    @Test
    fun `an NXT penbot drives as fast as an NXT's motors turn`() {
        val parameters = RobotParameters.of(ReadyRobots.NXT_PENBOT)
        assertEquals(44.2, parameters.topSpeed, 0.1)
        assertEquals(31.3, parameters.calibratedSpeed, 0.1)
        assertEquals(1696.4, parameters.stallForce, 0.1)
    }

    @Test
    fun `the footprint of the penbot is the string around it, in the order of its runs`() {
        val half = Penbot.OVERALL_WIDTH / 2
        val bumper = Penbot.BUMPER_GAP / 2 + Penbot.BUMPER_WIDTH
        val radius = Penbot.WHEEL_DIAMETER / 2
        val expected = listOf(
            Point(Penbot.CHASSIS_BACK, -Penbot.CHASSIS_WIDTH / 2),
            Point(-radius, -half),
            Point(radius, -half),
            Point(Penbot.BUMPER_FRONT, -bumper),
            Point(Penbot.BUMPER_FRONT, bumper),
            Point(radius, half),
            Point(-radius, half),
            Point(Penbot.CHASSIS_BACK, Penbot.CHASSIS_WIDTH / 2),
        )
        assertEquals(expected, penbot.footprint)
        assertEquals(Bounds(Penbot.CHASSIS_BACK, -half, Penbot.BUMPER_FRONT, half), penbot.box)
    }

    @Test
    fun `a bumper faces where it is turned to`() {
        val corners = ReadyRobots.SUMO.bumpers.single().corners
        assertEquals(-9.5, corners.minOf { it.x })
        assertEquals(-8.3, corners.maxOf { it.x }, 1e-9)
        assertEquals(5.0, corners.maxOf { it.y }, 1e-9)
        assertEquals(-9.5, ReadyRobots.SUMO.box.left)
    }

    @Test
    fun `every ready robot can be built`() {
        for ((name, robot) in ReadyRobots.all) assertEquals(emptyList(), robotErrors(robot), name)
        assertEquals(19, ReadyRobots.all.size)
    }
}
