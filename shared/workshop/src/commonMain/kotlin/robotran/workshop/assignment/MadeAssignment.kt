package robotran.workshop.assignment

import robotran.assignments.doing.firstPrograms
import robotran.assignments.doing.notAllowedIn
import robotran.assignments.doing.ordinaryText
import robotran.assignments.tokens.isSameProgram
import robotran.documents.FileStamp
import robotran.projects.Assignment
import robotran.projects.AssignmentChecks
import robotran.projects.AssignmentLimits
import robotran.projects.AssignmentPicture
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.writeProject
import robotran.workshop.state.MissingPart
import robotran.world.WorldLimits
import kotlin.io.encoding.Base64

/**
 * A new assignment about [project]: pupils begin with its programs, except with [solution] and what equals it.
 *
 * @param now in milliseconds since 1970.
 * @param solution the program that has met all goals; null if none has.
 * @param unsure programs of which nobody knows yet whether they solve it; pupils do not begin with them for now.
 */
internal fun newAssignment(
    project: Project,
    now: Long,
    solution: ProjectProgram? = null,
    unsure: List<ProjectProgram> = emptyList(),
): Assignment {
    val stamp = FileStamp.of(writeProject(project)).text.take(STAMP_DIGITS)
    val open = project.firstPrograms.map { it.copy(view = null) }
    val proposed = proposedStart(open).filterNot { it in unsure || (solution != null && isSameProgram(it, solution)) }
    val made = Assignment(
        id = "${now.coerceAtLeast(0).toString(radix = 36)}-$stamp",
        start = proposed,
        checks = AssignmentChecks(FIRST_SEEDS),
        solution = listOfNotNull(solution),
    )
    return withBeginning(made, open)
}

/** [typed] without what a file cannot hold. */
internal fun ordinary(typed: Assignment): Assignment {
    val note = { text: String -> ordinaryText(text, AssignmentLimits.MAXIMUM_NAME_CHARACTERS, severalLines = false) }
    return typed.copy(
        text = ordinaryText(typed.text, AssignmentLimits.MAXIMUM_TEXT_CHARACTERS, severalLines = true),
        due = note(typed.due),
        nameWanted = note(typed.nameWanted),
        hints = typed.hints.filter { it.text.isNotBlank() }.map { hint ->
            val text = ordinaryText(hint.text, WorldLimits.MAXIMUM_TASK_CHARACTERS, severalLines = true)
            hint.copy(text = text, condition = hint.condition?.let(note))
        },
        checks = typed.checks?.let { checks ->
            checks.copy(
                variations = checks.variations.map {
                    it.copy(name = ordinaryText(it.name, WorldLimits.MAXIMUM_TITLE_CHARACTERS, severalLines = false))
                },
            )
        },
    )
}

/** What [assignment], about [project], lacks. */
internal fun missingParts(project: Project, assignment: Assignment): List<MissingPart> = buildList {
    if (project.world.task.isBlank() && assignment.text.isBlank()) add(MissingPart.TASK)
    if (project.world.goals.isEmpty()) add(MissingPart.GOALS)
    if (assignment.solution.isEmpty()) add(MissingPart.SOLUTION)
    if (notAllowedIn(assignment, assignment.solution).isNotEmpty()) add(MissingPart.SOLUTION_NOT_ALLOWED)
}

/** [assignment] with the picture in [bytes], of the file [file], and its mark at the end of the text. */
internal fun withPicture(assignment: Assignment, file: String, bytes: ByteArray): Assignment {
    val plain = file.substringBeforeLast('.').filter { it.isLetterOrDigit() || it in " -_" }.trim()
        .take(MAX_PICTURE_NAME).ifEmpty { "picture" }
    val names = assignment.pictures.map { it.name }
    val name = generateSequence(1) { it + 1 }.map { if (it == 1) plain else "$plain $it" }.first { it !in names }
    val text = "${assignment.text.trimEnd()}\n\n![$name]($name)\n".trimStart()
    val picture = AssignmentPicture(name, Base64.encode(bytes))
    return assignment.copy(pictures = assignment.pictures + picture, text = text)
}

private const val STAMP_DIGITS = 8
private const val MAX_PICTURE_NAME = 40

/** With so many, a program that works by luck is found out. */
internal val FIRST_SEEDS = 1..20
