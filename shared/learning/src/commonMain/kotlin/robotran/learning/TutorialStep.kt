package robotran.learning

import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.SourceFile
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.world.World

/**
 * One step of the [Tutorial]: something to read, a program to try, and a task that is done when the goals of the step's
 * world are met.
 *
 * @property name what the step is kept by, such as `03-repeat`; no two have the same.
 * @property program what is to be tried and changed.
 * @property solution the same program with the task done.
 */
class TutorialStep internal constructor(
    val name: String,
    val program: SourceFile,
    val solution: SourceFile,
    private val plainWorld: World,
    private val texts: Map<Language, TutorialText>,
) {
    /** What the step has to say to speakers of [language]. */
    fun text(language: Language): TutorialText = texts.getValue(language)

    /** The world of the step, with title and task in [language]. */
    fun world(language: Language): World =
        text(language).let { plainWorld.copy(title = it.title, task = withoutMarks(it.task)) }

    /** What [program] is written in. */
    val code: ProgramLanguage
        get() = if (program.name.endsWith(JAVA_FILE)) ProgramLanguage.JAVA else ProgramLanguage.ROBOLANG

    /**
     * The step ready to be tried, in a project of its own.
     *
     * @param files the pupil's own version of [program], such as [solution]; its first file counts, under whatever
     * name.
     */
    fun project(language: Language, files: List<SourceFile> = listOf(program)): Project {
        val world = world(language)
        return Project(
            world,
            listOf(ProjectRobot(world.robots.first().name, listOf(ProjectProgram(files.first().name, code, files)))),
        )
    }
}

/**
 * What a [TutorialStep] says. Program text stands between backticks.
 *
 * @property paragraphs two or three short ones.
 * @property task what is to be done.
 * @property hint what helps to do it.
 */
data class TutorialText(val title: String, val paragraphs: List<String>, val task: String, val hint: String)

/** [text] without the backticks around program text. */
internal fun withoutMarks(text: String): String = text.replace("`", "")

internal const val JAVA_FILE = ".java"
