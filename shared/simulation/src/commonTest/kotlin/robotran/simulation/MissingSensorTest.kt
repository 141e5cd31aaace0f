package robotran.simulation

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.rcxrom.program.ProgramRun
import robotran.rcxrom.program.ProgramStatus
import robotran.rcxrom.program.RcxProgram
import robotran.rcxrom.program.Rom
import robotran.rcxrom.sensors.SensorCode
import robotran.rcxrom.sensors.SensorKind
import robotran.simulation.physics.loadPhysicsEngine
import robotran.world.PortSensor
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse

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
        val session = Session(world, listOf(RobotLoad(listOf(program))), loadPhysicsEngine(), language)
        session.pressRun()
        session.advance(20)
        return session
    }

    private fun World.withPorts(ports: List<List<PortSensor>>) = copy(robots = robots.map { it.copy(ports = ports) })

    @Test
    fun `a touch sensor on port 2 is missing, since the penbot has its light sensor there`() = runTest {
        val session = sessionOf(Setting(2 to SensorCode.TYPE_TOUCH, 1 to SensorCode.TYPE_TOUCH))
        val missing = session.state.missingSensors.single()
        assertEquals(2 to SensorKind.TOUCH, missing.port to missing.kind)
        val remark = session.remarks.single()
        assertEquals(remark, session.state.remarks.single())
        assertEquals(3, remark.sourceLine)
        assertEquals("The program expects a touch sensor on port 2, but the robot has none there.", remark.message)
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
        assertEquals(emptyList(), session.state.missingSensors)
        assertEquals(emptyList(), session.remarks)
        assertFalse("missingSensors" in session.report().toJson())
    }

    @Test
    fun `there is one remark per port`() = runTest {
        val program = Setting(
            2 to SensorCode.TYPE_TOUCH,
            2 to SensorCode.TYPE_ROTATION,
            2 to SensorCode.TYPE_TOUCH,
            3 to SensorCode.TYPE_TEMPERATURE,
        )
        val missing = sessionOf(program).state.missingSensors
        assertEquals(listOf(2 to SensorKind.TOUCH, 3 to SensorKind.TEMPERATURE), missing.map { it.port to it.kind })
    }

    @Test
    fun `with what it is told to plug in, nothing is missing any more`() = runTest {
        for (kind in SensorKind.entries) {
            for (port in 1..SensorCode.PORTS) {
                val program = Setting(port to kind.type, port to kind.type)
                val empty = BuiltInWorlds.plain.withPorts(List(SensorCode.PORTS) { emptyList() })
                val missing = sessionOf(program, empty).state.missingSensors.single()
                assertEquals(port to kind, missing.port to missing.kind)
                val plugged = List(SensorCode.PORTS) { if (it == port - 1) missing.plug else emptyList() }
                assertEquals(emptyList(), sessionOf(program, empty.withPorts(plugged)).state.missingSensors)
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
        val german = sessionOf(program, language = Language.GERMAN).remarks.single().message
        assertEquals("Das Programm erwartet an Anschluss 2 einen Tastsensor, aber der Roboter hat dort keinen.", german)
        val spanish = sessionOf(program, language = Language.SPANISH).remarks.single().message
        assertContains(spanish, "sensor de contacto en el puerto 2")
    }

    private companion object {
        const val MODE = SensorCode.MODE_BOOLEAN
    }
}
