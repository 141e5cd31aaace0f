package robotran.projects

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import robotran.json.jsonObject
import robotran.world.World
import robotran.world.file.elementOf
import robotran.world.file.wordFor

internal fun elementOf(assignment: Assignment): JsonObject = jsonObject(assignment.unknown.members) {
    text("id", assignment.id)
    put(TEXT, assignment.text.takeIf { it.isNotEmpty() }?.let(::linesOf))
    list("pictures", assignment.pictures) {
        jsonObject {
            text("name", it.name)
            text("data", it.base64)
        }
    }
    flag("mayChangeWorld", assignment.mayChangeWorld, default = false)
    list("languages", assignment.languages) { JsonPrimitive(wordFor(it)) }
    list("words", assignment.words, ::JsonPrimitive)
    list("hints", assignment.hints) {
        jsonObject {
            text("when", it.condition)
            number("afterTries", it.afterTries, default = 1)
            text(TEXT, it.text)
        }
    }
    text("due", assignment.due, default = "")
    text("nameWanted", assignment.nameWanted, default = "")
    list("start", assignment.start, ::elementOf)
    put("checks", assignment.checks?.let(::elementOf))
    list("solution", assignment.solution, ::elementOf)
}

private fun elementOf(checks: AssignmentChecks) = jsonObject {
    put(
        "seeds",
        jsonObject {
            number("from", checks.seeds.first)
            number("to", checks.seeds.last)
        },
    )
    list("variations", checks.variations) {
        jsonObject {
            text("name", it.name)
            put("world", elementOf(it.world))
        }
    }
}

internal fun elementOf(tries: AssignmentTries, world: World): JsonObject = jsonObject {
    number("tries", tries.tries)
    put(
        "best",
        tries.best?.let { best ->
            jsonObject {
                put("programs", JsonArray(best.programs.map(::elementOf)))
                number("firstProgram", best.firstProgram + 1, default = 1)
                list("inputs", possibleInputs(best.inputs, world)) { elementOf(it, world) }
                put("result", elementOf(best.result))
                best.percent?.let { number("percent", it) }
            }
        },
    )
}

internal fun elementOf(handIn: HandIn): JsonObject = jsonObject(handIn.unknown.members) {
    text("name", handIn.name)
    number("tries", handIn.tries)
    put("result", handIn.result?.let(::elementOf))
    text("hash", handIn.hash)
}

private fun elementOf(result: TryResult) = jsonObject {
    number("goalsMet", result.goalsMet)
    number("goals", result.goals)
    number("milliseconds", result.milliseconds)
    text("traceHash", result.traceHash)
}

internal fun elementOf(feedback: Feedback): JsonObject = jsonObject(feedback.unknown.members) {
    put("comment", feedback.comment.takeIf { it.isNotEmpty() }?.let(::linesOf))
    list("results", feedback.results) {
        jsonObject {
            text("world", it.world, default = "")
            number("seedsMet", it.seedsMet)
            number("seeds", it.seeds)
        }
    }
}
