package robotran.projects

import kotlinx.coroutines.test.runTest
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonPrimitive
import robotran.brick.kind.BrickKind
import robotran.json.nearestDecimal
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.languagesupport.SourceFile
import robotran.programs.JavaSettings
import robotran.programs.Program
import robotran.simulation.RecordedInput
import robotran.simulation.SessionInput
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.config.TinyVmSpeed
import robotran.world.LightFacing
import robotran.world.UnknownFields
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

/** Projects of all kinds, the same on every target. */
class ProjectRoundTripTest {
    private val random = Random(2005)

    @Test
    fun `any project is read as it was written`() {
        repeat(500) { project().let { assertEquals(it, loaded(writeProject(it))) } }
    }

    @Test
    fun `any project survives a link`() = runTest {
        repeat(100) {
            val project = project()
            val link = assertIs<LinkCreation.Made>(linkOf(project, Language.ENGLISH)).fragment
            assertEquals<LinkResult>(LinkResult.OfProject(project), openLink(link, Language.ENGLISH))
        }
    }

    private fun project() = Project(
        world = FULL_PROJECT.world,
        robots = listOf("ann", "bob").shuffled(random).take(random.nextInt(3)).map(::robot),
        settings = ProjectSettings(
            maybe {
                random.nextInt(Int.MAX_VALUE)
            },
            maybe { number(0.0, 1.0) },
            java(),
            unknown(),
        ),
        inputs = inputs(),
        unknown = unknown(),
    )

    private fun robot(name: String): ProjectRobot {
        val programs = List(random.nextInt(6)) { program() }
        return ProjectRobot(
            name,
            programs,
            random.nextInt(maxOf(1, programs.size)),
            maybe {
                LightFacing.entries.random(random)
            },
            unknown(),
        )
    }

    private fun program(): ProjectProgram {
        val name = "p" + visible()
        if (random.nextBoolean()) {
            return ProjectProgram(
                Program(name, ProgramLanguage.ROBOLANG, text()),
                maybe {
                    ProgramView.entries.random(random)
                },
                unknown(),
            )
        }
        return ProjectProgram(
            Program(
                name,
                ProgramLanguage.JAVA,
                List(random.nextInt(1, 4)) {
                    SourceFile("f" + visible(), text())
                },
            ),
            unknown = unknown(),
        )
    }

    private fun java() = JavaSettings(TinyVmMode.entries.random(random), TinyVmSpeed.entries.random(random))

    private fun inputs(): List<RecordedInput> {
        var time = 0L
        return List(random.nextInt(20)) {
            time += random.nextInt(5000)
            RecordedInput(time, input())
        }
    }

    private fun input(): SessionInput = when (random.nextInt(10)) {
        0 -> SessionInput.Press(BrickKind.allButtons.random(random), robot())
        1 -> SessionInput.Release(BrickKind.allButtons.random(random), robot())
        2 -> SessionInput.Stop
        3 -> SessionInput.PlaceRobot(robot(), Pose(far(), far(), far()))
        8 -> SessionInput.PlaceBlock(block(), Pose(far(), far(), far()))
        4 -> SessionInput.MoveLamp(lamp(), Point(far(), far()))
        5 -> SessionInput.SwitchLamp(lamp(), random.nextBoolean())
        6 -> SessionInput.ChangeAmbientLight(far())
        7 -> SessionInput.ChangeTemperature(far())
        else -> SessionInput.TouchSensor(robot(), random.nextInt(3), random.nextBoolean())
    }

    private fun robot() = random.nextInt(2)

    private fun block() = random.nextInt(2)

    private fun lamp() = random.nextInt(2)

    private fun far() = number(-500.0, 1500.0)

    private fun number(from: Double, to: Double) = nearestDecimal(random.nextDouble(from, to))

    private fun visible() = List(random.nextInt(8)) {
        listOf("a", "é", "\"", "\\", "/", "🤖", "語").random(random)
    }.joinToString("")

    private fun text() = List(random.nextInt(40)) {
        listOf("a", "\n", "\r\n", "\t", "\u0000", "\uD83E", "🤖", "\"", "end").random(random)
    }.joinToString("")

    private fun unknown() = if (random.nextBoolean()) {
        UnknownFields.NONE
    } else {
        UnknownFields(
            mapOf(
                "_" to JsonPrimitive(text()),
                "?" to JsonNull,
            ),
        )
    }

    private fun <T : Any> maybe(make: () -> T): T? = if (random.nextBoolean()) make() else null
}
