package robotran.documents

import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.world.file.BuiltInWorlds
import kotlin.test.assertIs

/** A project with one program with this [text]. */
internal fun projectOf(text: String): Project {
    val world = BuiltInWorlds.plain
    val program = ProjectProgram(Program("maze.robo", ProgramLanguage.ROBOLANG, text))
    return Project(world, listOf(ProjectRobot(world.robots.first().name, listOf(program))))
}

internal fun workOf(text: String, id: String = "one", keptAt: Long = 1_000): SavedProject =
    SavedProject(id, "Maze", keptAt, projectOf(text))

internal suspend fun KeyValueStore.work(id: String = "one"): SavedProjectResult.Found =
    assertIs<SavedProjectResult.Found>(ProjectRepository(this).read(id))

internal val SavedProject.text: String get() = project.robots.single().programs.single().files.single().text
