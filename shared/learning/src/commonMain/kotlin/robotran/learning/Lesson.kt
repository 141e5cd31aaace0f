package robotran.learning

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.languagesupport.SourceFile
import robotran.learning.drawing.RunDrawing
import robotran.learning.hint.Attempt
import robotran.programs.Program
import robotran.programs.support
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.simulation.state.SessionState
import robotran.world.World

/**
 * One lesson: a text, a program to try, and a task that is done when the goals of the lesson's world are met. The task
 * of a [GalleryWorld] is one too, without paragraphs.
 *
 * @property name the unique name under which progress is saved, such as `repeat`.
 * @property strand the name of its [Strand]; empty for the task of a [GalleryWorld].
 * @property otherSolutions the task done in other languages than that of [program], for a pupil who writes them.
 * @param onOtherBricks the same lesson with robots that have other bricks; empty for such a lesson itself, for one that
 * is about one brick, and for the task of a [GalleryWorld].
 * @param version reads programs and world when they are needed.
 */
class Lesson internal constructor(
    val name: String,
    val strand: String,
    val otherSolutions: List<SourceFile> = emptyList(),
    onOtherBricks: () -> Map<BrickKind, Lazy<Lesson>> = { emptyMap() },
    version: () -> LessonVersion,
    read: (language: Language, inBlocks: Boolean) -> LessonText,
) {
    // Whoever only looks for a name reads no files.
    private val version by lazy(version)
    private val plainWorld: World get() = version.world
    private val onOtherBricks by lazy(onOtherBricks)

    /** The program that the pupil tries and changes. */
    val program: SourceFile get() = version.program

    /** The same program with the task done. */
    val solution: SourceFile get() = version.solution

    /** What the run of [solution] leaves on the sheet; null for the task of a [GalleryWorld]. */
    val drawing: RunDrawing? get() = version.drawing

    private val texts by lazy { Language.entries.associateWith { read(it, false) } }
    private val textsForBlocks by lazy { Language.entries.associateWith { read(it, true) } }
    private val textsInWords = HashMap<Triple<Language, Boolean, Language>, LessonText>()

    /**
     * What the lesson says; to a pupil who sees programs in blocks, if [inBlocks].
     *
     * @param words the language whose words its program text has.
     */
    fun text(language: Language, inBlocks: Boolean = false, words: Language = Language.ENGLISH): LessonText {
        val written = (if (inBlocks) textsForBlocks else texts).getValue(language)
        if (words == Language.ENGLISH) return written
        return textsInWords.getOrPut(Triple(language, inBlocks, words)) {
            written.inWords(programLanguage.support, words)
        }
    }

    /** The places in which a program must reach the goals. */
    val places: List<LessonPlace> get() = LessonPlace.entries.filter { worldAt(it) != null }

    /**
     * The world of the lesson, with title, task and goals in [language], and program text in [words]. Fails if the lesson
     * lacks the [place].
     */
    fun world(language: Language, place: LessonPlace = LessonPlace.FIRST, words: Language = Language.ENGLISH): World {
        val world = checkNotNull(worldAt(place)) { "$name has one place." }
        val text = text(language, words = words)
        return world.withGoalsSaid(text(Language.ENGLISH).goals, text.goals)
            .copy(title = text.title, task = withoutBackticks(text.task))
    }

    private fun worldAt(place: LessonPlace): World? = when (place) {
        LessonPlace.FIRST -> plainWorld
        LessonPlace.AGAIN -> version.again
    }

    /** The same lesson with a robot that has a [brick], or this one if there is none. */
    fun on(brick: BrickKind): Lesson = onOtherBricks[brick]?.value ?: this

    /** The brick of the pupil's robot. */
    val brick: BrickKind get() = plainWorld.robots.first().description.brick

    /** The place whose world is [world], in any language, on this brick; null if it is another's. */
    fun placeOf(world: World): LessonPlace? = when {
        // Both places have the same paper, so few worlds are read.
        plainWorld.paper != world.paper -> null
        plainWorld.isSameWorldAs(world) -> LessonPlace.FIRST
        version.again?.isSameWorldAs(world) == true -> LessonPlace.AGAIN
        else -> null
    }

    /** The lesson with the brick for which [world] is its world, in any language; null if it is another's. */
    internal fun foundIn(world: World): Lesson? = takeIf { placeOf(world) != null }
        ?: onOtherBricks[world.robots.first().description.brick]?.value
            ?.takeIf { it.placeOf(world.withPupilsPenbot()) != null }

    /** The language of [program]. */
    val programLanguage: ProgramLanguage get() = languageOf(program)

    /** [solution] and [otherSolutions]. */
    val solutions: List<SourceFile> get() = listOf(solution) + otherSolutions

    /**
     * Creates a project for the lesson.
     *
     * @param files the pupil's own version of [program], such as [solution]; the first file may have any name, whose
     * extension tells the language.
     * @param words the language whose words program text in the task has.
     */
    fun project(
        language: Language,
        files: List<SourceFile> = listOf(program),
        place: LessonPlace = LessonPlace.FIRST,
        words: Language = Language.ENGLISH,
    ): Project {
        val world = world(language, place, words)
        return Project(
            world,
            listOf(
                ProjectRobot(
                    world.robots.first().name,
                    listOf(ProjectProgram(Program(files.first().name, languageOf(files.first()), files))),
                ),
            ),
        )
    }

    /**
     * A try at the task with the text [program], whose run at [place] ended in the state [run].
     *
     * @param hasPassed whether the same program has reached the goals in the other place.
     */
    fun attempt(
        program: String,
        run: SessionState,
        place: LessonPlace = LessonPlace.FIRST,
        hasPassed: Boolean = false,
    ): Attempt {
        val written = languageOf(this.program).support.inUsualWords(program)
        return Attempt(written, this.program.text, solution.text, checkNotNull(worldAt(place)), run, hasPassed)
    }
}

private fun languageOf(file: SourceFile): ProgramLanguage = ProgramLanguage.ofFileOrDefault(file.name)
