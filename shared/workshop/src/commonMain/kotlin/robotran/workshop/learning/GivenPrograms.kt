package robotran.workshop.learning

import robotran.language.ProgramLanguage
import robotran.learning.Lesson
import robotran.learning.WorldGallery
import robotran.programs.Program
import robotran.programs.support
import robotran.world.World

/** Whether a world of the gallery brought this program, and the pupil has changed nothing in it. */
internal val Program.isGiven: Boolean
    get() = files.size == 1 && (WorldGallery.isGiven(name, inUsualWords().text) || NqcVersions().has(this))

/**
 * The programs that leave when [world] is opened: those that other worlds brought and the pupil has not changed. The
 * program to begin with of [world] itself stays.
 */
internal fun programsLeftBehind(world: World): (Program) -> Boolean {
    val task by lazy { WorldGallery.find(world)?.lesson }
    val starts by lazy {
        listOfNotNull(task?.program?.let { Program.of(it.name, it.text) }, task?.let { NqcVersions().start(it) })
    }
    return { program -> program.isGiven && program.inUsualWords() !in starts }
}

/** What "Show me" puts into tabs for [task], one program for each of its languages, in the usual words. */
internal fun solutionsOf(task: Lesson): List<Program> = task.solutions.map {
    val language = checkNotNull(ProgramLanguage.ofFile(it.name)) { it.name }
    Program(language.support.files.nameFor("solution"), language, it.text)
}

/**
 * The program to begin with that [world] of the gallery brings, in NQC if [shown] is; null for any other world, and for
 * the free sheet.
 */
internal fun beginningIn(world: World, shown: Program): Program? =
    WorldGallery.find(world)?.lesson?.let { beginningOf(it, NqcVersions().isIn(shown)) }

/** The program to begin with of [task], in NQC if it can be and [inNqc]; otherwise in the usual words. */
internal fun beginningOf(task: Lesson, inNqc: Boolean): Program =
    (if (inNqc) NqcVersions().start(task) else null) ?: Program.of(task.program.name, task.program.text)
