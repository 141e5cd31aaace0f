package robotran.projects

import kotlinx.coroutines.test.runTest
import robotran.brick.controls.MotorPort
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramSource
import robotran.robolang.robot.RobotTarget
import robotran.world.LightFacing
import robotran.world.Penbot
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.RobotPlacement
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Pose
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class RobotProgramSetsTest {
    private val reader =
        ProgramCompiler(
            RobotTarget.Rcx(Penbot.MILLISECONDS_PER_CENTIMETRE, Penbot.MILLISECONDS_PER_DEGREE),
            language = Language.ENGLISH,
        )
    private val world = BuiltInWorlds.plain.copy(
        robots = listOf(
            RobotPlacement(Pose(20.0, 20.0, 0.0), "ann"),
            RobotPlacement(Pose(60.0, 20.0, 0.0), "bob", program = "forward 5"),
            RobotPlacement(Pose(60.0, 60.0, 0.0), "carl"),
        ),
    )

    private fun program(name: String, text: String) = Program(name, ProgramLanguage.ROBOLANG, text)

    private suspend fun names(given: Map<String, List<ProgramSource>>): List<List<String?>> =
        assertIs<RobotProgramSets.Success>(readRobotLoads(world, reader, given)).loads.map { load ->
            load.programs.map { it?.name }
        }

    @Test
    fun `each robot gets the programs it is given and otherwise its own`() = runTest {
        val first = world.forFirstRobot(listOf(program("a.robo", "beep"), program("b.robo", "buzz")))
        assertEquals(listOf(listOf("a.robo", "b.robo"), listOf("bob.robo"), emptyList()), names(first))
        assertEquals(
            listOf(emptyList(), listOf("b.robo"), emptyList()),
            names(mapOf("bob" to listOf(program("b.robo", "beep")))),
        )
    }

    @Test
    fun `warnings are about what was given only`() = runTest {
        val warned = world.copy(robots = world.robots.map { it.copy(program = "var unused = 1") })
        val given = warned.forFirstRobot(listOf(program("a.robo", "var unused = 1")))
        assertEquals(
            listOf("a.robo"),
            assertIs<RobotProgramSets.Success>(readRobotLoads(warned, reader, given)).warnings.map { it.file },
        )
    }

    @Test
    fun `a light sensor looks where the first program's header says, unless the pupil has turned it`() = runTest {
        val forward = program("a.robo", "robot\n  light sensor on 2 facing forward\nend\nshow light")
        val given = mapOf("ann" to listOf(forward), "carl" to listOf(program("c.robo", "beep"), forward))
        val loads = assertIs<RobotProgramSets.Success>(readRobotLoads(world, reader, given)).loads
        assertEquals(listOf(LightFacing.FORWARD, null, null), loads.map { it.lightFacing })
        val written = listOf(checkNotNull(ProjectProgram.of(forward)))
        val turned = Project(world, listOf(ProjectRobot("ann", written, lightFacing = LightFacing.DOWN)))
        assertEquals(
            LightFacing.DOWN,
            assertIs<RobotProgramSets.Success>(readRobotLoads(turned, reader)).loads.first().lightFacing,
        )
    }

    @Test
    fun `mistakes are told with the robot they belong to`() = runTest {
        val result = readRobotLoads(world, reader, mapOf("carl" to listOf(program("c.robo", "forwrd 5"))))
        val mistaken = assertIs<RobotProgramSets.Failure>(result)
        assertEquals("carl", mistaken.robot)
        assertEquals(listOf("c.robo"), mistaken.diagnostics.map { it.file })
    }

    @Test
    fun `a program for a robot that is not there is a mistake`() = runTest {
        val mistaken = assertIs<RobotProgramSets.Failure>(readRobotLoads(world, reader, mapOf("dora" to emptyList())))
        assertEquals(
            "No robot in this world is called dora. Its robots are ann, bob and carl.",
            mistaken.diagnostics.single().message,
        )
    }

    @Test
    fun `a project gives its robots more than programs`() = runTest {
        fun program(name: String) = checkNotNull(ProjectProgram.of(Program(name, ProgramLanguage.ROBOLANG, "beep")))
        val robots = listOf(
            ProjectRobot("carl", listOf(program("a.robo"), program("b.robo")), firstProgram = 1),
            ProjectRobot("ann", lightFacing = LightFacing.FORWARD),
        )
        val loads = assertIs<RobotProgramSets.Success>(readRobotLoads(Project(world, robots), reader)).loads
        assertEquals(listOf(0, 1, 2), loads.map { it.programs.size })
        assertEquals(listOf(0, 0, 1), loads.map { it.firstSlot })
        assertEquals(listOf(LightFacing.FORWARD, null, null), loads.map { it.lightFacing })
    }

    @Test
    fun `a brick has room for five programs`() = runTest {
        val given = world.forFirstRobot(List(6) { program("$it.robo", "beep") })
        val mistaken = assertIs<RobotProgramSets.Failure>(readRobotLoads(world, reader, given))
        assertEquals(
            "The robot ann has been given 6 programs, but a brick has room for 5.",
            mistaken.diagnostics.single().message,
        )
    }

    @Test
    fun `no program can run as long as a robot is unfinished and impossible`() = runTest {
        val crossed = ReadyRobots.RCX_PENBOT.drive.copy(left = MotorPort.C)
        val draft = ReadyRobots.RCX_PENBOT.copy(title = "One motor", drive = crossed)

        fun with(draft: RobotDescription) =
            world.copy(robots = world.robots.map { if (it.name == "bob") it.copy(draft = draft) else it })

        for ((language, begin) in listOf(
            Language.ENGLISH to "The robot bob is not finished: \"One motor\" cannot drive. Two motors are needed",
            Language.GERMAN to "Der Roboter bob ist nicht fertig: „One motor“ kann nicht fahren. ",
            Language.SPANISH to "El robot bob no está terminado: «One motor» no puede conducir. ",
        )) {
            val result = readRobotLoads(with(draft), reader.withLanguage(language), emptyMap())
            val mistaken = assertIs<RobotProgramSets.Failure>(result)
            assertEquals("bob", mistaken.robot)
            assertTrue(mistaken.diagnostics.single().message.startsWith(begin), "${mistaken.diagnostics}")
        }
        assertIs<RobotProgramSets.Success>(readRobotLoads(with(ReadyRobots.SUMO), reader, emptyMap()))
    }
}
