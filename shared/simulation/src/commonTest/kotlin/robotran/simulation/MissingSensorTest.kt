package robotran.simulation

import kotlinx.coroutines.test.runTest
import robotran.brick.program.ProgramRun
import robotran.brick.program.ProgramStatus
import robotran.brick.sensors.SensorKind
import robotran.language.Language
import robotran.rcxrom.program.RcxProgram
import robotran.rcxrom.program.Rom
import robotran.rcxrom.sensors.SensorCode
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.state.SessionState
import robotran.world.PortSensor
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import robotran.world.robot.withSensor
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNull

/** A program that expects a sensor where the robot has none is told so, and what to plug in. */
class MissingSensorTest {
    /** Sets ports to types, as pairs of a port from 1 and a type, and then waits. */
    private class Setting(private vararg val types: Pair<Int, Int>) : RcxProgram {
        override val name = "setting"

        override fun start(rom: Rom) = object : ProgramRun {
            override val sourceLine = 3
            private var isDone = false

            override fun resume(steps: Int): ProgramStatus {
                if (!isDone) types.forEach { (port, type) -> rom.setSensorTypeAndMode(port - 1, type, MODE) }
                isDone = true
                return ProgramStatus.Waiting(rom.milliseconds + 1_000)
            }
        }
    }

    private suspend fun sessionOf(
        program: RcxProgram,
        world: World = BuiltInWorlds.plain,
        language: Language = Language.ENGLISH,
    ): Session {
        val session = Session(world, listOf(RobotProgramSet(listOf(program))), loadPhysicsEngine(), language)
        session.pressRun()
        session.advance(20)
        return session
    }

    private val SessionState.missing get() = missingSensors?.sensors.orEmpty()

    private fun World.withPorts(ports: List<List<PortSensor>>) = copy(robots = robots.map { it.withPorts(ports) })

    @Test
    fun `a touch sensor on port 2 is missing, since the penbot has its light sensor there`() = runTest {
        val session = sessionOf(Setting(2 to SensorCode.TYPE_TOUCH, 1 to SensorCode.TYPE_TOUCH))
        val missing = session.state.missing.single()
        assertEquals(2 to SensorKind.TOUCH, missing.port to missing.kind)
        val warning = session.warnings.single()
        assertEquals(warning, session.state.warnings.single())
        assertEquals(3, warning.sourceLine)
        assertEquals("A touch sensor is missing on port 2.", warning.message)
    }

    @Test
    fun `a program that sets what is plugged in is told nothing`() = runTest {
        val program = Setting(
            1 to SensorCode.TYPE_TOUCH,
            2 to SensorCode.TYPE_LIGHT,
            2 to SensorCode.TYPE_LIGHT,
            3 to SensorCode.TYPE_TOUCH,
        )
        val session = sessionOf(program)
        assertNull(session.state.missingSensors)
        assertEquals(emptyList(), session.warnings)
        assertFalse("missingSensors" in session.report().toJson())
    }

    @Test
    fun `what a port is first expected to have is missing there`() = runTest {
        val program = Setting(
            2 to SensorCode.TYPE_TOUCH,
            2 to SensorCode.TYPE_ROTATION,
            2 to SensorCode.TYPE_TOUCH,
            3 to SensorCode.TYPE_TEMPERATURE,
        )
        val missing = sessionOf(program).state.missing
        assertEquals(listOf(2 to SensorKind.TOUCH, 3 to SensorKind.TEMPERATURE), missing.map { it.port to it.kind })
    }

    @Test
    fun `one remark names all sensors that are missing, on the line of the first`() = runTest {
        val bare = BuiltInWorlds.plain.withPorts(List(SensorCode.PORTS) { emptyList() })
        val touch = SensorCode.TYPE_TOUCH
        val rotation = SensorCode.TYPE_ROTATION
        val ofOneKind = sessionOf(Setting(3 to touch, 1 to touch), bare).state
        assertEquals(listOf(1, 3), ofOneKind.missing.map { it.port })
        assertEquals(
            listOf("Touch sensors are missing on ports 1 and 3."),
            ofOneKind.warnings.map { it.message },
        )
        assertEquals(3, ofOneKind.warnings.single().sourceLine)
        val ofAll = sessionOf(Setting(1 to touch, 2 to touch, 3 to touch), bare).warnings.single()
        assertContains(ofAll.message, "ports 1, 2 and 3")
        val ofTwoKinds = sessionOf(Setting(3 to touch, 2 to rotation, 1 to touch), bare).warnings.single()
        assertEquals(
            "Sensors are missing: touch sensors on ports 1 and 3 and a rotation sensor on port 2.",
            ofTwoKinds.message,
        )
    }

    @Test
    fun `with what it is told to plug in, nothing is missing any more`() = runTest {
        for (type in SensorCode.TYPE_TOUCH..SensorCode.TYPE_ROTATION) {
            val kind = SensorCode.kindOf(type)
            for (port in 1..SensorCode.PORTS) {
                val program = Setting(port to type, port to type)
                val empty = BuiltInWorlds.plain.withPorts(List(SensorCode.PORTS) { emptyList() })
                val missing = sessionOf(program, empty).state.missing.single()
                assertEquals(port to kind, missing.port to missing.kind)
                val robot = empty.robots.single().description.withSensor(missing.kind, missing.port)
                val plugged = empty.copy(robots = empty.robots.map { it.copy(description = robot) })
                assertNull(sessionOf(program, plugged).state.missingSensors)
            }
        }
    }

    @Test
    fun `the report names what is missing`() = runTest {
        val report = sessionOf(Setting(2 to SensorCode.TYPE_TOUCH)).report()
        val sensor = report.missingSensors.single()
        assertEquals(2 to ReportedSensorKind.TOUCH, sensor.port to sensor.sensor)
        assertContains(report.toJson(), "\"sensor\": \"touch\"")
    }

    @Test
    fun `pupils are told in their language`() = runTest {
        val program = Setting(2 to SensorCode.TYPE_TOUCH)
        val german = sessionOf(program, language = Language.GERMAN).warnings.single().message
        assertEquals("An Anschluss 2 fehlt ein Tastsensor.", german)
        val spanish = sessionOf(program, language = Language.SPANISH).warnings.single().message
        assertContains(spanish, "sensor de contacto en el puerto 2")
        val several = Setting(2 to SensorCode.TYPE_TOUCH, 3 to SensorCode.TYPE_LIGHT, 3 to SensorCode.TYPE_LIGHT)
        assertEquals(
            "Es fehlen Sensoren: ein Tastsensor an Anschluss 2 und ein Lichtsensor an Anschluss 3.",
            sessionOf(several, language = Language.GERMAN).warnings.single().message,
        )
        assertEquals(
            "Faltan sensores: un sensor de contacto en el puerto 2 y un sensor de luz en el puerto 3.",
            sessionOf(several, language = Language.SPANISH).warnings.single().message,
        )
    }

    private companion object {
        const val MODE = SensorCode.MODE_BOOLEAN
    }
}
