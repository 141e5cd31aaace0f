package robotran.learning

import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.SourceFile
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.world.World

/**
 * One step of the [Tutorial]: a text, a program to try, and a task that is done when the goals of the step's world are
 * met.
 *
 * @property name the unique name under which the step's progress is saved, such as `03-repeat`.
 * @property program the program that the pupil tries and changes.
 * @property solution the same program with the task done.
 */
class TutorialStep internal constructor(
    val name: String,
    val program: SourceFile,
    val solution: SourceFile,
    private val plainWorld: World,
    files: Map<Language, String>,
) {
    private val texts = Language.entries.associateWith { TutorialText.of(files.getValue(it), inBlocks = false) }
    private val textsForBlocks = Language.entries.associateWith {
        TutorialText.of(files.getValue(it), inBlocks = true)
    }

    /** What the step says; to a pupil who sees programs in blocks, if [inBlocks]. */
    fun text(language: Language, inBlocks: Boolean = false): TutorialText =
        (if (inBlocks) textsForBlocks else texts).getValue(language)

    /** The world of the step, with title and task in [language]. */
    fun world(language: Language): World =
        text(language).let { plainWorld.copy(title = it.title, task = withoutBackticks(it.task)) }

    /** The language of [program]. */
    val code: ProgramLanguage
        get() = if (program.name.endsWith(JAVA_FILE)) ProgramLanguage.JAVA else ProgramLanguage.ROBOLANG

    /**
     * Creates a project for the step.
     *
     * @param files the pupil's own version of [program], such as [solution]; the first file may have any name.
     */
    fun project(language: Language, files: List<SourceFile> = listOf(program)): Project {
        val world = world(language)
        return Project(
            world,
            listOf(ProjectRobot(world.robots.first().name, listOf(ProjectProgram(files.first().name, code, files)))),
        )
    }
}

internal const val JAVA_FILE = ".java"
