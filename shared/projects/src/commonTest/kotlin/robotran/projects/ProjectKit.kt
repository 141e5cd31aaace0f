package robotran.projects

import robotran.brick.controls.BrickButton
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.languagesupport.SourceFile
import robotran.programs.JavaSettings
import robotran.programs.Program
import robotran.simulation.RecordedInput
import robotran.simulation.SessionInput
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.config.TinyVmSpeed
import robotran.world.Lamp
import robotran.world.LightFacing
import robotran.world.MovableBlock
import robotran.world.RobotColour
import robotran.world.RobotPlacement
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** A project with every feature of the file format. */
internal val FULL_PROJECT = Project(
    world = BuiltInWorlds.plain.copy(
        robots = listOf(
            RobotPlacement(Pose(20.0, 20.0, 0.0), "ann"),
            RobotPlacement(Pose(60.0, 20.0, 0.0), "bob", RobotColour.BLUE),
        ),
        blocks = listOf(
            MovableBlock(Shape.Circle(Point(50.0, 50.0), 3.0)),
            MovableBlock(Shape.Rectangle(Point(70.0, 50.0), 4.0, 6.0)),
        ),
        lamps = listOf(Lamp(Point(1.0, 2.0)), Lamp(Point(3.0, 4.0))),
    ),
    robots = listOf(
        ProjectRobot(
            "bob",
            listOf(
                ProjectProgram(Program("a.robo", ProgramLanguage.ROBOLANG, "beep\r\n\tbuzz // ñ🤖\u0000\n")),
                ProjectProgram(
                    Program(
                        "B",
                        ProgramLanguage.JAVA,
                        listOf(SourceFile("B.java", "class B {\n}"), SourceFile("C.java", "")),
                    ),
                ),
            ),
            firstProgram = 1,
            lightFacing = LightFacing.FORWARD,
        ),
        ProjectRobot("ann"),
    ),
    settings = ProjectSettings(
        seed = 5,
        realism = 0.25,
        java = JavaSettings(TinyVmMode.FORGIVING, TinyVmSpeed.UNLIMITED),
    ),
    inputs = listOf(
        RecordedInput(0, SessionInput.Press(BrickButton.ON_OFF)),
        RecordedInput(10, SessionInput.Release(BrickButton.ON_OFF, 1)),
        RecordedInput(10, SessionInput.Stop),
        RecordedInput(20, SessionInput.PlaceRobot(1, Pose(-5.5, 6.0, 270.0))),
        RecordedInput(30, SessionInput.MoveLamp(1, Point(0.125, 9.0))),
        RecordedInput(40, SessionInput.SwitchLamp(0, false)),
        RecordedInput(50, SessionInput.ChangeAmbientLight(-0.5)),
        RecordedInput(60, SessionInput.ChangeTemperature(30.0)),
        RecordedInput(70, SessionInput.PlaceBlock(1, Pose(80.25, 1.0, -30.0))),
        RecordedInput(5_000_000, SessionInput.TouchSensor(1, 2, true)),
    ),
)

/** A project with programs for LEGO's own firmware. */
internal val FIRMWARE_PROJECT = Project(
    world = BuiltInWorlds.plain,
    robots = listOf(
        ProjectRobot(
            BuiltInWorlds.plain.robots.first().name,
            listOf(
                ProjectProgram(
                    Program(
                        "d.nqc",
                        ProgramLanguage.NQC,
                        listOf(SourceFile("d.nqc", "#include \"e.nqh\"\ntask main() { }"), SourceFile("e.nqh", "")),
                    ),
                ),
                ProjectProgram(Program("f.lasm", ProgramLanguage.LASM, "\ttask 0\n\tendt\n")),
            ),
        ),
    ),
)

internal fun loaded(text: String): Project = when (val result = readProject(text, Language.ENGLISH)) {
    is ProjectFileResult.Success -> result.project
    is ProjectFileResult.Failure -> throw AssertionError(result.message)
}

/** The error message for the full project with [new] instead of the first [old]. */
internal fun refusalWith(old: String, new: String): String {
    val text = writeProject(FULL_PROJECT)
    assertTrue(old in text, "$old is in\n$text")
    return assertIs<ProjectFileResult.Failure>(
        readProject(text.replaceFirst(old, new), Language.ENGLISH),
    ).message.substringAfter(": ")
}
