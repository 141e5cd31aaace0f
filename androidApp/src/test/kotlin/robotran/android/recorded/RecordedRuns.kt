package robotran.android.recorded

import robotran.brick.log.toLogText
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.programs.ProgramSource
import robotran.projects.ProjectFileResult
import robotran.projects.RobotProgramSets
import robotran.projects.lightFacingOf
import robotran.projects.readProject
import robotran.projects.readRobotLoads
import robotran.robolang.robot.RobotTarget
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.physics.PhysicsEngine
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.report
import robotran.simulation.runUnattended
import robotran.world.Penbot
import robotran.world.file.BuiltInWorlds
import java.io.File

/**
 * Repeats the runs that the tests of all targets share: all examples in both languages, and the projects with crowded
 * worlds.
 *
 * @param tree the folder with the source tree, which contains the programs and the records.
 */
internal class RecordedRuns(private val tree: File) {
    private val target = RobotTarget.Rcx(Penbot.MILLISECONDS_PER_CENTIMETRE, Penbot.MILLISECONDS_PER_DEGREE)

    /** Repeats all sessions and returns those whose report or ROM log differs from the record. */
    suspend fun differences(): Outcome {
        val physics = loadPhysicsEngine()
        val compiler = ProgramCompiler(target, language = Language.ENGLISH)
        val robolang = files("examples", ".robo").map { file ->
            compare(
                example(compiler, Program(file.name, ProgramLanguage.ROBOLANG, file.readText()), physics),
                file,
                "shared/simulation",
            )
        }
        val java = files("examples/lejos", ".java").map { file ->
            val source = Program(file.name, ProgramLanguage.JAVA, file.readText())
            compare(example(compiler, source, physics), file, "shared/programs")
        }
        val projects = files("shared/projects/$RUNS", ".robotran").map { file ->
            compare(project(file.readText(), physics), file, "shared/projects")
        }
        return Outcome(robolang.size, java.size, projects.size, (robolang + java + projects).filterNotNull())
    }

    private suspend fun example(compiler: ProgramCompiler, source: ProgramSource, physics: PhysicsEngine): Session {
        val result = compiler.compileOrThrow(source)
        check(result is ProgramResult.Success) { "$source has mistakes: $result" }
        val load = RobotProgramSet(listOf(result.program), lightFacing = lightFacingOf(result.program))
        return Session(BuiltInWorlds.plain, listOf(load), physics, Language.ENGLISH).apply {
            runUnattended(EXAMPLE_MILLISECONDS)
        }
    }

    private suspend fun project(text: String, physics: PhysicsEngine): Session {
        val project = (readProject(text, Language.ENGLISH) as ProjectFileResult.Success).project
        val loads = (
            readRobotLoads(
                project,
                ProgramCompiler(target, project.settings.java, Language.ENGLISH),
            ) as RobotProgramSets.Success
        ).loads
        return Session.replay(
            project.worldToRun,
            loads,
            physics,
            project.inputs,
            EXAMPLE_MILLISECONDS.toLong(),
            Language.ENGLISH,
        ).apply {
            finish()
        }
    }

    /** The differences from the records of [file]; null if there are none. */
    private fun compare(session: Session, file: File, module: String): String? {
        session.close()
        val record = tree.resolve("$module/$RUNS/${file.nameWithoutExtension}.report.json").readText()
        val report = session.report().toJson() + "\n"
        if (report != record) return "${file.name} leaves the report\n$report and not\n$record"
        val recordedLog = tree.resolve("$module/$RUNS/${file.nameWithoutExtension}.rom-log.txt")
        if (!recordedLog.exists()) return null
        val log = session.callLog.entries.toLogText()
        return if (log == recordedLog.readText()) null else "${file.name} makes other ROM calls:\n$log"
    }

    private fun files(folder: String, extension: String): List<File> =
        tree.resolve(folder).listFiles().orEmpty().filter { it.name.endsWith(extension) }.sorted()

    /**
     * The result of repeating the runs.
     *
     * @property differences one text per run that differs from its record.
     */
    data class Outcome(val robolang: Int, val java: Int, val projects: Int, val differences: List<String>)

    private companion object {
        const val RUNS = "src/commonTest/resources/runs"
        const val EXAMPLE_MILLISECONDS = 60_000
    }
}
