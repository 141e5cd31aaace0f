package robotran.projects

import robotran.language.ProgramLanguage
import robotran.world.UnknownFields
import robotran.world.World

/**
 * The task that a teacher has set in a [Project]: its world is that of the task, its programs are those that the pupil
 * begins with. `docs/assignments.md` describes the file format.
 *
 * @property id links a hand-in to its assignment; all copies of an assignment have the same.
 * @property text what to do, in paragraphs; a line `![description](name)` shows one of [pictures].
 * @property mayChangeWorld whether the pupil may change the world, too, and not only programs.
 * @property languages in which the pupil may program; empty for any.
 * @property words of Robolang that the pupil may use, as in its blocks; empty for all.
 * @property hints in the order in which they are given.
 * @property due until when to hand in, in the teacher's words; empty for none.
 * @property nameWanted what the pupil should enter as a name, in the teacher's words; empty for the usual request.
 * @property start what the pupil's own robot began with; empty while its programs are still those.
 * @property checks what only grading uses; null in the pupils' file.
 * @property solution programs of the first robot that reach all goals; empty in the pupils' file.
 */
data class Assignment(
    val id: String,
    val text: String = "",
    val pictures: List<AssignmentPicture> = emptyList(),
    val mayChangeWorld: Boolean = false,
    val languages: List<ProgramLanguage> = emptyList(),
    val words: List<String> = emptyList(),
    val hints: List<AssignmentHint> = emptyList(),
    val due: String = "",
    val nameWanted: String = "",
    val start: List<ProjectProgram> = emptyList(),
    val checks: AssignmentChecks? = null,
    val solution: List<ProjectProgram> = emptyList(),
    val unknown: UnknownFields = UnknownFields.NONE,
)

/**
 * A picture in the text of an [Assignment].
 *
 * @property name under which the text mentions it.
 * @property base64 a PNG or JPEG picture in Base64.
 */
data class AssignmentPicture(val name: String, val base64: String)

/**
 * A hint of an [Assignment].
 *
 * @property condition what went wrong, such as `never moved`, see `learning/README.md`; null for any failed try.
 * @property afterTries the number of failed tries after which it may be given.
 */
data class AssignmentHint(val text: String, val condition: String? = null, val afterTries: Int = 1)

/**
 * The runs by which a hand-in is graded, in addition to the goals that the pupil sees.
 *
 * @property seeds with which each world is run.
 * @property variations of the assignment's world, with goals of their own. The assignment's world itself is always run.
 */
data class AssignmentChecks(val seeds: IntRange, val variations: List<WorldVariation> = emptyList())

/** @property name tells the teacher how [world] differs. */
data class WorldVariation(val name: String, val world: World)
