package robotran.assignments.grading.workers

import kotlinx.serialization.Serializable
import kotlinx.serialization.json.Json
import robotran.assignments.grading.GradingPlan
import robotran.language.Language
import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.readProject
import robotran.projects.writeProject

/**
 * What a worker that shares no memory with the screen must know to grade hand-ins.
 *
 * @property plan of [assignment].
 * @property language of goals and errors.
 */
class GradingOrder private constructor(val assignment: Project, val plan: GradingPlan, val language: Language) {
    /** For [parse]. */
    fun write(): String = Json.encodeToString(
        OrderText.serializer(),
        OrderText(writeProject(assignment), plan.seeds.first, plan.seeds.last, language.tag),
    )

    companion object {
        /** Null if [plan] is not one that follows from [assignment] and the seeds, since only those are written. */
        fun of(assignment: Project, plan: GradingPlan, language: Language): GradingOrder? =
            GradingOrder(assignment, plan, language).takeIf { plan == GradingPlan.of(assignment, plan.seeds) }

        /** @throws IllegalArgumentException if [text] is not what [write] has written. */
        fun parse(text: String): GradingOrder {
            val order = Json.decodeFromString(OrderText.serializer(), text)
            val assignment = when (val result = readProject(order.assignment, Language.ENGLISH)) {
                is ProjectFileResult.Success -> result.project
                is ProjectFileResult.Failure -> throw IllegalArgumentException(result.message)
            }
            val language = requireNotNull(Language.of(order.language)) { "There is no language ${order.language}." }
            return GradingOrder(assignment, GradingPlan.of(assignment, order.first..order.last), language)
        }
    }
}

/** @property first the first seed. */
@Serializable
private class OrderText(val assignment: String, val first: Int, val last: Int, val language: String)
