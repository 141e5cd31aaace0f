package robotran.web.embedding

import kotlinx.coroutines.delay
import kotlinx.serialization.json.JsonObject
import robotran.json.JsonReading
import robotran.json.ObjectBuilder
import robotran.json.jsonObject
import robotran.json.readJson
import robotran.json.writeCompactJson
import robotran.language.Language
import robotran.projects.Assignment
import robotran.projects.LinkCreation
import robotran.projects.LinkResult
import robotran.projects.Project
import robotran.projects.ProjectLimits
import robotran.projects.handInLinkOf
import robotran.projects.openHandInLink
import robotran.workshop.Workshop

/**
 * Tells the page around this one how the pupil gets on with the assignment, or with each one of a course, and gives it
 * the pupil's work, since this page saves nothing; takes work that it has given before. Never returns if the page
 * around may know.
 */
internal suspend fun reportToParent(workshop: Workshop) {
    val parent = ParentPage.find() ?: return
    while (workshop.project.assignment == null) delay(LOOK)
    var assignment = workshop.project
    val brought = mutableListOf<String>()
    parent.onMessage { message -> workIn(message)?.let(brought::add) }
    parent.post(text("ready", assignment) {})
    var seen: Project? = null
    var result = ""
    while (true) {
        brought.removeLastOrNull()?.let { link -> resume(workshop, assignment, link) }
        brought.clear()
        val now = workshop.project
        if (!isThe(assignment, now) && workshop.state.course.open != null) {
            // The next one of the course.
            assignment = now
            parent.post(text("ready", now) {})
        }
        if (now != seen && isThe(assignment, now)) {
            seen = now
            val told = text("result", now) { result(now) }
            if (told != result) parent.post(told)
            result = told
            (handInLinkOf(withoutTexts(now), Language.ENGLISH) as? LinkCreation.Made)?.let { link ->
                parent.post(text("work", now) { text("work", link.fragment) })
            }
        }
        delay(LOOK)
    }
}

/** Whether [project] is still a pupil's version of [assignment] and not something else that was opened. */
private fun isThe(assignment: Project, project: Project): Boolean = project.assignment?.id == assignment.assignment?.id

private suspend fun resume(workshop: Workshop, assignment: Project, link: String) {
    val saved = (openHandInLink(link, assignment.world, Language.ENGLISH) as? LinkResult.OfProject)?.project ?: return
    if (!isThe(assignment, saved)) return
    workshop.services.editor.openProject(
        assignment.copy(world = saved.world, robots = saved.robots, tries = saved.tries),
    )
}

/** The parent has the assignment, so its work needs no texts. */
private fun withoutTexts(project: Project): Project = project.copy(
    assignment = project.assignment?.let { Assignment(it.id, mayChangeWorld = it.mayChangeWorld) },
)

private fun text(kind: String, project: Project, content: ObjectBuilder.() -> Unit): String = writeCompactJson(
    jsonObject {
        number("robotran", VERSION)
        text("kind", kind)
        put("assignment", titled(project))
        content()
    },
)

private fun titled(project: Project): JsonObject = jsonObject {
    text("id", project.assignment?.id)
    text("title", project.world.title)
}

private fun ObjectBuilder.result(project: Project) {
    val best = project.tries?.best?.result
    val goals = project.world.goals.size
    val met = best?.goalsMet ?: 0
    number("tries", project.tries?.tries ?: 0)
    number("goalsMet", met)
    number("goals", goals)
    number("score", if (goals == 0) 0.0 else met.toDouble() / goals)
    flag("completed", best?.isSolved == true, default = null)
    if (best != null) number("seconds", best.milliseconds / MILLISECONDS_PER_SECOND)
}

/** The link in a message of the page around; null if it has none. */
private fun workIn(message: String): String? {
    val reading = readJson(message, Language.ENGLISH) { file ->
        file.optional("work")?.longText(ProjectLimits.MAXIMUM_LINK_CHARACTERS)
            ?.takeIf { file.optional("kind")?.textOrNull() == "resume" }
    }
    return (reading as? JsonReading.Success)?.value
}

/** The version of the messages. */
private const val VERSION = 1

/** Milliseconds between two looks at the workshop. */
private const val LOOK = 1_000L
private const val MILLISECONDS_PER_SECOND = 1000.0
